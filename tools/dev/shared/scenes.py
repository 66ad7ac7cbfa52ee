"""The scenes to measure with: ours under assets/, the course's where they are present."""

import os
import pathlib

# Those of other people that figures are published of (docs/benchmarks.md).
ELSEWHERE = (*(f"lab3/{name}" for name in (
    "breakfast_room", "bunny", "cornell_box", "floor", "sibenik", "sponza", "sports_car", "teapot",
    "white_oak")), *(f"pbrt/{name}" for name in (
        "classroom", "cornell-box", "staircase", "staircase2", "teapot", "veach-ajar", "veach-mis")))


def shared_folder(root):
    """As the tests look for it: the folder that holds lab3/."""
    return pathlib.Path(os.environ.get("CANDELA_SCENES", root.parent / "shared" / "scenes"))


def assets(root):
    return sorted(root.glob("assets/*/*.yaml"))


def shipped_pbrt_scenes(root):
    return {path.stem: path for path in sorted(root.glob("assets/*/*.pbrt"))}


def course_scenes(root):
    return sorted(shared_folder(root).glob("lab3/*/*.yaml"))


def scenes_by_name(root):
    """All YAML files that are present; the course's with `lab3/` before their names."""
    return ({path.stem: path for path in assets(root)} |
            {f"lab3/{path.stem}": path for path in course_scenes(root)})


def pbrt_scenes(root):
    """`pbrt/FOLDER` -> file; of several versions of a scene the last, which mends the others."""
    found = sorted(shared_folder(root).glob("pbrt/*/scene-v4*.pbrt"),
                   key=lambda path: (path.parent, len(path.name)))
    return {f"pbrt/{path.parent.name}": path for path in found}


def absent_scenes(root):
    """Of those from elsewhere, by name."""
    return [name for name in ELSEWHERE if name not in scenes_by_name(root) | pbrt_scenes(root)]
