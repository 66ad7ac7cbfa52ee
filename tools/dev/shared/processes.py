"""Runs other programs and tells what they took."""

import os
import subprocess


class ProgramFailed(OSError):
    """A program ended with an error; the text is its own."""


def first_line(reason):
    """Of why a program failed."""
    return (str(reason).splitlines() or ["for no reason that was told"])[0]


def run_checked(words, name=None, failed=ProgramFailed, writes=(), log=None, **options):
    """Runs a program to its end and gives that, with what was printed as text. `failed` is raised
    where it ends with an error, or without one of the files that it `writes`: in its own words or,
    where all that it prints goes into a file `log`, with that file's name; what of these files
    there was before is deleted. `options`: those of subprocess.run()."""
    for file in writes:
        file.unlink(missing_ok=True)
    done = subprocess.run(list(map(str, words)), capture_output=True, text=True, **options)
    if log:
        log.write_text(done.stdout + done.stderr)
    if done.returncode != 0 or not all(file.exists() for file in writes):
        name = name or words[0]
        raise failed(f"{_reason(name, done.returncode)}; see {log}" if log
                     else _reason(name, done.returncode, done.stderr))
    return done


def cpu_seconds_of(words, writes=()):
    """CPU seconds of a process, children and all; `writes` as in run_checked()."""
    for file in writes:
        file.unlink(missing_ok=True)
    process = subprocess.Popen(list(map(str, words)), stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE, text=True)
    error = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0 or not all(file.exists() for file in writes):
        raise ProgramFailed(_reason(words[0], process.returncode, error))
    return usage.ru_utime + usage.ru_stime


def _reason(name, code, error=""):
    """From the first error on: warnings may stand before it. A signal (below 0) is told first."""
    lines = error.strip().splitlines()
    first = next((i for i, line in enumerate(lines) if " error: " in f" {line}"), 0)
    told = lines[first:] if code >= 0 else []
    return "\n".join(told) or "\n".join([f"{name} ended with {code}", *lines])
