"""Numbers that look random and are the same everywhere."""

import math
import zlib


def hash01(*keys):
    """A number in [0, 1) that looks random and depends on the keys alone."""
    return zlib.crc32(repr(keys).encode()) / 2**32


def smooth_noise(x, y, period, seed):
    """Value noise on a grid that repeats every `period` cells."""
    x0, y0 = math.floor(x), math.floor(y)
    fx, fy = x - x0, y - y0
    fx, fy = fx * fx * (3 - 2 * fx), fy * fy * (3 - 2 * fy)

    def corner(i, j):
        return hash01(seed, (x0 + i) % period, (y0 + j) % period)

    low = corner(0, 0) * (1 - fx) + corner(1, 0) * fx
    high = corner(0, 1) * (1 - fx) + corner(1, 1) * fx
    return low * (1 - fy) + high * fy
