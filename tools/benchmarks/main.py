"""Measures candela; tools/bench calls this. Every measurement is a module of its own here, with
ABOUT (a line for --help), add_arguments(parser) and run(options), which gives the exit status."""

import argparse
import fcntl
import importlib
import os
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tools" / "dev" / "shared"))  # what tools/figures uses too

NAMES = ("ablation", "accel", "adaptive", "before", "budget", "calibration", "convergence",
         "cycles", "limit", "memory", "peers", "replicates", "sampler", "scaling", "stress",
         "times")


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


def parsed(words):
    """Options may stand anywhere behind the measurement's name."""
    parser, commands = parser_and_commands()
    if words and words[0] in commands:
        return commands[words[0]].parse_intermixed_args(words[1:])
    return parser.parse_args(words)


def locked(folder):
    """A file that keeps other runs out of the folder as long as it is open: pictures have the same
    names in all."""
    folder.mkdir(parents=True, exist_ok=True)
    file = (folder / ".lock").open("w")
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        sys.exit(f"tools/bench: another run writes into {folder}; expected another --out")
    return file


def main():
    options = parsed(sys.argv[1:])
    try:
        with locked(options.out):
            sys.exit(status_of(options))
    except OSError as problem:  # a program that fails is one too (processes.py)
        sys.exit(f"tools/bench: {problem}")


def status_of(options):
    """The exit status; a run that is stopped leaves the page as far as it got."""
    from results import Results
    try:
        return options.run(options)
    except KeyboardInterrupt:
        if Results.latest:
            Results.latest.finish_stopped()
        return 130


if __name__ == "__main__":
    os.environ.setdefault("MPLBACKEND", "Agg")
    main()
