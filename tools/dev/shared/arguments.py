"""What numbers on the command line may be."""

import argparse
import math
import re


def at_least(least):
    """A parser's type: whole numbers from `least` on."""
    def number(text):
        found = int(text)
        if found < least:
            raise argparse.ArgumentTypeError(f"{text} is no number of at least {least}")
        return found
    return number


def numbers(least):
    """The same of several, by comma."""
    def counts(text):
        return tuple(map(at_least(least), text.split(",")))
    return counts


def above_zero(text):
    """A parser's type: numbers above 0."""
    found = float(text)
    if not 0 < found < math.inf:
        raise argparse.ArgumentTypeError(f"{text} is no number above 0")
    return found


def size(text):
    """A parser's type: pixels, as candela takes them."""
    if not re.fullmatch(r"[1-9]\d*x[1-9]\d*", text):
        raise argparse.ArgumentTypeError(f"{text} is no size such as 256x256")
    return text
