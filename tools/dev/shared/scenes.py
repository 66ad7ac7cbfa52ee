"""The scenes to measure with: ours under assets/, the course's where they are present."""

import os
import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[3]
ASSETS = ROOT / "assets"
# Those of other people that figures are published of (docs/benchmarks.md).
ELSEWHERE = (*(f"lab3/{name}" for name in (
    "breakfast_room", "bunny", "cornell_box", "floor", "sibenik", "sponza", "sports_car", "teapot",
    "white_oak")), *(f"pbrt/{name}" for name in (
        "classroom", "cornell-box", "staircase", "staircase2", "teapot", "veach-ajar",
        "veach-mis")))


def shared_folder():
    """As the tests look for it: the folder that holds lab3/."""
    return pathlib.Path(os.environ.get("CANDELA_SCENES", ROOT.parent / "shared" / "scenes"))


def asset(name):
    return ASSETS / name / f"{name}.yaml"


def assets():
    return sorted(ASSETS.glob("*/*.yaml"))


def shipped_pbrt_scenes():
    return {path.stem: path for path in sorted(ASSETS.glob("*/*.pbrt"))}


def course_scenes():
    return sorted(shared_folder().glob("lab3/*/*.yaml"))


def scenes_by_name():
    """All YAML files that are present; the course's with `lab3/` before their names."""
    return ({path.stem: path for path in assets()} |
            {f"lab3/{path.stem}": path for path in course_scenes()})


def pbrt_scenes():
    """`pbrt/FOLDER` -> file; of several versions of a scene the last, which mends the others."""
    found = sorted(shared_folder().glob("pbrt/*/scene-v4*.pbrt"),
                   key=lambda path: (path.parent, len(path.name)))
    return {f"pbrt/{path.parent.name}": path for path in found}


def absent_scenes():
    """Of those from elsewhere, by name."""
    return [name for name in ELSEWHERE if name not in scenes_by_name() | pbrt_scenes()]
