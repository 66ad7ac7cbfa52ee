"""Generated scenes, once: what tools/scene_gen makes, kept in a folder of the caller's."""

import hashlib
import json
import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))  # for the package scene_gen


def generated(folder, name, **parameters):
    """The scene's file, below `folder`; parameters are tools/scene_gen's own. It is made anew where
    the generator or a parameter is another one, or the last time was stopped half-way."""
    from scene_gen import generate
    words = [name, *(f"{key}_{value}" for key, value in sorted(parameters.items()))]
    place = folder / "scenes" / "_".join(words)
    stamp = place / "stamp"
    made_by = stamp_of(pathlib.Path(generate.__file__).parent, name, parameters)
    if not stamp.exists() or stamp.read_text() != made_by:
        stamp.unlink(missing_ok=True)
        generate.generate(name, place, **parameters)
        stamp.write_text(made_by)
    return place / f"{name}.yaml"


def stamp_of(sources, *asked):
    """Of the generator's source files and of what it is asked for."""
    text = [path.read_text() for path in sorted(sources.glob("*.py"))]
    return hashlib.sha256(json.dumps([text, asked], sort_keys=True).encode()).hexdigest()
