"""What the scripts of this folder have in common, which answer questions of C++ tests:

    SCRIPT.py SOURCE_FOLDER QUESTION [arguments]

Importing it lets them import the modules of tools/benchmarks.
"""

import contextlib
import json
import math
import pathlib
import sys

ROOT = pathlib.Path(sys.argv[1])
sys.path += [str(ROOT / "tools" / "benchmarks"), str(ROOT / "tools" / "dev" / "shared")]


def print_answer(questions):
    """As JSON. `questions`: functions by name; what they print is not the answer."""
    question, *arguments = sys.argv[2:]
    with contextlib.redirect_stdout(sys.stderr):
        answer = questions[question](*arguments)
    print(json.dumps(plain(answer)))


def plain(value):
    """For JSON, which knows no nan."""
    if isinstance(value, dict):
        return {key: plain(of) for key, of in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(of) for of in value]
    if callable(value):
        return str(value)
    return None if isinstance(value, float) and math.isnan(value) else value
