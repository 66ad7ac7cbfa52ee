"""Measurements that take turns, so that what else the machine does meets all alike."""


def in_turn(points, seeds, measure):
    """{point: [measure(point, seed) by seed]}: A B C A B C ..."""
    found = {point: [] for point in points}
    for seed in seeds:
        for point in points:
            found[point].append(measure(point, seed))
    return found
