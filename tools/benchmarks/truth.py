"""Long references, made once, and how far measured pictures are from them.

relMSE = mean over pixels and channels of (x - r)^2 / (r^2 + 1e-2 mean(r)^2), without the reference's
own noise, which its seeds tell; it should be below 1/20 of what is claimed with it.
"""

import dataclasses
import statistics
from math import nan

import references
from chosen_scenes import safe
from fits import error_rate, spread

TRIMMED = 1e-3  # of the pixels, the worst
NOISE_ALLOWED = 1 / 20


def reference(candela, name, scene, size, spp, **options):
    return references.reference(candela, f"reference_{safe(name)}_{size}", scene, integrator="path",
                                size=references.square(size), spp=spp, replicates=16, filter="box",
                                **options)


def trimmed(truth, image):
    """relMSE without the worst pixels, whose noise of the reference stays in."""
    errors = sorted(((image - truth.image) ** 2 * truth.weight).mean(axis=2).ravel())
    return float(statistics.fmean(errors[:len(errors) - max(1, round(len(errors) * TRIMMED))]))


@dataclasses.dataclass
class Run:
    """One picture of one seed."""
    relmse: float
    trimmed: float
    cpu_seconds: float
    seconds: float
    spp: float
    mean_ratio: float  # of the picture's mean to the reference's


def measured(candela, scene, truth, counts_decoding=True, **options):
    """Without a truth (None) only the times count, and errors are nan."""
    from exr import read_exr
    render = candela.render("measured", scene, png=False, filter="box", **options)
    decoding = 0 if counts_decoding else render.stats["cpu_seconds"]["decoding"]
    if truth is None:
        return Run(nan, nan, render.cpu_seconds - decoding, render.seconds, render.spp, nan)
    return run_of(read_exr(render.exr), truth, render.cpu_seconds - decoding, render.seconds,
                  render.spp)


def run_of(image, truth, cpu_seconds, seconds, spp):
    return Run(truth.relmse(image), trimmed(truth, image), cpu_seconds, seconds, spp,
               float(image.mean() / truth.image.mean()))


def rate_of_runs(fewer, more):
    """With which relMSE falls over CPU time, from runs of few and of more samples."""
    mean = statistics.fmean
    return error_rate(mean(r.relmse for r in fewer) / mean(r.relmse for r in more),
                      mean(r.cpu_seconds for r in more) / mean(r.cpu_seconds for r in fewer))


def judged(truth, *errors):
    """Whether the reference is good enough for the smallest of the errors that are claimed with it;
    `errors`: lists of relMSE, whose medians count."""
    smallest = min(statistics.median(of) for of in errors)
    return "good" if truth.own_relmse() < NOISE_ALLOWED * smallest else "too noisy"


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
