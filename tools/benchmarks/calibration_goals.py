"""What is wanted of stated errors (docs/accuracy.md), and what of that is not so."""

import math
import statistics

# How unsure a case's reference may be of the pixels that the error hangs on.
SURE = .05
# Of the ratio of means from 16 samples on, of the median of all, of the share of pixels within
# their intervals from 64 samples on, where the radiance is known and elsewhere; and of the pictures
# that end by --error.
RATIO = (.8, 1.25)
MEDIAN = (.95, 1.05)
COVERED = {True: (.93, .97), False: (.9, .98)}
STOPS = .95


def is_within(value, goal):
    return goal[0] <= value <= goal[1]


def median_ratio(rows):
    return statistics.median(r["stated_over_true"] for r in rows)


def case_of(row):
    return f"{row['scene']} at {row['spp']} samples"


def sure(rows, note):
    """The rows that are judged. `note` is told of the others."""
    for r in rows:
        if r["reference_unsure"] > SURE:
            note(f"{case_of(r)} is not judged: its reference is unsure, by "
                 f"{r['reference_unsure']:.2f}, of the pixels that the error hangs on")
    return [r for r in rows if r["reference_unsure"] <= SURE]


def misses(rows, stop_rows):
    """A sentence each."""
    if rows and not is_within(median_ratio(rows), MEDIAN):
        yield f"the median of stated / true is {median_ratio(rows):.3f}"
    for r in rows:
        if r["spp"] >= 16 and not is_within(r["stated_over_true"], RATIO):
            yield (f"{case_of(r)}: stated / true is {r['stated_over_true']:.2f} +- "
                   f"{r['plus_minus']:.2f}")
        covered = r["pixels_covered"]  # nan where all are masked, or none is noisy
        if r["spp"] >= 64 and not (math.isnan(covered)
                                   or is_within(covered, COVERED[r["is_analytic"]])):
            yield f"{case_of(r)}: {covered:.1%} of the pixels lie within their interval"
    for r in stop_rows:
        for key, what in (("at_most_1.1", "at most 1.1"), ("at_least_0.8", "at least 0.8")):
            if r[key] < STOPS:
                yield (f"{r['scene']}: of runs that end by --error {r['goal']:g}, "
                       f"{r[key]:.1%} have {what} of it")
