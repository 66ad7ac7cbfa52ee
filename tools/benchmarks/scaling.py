"""How the cost of a render grows with threads, pixels, triangles and lights.

Costs are CPU seconds of rendering alone, medians over runs that take turns, and each growth is an
exponent fitted to the medians of a series; over triangles from 10^4 on. For these the cost of the
same rays through bare calls of Embree stands beside it (`--ray-limit`), and the ratio of a render
without packets, which gain the less the smaller triangles are. Fails where two threads are not
nearly twice as fast as one, or the ratio to bare calls grows beyond its 95 % interval.
"""

import functools
import math
import os

from arguments import at_least
from fits import fit_power, growth, spread
from generated import generated
from renders import square
from results import begin, status
from turns import in_turn

ABOUT = "threads, image size, triangles, lights: fitted exponents"
TWICE = 1.95  # times as fast with two threads, at least
SHAPES = ("soup", "terrain")
# Costs over triangles, by shape.
RENDER, ALONE, RATIO = "render, a ray, {}", "the same rays alone, {}", "render over these, {}"


def add_arguments(parser):
    parser.add_argument("--quick", action="store_true", help="short series, 2 runs each")
    parser.add_argument("--runs", type=at_least(1), help="of each point (5)")


def run(options):
    out, candela, results = begin(options, "Scaling", __doc__)
    seeds = range(1, 1 + (options.runs or (2 if options.quick else 5)))
    series = []
    for name, measure in {
            "threads": threads, "pixels": pixels,
            **{f"triangles of a {shape}": functools.partial(triangles, shape) for shape in SHAPES},
            "lights": lights}.items():
        with results.attempt(f"the series over {name}"):
            series.append(measure(candela, out, seeds, options.quick))
            results.table(*series[-1][:3])
    exponents = {cost: fit for *_, fits in series for cost, fit in fits.items()}
    results.table("exponents", "Exponents (standard error)",
                  [{"cost": cost, "over": name.split("_")[0], "exponent": str(fit)}
                   for name, _, _, fits in series for cost, fit in fits.items()],
                  "1 for a cost in proportion, 0 for one that stays.")
    thread_rows = next((rows for name, _, rows, _ in series if name == "threads"), [])
    judged = verdicts(thread_rows, exponents)
    results.table("verdicts", "What is wanted", judged)
    for name, title, rows, _ in series:
        for file, caption in plotted(out, name, title, rows):
            results.plot(file, caption)
    results.finish()
    return status(row["verdict"] for row in judged)


def verdicts(thread_rows, exponents):
    """`exponents`: Power by cost. What cannot be told is not judged: without two processors, and of
    too few points for an error. Render and bare calls are of one scene and not independent: it is
    their ratio's own exponent that tells."""
    rows = [{"what": "times as fast with two threads", "found": row["times_faster"],
             "plus_minus": None, "wanted": f"at least {TWICE}",
             "verdict": verdict(row["times_faster"] >= TWICE)}
            for row in thread_rows if row["threads"] == 2]
    for shape in (shape for shape in SHAPES if RATIO.format(shape) in exponents):
        more = exponents[RATIO.format(shape)]
        reach = more.plus_minus()
        rows.append({"what": f"a ray's exponent over its bare call's, {shape}",
                     "found": more.exponent, "plus_minus": reach, "wanted": "0, within that",
                     "verdict": "-" if math.isnan(reach) else verdict(more.exponent <= reach)})
    return rows


def verdict(is_met):
    return "met" if is_met else "missed"


def fit(found, value, fitted=fit_power):
    return fitted(list(found), [median(seen, value) for seen in found.values()])


def median(seen, value):
    return spread(map(value, seen)).median


def threads(candela, out, seeds, quick):
    """Wall time: the more threads the less; CPU time should stay as it is."""
    counts = [1]
    while counts[-1] * 2 <= len(os.sched_getaffinity(0)):
        counts.append(counts[-1] * 2)
    scene = generated(out, "terrain", triangles=100_000)
    size, spp = ("256x256", 8) if quick else ("512x512", 32)
    found = in_turn(counts, seeds, lambda n, seed: candela.render(
        "threads", scene, png=False, size=size, spp=spp, seed=seed, threads=n))
    rows = []
    for n, seen in found.items():
        speed = spread(one.seconds / x.seconds for one, x in zip(found[1], seen))
        cpu = spread(x.cpu_seconds / one.cpu_seconds for one, x in zip(found[1], seen))
        rows.append({"threads": n, "times_faster": speed.median, "low": speed.low,
                     "high": speed.high, "cpu_ratio": cpu.median, "cpu_low": cpu.low,
                     "cpu_high": cpu.high})
    fits = {"wall seconds": fit(found, lambda x: x.seconds)} if len(counts) > 1 else {}
    return "threads", "Threads: wall time of one over that of n, run by run", rows, fits


def pixels(candela, out, seeds, quick):
    scene = generated(out, "terrain", triangles=100_000)
    sides = (32, 64, 128) if quick else (32, 64, 128, 256, 512, 1024)
    found = in_turn([side ** 2 for side in sides], seeds, lambda n, seed: candela.render(
        "pixels", scene, png=False, size=square(round(n ** .5)), spp=16, seed=seed))
    rows = [{"pixels": n, "ns_a_sample": median(seen, lambda x: 1e9 * x.cpu_seconds / (16 * n))}
            for n, seen in found.items()]
    return ("pixels", "Image size, 16 spp", rows,
            {"CPU seconds": fit(found, lambda x: x.cpu_seconds)})


def triangles(shape, candela, out, seeds, quick):
    powers = range(2, 6 if quick else 8)
    size = "128x128" if quick else "256x256"
    files = {10 ** power: generated(out, shape, triangles=10 ** power) for power in powers}

    def limits(**options):
        return in_turn(files, seeds, lambda n, seed: candela.render(
            "triangles", files[n], png=False, size=size, spp=16, seed=seed, ray_limit=True,
            **options).stats["ray_limit"])

    def ratio(limit):
        return limit["render_cpu_seconds"] / limit["rays_cpu_seconds"]

    def ns_a_ray(key):
        return lambda limit: 1e9 * limit[key] / limit["rays"]

    found, unpacked = limits(), limits(without="packets")
    render, alone = ns_a_ray("render_cpu_seconds"), ns_a_ray("rays_cpu_seconds")
    rows = [{"triangles": n, "ns_a_ray": median(seen, render),
             "ns_a_ray_alone": median(seen, alone),
             "ratio": median(seen, ratio),
             "ratio_without_packets": median(unpacked[n], ratio)}
            for n, seen in found.items()]
    return (f"triangles_{shape}", f"Triangles, {shape}", rows,
            {RENDER.format(shape): fit(found, render, growth),
             ALONE.format(shape): fit(found, alone, growth),
             RATIO.format(shape): fit(found, ratio, growth)})


def lights(candela, out, seeds, quick):
    """A sample's cost, and the stated error of so many samples."""
    counts = [10 ** power for power in range(1, 4 if quick else 6)]
    files = {n: generated(out, "lamps", lamps=n) for n in counts}
    found = in_turn(counts, seeds, lambda n, seed: candela.render(
        "lights", files[n], png=False, size="128x96" if quick else "256x192", spp=16, seed=seed))

    def ns(x):
        return 1e9 * x.cpu_seconds / x.stats["rays"]["camera"]

    rows = [{"lamps": n, "ns_a_sample": median(seen, ns),
             "relmse_stated": median(seen, lambda x: x.stats["error"]["relmse"])}
            for n, seen in found.items()]
    return ("lights", "Lights", rows,
            {"a sample": fit(found, ns), "stated relMSE * CPU seconds, 16 spp": fit(
                found, lambda x: x.stats["error"]["relmse"] * x.cpu_seconds)})


def plotted(out, name, title, rows):
    import plots
    first, *others = rows[0]
    shown = [key for key in others if key.startswith(("ns_", "times_"))]
    if len(rows) < 2:
        return
    plots.power_plot(out / f"{name}.png",
                     [(key, [row[first] for row in rows], [row[key] for row in rows], {})
                      for key in shown], first, " / ".join(shown))
    yield f"{name}.png", title
