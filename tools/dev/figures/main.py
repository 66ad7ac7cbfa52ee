"""Renders the report's figures, or all scenes that are here, and writes them as one page;
tools/figures calls this."""

import argparse
import json
import pathlib
import shutil
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.append(str(ROOT / "tools" / "dev" / "shared"))  # what tools/bench uses too
TOOL = "tools/figures"
NAMES = ("figure_1", "figure_2", "figure_3", "figure_4", "figure_5", "encoded_average", "furnace",
         "course_scenes")
# Plots that docs/ shows, and their names there.
DOCS_PLOTS = {"encoded_average_ceiling": "encoded_average", "furnace": "brushed_metal_furnace"}


def parsed():
    from arguments import at_least
    parser = argparse.ArgumentParser(
        prog=TOOL,
        description="Renders the report's figures and writes them as one HTML page.")
    parser.add_argument("--out", type=pathlib.Path, metavar="DIR",
                        help="folder for index.html, figures.json, renders and plots (figures; "
                             "build/gallery for --gallery and --pbrt)")
    parser.add_argument("--quick", action="store_true",
                        help="smaller pictures and fewer samples: under 2 minutes on 2 cores")
    parser.add_argument("--docs", action="store_true",
                        help="also put the plots that docs/ shows into docs/images")
    parser.add_argument("--only", action="append", metavar="NAME", choices=NAMES,
                        help="make this one alone; may be given several times: " + ", ".join(NAMES))
    parser.add_argument("--gallery", action="store_true",
                        help="in their place all scenes that are here, with references beside them")
    parser.add_argument("--pbrt", action="store_true",
                        help="in their place the difference to pbrt-v4's pictures, as one picture")
    parser.add_argument("--spp", type=at_least(1), default=64, metavar="N",
                        help="of --gallery and --pbrt (64)")
    parser.add_argument("--size", type=at_least(1), metavar="N",
                        help="pixels of the longer side in --gallery (the reference's, else 192)")
    parser.add_argument("--scene", action="append", metavar="NAME",
                        help="of --gallery and --pbrt this one alone; may be given several times")
    parser.add_argument("--tiny", action="store_true", help=argparse.SUPPRESS)  # for the tests
    parser.add_argument("--program", type=pathlib.Path, help=argparse.SUPPRESS,
                        default=ROOT / "build" / "release" / "candela")
    return parser.parse_args()


def makers():
    """What makes each figure, in the order of the page."""
    import convergence
    import course_scenes
    import encoded_average
    import furnace
    import ray_tracing
    import scenes
    import strategies

    return {
        "figure_1": convergence.make,
        "figure_2": ray_tracing.overview,
        "figure_3": ray_tracing.colour_bleeding,
        "figure_4": ray_tracing.penumbra,
        "figure_5": strategies.make,
        "encoded_average": encoded_average.make,
        "furnace": furnace.make,
        "course_scenes": lambda shop: course_scenes.make(shop, scenes.course_scenes()),
    }


def figures_of(workshop, only):
    for name, make in makers().items():
        if only and name not in only:
            continue
        start = time.monotonic()
        yield make(workshop)
        print(f"tools/figures: {name}: {time.monotonic() - start:.1f} s", file=sys.stderr)


def run_on_scenes(options):
    """What is made of whole scenes: --gallery, --pbrt."""
    import gallery
    import pbrt_differences
    from page_parts import facts_of
    from renders import Candela

    out = (options.out or ROOT / "build" / "gallery").resolve()
    candela = Candela(options.program, out / "renders")
    if options.gallery:
        facts = facts_of(candela.version(), TOOL)
        print(gallery.make(candela, out, options, facts))
    if options.pbrt:
        picture = pbrt_differences.make(candela, out, options)
        if options.docs:
            shutil.copyfile(picture, ROOT / "docs" / "images" / picture.name)
        print(picture)


def run(options):
    from page import page
    from page_parts import facts_of
    from renders import Candela
    from scale import FULL, QUICK, TINY
    from workshop import Workshop

    start = time.monotonic()
    out = (options.out or pathlib.Path("figures")).resolve()
    candela = Candela(options.program, out / "renders")
    scale = TINY if options.tiny else QUICK if options.quick else FULL
    workshop = Workshop(candela, scale, out)
    record = facts_of(candela.version(), TOOL)
    record["figures"] = list(figures_of(workshop, options.only))
    record["seconds"] = round(time.monotonic() - start, 1)
    (out / "figures.json").write_text(json.dumps(record, indent=1, allow_nan=False) + "\n")
    (out / "index.html").write_text(page(out, record))
    if options.docs:
        made = [out / file for figure in record["figures"] for file, _ in figure["plots"]]
        for plot, name in DOCS_PLOTS.items():
            if workshop.plot(plot) in made:  # --only may leave it out
                shutil.copyfile(workshop.plot(plot), ROOT / "docs" / "images" / f"{name}.png")
    print(out / "index.html")


def main():
    options = parsed()
    try:
        import matplotlib  # noqa: F401
        import numpy  # noqa: F401
    except ImportError as missing:
        sys.exit(f"tools/figures: {missing}; expected Debian's python3-numpy and "
                 "python3-matplotlib, which `tools/setup --figures` installs.")
    from renders import CandelaFailed
    try:
        run_on_scenes(options) if options.gallery or options.pbrt else run(options)
    except (CandelaFailed, OSError) as problem:
        sys.exit(f"tools/figures: {problem}")


if __name__ == "__main__":
    main()
