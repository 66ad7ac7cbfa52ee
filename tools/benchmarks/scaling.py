"""How the cost of a render grows with threads, pixels, triangles and lights.

Costs are CPU seconds of rendering alone, medians over runs that take turns, and each growth is an
exponent fitted over all runs of a series. For triangles the cost of the same rays through bare calls
of Embree stands beside it (`--ray-limit`): a sample may grow no faster than its rays.
"""

import os

from fits import fit_power, spread
from generated import generated

ABOUT = "threads, image size, triangles, lights: fitted exponents"


def add_arguments(parser):
    parser.add_argument("--quick", action="store_true", help="short series, 2 runs each")
    parser.add_argument("--runs", type=int, help="of each point (5)")


def run(options):
    from renders import Candela
    from results import Results
    out = options.out.resolve()
    candela = Candela(options.program, out / "renders")
    results = Results(out, "Scaling", __doc__, candela.version())
    runs = options.runs or (2 if options.quick else 5)
    series = [threads(candela, out, runs, options.quick), pixels(candela, out, runs, options.quick),
              *(triangles(candela, out, shape, runs, options.quick) for shape in ("soup", "terrain")),
              lights(candela, out, runs, options.quick)]
    for name, title, rows, _ in series:
        results.table(name, title, rows)
    fitted = [fit for *_, fits in series for fit in fits]
    results.table("exponents", "Exponents (standard error)", fitted,
                  "1 for a cost in proportion, 0 for one that stays.")
    for name, title, rows, _ in series:
        for file, caption in plotted(out, name, title, rows):
            results.plot(file, caption)
    results.finish()


def in_turn(points, runs, measure):
    """{point: [measure(point, seed) by run]}: A B C A B C ..."""
    found = {point: [] for point in points}
    for seed in range(1, runs + 1):
        for point in points:
            found[point].append(measure(point, seed))
    return found


def fit(of, over, found, value):
    pairs = [(point, value(x)) for point, seen in found.items() for x in seen]
    return {"cost": of, "over": over, "exponent": str(fit_power(*zip(*pairs)))}


def median(seen, value):
    return spread(map(value, seen)).median


def threads(candela, out, runs, quick):
    """Wall time: the more threads the less; CPU time should stay as it is."""
    counts = [1]
    while counts[-1] * 2 <= len(os.sched_getaffinity(0)):
        counts.append(counts[-1] * 2)
    scene = generated(out, "terrain", triangles=100_000)
    size, spp = ("256x256", 8) if quick else ("512x512", 32)
    found = in_turn(counts, runs, lambda n, seed: candela.render(
        "threads", scene, png=False, size=size, spp=spp, seed=seed, threads=n))
    rows = []
    for n, seen in found.items():
        speed = spread(one.seconds / x.seconds for one, x in zip(found[1], seen))
        cpu = spread(x.cpu_seconds / one.cpu_seconds for one, x in zip(found[1], seen))
        rows.append({"threads": n, "times_faster": speed.median, "low": speed.low,
                     "high": speed.high, "cpu_ratio": cpu.median, "cpu_low": cpu.low,
                     "cpu_high": cpu.high})
    fits = [fit("wall seconds", "threads", found, lambda x: x.seconds)] if len(counts) > 1 else []
    return "threads", "Threads: wall time of one over that of n, run by run", rows, fits


def pixels(candela, out, runs, quick):
    scene = generated(out, "terrain", triangles=100_000)
    sides = (32, 64, 128) if quick else (32, 64, 128, 256, 512, 1024)
    found = in_turn([side ** 2 for side in sides], runs, lambda n, seed: candela.render(
        "pixels", scene, png=False, size=f"{round(n ** .5)}x{round(n ** .5)}", spp=16, seed=seed))
    rows = [{"pixels": n, "ns_a_sample": median(seen, lambda x: 1e9 * x.cpu_seconds / (16 * n))}
            for n, seen in found.items()]
    return ("pixels", "Image size, 16 spp", rows,
            [fit("CPU seconds", "pixels", found, lambda x: x.cpu_seconds)])


def triangles(candela, out, shape, runs, quick):
    powers = range(2, 5 if quick else 8)
    size = "128x128" if quick else "256x256"
    files = {10 ** power: generated(out, shape, triangles=10 ** power) for power in powers}
    found = in_turn(files, runs, lambda n, seed: candela.render(
        "triangles", files[n], png=False, size=size, spp=16, seed=seed,
        ray_limit=True).stats["ray_limit"])

    def ns_a_ray(key):
        return lambda limit: 1e9 * limit[key] / limit["rays"]

    render, alone = ns_a_ray("render_cpu_seconds"), ns_a_ray("rays_cpu_seconds")
    rows = [{"triangles": n, "ns_a_ray": median(seen, render),
             "ns_a_ray_alone": median(seen, alone),
             "ratio": median(seen, lambda x: x["render_cpu_seconds"] / x["rays_cpu_seconds"])}
            for n, seen in found.items()]
    return (f"triangles_{shape}", f"Triangles, {shape}", rows,
            [fit(f"render, a ray, {shape}", "triangles", found, render),
             fit(f"the same rays alone, {shape}", "triangles", found, alone)])


def lights(candela, out, runs, quick):
    """A sample's cost, and the stated error of so many samples."""
    counts = [10 ** power for power in range(1, 4 if quick else 6)]
    files = {n: generated(out, "lamps", lamps=n) for n in counts}
    found = in_turn(counts, runs, lambda n, seed: candela.render(
        "lights", files[n], png=False, size="128x96" if quick else "256x192", spp=16, seed=seed))

    def ns(x):
        return 1e9 * x.cpu_seconds / x.stats["rays"]["camera"]

    rows = [{"lamps": n, "ns_a_sample": median(seen, ns),
             "relmse_stated": median(seen, lambda x: x.stats["error"]["relmse"])}
            for n, seen in found.items()]
    return ("lights", "Lights", rows,
            [fit("a sample", "lamps", found, ns),
             fit("stated relMSE * CPU seconds, 16 spp", "lamps", found,
                 lambda x: x.stats["error"]["relmse"] * x.cpu_seconds)])


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
