"""What numbers on the command line may be."""

import argparse


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
