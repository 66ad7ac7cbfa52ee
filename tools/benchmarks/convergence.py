"""relMSE against CPU seconds and against samples a pixel, for each way of sampling and each option.

Every curve is measured against a long reference of the same size and box filter, of seeds that no
picture has, made once and kept. Points are medians over seeds; runs of all curves take turns. Other
strategies, splitting and guiding have no walks that choose a roulette, and share no paths: these
curves are to be compared with that whose roulette is theirs, from 1/2 on, and which shares none.
"""

import chosen_scenes
import truth
from ablation import PLAIN_PATHS
from arguments import at_least
from fits import fit_power, x_where
from processes import first_line
from renders import CandelaFailed, square
from results import begin, status_of_rows
from turns import in_turn

ABOUT = "relMSE against seconds and samples, by sampling and option"
# A curve is one line here. What a scene does not allow (only BSDF samples under a point light) is
# left out with candela's own words.
CURVES = {
    "path": {},
    "path, not adaptive": {"adaptive": "off"},
    "path, balance heuristic": PLAIN_PATHS | {"heuristic": "balance"},
    "path, light samples": PLAIN_PATHS | {"sampling": "light"},
    "path, BSDF samples": PLAIN_PATHS | {"sampling": "bsdf"},
    "path, cosine": PLAIN_PATHS | {"sampling": "cosine"},
    "path, uniform": PLAIN_PATHS | {"sampling": "uniform"},
    "path, split by four": PLAIN_PATHS | {"splitting": 4},
    "path, guided": PLAIN_PATHS | {"guiding": "on"},
    "path, guided by a trial": PLAIN_PATHS | {"guiding": "auto"},
    "path, 1 replicate": {"replicates": 1, "adaptive": "on"},
    "path, plain random numbers": {"sampler": "independent"},
    "path, padded points": {"sampler": "padded"},
    "path, no rays at lamps' edges": {"lamp_rays": 0},
    "path, lights by power": {"light_cells": "off"},
    "path, lamps by solid angle": {"light_sampling": "solid_angle"},
    "path, samples of constant skies": {"sky_samples": "on"},
    "path, skies as they are": {"sky_compensation": "off"},
    "path, nothing shared": {"reuse": "off"},
    "path, roulette from 1/2 on, nothing shared": PLAIN_PATHS,
    "path, not robust": {"robust": "off"},
    "report": {"integrator": "report"},
}
GOALS = (1e-2, 1e-3)


def add_arguments(parser):
    chosen_scenes.add_argument(parser, "the shipped YAML files and the generated ones")
    parser.add_argument("--quick", action="store_true", help="48x48, 4 and 16 spp, 2 seeds")
    parser.add_argument("--seeds", type=at_least(1), help="pictures a point (5)")
    parser.add_argument("--size", type=at_least(1), metavar="N", help="pixels a side (96)")
    parser.add_argument("--most", type=at_least(4), metavar="SPP",
                        help="samples of the last point (256)")
    parser.add_argument("--curve", action="append", choices=CURVES, metavar="NAME",
                        help="only this one; may be given several times: " + "; ".join(CURVES))
    parser.add_argument("--threads", type=at_least(1), default=1,
                        help="of the measured pictures (1)")


def run(options):
    out, candela, results = begin(options, "Convergence", __doc__)
    size = options.size or (48 if options.quick else 96)
    most = options.most or (16 if options.quick else 256)
    seeds = range(1, 1 + (options.seeds or (2 if options.quick else 5)))
    counts = counts_to(most)
    curves = {name: CURVES[name] for name in options.curve or CURVES}
    scenes = chosen_scenes.chosen(candela, out, options.scenes, chosen_scenes.own_names(),
                                  results.note)
    rows, ends = [], []
    for name, scene in scenes.items():
        with results.attempt(name):
            right = truth.reference_for(candela, name, scene, size, 16 * most, spp=most,
                                        threads=options.threads)
            allowed = [c for c in curves if is_allowed(results, candela, name, scene, c)]
            common = {"size": square(size), "threads": options.threads}
            own = points(candela, name, scene, right, allowed, counts, seeds, common)
            rows += own
            results.keep("convergence", rows)
            ends += [end_of(name, curve, [r for r in own if r["curve"] == curve], right)
                     for curve in allowed]
            for file, caption in plotted(out, name, allowed, own):
                results.plot(file, caption)
            print(f"{name}: {len(own)} points", flush=True)
    results.table("convergence", f"All points, {square(size)}, {len(seeds)} seeds", rows)
    results.table("goals", "CPU seconds to a relMSE, where the curve gets there; exponent of "
                  "relMSE over samples, with its standard error", ends,
                  "-1 for independent samples. beside: the curve to compare with.")
    results.finish()
    return status_of_rows(rows)


def counts_to(most):
    """Of samples a pixel, each four times the one before."""
    return [4 ** power for power in range(1, 10) if 4 ** power <= most]


def is_allowed(results, candela, name, scene, curve):
    try:
        candela.render("allowed", scene, png=False, size="4x4", spp=1, **CURVES[curve])
        return True
    except CandelaFailed as reason:
        results.note(f"{name}, {curve}: left out. {first_line(reason)}")
        return False


def points(candela, name, scene, right, curves, counts, seeds, common):
    """Rows, by count and curve."""
    rows = []
    for spp in counts:
        found = in_turn(curves, seeds, lambda curve, seed: truth.measured(
            candela, scene, right, spp=spp, seed=seed, **common, **CURVES[curve]))
        rows += [{"scene": name, "curve": curve, "spp": spp} | truth.summary(runs, right)
                 for curve, runs in found.items()]
    return rows


def compared_with(curve):
    """The curve that differs from this one in one thing alone."""
    plain = next(name for name, options in CURVES.items() if options == PLAIN_PATHS)
    if curve == plain:
        return "path, nothing shared"
    return plain if "roulette" in CURVES[curve] else "path"


def end_of(name, curve, rows, right):
    """`rows`: the curve's points."""
    seconds, relmse = ([row[key] for row in rows] for key in ("cpu_s", "relmse"))
    positive = [(row["spp"], row["relmse"]) for row in rows if row["relmse"] > 0]
    fit = fit_power(*zip(*positive)) if len(positive) > 1 else None
    line = {"scene": name, "curve": curve, "beside": compared_with(curve),
            "points": len(positive), "exponent": fit and fit.exponent,
            "exponent_error": fit and fit.error}
    for goal in GOALS:
        line |= {f"s_to_{goal:g}": x_where(goal, seconds, relmse),
                 f"reference_{goal:g}": truth.judged(right, [goal])}
    return line | {"relmse_cpu_s": rows[-1]["relmse_cpu_s"], "reference": rows[-1]["reference"]}


def plotted(out, name, curves, rows):
    import plots
    for key, label in (("cpu_s", "CPU seconds"), ("spp", "samples a pixel")):
        lines = []
        for curve in curves:
            own = [row for row in rows if row["curve"] == curve and row["relmse"] > 0]
            y = [row["relmse"] for row in own]
            # A seed that is lost in the reference's noise reaches down to the plot's edge.
            lines.append((curve, [row[key] for row in own], y, {},
                          [[a - max(row["relmse_low"], a / 100) for a, row in zip(y, own)],
                           [row["relmse_high"] - a for a, row in zip(y, own)]]))
        if not any(y for _, _, y, *_ in lines):
            continue
        file = f"{chosen_scenes.safe(name)}_{key}.png"
        plots.power_plot(out / file, lines, label, "relMSE")
        yield file, f"{name}: relMSE against {label}"
