"""Writes scenes to measure with; tools/scene_gen calls this. Every scene is a module of its own
here: see generate.py."""

import argparse
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))  # for the package scene_gen


def arguments(generate):
    parser = argparse.ArgumentParser(prog="tools/scene_gen",
                                     description="Writes a scene to measure with.")
    scenes = parser.add_subparsers(required=True, metavar="SCENE", dest="scene")
    for name in generate.NAMES:
        module = generate.module_of(name)
        about = module.__doc__.splitlines()[0].rstrip(".")
        scene = scenes.add_parser(name, help=about, description=about)
        scene.add_argument("--out", type=pathlib.Path, metavar="DIR",
                           default=pathlib.Path("bench") / "scenes" / name,
                           help=f"folder for {name}.yaml and its meshes (bench/scenes/{name})")
        scene.add_argument("--seed", type=int, default=0, help="of all that is random (0)")
        for parameter, (default, meaning) in module.PARAMETERS.items():
            scene.add_argument("--" + parameter.replace("_", "-"), type=type(default),
                               default=default, help=f"{meaning} ({default})")
    if len(sys.argv) == 1:
        for scene in scenes.choices.values():
            print(scene.format_help())
        sys.exit()
    return vars(parser.parse_args())


def main():
    try:
        from scene_gen import generate
    except ImportError as missing:
        sys.exit(f"tools/scene_gen: {missing}; expected Debian's python3-numpy, which "
                 "`tools/setup --figures` installs.")
    options = arguments(generate)
    try:
        print(generate.generate(options.pop("scene"), options.pop("out"), **options))
    except (OSError, ValueError, MemoryError) as problem:
        sys.exit(f"tools/scene_gen: {problem}")


if __name__ == "__main__":
    main()
