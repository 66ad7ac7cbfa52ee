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

import budget  # noqa: E402
import callgrind  # noqa: E402
import fits  # noqa: E402
import limit  # noqa: E402
import results  # noqa: E402


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


def perf(report):
    return [(share, limit.kind_of(where, what), limit.short(what))
            for share, where, what in limit.perf_shares(report)]


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
