"""Generated scenes, once: what tools/scene_gen makes, kept in a folder of the caller's."""

import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))  # for the package scene_gen


def generated(folder, name, seed=0, **parameters):
    """The scene's file, below `folder`; parameters are tools/scene_gen's own."""
    from scene_gen import generate
    words = [name, *(f"{key}_{value}" for key, value in sorted(parameters.items()))]
    return generate.generate(name, folder / "scenes" / "_".join(words), seed, **parameters)
