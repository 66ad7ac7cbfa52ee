"""Long references, made once, and how far measured pictures are from them.

relMSE = mean over pixels and channels of (x - r)^2 / (r^2 + 1e-2 mean(r)^2), without the
reference's own noise, which its replicates tell; it should be below 1/20 of what is claimed with
it.
"""

import dataclasses
import statistics
from math import log, nan

import references
from chosen_scenes import safe
from fits import error_rate, jackknifed, ratio_of_errors, spread, times_to_same_error
from processes import ProgramFailed
from renders import square

TRIMMED = 1e-3  # of the pixels, the worst
NOISE_ALLOWED = 1 / 20
# How many times as long a reference may become where it is too noisy for the pictures.
LONGER = (1, 4, 16)
MARGIN = 1.5  # below a picture's error: another way's, or another seed's, may be as much smaller


def reference(candela, name, scene, size, spp, **options):
    return references.reference(candela, f"reference_{safe(name)}_{size}_{spp}", scene,
                                size=square(size), spp=spp, replicates=16, filter="box",
                                **options)


def reference_for(candela, name, scene, size, least, **options):
    """One of `least` samples, or of more, until it is good enough for pictures by these options."""
    def is_good(right):
        run = measured(candela, scene, right, size=square(size), **options)
        return judged(right, [run.relmse / MARGIN]) == "good"

    return references.long_enough(
        lambda longer: reference(candela, name, scene, size, longer * least), LONGER, is_good)


def trimmed(truth, image):
    """relMSE without the pixels that are seen to be the worst."""
    seen = ((image - truth.image) ** 2 * truth.weight).mean(axis=2).ravel()
    kept = seen.argsort()[:seen.size - round(seen.size * TRIMMED)]
    return float(truth.errors(image).mean(axis=2).ravel()[kept].mean())


@dataclasses.dataclass
class Run:
    """One picture of one seed."""
    relmse: float
    trimmed: float
    cpu_seconds: float
    seconds: float
    spp: float
    mean_ratio: float = nan  # of the picture's mean to the reference's
    built_cpu_seconds: float = nan  # cpu_seconds with making the scene and its trees
    stats: dict = dataclasses.field(default_factory=dict)  # candela's own, where it is candela's


def measured(candela, scene, truth, **options):
    """Without a truth (None) only the times count, and errors are nan."""
    from exr import read_exr
    render = candela.render("measured", scene, png=False, filter="box", **options)
    times = render.cpu_seconds, render.seconds, render.spp
    run = Run(nan, nan, *times) if truth is None else run_of(read_exr(render.exr), truth, *times)
    return dataclasses.replace(run, built_cpu_seconds=render.built_cpu_seconds, stats=render.stats)


def run_of(image, truth, cpu_seconds, seconds, spp):
    return Run(truth.relmse(image), trimmed(truth, image), cpu_seconds, seconds, spp,
               float(image.mean() / truth.image.mean()))


def rate_of_runs(fewer, more):
    """With which relMSE falls over CPU time, from runs of few and of more samples; nan where an
    error is lost in the reference's noise."""
    mean = statistics.fmean
    return error_rate(ratio_of_errors(*(mean(r.relmse for r in runs) for runs in (fewer, more))),
                      mean(r.cpu_seconds for r in more) / mean(r.cpu_seconds for r in fewer))


def trials_of(runs):
    """The trials that candela took: what they choose, from some number of samples on, is another
    estimator."""
    return {key for run in runs for key in ("reuse_samples", "roulette_samples")
            if run.stats.get(key)}


def ladder(runs_of, *rungs):
    """Runs of fewer and of more samples, which tell a rate: the first of the `rungs`, pairs of
    counts, both of which take the same trials."""
    for counts in rungs:
        fewer, more = map(runs_of, counts)
        if trials_of(fewer) == trials_of(more):
            return fewer, more
    raise ProgramFailed("trials to share paths, or of roulette, begin between the numbers of "
                        "samples that tell the rate; expected more --spp")


def time_to_same_error(times, errors, fewer, more):
    """Geometric mean of times_to_same_error() over seeds, and the factor by which it may be off.
    `times`, `errors`: ratios by seed; `fewer`, `more`: the same seeds' runs, which tell the rate.
    Its own error is in the factor, since each seed is left out of both."""
    def mean_log(seeds):
        rate = rate_of_runs(*([runs[seed] for seed in seeds] for runs in (fewer, more)))
        ratios = [times_to_same_error(times[seed], errors[seed], rate) for seed in seeds]
        return statistics.fmean(map(log, ratios)) if all(ratio > 0 for ratio in ratios) else nan

    return jackknifed(mean_log, len(times))


def judged(truth, *errors):
    """Whether the reference is good enough for the smallest of the errors that are claimed with it;
    `errors`: lists of relMSE, whose medians count."""
    smallest = min(statistics.median(of) for of in errors)
    return "good" if truth.own_relmse() <= NOISE_ALLOWED * smallest else "too noisy"


def counted(rows, keys, note, mean="the mean"):
    """The rows that a mean over scenes may count: with a reference that is good, or with no need
    of one, and a number in each of the columns `keys`. `note` is told of the others, and why."""
    reasons = {why_not(row, keys) for row in rows} - {None}
    for reason in sorted(reasons):
        names = (name_of(row) for row in rows if why_not(row, keys) == reason)
        note(f"{mean} is without {', '.join(names)}: {reason}")
    kept = [row for row in rows if why_not(row, keys) is None]
    tell_bias(*([row[keys[0]] for row in of if is_told(row[keys[0]])]
                for of in (kept, [row for row in rows if row not in kept])), note, mean)
    return kept


def tell_bias(kept, left, note, mean):
    """Where what is left out lies on one side of all that is counted."""
    if not kept or not left:
        return
    side = ("above" if min(left) > max(kept) else "below" if max(left) < min(kept) else None)
    if side:
        note(f"{mean} may be off: what it is without lies {side} all that it counts")


def is_told(value):
    return value is not None and value > 0


def why_not(row, keys):
    """None where the row counts."""
    if row.get("reference") not in ("good", None):
        return "the reference is too noisy"
    if not all(is_told(row[key]) for key in keys):
        return "an error or a time is lost in noise, or most of the time is not that of samples"
    return None


def name_of(row):
    return row["scene"] + (f" at {row['spp']} spp" if "spp" in row else "")


def summary(runs, truth):
    """Columns of a table: medians, ranges, and whether the reference is good enough."""
    relmse = spread(run.relmse for run in runs)
    cpu = spread(run.cpu_seconds for run in runs)
    return {"relmse": relmse.median, "relmse_low": relmse.low, "relmse_high": relmse.high,
            "trimmed": spread(run.trimmed for run in runs).median, "cpu_s": cpu.median,
            "cpu_low": cpu.low, "cpu_high": cpu.high,
            "wall_s": spread(run.seconds for run in runs).median,
            "relmse_cpu_s": spread(run.relmse * run.cpu_seconds for run in runs).median,
            "reference": judged(truth, [run.relmse for run in runs])}
