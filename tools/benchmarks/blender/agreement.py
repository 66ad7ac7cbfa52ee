"""Whether two renderers' pictures are the same within their own noise, as several seeds show it."""

import dataclasses
import math

import numpy

from pixels import block_means
from student import student_tail

BLOCK = 8  # pixels
LEVEL = .01  # of finding a difference where there is none, in all of a run
RATIO = .003  # of the channels' means, at most, beyond twice the standard error
# Sums of 32-bit floats are no better than this; where nothing varies (inside of a lamp) it counts.
ROUNDING = 1e-5


@dataclasses.dataclass
class Agreement:
    ratio: numpy.ndarray  # of the means, by channel
    ratio_error: numpy.ndarray  # its standard error
    t: numpy.ndarray  # [block row, block column, channel]
    p: numpy.ndarray  # two-sided
    spread: numpy.ndarray  # mean of t^2 over what it is for equal pictures, by channel
    spread_p: numpy.ndarray
    block_noise: float  # median standard error of a block's difference, over its radiance

    def failures(self, tests):
        """Sentences. `tests`: how many such p this run looks at in all."""
        level = 1 - (1 - LEVEL) ** (1 / tests)  # [Sidak67]
        found = [f"mean ratio of {c}: {r:.5f} +- {e:.5f}, expected within {RATIO} of 1, beyond "
                 "twice that error" for c, r, e in zip("RGB", self.ratio, self.ratio_error)
                 if not abs(r - 1) <= RATIO + 2 * e]
        found += [f"block {x}, {y} of {'RGB'[c]}: t = {self.t[y, x, c]:.2f}, p = {p:.2g}, "
                  f"expected at least {level:.2g}"
                  for (y, x, c), p in numpy.ndenumerate(self.p) if not p >= level]
        found += [f"blocks of {c} differ too much as a whole: mean t^2 is {s:.2f} of the expected, "
                  f"p = {p:.2g}, expected at least {level:.2g}"
                  for c, s, p in zip("RGB", self.spread, self.spread_p) if not p >= level]
        return found

    def untold(self):
        """Sentences: of means that do not fail, and whose error hides a difference of RATIO."""
        return [f"mean ratio of {c}: {r:.5f} +- {e:.5f}: whether it is within {RATIO} of 1 is not "
                "told; expected more seeds or samples"
                for c, r, e in zip("RGB", self.ratio, self.ratio_error)
                if e > RATIO and abs(r - 1) <= RATIO + 2 * e]

    @property
    def tests(self):
        return self.p.size + self.spread_p.size


def compare(ours, theirs):
    """Pictures as [seed, row, column, channel] each; sides are multiples of BLOCK."""
    a, b = (numpy.array([block_means(picture, BLOCK) for picture in of])
            for of in (ours, theirs))
    t, freedom, is_noisy, error = welch(a, b)
    p = student_tail(numpy.abs(t), freedom)
    spread, spread_p = spread_of(t, freedom, is_noisy)
    ratio, ratio_error = ratio_of_means(ours.mean(axis=(1, 2)), theirs.mean(axis=(1, 2)))
    block_noise = float(numpy.median(error[is_noisy] / b.mean(axis=0)[is_noisy]))
    return Agreement(ratio, ratio_error, t, p, spread, spread_p, block_noise)


def ratio_of_means(a, b):
    """[seed, channel] each."""
    relative = [x.var(axis=0, ddof=1) / len(x) / x.mean(axis=0) ** 2 for x in (a, b)]
    ratio = a.mean(axis=0) / b.mean(axis=0)
    return ratio, ratio * numpy.sqrt(sum(relative))


def welch(a, b):
    """Welch's t and degrees of freedom [Welch47] of the difference of the means over axis 0, where
    that is noise rather than rounding, and its standard error."""
    va, vb = (x.var(axis=0, ddof=1) / len(x) for x in (a, b))
    difference = a.mean(axis=0) - b.mean(axis=0)
    floor = (ROUNDING * b.mean(axis=0)) ** 2
    variance = va + vb + floor
    with numpy.errstate(divide="ignore", invalid="ignore"):
        t = numpy.where(difference == 0, 0, difference / numpy.sqrt(variance))
        freedom = (va + vb) ** 2 / (va ** 2 / (len(a) - 1) + vb ** 2 / (len(b) - 1))
    is_noisy = va + vb > 10 * floor
    freedom = numpy.where(is_noisy, freedom, min(len(a), len(b)) - 1)
    return t, freedom, is_noisy, numpy.sqrt(variance)


def spread_of(t, freedom, is_noisy):
    """One-sided: many small differences show here before one block alone shows them. Channels are
    apart, since they share their paths."""
    ratios, ps = [], []
    for channel in range(t.shape[2]):
        seen = is_noisy[..., channel]
        n, square = freedom[..., channel][seen], t[..., channel][seen] ** 2
        mean = n / (n - 2)
        variance = 2 * n ** 2 * (n - 1) / ((n - 2) ** 2 * (n - 4))
        z = (square - mean).sum() / math.sqrt(variance.sum())
        ratios.append((square / mean).mean())
        ps.append(math.erfc(z / math.sqrt(2)) / 2)
    return numpy.array(ratios), numpy.array(ps)
