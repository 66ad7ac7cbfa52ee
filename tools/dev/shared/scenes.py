"""The scenes to measure with: ours under assets/, the course's where they are present."""

import os
import pathlib


def shared_folder(root):
    """As the tests look for it: the folder that holds lab3/."""
    return pathlib.Path(os.environ.get("CANDELA_SCENES", root.parent / "shared" / "scenes"))


def assets(root):
    return sorted(root.glob("assets/*/*.yaml"))


def course_scenes(root):
    return sorted(shared_folder(root).glob("lab3/*/*.yaml"))


def scenes_by_name(root):
    """All that are present; the course's with `lab3/` before their names."""
    return ({path.stem: path for path in assets(root)} |
            {f"lab3/{path.stem}": path for path in course_scenes(root)})


def pbrt_scenes(root):
    """`pbrt/FOLDER` -> file; of several versions of a scene the last, which mends the others."""
    found = sorted(shared_folder(root).glob("pbrt/*/scene-v4*.pbrt"),
                   key=lambda path: (path.parent, len(path.name)))
    return {f"pbrt/{path.parent.name}": path for path in found}
