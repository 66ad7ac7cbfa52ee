"""Runs other programs and tells what they took."""

import os
import subprocess


class ProgramFailed(OSError):
    """A program ended with an error; the text is its own."""


def cpu_seconds_of(words):
    """CPU seconds of a process, children and all."""
    process = subprocess.Popen(list(map(str, words)), stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE, text=True)
    error = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise ProgramFailed(error.strip() or f"{words[0]} ended with {process.returncode}")
    return usage.ru_utime + usage.ru_stime
