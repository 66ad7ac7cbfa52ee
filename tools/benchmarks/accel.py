"""Embree against the reference SAH BVH: building, memory, rays a second, and how they grow.

All figures are those of `candela bench SCENE --json`: rays of real paths through bare calls, by CPU
time of one thread. Growth is told by generated soups and terrains of 10^2 to 10^7 triangles: the
exponent of cost over triangles, fitted from 10^4 on, where a tree no longer fits into the nearest
cache.
"""

import chosen_scenes
from fits import fit_power, geometric_mean
from generated import generated

ABOUT = "Embree against the reference BVH: build, memory, rays a second, growth"
CLASSES = ("camera", "bounce", "shadow")
BACK_ENDS = ("embree", "bvh")
SHAPES = ("soup", "terrain")
GROWN_FROM = 10_000  # triangles


def add_arguments(parser):
    chosen_scenes.add_argument(parser)
    parser.add_argument("--quick", action="store_true",
                        help="generated ones up to 10^4 triangles, short measurements")
    parser.add_argument("--most", type=int, metavar="N", help="largest power of ten (7)")
    parser.add_argument("--seconds", type=float, metavar="S",
                        help="for each kind of rays (0.5)")


def run(options):
    from renders import Candela
    from results import Results
    out = options.out.resolve()
    candela = Candela(options.program, out / "renders")
    results = Results(out, "Embree and the reference BVH", __doc__, candela.version())
    seconds = options.seconds or (.05 if options.quick else .5)
    most = options.most or (4 if options.quick else 7)
    scenes = chosen_scenes.chosen(candela, out, options.scenes, chosen_scenes.names())
    rows = [row(candela, name, scene, seconds) for name, scene in scenes.items()]
    results.table("scenes", "Scenes", rows)
    for key in CLASSES:
        results.note(f"{key} rays, Embree's a second over the BVH's, geometric mean: "
                     f"{geometric_mean(r[f'embree_{key}'] / r[f'bvh_{key}'] for r in rows):.2f}")
    grown = [row(candela, f"{shape} 10^{power}",
                 generated(out, shape, triangles=10 ** power), seconds) | {"shape": shape}
             for shape in SHAPES for power in range(2, most + 1)]
    results.table("generated", "Generated scenes", grown)
    results.table("growth", "Exponents over triangles (standard error)", growth(grown))
    for file, caption in plotted(out, grown):
        results.plot(file, caption)
    disagreeing = sum(r["disagreeing"] for r in rows + grown)
    results.note(f"{disagreeing} of {sum(r['rays'] for r in rows + grown)} rays disagree")
    results.finish()


def row(candela, name, scene, seconds):
    """Mray/s of one thread."""
    found = candela.bench(scene, seconds=seconds)
    figures = {"scene": name, "triangles": found["triangles"]}
    for back_end in BACK_ENDS:
        of = found[back_end]
        figures |= {f"{back_end}_build_s": of["build_seconds"],
                    f"{back_end}_bytes_a_triangle": of["bytes"] / max(found["triangles"], 1)}
        figures |= {f"{back_end}_{key}": of["mrays_per_second_one_thread"][key] for key in CLASSES}
    figures |= {"rays": found["agreement"]["rays"], "disagreeing": found["agreement"]["disagreeing"]}
    print(f"{name}: {found['triangles']} triangles", flush=True)
    return figures


def growth(rows):
    """A line a shape and figure, a column a back end."""
    lines = []
    for shape in SHAPES:
        own = [r for r in rows if r["shape"] == shape and r["triangles"] >= .9 * GROWN_FROM]
        own = own if len(own) > 1 else [r for r in rows if r["shape"] == shape]
        triangles = [r["triangles"] for r in own]
        for figure in ("build_s", *CLASSES):
            if not all(r[f"{b}_{figure}"] > 0 for r in own for b in BACK_ENDS):
                continue  # nothing was lit: no shadow rays
            line = {"shape": shape, "cost": "build" if figure == "build_s" else f"{figure} ray"}
            for back_end in BACK_ENDS:
                values = [r[f"{back_end}_{figure}"] for r in own]
                costs = values if figure == "build_s" else [1 / v for v in values]
                line[back_end] = str(fit_power(triangles, costs))
            lines.append(line)
    return lines


def plotted(out, rows):
    import plots
    styles = {"embree": {"color": "C0"}, "bvh": {"color": "C1"}}
    for shape in SHAPES:
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
              for back_end in BACK_ENDS for shape, line in zip(SHAPES, ("-", "--"))]
    plots.power_plot(out / "build.png", curves, "triangles", "seconds of building")
    yield "build.png", "building, all threads"
