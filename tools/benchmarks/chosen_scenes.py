"""Which scenes to measure with: of the shipped ones, those from elsewhere that are present, and
generated ones."""

from generated import generated
from processes import first_line
from renders import CandelaFailed
from scenes import (ROOT, absent_scenes, pbrt_scenes, scenes_by_name, shared_folder,
                    shipped_pbrt_scenes)

# Of closed forms (cycles.py). Which measurement takes which: docs/benchmarks.md.
ANALYTIC = {name: ROOT / f"tools/benchmarks/blender/scenes/{name}.yaml"
            for name in ("point_lit", "sun_lit", "environment_lit")}
GENERATED = ("attic", "door_ajar", "forest", "glass_and_mirrors", "lamps", "mis_plates",
             "white_room", "window")
LARGELY_CONVERGED = "shed"  # measured where it is asked for, too


def present():
    return scenes_by_name() | pbrt_scenes()


def all_names():
    return [*names(), f"gen/{LARGELY_CONVERGED}", *ANALYTIC, *shipped_pbrt_scenes()]


def names():
    return [*present(), *(f"gen/{name}" for name in GENERATED)]


def own_names():
    """Of the shipped and the generated scenes."""
    return [name for name in names() if not name.startswith(("lab3/", "pbrt/"))]


def add_argument(parser, default="all but " + ", ".join(
        [f"gen/{LARGELY_CONVERGED}", *ANALYTIC, "shipped pbrt files"])):
    parser.add_argument("scenes", nargs="*", metavar="SCENE",
                        help=f"names ({default}); gen/NAME is what tools/scene_gen NAME writes: "
                        + ", ".join(all_names()).replace("%", "%%"))


def chosen(candela, out, wanted, default, tell=print):
    """Name -> file. What is absent of all scenes, and what candela cannot read, is left out with a
    word."""
    found = present() | ANALYTIC | shipped_pbrt_scenes()
    files = {}
    if not wanted and set(names()) <= set(default):
        tell_absent(tell)
    for name in wanted or default:
        if name.startswith("gen/") and name[4:] in (*GENERATED, LARGELY_CONVERGED):
            files[name] = generated(out, name[4:])
        elif name in found:
            files[name] = found[name]
        elif wanted:
            raise CandelaFailed(f"no scene '{name}'; expected one of " + ", ".join(all_names()))
    return {name: file for name, file in files.items() if is_read(candela, name, file, tell)}


def tell_absent(tell):
    absent = absent_scenes()
    if absent:
        tell(f"not in {shared_folder()}, and left out: {', '.join(absent)}")


def is_read(candela, name, file, tell):
    try:
        candela.info(file)
        return True
    except CandelaFailed as reason:
        tell(f"{name} is left out: {first_line(reason)}")
        return False


def safe(name):
    return name.replace("/", "_")
