"""Measures candela; tools/bench calls this. Every measurement is a module of its own here, with
ABOUT (a line for --help), add_arguments(parser) and run(options), which gives the exit status."""

import argparse
import importlib
import os
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tools" / "dev" / "shared"))  # what tools/figures uses too

NAMES = ("ablation", "accel", "adaptive", "before", "budget", "calibration", "convergence", "cycles",
         "limit", "memory", "peers", "replicates", "sampler", "scaling", "stress", "times")


def parser_and_commands():
    parser = argparse.ArgumentParser(prog="tools/bench", description="Measures candela.")
    commands = parser.add_subparsers(required=True, metavar="MEASUREMENT")
    for name in NAMES:
        module = importlib.import_module(name)
        command = commands.add_parser(name, help=module.ABOUT.replace("%", "%%"),
                                      description=module.ABOUT)
        command.add_argument("--out", type=pathlib.Path, default=pathlib.Path("bench") / name,
                             metavar="DIR", help=f"folder for what it makes (bench/{name})")
        command.add_argument("--program", type=pathlib.Path, help=argparse.SUPPRESS,
                             default=ROOT / "build" / "release" / "candela")
        module.add_arguments(command)
        command.set_defaults(run=module.run)
    return parser, commands.choices


def main():
    options = parser_and_commands()[0].parse_args()
    try:
        sys.exit(options.run(options))
    except OSError as problem:  # a program that fails is one too (processes.py)
        sys.exit(f"tools/bench: {problem}")


if __name__ == "__main__":
    os.environ.setdefault("MPLBACKEND", "Agg")
    main()
