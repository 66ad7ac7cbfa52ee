"""What Embree's robust mode costs: time with it over that without, median and range of alternating
runs of one program. ray: CPU time of a ray of real paths through bare calls; build and render: wall
time."""

import pathlib

import renders
import scenes
from fits import spread

ABOUT = "what Embree's robust mode costs, in rays a second and in render time"

ROOT = pathlib.Path(__file__).resolve().parents[2]


def add_arguments(parser):
    parser.add_argument("--scene", action="append", metavar="NAME",
                        help="a scene by its name, e.g. lab3/white_oak; may be given several times "
                        "(cornell_box and the course's)")
    parser.add_argument("--pairs", type=int, default=5, help="runs of each mode (5)")
    parser.add_argument("--spp", type=int, default=16)


def seconds_of(candela, scene, robust, spp):
    """CPU seconds a ray, and wall seconds of building and of rendering."""
    render = candela.render(f"robust_{robust}", scene, robust=robust, spp=spp, size="256x256",
                            ray_limit=True)
    limit = render.stats["ray_limit"]
    return (limit["rays_cpu_seconds"] / limit["rays"], render.stats["seconds"]["build"],
            render.seconds)


def row(candela, name, scene, options):
    """Ratios on / off, each pair one after the other."""
    pairs = [[seconds_of(candela, scene, robust, options.spp) for robust in ("off", "on")]
             for _ in range(options.pairs)]
    found = {"scene": name}
    for figure, *values in zip(("ray", "build", "render"), *(zip(off, on) for off, on in pairs)):
        of = spread(on / off for off, on in values)
        found |= {figure: of.median, f"{figure}_low": of.low, f"{figure}_high": of.high}
    print(f"{name}: {found['ray']:.2f}", flush=True)
    return found


def run(options):
    from results import Results
    found = scenes.scenes_by_name(ROOT)
    chosen = options.scene or ["cornell_box"] + [name for name in found if name.startswith("lab3/")]
    out = options.out.resolve()
    candela = renders.Candela(options.program, out / "renders")
    results = Results(out, "Robust mode", __doc__, candela.version())
    results.table("robust", f"On over off, {options.pairs} pairs",
                  [row(candela, name, found[name], options) for name in chosen])
    results.finish()
