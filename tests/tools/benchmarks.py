"""What benchmarks_test.cpp asks of tools/benchmarks, printed as JSON.

    benchmarks.py SOURCE_FOLDER QUESTION [arguments]
"""

import contextlib
import dataclasses
import json
import math
import pathlib
import statistics

from answers import print_answer  # first: it tells where the modules below are

import ablation
import adaptive
import arguments
import before
import budget
import calibration
import calibration_goals
import callgrind
import convergence
import fits
import generated
import limit
import main
import numpy
import peers
import processes
import references
import renders
import results
import scaling
import times as times_module
import truth


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


def with_factor(values):
    return fits.with_factor(json.loads(values))


def growth(x, y):
    return fits.growth(json.loads(x), json.loads(y)).exponent


def x_where(wanted, x, y):
    return fits.x_where(float(wanted), json.loads(x), json.loads(y))


def runs_of(rows):
    """[[relmse, CPU seconds, seconds], ...]; making scene and trees takes one CPU second more."""
    return [truth.Run(relmse, relmse, cpu, wall, 16, 1, cpu + 1) for relmse, cpu, wall in rows]


def ladder(rate, count):
    """Runs in which error falls with that power of the time."""
    return [runs_of([row] * count) for row in ([1, 1, 1], [2 ** -float(rate), 2, 2])]


def compared(on, off, same_picture, rate):
    on, off = (runs_of(json.loads(rows)) for rows in (on, off))
    return ablation.compared(on, off,
                             None if json.loads(same_picture) else ladder(rate, len(on)))


def noise_of_a_rate(count, spread):
    """Half of the logarithm's 95 % interval that is stated of times to the same error, and the same
    by the times themselves, over 300 measurements of `count` seeds. Pairs have no noise: all of it
    is the rate's, by runs whose errors scatter by that part."""
    random, found = numpy.random.RandomState(1), []
    for _ in range(300):
        fewer, more = (runs_of([[mean * (1 + float(spread) * random.standard_normal()), cpu, cpu]
                                for _ in range(int(count))]) for mean, cpu in ((1, 1), (.25, 2)))
        ratio, factor = truth.time_to_same_error([1] * int(count), [4] * int(count), fewer, more)
        found.append((math.log(ratio), math.log(factor)))
    logs, errors = zip(*found)
    return statistics.fmean(errors), 2 * statistics.stdev(logs)


def error_rate(fewer, more):
    return truth.rate_of_runs(runs_of(json.loads(fewer)), runs_of(json.loads(more)))


def verdicts(rows):
    """The lines, and what is noted. `rows`: of the first technique and eight pairs, {scene: [time
    to the same error, factor by which it may be off, reference's word, whether it is used]}."""
    name, notes = ablation.TECHNIQUES[0].name, []
    lines = ablation.verdicts(
        [{"technique": name, "scene": scene, "time_to_error": ratio, "low": ratio / factor,
          "high": ratio * factor, "cpu_with_making": 1.0, "reference": reference, "used": used}
         for scene, (ratio, factor, reference, used) in json.loads(rows).items()], 8, notes.append)
    return lines, notes


def used(name, stats, info, on, off):
    """Of the technique, by errors with it on and off."""
    technique = next(t for t in ablation.TECHNIQUES if t.name.startswith(name))
    on, off = ([truth.Run(error, error, 1, 1, 16, stats=json.loads(stats))
                for error in json.loads(errors)] for errors in (on, off))
    return ablation.used_word(technique, on, off, json.loads(info))


def counted(rows, key):
    """Scenes that count, and what is noted."""
    notes = []
    rows = truth.counted(json.loads(rows), (key,), notes.append)
    return [row["scene"] for row in rows], notes


def adaptive_gain(off, on, twice):
    return adaptive.compared(*(runs_of(json.loads(runs)) for runs in (off, on, twice)))


def before_and_now(pairs, ladder):
    """`ladder`: of half the samples, and of all."""
    return before.compared([runs_of(pair) for pair in json.loads(pairs)],
                           [runs_of(runs) for runs in json.loads(ladder)])


def times(pairs):
    return times_module.compared(json.loads(pairs))


def ratios_of(pairs, counts):
    return peers.ratios_of([tuple(map(runs_of, pair)) for pair in json.loads(pairs)],
                           json.loads(counts))


def better_settings(ours, theirs):
    """Of one pair."""
    return peers.better_settings([tuple(
        {setting: runs_of(runs) for setting, runs in json.loads(ladders).items()}
        for ladders in (ours, theirs))])


def their_cpu_seconds(seconds, taken_off):
    from blender.cycles_renders import Picture
    grey = numpy.ones((2, 2, 3))
    right = references.with_weight(grey, 0 * grey)
    return peers.their_run(Picture(grey, 4, 1.0, float(seconds)), right,
                           float(taken_off)).cpu_seconds


def compared_with_cycles(files):
    """Which of the scenes, {name: file}, Blender gets."""
    found = peers.described(None, None, {name: pathlib.Path(file)
                                         for name, file in json.loads(files).items()})
    return list(found)


def approximated(folder, scenes):
    """What is told of these scenes, as a table."""
    out = pathlib.Path(folder)
    peers.tell_approximated(results.Results(out, "Peers", "", ""), json.loads(scenes))
    return sorted(file.name for file in out.glob("[!.]*"))


def errors(shape, reference_noise, picture_noise):
    """relMSE and its trimmed version of a noisy picture against a noisy reference of grey 2, and
    what they are to be: the picture's variance over its denominator; one pixel is off by 100."""
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
    return truth.judged(noisy_reference(noise), *json.loads(errors))


def noisy_reference(noise):
    grey = numpy.ones((2, 2, 3))
    return references.with_weight(grey, float(noise) * 1.01 * grey)


def judged_apart(our_noise, their_noise, our_error, their_error):
    row = {"relmse_candela": float(our_error), "relmse_Cycles": float(their_error)}
    return peers.judged(row, noisy_reference(our_noise), noisy_reference(their_noise))


def techniques():
    return [dataclasses.asdict(technique) for technique in ablation.TECHNIQUES]


def compared_with():
    """Of curves, the one to compare each with."""
    return {curve: convergence.compared_with(curve) for curve in convergence.CURVES}


def rendering_cpu_seconds(told):
    return renders.rendering_cpu_seconds(json.loads(told))


def generated_once(folder):
    """Whether a scene is left as it is, and what makes it anew: another parameter in its stamp, or
    no stamp, since it was stopped half-way."""
    out = pathlib.Path(folder)

    def is_made():
        file = generated.generated(out, "soup", triangles=10)
        is_new = "touched" not in file.read_text()
        file.write_text("touched")
        return is_new

    found = [is_made(), is_made()]
    stamp, = out.rglob("stamp")
    stamp.write_text("another generator's")
    found.append(is_made())
    stamp.unlink()
    return found + [is_made()]


class StopsHalfWay(renders.Candela):
    """Stands for candela, whose render is stopped."""
    made_by = "a program"

    def info(self, _):
        return {"scene_hash": "a"}

    def render(self, name, scene, png, **options):
        raise renders.CandelaFailed("stopped\nby hand")


def vouches_after_a_stop(folder):
    """Whether a picture counts as that of other options, whose render was stopped."""
    candela = StopsHalfWay("candela", folder)
    asked = candela.folder / "r.asked.json"
    asked.write_text("of other options")
    with contextlib.suppress(processes.ProgramFailed):
        candela.cached("r", "scene")
    return asked.exists()


def attempted(folder):
    """What a measurement goes on with where a program fails."""
    made = results.Results(pathlib.Path(folder), "Some", "", "")
    with made.attempt("box"):
        raise renders.CandelaFailed("out of memory\nmore")
    return made.parts[-1]


def told_of_script(folder, script, log=None):
    """Of a shell's script that is to write a file `made`: what it prints, or how it failed."""
    folder = pathlib.Path(folder)
    try:
        return processes.run_checked(["/bin/sh", "-c", script], "a script", cwd=folder,
                                     writes=[folder / "made"], log=log and folder / log).stdout
    except processes.ProgramFailed as reason:
        return str(reason)


def exit_status(words):
    return results.status(json.loads(words))


def scaling_verdicts(thread_rows, exponents):
    """`exponents`: of soup and terrain, of four sizes [exponent, error], of a ray over its bare
    call."""
    costs = [scaling.RATIO.format(shape) for shape in scaling.SHAPES]
    powers = [fits.Power(*pair, 1, 2) for pair in json.loads(exponents)]
    rows = [{"threads": n, "times_faster": faster} for n, faster in json.loads(thread_rows)]
    return [row["verdict"] for row in scaling.verdicts(rows, dict(zip(costs, powers)))]


def is_allowed(least, text):
    try:
        return arguments.at_least(int(least))(text)
    except Exception as problem:
        return str(problem)


def perf(report):
    return [(share, limit.kind_of(where), limit.short(what))
            for share, where, what in limit.perf_shares(report)]


def calibration_misses(rows, stop_rows):
    """What is missed, and what is noted. `rows`: [[is analytic, samples, stated / true or null,
    pixels covered or null, how unsure the reference is], ...]; `stop_rows`: [[share of at most 1.1,
    of at least .8], ...]"""
    def number(value):
        return math.nan if value is None else value

    rows = [{"scene": "s", "is_analytic": analytic, "spp": spp, "stated_over_true": number(ratio),
             "plus_minus": .1, "pixels_covered": number(covered), "reference_unsure": unsure}
            for analytic, spp, ratio, covered, unsure in json.loads(rows)]
    stop_rows = [{"scene": "s", "goal": .1, "at_most_1.1": most, "at_least_0.8": least}
                 for most, least in json.loads(stop_rows)]
    notes = []
    return list(calibration_goals.misses(calibration_goals.sure(rows, notes.append),
                                         stop_rows)), notes


def jackknife(errors):
    """`errors`: [[stated, true], ...]"""
    return calibration.ratio_with_range([calibration.Stopped(stated, true, True, 1)
                                         for stated, true in json.loads(errors)])


def page(folder, rows):
    """The files that a measurement of these rows leaves."""
    out = pathlib.Path(folder)
    made = results.Results(out, "A <title>", "About.", "1.2.3")
    made.table("rows", "Rows & more", json.loads(rows))
    made.note("A note.")
    made.finish()
    return sorted(file.name for file in out.glob("[!.]*"))


print_answer(globals())
