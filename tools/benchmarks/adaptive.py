"""What adaptive sampling gains: pictures with it and without, alternating.

error_gain is the ratio of relMSE, off over on; time_ratio that of CPU time, on over off; efficiency
the time to the same error without over with, by the rate at which the error falls from as many
samples to twice as many: what adaptive sampling gains lies there. Each seed tells such ratios of
its own: of them the geometric mean, with half of the 95 % interval of its logarithm (plus_minus,
low and high), in which the rate's own error is.
"""

import math
import statistics

import chosen_scenes
import truth
from arguments import at_least, numbers
from fits import geometric_mean, ratio_of_errors, with_factor
from renders import square
from results import begin, status_of_rows
from turns import in_turn

ABOUT = "what adaptive sampling gains: error and CPU time with it and without"

REFERENCE_FACTOR = 32  # samples over those of the largest count


def add_arguments(parser):
    chosen_scenes.add_argument(parser)
    parser.add_argument("--seeds", type=at_least(1), default=6, help="pictures a case (6)")
    parser.add_argument("--size", type=at_least(1), default=96, help="pixels a side (96)")
    parser.add_argument("--spp", type=numbers(1), default=(128, 512), metavar="LIST",
                        help="counts, by comma (128,512)")
    parser.add_argument("--replicates", type=at_least(1), default=4, metavar="N",
                        help="of all pictures; one states no error (4)")


def measure(candela, path, right, spp, options):
    """Runs with adaptive sampling off, on, and off with twice the samples, by seed."""
    ways = {"off": (spp, "off"), "on": (spp, "on"), "twice": (2 * spp, "off")}

    def run_of(way, seed):
        samples, switch = ways[way]
        return truth.measured(candela, path, right, integrator="path", size=square(options.size),
                              spp=samples, seed=seed, threads=1, adaptive=switch,
                              replicates=options.replicates)

    return in_turn(ways, range(1, options.seeds + 1), run_of)


def compared(off, on, twice):
    """Runs by seed."""
    gains = [ratio_of_errors(a.relmse, b.relmse) for a, b in zip(off, on)]
    times = [a.cpu_seconds / b.cpu_seconds for a, b in zip(off, on)]
    (gain, gain_factor), (time, _) = map(with_factor, (gains, times))
    efficiency, factor = truth.time_to_same_error(times, gains, off, twice)
    return {"error_gain": gain, "plus_minus": math.log(gain_factor), "time_ratio": 1 / time,
            "rate": truth.rate_of_runs(off, twice), "efficiency": efficiency,
            "low": efficiency / factor, "high": efficiency * factor}


def stated_over_true(runs):
    """None where no error is stated."""
    if any(run.stats["error"] is None for run in runs):
        return None
    return ratio_of_errors(statistics.fmean(run.stats["error"]["relmse"] for run in runs),
                           statistics.fmean(run.relmse for run in runs))


def row_of(name, spp, found, right):
    return ({"scene": name, "spp": spp} | compared(**found)
            | {"stated_over_true": stated_over_true(found["on"]),
               "reference": truth.judged(right, *([run.relmse for run in runs]
                                                  for runs in found.values()))})


def run(options):
    out, candela, results = begin(options, "Adaptive sampling", __doc__)
    rows = []
    scenes = chosen_scenes.chosen(candela, out, options.scenes, chosen_scenes.names(), results.note)
    for name, path in scenes.items():
        with results.attempt(name):
            most = max(options.spp)
            right = truth.reference_for(candela, name, path, options.size, REFERENCE_FACTOR * most,
                                        spp=2 * most, threads=1, replicates=options.replicates)
            for spp in options.spp:
                with results.attempt(f"{name} at {spp} spp"):
                    found = measure(candela, path, right, spp, options)
                    truth.ladder(found.get, ("off", "twice"))  # or else no rate is told
                    rows.append(row_of(name, spp, found, right))
                    print(f"{name}, {spp} spp: {rows[-1]['efficiency']:.2f}", flush=True)
            results.keep("adaptive", rows)
    results.table("adaptive", f"{square(options.size)}, {options.seeds} seeds", rows)
    found = truth.counted(rows, ("efficiency",), results.note)
    if found:
        results.note(f"geometric mean of the efficiency of {len(found)} rows: "
                     f"{geometric_mean(row['efficiency'] for row in found):.2f}")
    results.finish()
    return status_of_rows(rows)
