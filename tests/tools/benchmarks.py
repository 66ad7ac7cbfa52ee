"""What benchmarks_test.cpp asks of tools/benchmarks, printed as JSON.

    benchmarks.py SOURCE_FOLDER QUESTION [arguments]
"""

import contextlib
import dataclasses
import json
import pathlib
import sys

ROOT = pathlib.Path(sys.argv[1])
sys.path += [str(ROOT / "tools" / "benchmarks"), str(ROOT / "tools" / "dev" / "shared")]

import ablation  # noqa: E402
import before  # noqa: E402
import budget  # noqa: E402
import calibration  # noqa: E402
import callgrind  # noqa: E402
import fits  # noqa: E402
import limit  # noqa: E402
import main  # noqa: E402
import numpy  # noqa: E402
import peers  # noqa: E402
import references  # noqa: E402
import results  # noqa: E402
import times as times_module  # noqa: E402
import truth  # noqa: E402


def helps():
    """What --help prints, of all and of each measurement."""
    parser, commands = main.parser_and_commands()
    return {"all": parser.format_help()} | {name: command.format_help()
                                            for name, command in commands.items()}


def profile(path):
    read = callgrind.read(pathlib.Path(path).read_text())
    embree, library = callgrind.embree_of(read)
    return dataclasses.asdict(read) | {"embree": embree, "library": library,
                                       "vectors": callgrind.vectors_of(read)}


def grown(before, now):
    counts = {"scene": budget.Count(float(now), 0, {})}
    return budget.grown({"scene": {"all": float(before)}} if float(before) else {}, counts)


def budget_scenes():
    return list(json.loads(budget.RECORD.read_text())["instructions_per_sample"])


def power(x, y):
    return dataclasses.asdict(fits.fit_power(json.loads(x), json.loads(y)))


def spread(values):
    return dataclasses.asdict(fits.spread(json.loads(values)))


def geometric_mean(values):
    return fits.geometric_mean(json.loads(values))


def x_where(wanted, x, y):
    return fits.x_where(float(wanted), json.loads(x), json.loads(y))


def runs_of(rows):
    """[[relmse, CPU seconds, seconds], ...]"""
    return [truth.Run(relmse, relmse, cpu, wall, 16, 1) for relmse, cpu, wall in rows]


def compared(on, off, same_picture, rate):
    return ablation.compared(runs_of(json.loads(on)), runs_of(json.loads(off)),
                             json.loads(same_picture), float(rate))


def error_rate(fewer, more):
    return truth.rate_of_runs(runs_of(json.loads(fewer)), runs_of(json.loads(more)))


def verdicts(ratios):
    """`ratios`: of the first technique, by scene."""
    name = ablation.TECHNIQUES[0].name
    return ablation.verdicts([{"technique": name, "scene": scene, "time_to_error": ratio}
                              for scene, ratio in json.loads(ratios).items()])


def before_and_now(pairs, rate):
    return before.compared([runs_of(pair) for pair in json.loads(pairs)], float(rate))


def times(pairs):
    return times_module.compared(json.loads(pairs))


def ratios_of(pairs, counts):
    return peers.ratios_of([tuple(map(runs_of, pair)) for pair in json.loads(pairs)],
                           json.loads(counts))


class AskedOfCycles:
    """Stands for Cycles: keeps what it is asked for, and gives grey pictures."""

    def __init__(self, folder):
        self.folder, self.jobs = pathlib.Path(folder), []

    def made_by(self):
        return []

    def render(self, _, jobs):
        from blender.cycles_renders import Picture
        self.jobs += jobs
        return {job: Picture(numpy.ones((2, 2, 3)), job.spp, 2.0, 2.0) for job in jobs}


def asked_of_cycles(folder, counts):
    """[samples, first sample] of each picture of a pair, and of each of a reference."""
    counts, cycles = json.loads(counts), AskedOfCycles(folder)
    bench = peers.Bench(None, cycles, 2, counts, 1, 1, with_all=True)
    right = bench.cycles_reference("scene", {}, 16 * counts[-1])
    references_asked, cycles.jobs = cycles.jobs, []
    bench.their_ladders("scene", {}, right, 1)
    return [[[job.spp, job.first_sample] for job in jobs]
            for jobs in (cycles.jobs, references_asked)]


def better_setting(costs):
    """`costs`: {setting: [relMSE * seconds of the last point, by pair]}."""
    costs = json.loads(costs)
    count = len(next(iter(costs.values())))
    return peers.better_setting([{setting: runs_of([[9, 9, 9], [1, values[i], 1]])
                                  for setting, values in costs.items()} for i in range(count)])


def compared_with_cycles(files):
    """Which of the scenes, {name: file}, Blender gets."""
    found = peers.described(None, None, {name: pathlib.Path(file)
                                         for name, file in json.loads(files).items()})
    return list(found)


def approximated(folder, scenes):
    """What is told of these scenes, as a table."""
    out = pathlib.Path(folder)
    peers.tell_approximated(results.Results(out, "Peers", "", ""), json.loads(scenes))
    return sorted(file.name for file in out.iterdir())


def errors(shape, reference_noise, picture_noise):
    """relMSE and its trimmed version of a noisy picture against a noisy reference of grey 2, and what
    they are to be: the picture's variance over its denominator; one pixel is off by 100."""
    random = numpy.random.RandomState(1)
    shape = (*json.loads(shape), 3)
    noise, own = float(reference_noise), float(picture_noise)
    right = references.with_weight(2 + noise * random.standard_normal(shape),
                                   numpy.full(shape, noise ** 2))
    image = 2 + own * random.standard_normal(shape)
    expected = own ** 2 / (4 * 1.01)
    firefly = image.copy()
    firefly[0, 0, 0] += 100
    return {"relmse": right.relmse(image), "expected": expected,
            "own": right.own_relmse() / (noise ** 2 / (4 * 1.01)),
            "firefly": right.relmse(firefly), "trimmed": truth.trimmed(right, firefly)}


def judged(noise, errors):
    """Of a reference whose own relMSE is `noise`."""
    grey = numpy.ones((2, 2, 3))
    right = references.with_weight(grey, float(noise) * 1.01 * grey)
    return truth.judged(right, *json.loads(errors))


def techniques():
    return [dataclasses.asdict(technique) for technique in ablation.TECHNIQUES]


def perf(report):
    return [(share, limit.kind_of(where, what), limit.short(what))
            for share, where, what in limit.perf_shares(report)]


def calibration_misses(rows, stop_rows):
    """`rows`: [[is analytic, samples, stated / true, pixels covered or null], ...]; `stop_rows`:
    [[share of at most 1.1, of at least .8], ...]"""
    rows = [{"scene": "s", "is_analytic": analytic, "spp": spp, "stated_over_true": ratio,
             "plus_minus": .1, "pixels_covered": float("nan") if covered is None else covered}
            for analytic, spp, ratio, covered in json.loads(rows)]
    stop_rows = [{"scene": "s", "goal": .1, "at_most_1.1": most, "at_least_0.8": least}
                 for most, least in json.loads(stop_rows)]
    return list(calibration.misses(rows, stop_rows))


def page(folder, rows):
    """The files that a measurement of these rows leaves."""
    out = pathlib.Path(folder)
    made = results.Results(out, "A <title>", "About.", "1.2.3")
    made.table("rows", "Rows & more", json.loads(rows))
    made.note("A note.")
    made.finish()
    return sorted(file.name for file in out.iterdir())


def answer():
    """What else is printed is not the answer."""
    question, *arguments = sys.argv[2:]
    with contextlib.redirect_stdout(sys.stderr):
        return globals()[question](*arguments)


print(json.dumps(answer()))
