"""The scenes by their names. Each is a module with

    PARAMETERS    name -> (default, meaning)
    scene(meshes, random, **parameters)    the YAML file's content as nested dicts and lists;
                                           meshes.add(name, mesh) writes a mesh and gives its file

and a docstring whose first line says what it is for. `random` is NumPy's RandomState, whose streams
are frozen: one seed gives one scene with any version of NumPy."""

import importlib

import numpy

from scene_gen.files import MeshFolder, write_yaml

NAMES = ("attic", "door_ajar", "forest", "glass_and_mirrors", "lamps", "mis_plates", "shed",
         "soup", "terrain", "white_room", "window")


def module_of(name):
    return importlib.import_module(f"scene_gen.{name}")


def generate(name, folder, seed=0, **parameters):
    """Writes it to folder/NAME.yaml and gives that path."""
    module = module_of(name)
    values = {key: default for key, (default, _) in module.PARAMETERS.items()}
    unknown = set(parameters) - set(values)
    if unknown:
        raise ValueError(f"{name} has no parameter '{sorted(unknown)[0]}'; expected "
                         + (", ".join(values) or "none"))
    path = folder / f"{name}.yaml"
    about = module.__doc__.splitlines()[0]
    made = " ".join(f"--{key.replace('_', '-')} {value}"
                    for key, value in ({"seed": seed} | values | parameters).items())
    content = module.scene(MeshFolder(folder), numpy.random.RandomState(seed),
                           **(values | parameters))
    folder.mkdir(parents=True, exist_ok=True)
    write_yaml(path, content, f"{about}\ntools/scene_gen {name} {made}")
    return path
