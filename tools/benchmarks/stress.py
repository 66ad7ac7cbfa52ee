"""Runs the cases of tests/stress in their heavy versions and tells what they measured: stress.csv
with one figure a line, the page and stress.md with one table a test."""

import csv
import json
import os
import pathlib
import re
import subprocess

from renders import Candela
from results import FAILED, Results
from scenes import ROOT

ABOUT = "what breaks at odd scales, places and numbers (tests/stress, in full)"


def add_arguments(parser):
    parser.add_argument("--filter", metavar="PATTERN", help="cases to run, as GoogleTest takes "
                        "them, e.g. 'Stress_Scale.*' (all of tests/stress)")
    parser.add_argument("--light", action="store_true",
                        help="as the test suite runs them: fewer rays, samples and cases")
    parser.add_argument("--tests", type=pathlib.Path, metavar="PROGRAM",
                        default=ROOT / "build" / "release" / "tests" / "candela_tests",
                        help="the program with the tests")


def all_cases():
    """The suites that tests/stress defines."""
    text = "".join(path.read_text() for path in sorted((ROOT / "tests" / "stress").rglob("*.cpp")))
    suites = sorted(set(re.findall(r"^TEST(?:_F)?\((Stress_\w+),", text, re.MULTILINE)))
    return ":".join(f"{suite}.*" for suite in suites)


def run_tests(options, rows, report):
    """Whether all passed."""
    rows.unlink(missing_ok=True)
    environment = os.environ | {"CANDELA_STRESS_ROWS": str(rows.resolve())}
    if not options.light:
        environment["CANDELA_HEAVY"] = "1"
    done = subprocess.run([str(options.tests), f"--gtest_filter={options.filter or all_cases()}",
                           "--gtest_brief=1", f"--gtest_output=json:{report.resolve()}"],
                          env=environment)
    return done.returncode == 0


def outcomes(report):
    """(suite, test) -> passed, failed or skipped, with seconds."""
    found = {}
    for suite in json.loads(report.read_text())["testsuites"]:
        for test in suite["testsuite"]:
            if test["status"] != "RUN":
                continue
            verdict = "failed" if "failures" in test else test["result"].lower()
            found[suite["name"], test["name"]] = {"completed": "passed"}.get(verdict, verdict)
    return found


def write_csv(path, rows, verdicts):
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(["suite", "test", "case", "figure", "value", "verdict"])
        for row in rows:
            verdict = verdicts[row["suite"], row["test"]]
            for figure, value in row["figures"].items():
                writer.writerow([row["suite"], row["test"], row["case"], figure, value, verdict])


def text_of(figures, name):
    if name not in figures:
        return ""
    value = figures[name]
    return "not finite" if value is None else f"{value:.4g}"


def table_of(rows):
    """A Markdown table: a line a case, a column a figure; a case may lack some."""
    names = list(dict.fromkeys(name for row in rows for name in row["figures"]))
    lines = [["case"] + names, ["---"] + ["---:"] * len(names)]
    for row in rows:
        lines.append([row["case"]] + [text_of(row["figures"], name) for name in names])
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def markdown(rows, verdicts):
    parts = ["# The stress bench"]
    for (suite, test), verdict in verdicts.items():
        own = [row for row in rows if (row["suite"], row["test"]) == (suite, test)]
        parts.append(f"## {suite}.{test}: {verdict}")
        if own:
            parts.append(table_of(own))
    return "\n\n".join(parts) + "\n"


def tell(results, rows, verdicts):
    for (suite, test), verdict in verdicts.items():
        own = [row for row in rows if (row["suite"], row["test"]) == (suite, test)]
        names = list(dict.fromkeys(name for row in own for name in row["figures"]))
        if not own:
            results.note(f"{suite}.{test}: {verdict}")
            continue
        results.table(None, f"{suite}.{test}: {verdict}",
                      [{"case": row["case"]} | {name: text_of(row["figures"], name)
                                                for name in names} for row in own])


def run(options):
    results = Results(options.out, "The stress bench", __doc__,
                      Candela(options.program, options.out).version())
    rows_file, report = options.out / "rows.jsonl", options.out / "tests.json"
    report.unlink(missing_ok=True)
    passed = run_tests(options, rows_file, report)
    rows = [json.loads(line) for line in rows_file.read_text().splitlines()] \
        if rows_file.exists() else []
    verdicts = outcomes(report) if report.exists() else {
        (row["suite"], row["test"]): "crashed" for row in rows}
    write_csv(results.files.add("stress.csv"), rows, verdicts)
    results.files.add("stress.md").write_text(markdown(rows, verdicts), encoding="utf-8")
    tell(results, rows, verdicts)
    if not verdicts:
        results.note(f"no case ran; expected one that '{options.filter or all_cases()}' matches")
    results.finish()
    return 0 if passed and verdicts else FAILED
