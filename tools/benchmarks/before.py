"""This candela against another build of it, such as one of an earlier commit: time to the same error.

Both render every scene with what they do by default, in pairs of one seed that take turns, and are
held against one reference. Where one of them does not tell its CPU time of rendering, that of both is
the whole process's, less the median of what a picture of one sample takes (start-up, reading, building,
writing), in proportion to the other samples. Wall time is of rendering alone.
"""

import json
import os
import pathlib
import statistics
import subprocess

import chosen_scenes
import truth
from fits import geometric_mean, spread, times_to_same_error
from renders import CandelaFailed

ABOUT = "against another build of candela: time to the same error"


def add_arguments(parser):
    parser.add_argument("before", type=pathlib.Path, metavar="PROGRAM", help="the other candela")
    chosen_scenes.add_argument(parser, "the shipped, the course's and the generated ones")
    parser.add_argument("--quick", action="store_true", help="64x64, 64 spp, 2 pairs")
    parser.add_argument("--pairs", type=int, help="pictures of each program (5)")
    parser.add_argument("--size", type=int, metavar="N", help="pixels a side (128)")
    parser.add_argument("--spp", type=int, help="samples of a picture (128)")
    parser.add_argument("--threads", type=int, default=len(os.sched_getaffinity(0)),
                        help="of both (all processors)")


def run(options):
    from renders import Candela
    from results import Results
    out = options.out.resolve()
    candela = Candela(options.program, out / "renders")
    size = options.size or (64 if options.quick else 128)
    spp = options.spp or (64 if options.quick else 128)
    pairs = options.pairs or (2 if options.quick else 5)
    results = Results(out, "Before and now", __doc__, candela.version())
    default = [name for name in chosen_scenes.names() if not name.startswith("pbrt/")]
    rows = []
    for name, scene in chosen_scenes.chosen(candela, out, options.scenes, default).items():
        right = truth.reference(candela, name, scene, size, 16 * spp)
        words = [scene, "--size", f"{size}x{size}", "--threads", options.threads]
        try:
            programs = [Program(path.resolve(), out / "renders", words)
                        for path in (options.before, options.program)]
            is_told = all(program.tells_cpu_seconds for program in programs)
            measured = [[program.measured(spp, seed, right, is_told) for program in programs]
                        for seed in range(1, pairs + 1)]
            fewer = [programs[1].measured(spp // 2, seed, right, is_told)
                     for seed in range(1, pairs + 1)]
            rate = truth.rate_of_runs(fewer, [now for _, now in measured])
            rows.append({"scene": name} | compared(measured, rate))
            print(f"{name}: {rows[-1]['cpu_ratio']:.2f}", flush=True)
        except CandelaFailed as reason:
            results.note(f"{name}: left out. {str(reason).splitlines()[0]}")
    results.table("before", f"Before over now, {size}x{size}, {spp} spp, {pairs} pairs", rows)
    if rows:
        results.note(f"geometric mean {geometric_mean(r['cpu_ratio'] for r in rows):.2f} by CPU "
                     f"time, {geometric_mean(r['wall_ratio'] for r in rows):.2f} by wall time; "
                     f"least {min(r['cpu_ratio'] for r in rows):.2f}")
    results.finish()


class Program:
    """A candela, with a scene and what both are told of it."""

    def __init__(self, path, folder, words):
        self.path, self.words = path, words
        self.exr, self.stats = folder / "before.exr", folder / "before.json"
        self.start = statistics.median(self.process_cpu_seconds(1, seed) for seed in range(5))
        self.tells_cpu_seconds = "cpu_seconds" in self.read_stats()

    def process_cpu_seconds(self, spp, seed):
        return cpu_of([self.path, "render", *self.words, "--spp", spp, "--seed", seed, "--filter",
                       "box", "-o", self.exr, "--stats", self.stats, "--quiet"])

    def read_stats(self):
        return json.loads(self.stats.read_text())

    def measured(self, spp, seed, right, is_told):
        from exr import read_exr
        process, stats = self.process_cpu_seconds(spp, seed), self.read_stats()
        cpu = (stats["cpu_seconds"]["render"] if is_told
               else max(process - self.start, 1e-6) * spp / (spp - 1))
        return truth.run_of(read_exr(self.exr), right, cpu, stats["seconds"]["render"], spp)


def cpu_of(words):
    """CPU seconds of a process, children and all."""
    process = subprocess.Popen(list(map(str, words)), stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE, text=True)
    error = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise CandelaFailed(error.strip() or f"{words[0]} ended with {process.returncode}")
    return usage.ru_utime + usage.ru_stime


def compared(pairs, rate):
    """`pairs`: [before, now] each. Ratios before / now; error by medians, time by pairs. `rate`:
    with which the error falls over time, now."""
    error = (spread(before.relmse for before, _ in pairs).median
             / spread(now.relmse for _, now in pairs).median)
    cpu = spread(times_to_same_error(before.cpu_seconds / now.cpu_seconds, error, rate)
                 for before, now in pairs)
    wall = spread(times_to_same_error(before.seconds / now.seconds, error, rate)
                  for before, now in pairs)
    means = spread(before.mean_ratio / now.mean_ratio for before, now in pairs)
    return {"relmse_ratio": error, "rate": rate, "cpu_ratio": cpu.median, "cpu_low": cpu.low,
            "cpu_high": cpu.high, "wall_ratio": wall.median, "wall_low": wall.low,
            "wall_high": wall.high, "means_before_over_now": means.median}
