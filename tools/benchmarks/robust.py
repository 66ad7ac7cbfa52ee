"""What Embree's robust mode costs: rays a second of CPU time, through bare calls, with and without it,
on the rays of real paths; alternating runs of one program."""

import json
import pathlib
import statistics

import renders
import scenes

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


def spread(values):
    return f"{statistics.median(values):.2f} ({min(values):.2f}-{max(values):.2f})"


def measure(candela, name, scene, options):
    """A table's row: ratios on / off, each pair one after the other."""
    ratios = {"time a ray": [], "build": [], "render": []}
    for _ in range(options.pairs):
        off = seconds_of(candela, scene, "off", options.spp)
        on = seconds_of(candela, scene, "on", options.spp)
        for figure, a, b in zip(ratios, on, off):
            ratios[figure].append(a / b)
    print(f"| {name} | " + " | ".join(spread(values) for values in ratios.values()) + " |",
          flush=True)
    return {"scene": name} | ratios


def run(options):
    found = scenes.scenes_by_name(ROOT)
    chosen = options.scene or ["cornell_box"] + [name for name in found if name.startswith("lab3/")]
    candela = renders.Candela(options.program, options.out)
    print("| scene | time a ray, on / off | build | render |\n| --- | ---: | ---: | ---: |")
    rows = [measure(candela, name, found[name], options) for name in chosen]
    (options.out / "robust.json").write_text(json.dumps(rows, indent=1))
