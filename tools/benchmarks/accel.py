"""Embree against the reference SAH BVH: building, memory, rays a second, and how they grow.

All figures are those of `candela bench SCENE --json`: rays of real paths through bare calls, by CPU
time of one thread, medians of rounds of both in turn; `ratio` is how many times as many rays a
second Embree traces, its median and range. build_s is wall time of all threads. Growth is told by
generated soups and terrains of 10^2 to 10^7 triangles: the exponent of cost over triangles, fitted
from 10^4 on, where a tree no longer fits into the nearest cache. Fails where the two answer any ray
differently.
"""

import itertools

import chosen_scenes
from arguments import above_zero, at_least
from fits import geometric_mean, growth
from generated import generated
from results import FAILED, begin

ABOUT = "Embree against the reference BVH: build, memory, rays a second, growth"
CLASSES = ("camera", "bounce", "shadow")
BACK_ENDS = ("embree", "bvh")
SHAPES = ("soup", "terrain")


def add_arguments(parser):
    chosen_scenes.add_argument(parser)
    parser.add_argument("--quick", action="store_true",
                        help="generated ones up to 10^4 triangles, short measurements")
    parser.add_argument("--most", type=at_least(3), metavar="N", help="largest power of ten (7)")
    parser.add_argument("--seconds", type=above_zero, metavar="S",
                        help="for each kind of rays (0.5)")


def run(options):
    out, candela, results = begin(options, "Embree and the reference BVH", __doc__)
    seconds = options.seconds or (.05 if options.quick else .5)
    most = options.most or (4 if options.quick else 7)
    scenes = chosen_scenes.chosen(candela, out, options.scenes, chosen_scenes.names(),
                                  results.note)
    rows = []
    for name, scene in scenes.items():
        with results.attempt(name):
            rows.append(row(candela, name, scene, seconds))
            results.keep("scenes", rows)
    results.table("scenes", "Scenes", rows)
    tell_means(results, rows)
    grown = []
    for shape, power in itertools.product(SHAPES, range(2, most + 1)):
        name = f"{shape} 10^{power}"
        with results.attempt(name):
            scene = generated(out, shape, triangles=10 ** power)
            grown.append(row(candela, name, scene, seconds) | {"shape": shape})
            results.keep("generated", grown)
    results.table("generated", "Generated scenes", grown)
    results.table("growth", "Exponents over triangles (standard error)", exponents(grown))
    for file, caption in plotted(out, grown):
        results.plot(file, caption)
    disagreeing = sum(r["disagreeing"] for r in rows + grown)
    results.note(f"{disagreeing} of {sum(r['rays'] for r in rows + grown)} rays disagree")
    results.finish()
    return FAILED if disagreeing or not rows + grown else 0


def tell_means(results, rows):
    for key in CLASSES:
        traced = [r for r in rows if r[f"{key}_ratio"] > 0]  # some are unlit
        if traced:
            mean = geometric_mean(r[f"{key}_ratio"] for r in traced)
            results.note(f"{key} rays, Embree's a second over the BVH's, geometric mean of "
                         f"{len(traced)} scenes: {mean:.2f}")


def row(candela, name, scene, seconds):
    """Mray/s of one thread."""
    found = candela.bench(scene, seconds=seconds)
    figures = {"scene": name, "triangles": found["triangles"]}
    for back_end in BACK_ENDS:
        of = found[back_end]
        figures |= {f"{back_end}_build_s": of["build_seconds"],
                    f"{back_end}_bytes_a_triangle": of["bytes"] / max(found["triangles"], 1)}
        figures |= {f"{back_end}_{key}": of["mrays_per_second_one_thread"][key] for key in CLASSES}
    for key in CLASSES:
        ratio = found["embree_over_bvh"][key]
        figures |= {f"{key}_ratio": ratio["median"], f"{key}_ratio_low": ratio["least"],
                    f"{key}_ratio_high": ratio["most"]}
    figures |= {key: found["agreement"][key] for key in ("rays", "disagreeing")}
    print(f"{name}: {found['triangles']} triangles", flush=True)
    return figures


# What grows, and how it follows from a row's figure.
COSTS = {"build": ("build_s", lambda seconds, _: seconds),
         "bytes": ("bytes_a_triangle", lambda bytes_, triangles: bytes_ * triangles)
         } | {f"{key} ray": (key, lambda mrays, _: 1 / mrays) for key in CLASSES}


def exponents(rows):
    """A line a shape and cost, a column a back end."""
    lines = []
    for shape in SHAPES:
        own = [r for r in rows if r["shape"] == shape]
        triangles = [r["triangles"] for r in own]
        for cost, (figure, of) in COSTS.items() if len(own) > 1 else ():
            if not all(r[f"{b}_{figure}"] > 0 for r in own for b in BACK_ENDS):
                continue  # nothing was lit: no shadow rays
            lines.append({"shape": shape, "cost": cost} | {
                b: str(growth(triangles, [of(r[f"{b}_{figure}"], r["triangles"]) for r in own]))
                for b in BACK_ENDS})
    return lines


def plotted(out, rows):
    import plots
    styles = {"embree": {"color": "C0"}, "bvh": {"color": "C1"}}
    shapes = [shape for shape in SHAPES if any(r["shape"] == shape for r in rows)]
    for shape in shapes:
        own = [r for r in rows if r["shape"] == shape]
        x = [r["triangles"] for r in own]
        curves = [(f"{back_end}, {key}", x, [r[f"{back_end}_{key}"] for r in own],
                   styles[back_end] | {"linestyle": line})
                  for back_end in BACK_ENDS for key, line in zip(CLASSES, ("-", "--", ":"))]
        plots.power_plot(out / f"rays_{shape}.png", curves, "triangles", "Mray/s, one thread")
        yield f"rays_{shape}.png", f"rays a second, {shape}"
    curves = [(f"{back_end}, {shape}", [r["triangles"] for r in rows if r["shape"] == shape],
               [max(r[f"{back_end}_build_s"], 1e-5) for r in rows if r["shape"] == shape],
               styles[back_end] | {"linestyle": line})
              for back_end in BACK_ENDS for shape, line in zip(shapes, ("-", "--"))]
    if curves:
        plots.power_plot(out / "build.png", curves, "triangles", "seconds of building")
        yield "build.png", "building, all threads"
