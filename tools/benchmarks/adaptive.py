"""What adaptive sampling gains: relMSE and time with it over those without, alternating.

error_gain is the ratio of relMSE, off over on, with twice its standard error; efficiency the time
to the same error without over with, by the rate at which the error falls from as many samples to
twice as many: what adaptive sampling gains lies there.
"""

import math
import statistics

import chosen_scenes
import truth
from chosen_scenes import safe
from fits import error_rate, geometric_mean, ratio_of_errors, times_to_same_error, with_factor
from references import layers, reference, square

ABOUT = "what adaptive sampling gains: error and CPU time with it over those without"

REFERENCE_FACTOR = 32  # samples over those of the largest count
AOVS = "variance,heavy_tail"


def add_arguments(parser):
    chosen_scenes.add_argument(parser)
    parser.add_argument("--seeds", type=int, default=6, help="pictures a case (6)")
    parser.add_argument("--size", type=int, default=96, help="pixels a side (96)")
    parser.add_argument("--spp", default="128,512", help="counts, by comma (128,512)")


def measure(candela, path, right, size, spp, seeds):
    """Of adaptive sampling off, on, and off with twice the samples: true relMSE, stated relMSE and
    CPU seconds of each seed."""
    ways = {"off": (spp, "off"), "on": (spp, "on"), "twice": (2 * spp, "off")}
    found = {way: [] for way in ways}
    for seed in range(1, seeds + 1):
        for way, (samples, switch) in ways.items():
            render = candela.render("picture", path, png=False, integrator="path",
                                    size=square(size), spp=samples, seed=seed, threads=1,
                                    filter="box", adaptive=switch, aov=AOVS)
            found[way].append((right.relmse(layers(render)[0]), render.stats["error"]["relmse"],
                               render.stats["cpu_seconds"]["render"]))
    return {way: list(zip(*rows)) for way, rows in found.items()}


def mean_of_pairs(above, below):
    """The geometric mean of the ratios, seed by seed, and twice its standard error."""
    mean, factor = with_factor(map(ratio_of_errors, above, below))
    return mean, mean * math.log(factor)


def row_of(name, spp, found, right):
    true_off, _, seconds_off = found["off"]
    true_on, stated_on, seconds_on = found["on"]
    true_twice, _, seconds_twice = found["twice"]
    error_gain, spread = mean_of_pairs(true_off, true_on)
    time_ratio, _ = mean_of_pairs(seconds_on, seconds_off)
    rate = error_rate(mean_of_pairs(true_off, true_twice)[0],
                      mean_of_pairs(seconds_twice, seconds_off)[0])
    return {"scene": name, "spp": spp, "error_gain": error_gain, "plus_minus": spread,
            "time_ratio": time_ratio, "rate": rate,
            "efficiency": 1 / times_to_same_error(time_ratio, 1 / error_gain, rate),
            "stated_over_true": statistics.mean(stated_on) / statistics.mean(true_on),
            "reference": truth.judged(right, true_off, true_on, true_twice)}


def run(options):
    from renders import Candela
    from results import Results
    out = options.out.resolve()
    candela = Candela(options.program, out / "renders")
    results = Results(out, "Adaptive sampling", __doc__, candela.version())
    counts = [int(n) for n in options.spp.split(",")]
    rows = []
    scenes = chosen_scenes.chosen(candela, out, options.scenes, chosen_scenes.names(), results.note)
    for name, path in scenes.items():
        spp = REFERENCE_FACTOR * max(counts)
        right = reference(candela, f"reference_{safe(name)}_{options.size}_{spp}", path,
                          integrator="path", size=square(options.size), spp=spp, filter="box")
        for spp in counts:
            rows.append(row_of(name, spp, measure(candela, path, right, options.size, spp,
                                                  options.seeds), right))
            print(f"{name}, {spp} spp: {rows[-1]['efficiency']:.2f}", flush=True)
    results.table("adaptive", f"{options.size}x{options.size}, {options.seeds} seeds", rows)
    found = [row["efficiency"] for row in rows if row["efficiency"] > 0]
    if found:
        results.note(f"geometric mean of the efficiency: {geometric_mean(found):.2f}")
    results.finish()
