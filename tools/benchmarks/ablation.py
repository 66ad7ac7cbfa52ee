"""Each technique off in turn: what that does to error, to time, and to the time to the same error.

A scene's picture is rendered with everything on and with one technique off, in pairs of one seed
that take turns; above 1 the technique pays. relMSE falls as a power of the time, which pictures of
as many and of twice the samples tell, without adaptive sampling; so the time to the same error
follows from both ratios. On by default stays what gains 5 % in the geometric mean and, beyond
noise, anything at all, and of which no scene says beyond noise that it loses more than 3 %: of
twenty verdicts, not scenes, at most one is to be wrong in that. low and high: the 95 % interval, in
which the power's own error is.
cpu_with_making: CPU time with what the scene and its trees took to make.
"""

import dataclasses
import math
from collections.abc import Callable

import chosen_scenes
import truth
from arguments import at_least
from fits import (at_level, geometric_mean, mean_with_factor, ratio_of_errors, spread,
                  with_factor)
from processes import ProgramFailed, first_line
from renders import CandelaFailed, square
from results import begin, status_of_rows

ABOUT = "each technique off in turn: time to the same error"


@dataclasses.dataclass(frozen=True)
class Seen:
    """What tells whether a scene has any use for a technique."""
    stats: dict  # of a picture with everything on
    info: dict
    differs: bool  # whether any picture's error is another one without the technique


def has_walks(seen):
    return seen.stats["roulette_samples"] > 0


def has_other_pictures(seen):
    """Of what is decided as the scene is made and costs nothing where it is not needed."""
    return seen.differs


@dataclasses.dataclass(frozen=True)
class Technique:
    name: str
    off: dict  # candela's options
    same_picture: bool = False  # the same bits or the same noise: only the time is compared
    # Strategies other than the default have a kernel of their own, which costs a little more, and
    # the reference BVH the general one alone. So that this does not count as theirs, the time with
    # everything on is that of these options.
    timed_on: dict | None = None
    # Other strategies, splitting and guiding have no walks that choose a roulette, and share no
    # paths (integrators/feasible_options.cpp). So that this does not count as theirs, these options
    # hold on both sides.
    both: dict = dataclasses.field(default_factory=dict)
    # Whether the scene uses it: where not, both sides are one program. None: that is not told.
    is_used: Callable[[Seen], bool] | None = None


SAME_KERNEL = {"heuristic": "balance"}
# What is taken where nothing is chosen (integrators/path_plan.h).
PLAIN_PATHS = {"roulette": .5, "reuse": "off"}

TECHNIQUES = (  # a row is a line
    Technique("kernel for what the scene needs", {"kernel": "general"}, same_picture=True,
              is_used=lambda seen: seen.stats["kernel"] != "path/general"),
    Technique("Embree and lists of few faces (off: reference BVH)", {"accel": "bvh"},
              same_picture=True, timed_on={"kernel": "general"}),
    Technique("lists of few faces (off: Embree alone)", {"accel": "embree"}, same_picture=True,
              is_used=lambda seen: seen.info["faces"] > 0),
    Technique("robust mode", {"robust": "off"}, same_picture=True),
    Technique("packets of rays", {"without": "packets"}, same_picture=True),
    Technique("trees of high quality, without robust mode", {"without": "high-quality"},
              same_picture=True, both={"robust": "off"}),
    Technique("denormals as zero", {"without": "flushing"}, same_picture=True),
    Technique("large pages (images and trees)", {"without": "large-pages"}, same_picture=True),
    Technique("pixels that share blocks", {"without": "shared-blocks"}, same_picture=True),
    Technique("blocks in convoys", {"without": "convoys"}, same_picture=True),
    Technique("background without rays", {"without": "background"}, same_picture=True,
              is_used=lambda seen: seen.stats["skipped"]["samples"] > 0),
    Technique("grids of opacity", {"without": "opacity-grids"}, same_picture=True),
    Technique("adaptive sampling", {"adaptive": "off"}),
    Technique("no splitting (off: by two)", {"splitting": 2}, both=PLAIN_PATHS),
    Technique("no splitting (off: by four)", {"splitting": 4}, both=PLAIN_PATHS),
    Technique("shared paths where a trial says so (off: each pixel's its own)", {"reuse": "off"},
              is_used=lambda seen: seen.stats["reuse_samples"] > 0),
    Technique("shared paths where a trial says so (off: wherever they can be)", {"reuse": "on"},
              is_used=lambda seen: seen.stats["reuse_samples"] > 0),
    Technique("roulette by what walks tell (off: from 1/2 on)", {"roulette": .5},
              is_used=has_walks),
    Technique("roulette by what walks tell (off: from 1/4 on)", {"roulette": .25},
              is_used=has_walks),
    Technique("roulette by what walks tell (off: at any throughput)", {"roulette": 1},
              is_used=has_walks),
    Technique("no path guiding (off: everywhere)", {"guiding": "on"}, both=PLAIN_PATHS),
    Technique("no path guiding (off: where a trial says that it pays)", {"guiding": "auto"},
              both=PLAIN_PATHS),
    Technique("Sobol points (off: plain random numbers)", {"sampler": "independent"}),
    Technique("pairs of a path together (off: each shuffled by itself)", {"sampler": "padded"}),
    Technique("no light samples for a constant sky", {"sky_samples": "on"},
              is_used=has_other_pictures),
    Technique("dim parts of skies left to BSDF samples", {"sky_compensation": "off"},
              is_used=has_other_pictures),
    Technique("more camera rays at lamps' edges", {"lamp_rays": 0},
              is_used=lambda seen: seen.stats["rays"]["lamp"] > 0),
    Technique("two triangles as one lamp (off: apart)", {"light_sampling": "triangles"},
              is_used=has_other_pictures),
    Technique("lights by place (off: by power)", {"light_cells": "off"},
              is_used=lambda seen: seen.info["light_cells"] > 0),
    Technique("near lamps by area (off: by solid angle)", {"light_sampling": "solid_angle"},
              is_used=has_other_pictures),
    Technique("four replicates (off: one, no stated error)",
              {"replicates": 1, "adaptive": "on"}),  # which one by itself would not be
    Technique("light and BSDF samples (off: light alone)", {"sampling": "light"},
              timed_on=SAME_KERNEL, both=PLAIN_PATHS),
    Technique("light and BSDF samples (off: BSDF alone)", {"sampling": "bsdf"},
              timed_on=SAME_KERNEL, both=PLAIN_PATHS),
    Technique("directions by the BSDF (off: by the cosine)", {"sampling": "cosine"},
              timed_on=SAME_KERNEL, both=PLAIN_PATHS),
    Technique("power heuristic (off: balance)", {"heuristic": "balance"}, timed_on=SAME_KERNEL,
              both=PLAIN_PATHS),
)
GAIN, LOSS = 1.05, .97


def add_arguments(parser):
    chosen_scenes.add_argument(parser, "the shipped YAML files and the generated ones")
    parser.add_argument("--quick", action="store_true", help="48x48, 16 spp, 3 pairs")
    parser.add_argument("--pairs", type=at_least(1), help="pictures with and without (8)")
    parser.add_argument("--size", type=at_least(1), metavar="N", help="pixels a side (96)")
    parser.add_argument("--spp", type=at_least(1),
                        help="samples of a picture (128; adaptive sampling begins at 64)")
    parser.add_argument("--technique", action="append", metavar="WORDS",
                        help="only rows whose name has these words; may be given several times")
    parser.add_argument("--same-picture", action="store_true",
                        help="only rows that change time alone: no reference is needed")
    parser.add_argument("--threads", type=at_least(1), default=1, help="(1)")


def wanted(options):
    words = options.technique or [""]
    allowed = [t for t in TECHNIQUES if t.same_picture or not options.same_picture]
    found = [t for t in allowed if any(w.lower() in t.name.lower() for w in words)]
    if not found:
        kind = "technique that changes time alone" if options.same_picture else "technique"
        names = ", ".join(f"'{t.name}'" for t in allowed)
        raise CandelaFailed(f"no {kind} is called {' or '.join(words)}; there are {names}")
    return found


def run(options):
    out, candela, results = begin(options, "Ablation", __doc__)
    plan = Plan(options.size or (48 if options.quick else 96),
                options.spp or (16 if options.quick else 128),
                options.pairs or (3 if options.quick else 8), options.threads)
    scenes = chosen_scenes.chosen(candela, out, options.scenes, chosen_scenes.own_names(),
                                  results.note)
    techniques = wanted(options)
    rows = []
    for name, scene in scenes.items():
        with results.attempt(name):
            rows += rows_of(candela, name, scene, techniques, plan, results.note)
            results.keep("ablation", rows)
            print(f"{name}: done", flush=True)
    title = f"Off over on, {square(plan.size)}, {plan.spp} spp, {plan.pairs} pairs"
    results.table("ablation", title, rows,
                  "used: no where the scene has no use for it, so that both sides are one program.")
    results.table("verdicts", "Time to the same error, off over on, over the scenes that use it",
                  verdicts(rows, plan.pairs, results.note),
                  "with_making: mean of CPU time with what the scene and its trees took to make.")
    results.finish()
    return status_of_rows(rows)


@dataclasses.dataclass(frozen=True)
class Plan:
    size: int  # pixels a side
    spp: int
    pairs: int
    threads: int

    def options(self, seed, spp=None):
        """candela's, of every picture."""
        return {"size": square(self.size), "spp": spp or self.spp, "threads": self.threads,
                "seed": seed}

    def seeds(self):
        return range(1, self.pairs + 1)


def rows_of(candela, name, scene, techniques, plan, note):
    right = None
    info = candela.info(scene)
    if not all(technique.same_picture for technique in techniques):
        right = truth.reference_for(candela, name, scene, plan.size, 16 * plan.spp,
                                    spp=2 * plan.spp, threads=plan.threads)
    rows, ladders = [], {}  # by what holds on both sides
    for technique in techniques:
        try:
            on, off = pictures(candela, scene, right, technique, plan)
            both = tuple(technique.both.items())
            if not technique.same_picture and both not in ladders:
                ladders[both] = ladder_of(candela, scene, right, plan, technique.both)
        except ProgramFailed as reason:
            note(f"{name}, {technique.name}: left out. {first_line(reason)}")
            continue
        own_ladder = None if technique.same_picture else ladders[both]
        rows.append({"technique": technique.name, "scene": name}
                    | compared(on, off, own_ladder)
                    | {"reference": own_ladder and reference_word(right, on, off, *own_ladder),
                       "used": used_word(technique, on, off, info)})
    return rows


def ladder_of(candela, scene, right, plan, both):
    """Runs by seed, of as many samples and of twice as many, or of half as many. Adaptive sampling,
    which begins at some number of them, would look as if error fell the faster there."""
    def runs_of(spp):
        return [truth.measured(candela, scene, right,
                               **plan.options(seed, spp) | both | {"adaptive": "off"})
                for seed in plan.seeds()]

    return truth.ladder(runs_of, (plan.spp, 2 * plan.spp), (max(plan.spp // 2, 1), plan.spp))


def pictures(candela, scene, right, technique, plan):
    """Runs with everything on, and without the technique."""
    on, off = [], []
    for seed in plan.seeds():
        own = plan.options(seed) | technique.both
        picture = None if technique.same_picture else right
        on.append(truth.measured(candela, scene, picture, **own))
        if technique.timed_on:
            timed = truth.measured(candela, scene, None, **own, **technique.timed_on)
            on[-1] = dataclasses.replace(on[-1], cpu_seconds=timed.cpu_seconds,
                                         seconds=timed.seconds,
                                         built_cpu_seconds=timed.built_cpu_seconds)
        off.append(truth.measured(candela, scene, picture, **own, **technique.off))
    return on, off


def reference_word(right, *pictures):
    return truth.judged(right, *([run.relmse for run in runs] for runs in pictures))


def used_word(technique, on, off, info):
    if technique.is_used is None:
        return None
    differs = any(a.relmse != b.relmse for a, b in zip(on, off))
    seen = (Seen(run.stats, info, differs) for run in on)  # a seed's trials may say no
    return "yes" if any(technique.is_used(one) for one in seen) else "no"


def compared(on, off, ladder):
    """Ratios off / on: of CPU time by pairs, of error by medians, and of both together by pairs:
    the geometric mean, with its 95 % interval; nan where an error is lost in the reference's
    noise. `ladder`: of ladder_of(); None where pictures are the same."""
    cpu, built, wall = (spread(getattr(b, key) / getattr(a, key) for a, b in zip(on, off))
                        for key in ("cpu_seconds", "built_cpu_seconds", "seconds"))
    times = [b.cpu_seconds / a.cpu_seconds for a, b in zip(on, off)]
    if ladder is None:
        mean, factor = with_factor(times)
    else:
        errors = [ratio_of_errors(b.relmse, a.relmse) for a, b in zip(on, off)]
        mean, factor = truth.time_to_same_error(times, errors, *ladder)
    medians = (spread(run.relmse for run in runs).median for runs in (off, on))
    return {"cpu": cpu.median, "cpu_low": cpu.low, "cpu_high": cpu.high,
            "cpu_with_making": built.median, "wall": wall.median,
            "relmse": 1.0 if ladder is None else ratio_of_errors(*medians),
            "rate": None if ladder is None else truth.rate_of_runs(*ladder),
            "time_to_error": mean, "low": mean / factor, "high": mean * factor}


def verdicts(rows, pairs, note):
    """A line a technique, over the scenes that use it and of which the errors are known."""
    lines = []
    for technique in TECHNIQUES:
        every = [r for r in rows if r["technique"] == technique.name]
        own = [r for r in every if r["used"] != "no"]
        if every and not own:
            note(f"{technique.name}: no scene uses it")
        own = truth.counted(own, ("time_to_error",), note, f"{technique.name}: the mean")
        if own:
            lines.append({"technique": technique.name} | verdict(own, pairs)
                         | {"with_making": geometric_mean(r["cpu_with_making"] for r in own)})
    return lines


def verdict(rows, pairs):
    """It gains where the mean does, and is above 1 beyond noise; a scene loses where that is no
    noise in any of them [Sidak67]. Of single pairs no noise is known: nothing is said."""
    ratios, factors = zip(*((r["time_to_error"], r["high"] / r["time_to_error"]) for r in rows))
    mean, factor = mean_with_factor(ratios, factors, pairs - 1)
    least = min(rows, key=lambda r: r["time_to_error"])
    level = 1 - .95 ** (1 / len(rows))
    losing = [r["scene"] for r, ratio, own in zip(rows, ratios, factors)
              if ratio * at_level(own, pairs - 1, level) < LOSS]
    pays = "yes" if mean >= GAIN and mean / factor > 1 and not losing else "no"
    return {"scenes": len(rows), "geometric_mean": mean, "low": mean / factor,
            "high": mean * factor, "least": least["time_to_error"], "where": least["scene"],
            "loses": ", ".join(losing), "pays": None if math.isnan(factor) else pays}
