"""What benchmarks_test.cpp asks of tools/benchmarks, printed as JSON.

    benchmarks.py SOURCE_FOLDER QUESTION [arguments]
"""

import dataclasses
import json
import pathlib
import sys

ROOT = pathlib.Path(sys.argv[1])
sys.path += [str(ROOT / "tools" / "benchmarks"), str(ROOT / "tools" / "dev" / "shared")]

import budget  # noqa: E402
import callgrind  # noqa: E402


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


print(json.dumps(globals()[sys.argv[2]](*sys.argv[3:])))
