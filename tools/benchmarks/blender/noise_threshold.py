"""What Cycles' noise threshold says, against the error that is there.

Cycles stops a pixel once e = sum_c |I_c - A_c| / (0.0001 + sqrt(sum_c I_c)) is below the threshold,
with I the mean of all of the pixel's samples and A that of every other one [Dammertz10]: one
degree of freedom a channel, looked at after every 16 samples until it passes. I - A is as large as
the error of I in the mean, so e says how wrong I is, in its own unit.
"""

import dataclasses

import numpy


@dataclasses.dataclass
class Row:
    scene: str
    threshold: float
    spp: float  # mean over seeds of the mean samples a pixel
    rmse: float  # sqrt of the median relMSE over seeds
    rmse_low: float
    rmse_high: float
    reference_share: float  # of the reference's noise in relMSE as seen, before it is taken off
    beyond: float  # share of pixels whose true e is above the threshold
    worst: float  # true e that one pixel in a hundred exceeds, over the threshold
    ratio: float  # of the mean over the picture and the seeds to the reference's
    ratio_error: float


def measure(scene, threshold, pictures, references):
    """`references`: [seed, row, column, channel], of other seeds, without a threshold."""
    reference = references.mean(axis=0)
    noise = references.var(axis=0, ddof=1) / len(references)
    colours = numpy.array([picture.colour for picture in pictures])
    weight = 1 / (reference ** 2 + 1e-2 * reference.mean() ** 2)
    seen = (((colours - reference) ** 2) * weight).mean(axis=(1, 2, 3))
    taken_off = (noise * weight).mean()
    relmse = numpy.maximum(seen - taken_off, 0)
    e = own_error(colours, reference) / threshold
    means, expected = colours.mean(axis=(1, 2, 3)), references.mean(axis=(1, 2, 3))
    ratio = means.mean() / expected.mean()
    spread = [x.var(ddof=1) / len(x) / x.mean() ** 2 for x in (means, expected)]
    low, median, high = numpy.sqrt([relmse.min(), numpy.median(relmse), relmse.max()])
    return Row(scene, threshold, float(numpy.mean([picture.spp for picture in pictures])),
               median, low, high, taken_off / numpy.median(seen), (e > 1).mean(),
               numpy.quantile(e, .99), ratio, ratio * numpy.sqrt(sum(spread)))


def own_error(colours, reference):
    """Cycles' e with the truth in the place of its half of the samples."""
    return (numpy.abs(colours - reference).sum(axis=-1)
            / (1e-4 + numpy.sqrt(reference.sum(axis=-1))))
