"""This candela against another build, such as one of an earlier commit: time to the same error.

Both render every scene with what they do by default, in pairs of one seed that take turns, and are
held against one reference. Each pair tells ratios of its own: of them median, range and geometric
mean, with half of the 95 % interval of the mean's logarithm (plus_minus), in which the error of the
rate is with which error falls over time; the range is without it. Where one of the two does
not tell its CPU time of rendering, that of both is the whole process's, less the median of what a
picture of one sample takes (start-up, reading, building, writing), in proportion to the other
samples. Wall time is of rendering alone. What one of them cannot read is left out with a sentence.
"""

import dataclasses
import json
import os
import pathlib
import statistics

import chosen_scenes
import truth
from arguments import at_least
from fits import geometric_mean, ratio_columns, ratio_of_errors, spread, times_to_same_error
from page_parts import shown
from processes import cpu_seconds_of
from renders import rendering_cpu_seconds, square
from results import begin, status_of_rows

ABOUT = "against another build of candela: time to the same error"
SAME_MEANS = .03  # by how much the two pictures' means may differ before the mean is without them


def add_arguments(parser):
    parser.add_argument("before", type=pathlib.Path, metavar="PROGRAM", help="the other candela")
    chosen_scenes.add_argument(parser, "all but gen/shed and the shipped pbrt files")
    parser.add_argument("--quick", action="store_true", help="64x64, 64 spp, 2 pairs")
    parser.add_argument("--pairs", type=at_least(1), help="pictures of each program (5)")
    parser.add_argument("--size", type=at_least(1), metavar="N", help="pixels a side (128)")
    parser.add_argument("--spp", type=at_least(4), help="samples of a picture (128)")
    parser.add_argument("--threads", type=at_least(1), default=len(os.sched_getaffinity(0)),
                        help="of both (all processors)")


def run(options):
    size = options.size or (64 if options.quick else 128)
    spp = options.spp or (64 if options.quick else 128)
    pairs = options.pairs or (2 if options.quick else 5)
    out, candela, results = begin(options, "Before and now", __doc__)
    default = [*chosen_scenes.names(), *chosen_scenes.ANALYTIC]
    rows = []
    for name, scene in chosen_scenes.chosen(candela, out, options.scenes, default,
                                            results.note).items():
        words = [scene, "--size", square(size), "--threads", options.threads]
        with results.attempt(name):
            programs = [Program(path.resolve(), out / "renders", words)
                        for path in (options.before, options.program)]
            right = truth.reference_for(candela, name, scene, size, 16 * spp, spp=spp,
                                        threads=options.threads)
            rows.append({"scene": name} | row(programs, right, spp, range(1, pairs + 1)))
            print(f"{name}: {shown(rows[-1]['cpu_ratio'])}", flush=True)
            results.keep("before", rows)
    results.table("before", f"Before over now, {square(size)}, {spp} spp, {pairs} pairs", rows)
    tell_all(results, rows)
    results.finish()
    return status_of_rows(rows)


def tell_all(results, rows):
    same = [r for r in rows if abs(r["means_before_over_now"] - 1) <= SAME_MEANS]
    for r in rows:
        if r not in same:
            results.note(f"{r['scene']}: the earlier pictures' mean is "
                         f"{r['means_before_over_now']:.3f} of these; where that is no noise, it "
                         "counts as their error: the mean is without it")
    found = truth.counted(same, ("cpu_ratio", "wall_ratio"), results.note)
    if found:
        results.note(f"geometric mean of {len(found)} scenes: "
                     f"{geometric_mean(r['cpu_ratio'] for r in found):.2f} by CPU time, "
                     f"{geometric_mean(r['wall_ratio'] for r in found):.2f} by wall time; "
                     f"least {min(r['cpu_ratio'] for r in found):.2f}")


def row(programs, right, spp, seeds):
    """`programs`: the earlier one and this one."""
    told = programs[0].told & programs[1].told
    pairs = [[program.measured(spp, seed, right, told) for program in programs] for seed in seeds]

    def runs_of(count):
        # Without adaptive sampling, which begins at some number of samples: error would look as if
        # it fell the faster there.
        return [programs[1].measured(count, seed, right, told, "--adaptive", "off")
                for seed in seeds]

    ladder = truth.ladder(runs_of, (spp // 2, spp), (spp, 2 * spp))
    return (compared(pairs, ladder)
            | {"reference": truth.judged(right, *([run.relmse for run in runs]
                                                  for runs in (*zip(*pairs), *ladder)))})


class Program:
    """A candela, with a scene and what both are told of it."""

    def __init__(self, path, folder, words):
        self.path, self.words = path, words
        self.exr, self.stats = folder / "before.exr", folder / "before.json"
        self.start = statistics.median(self.process_cpu_seconds(1, seed) for seed in range(5))
        self.told = set(self.read_stats().get("cpu_seconds", {}))

    def process_cpu_seconds(self, spp, seed, *words):
        return cpu_seconds_of([self.path, "render", *self.words, "--spp", spp, "--seed", seed,
                               "--filter", "box", "-o", self.exr, "--stats", self.stats, "--quiet",
                               *words], writes=[self.exr, self.stats])

    def read_stats(self):
        return json.loads(self.stats.read_text())

    def measured(self, spp, seed, right, told, *words):
        """`told`: of `cpu_seconds`, what both programs tell. `words`: further options."""
        from exr import read_exr
        process, stats = self.process_cpu_seconds(spp, seed, *words), self.read_stats()
        cpu = (rendering_cpu_seconds({key: stats["cpu_seconds"][key] for key in told})
               if "render" in told else max(process - self.start, 1e-6) * spp / (spp - 1))
        run = truth.run_of(read_exr(self.exr), right, cpu, stats["seconds"]["render"], spp)
        return dataclasses.replace(run, stats=stats)


def compared(pairs, ladder):
    """`pairs`: [before, now] each. Ratios before / now, pair by pair, so that ranges have the
    errors' noise. `ladder`: runs now of fewer samples and of more, of the same seeds."""
    errors = [ratio_of_errors(before.relmse, now.relmse) for before, now in pairs]
    rate = truth.rate_of_runs(*ladder)

    def columns(key, seconds):
        times = [getattr(before, seconds) / getattr(now, seconds) for before, now in pairs]
        _, factor = truth.time_to_same_error(times, errors, *ladder)
        return ratio_columns(key, [times_to_same_error(time, error, rate)
                                   for time, error in zip(times, errors)], factor)

    means = spread(before.mean_ratio / now.mean_ratio for before, now in pairs)
    return ({"relmse_ratio": ratio_columns("relmse", errors)["relmse_ratio"], "rate": rate}
            | columns("cpu", "cpu_seconds") | columns("wall", "seconds")
            | {"means_before_over_now": means.median})
