"""Student's t: how far a mean of few values may be off."""

import functools
import math

import numpy


def student_tail(t, freedom):
    """P(|T| > t), of arrays. With t = sqrt(n) tan(x) Student's density is cos(x)^(n - 1), up to a
    factor."""
    nodes, weights = numpy.polynomial.legendre.leggauss(64)
    start = numpy.arctan(t / numpy.sqrt(freedom))
    half = (math.pi / 2 - start) / 2
    x = start[..., None] + half[..., None] * (nodes + 1)
    tail = (numpy.cos(x) ** (freedom[..., None] - 1) * weights).sum(axis=-1) * half
    log_gamma = numpy.vectorize(math.lgamma)
    whole = numpy.sqrt(math.pi) * numpy.exp(log_gamma(freedom / 2) - log_gamma((freedom + 1) / 2))
    return 2 * tail / whole


@functools.cache
def student_t(degrees, level=.05):
    """What |T| exceeds with probability `level`; nan where a single value has no error."""
    if degrees <= 0:
        return math.nan
    low, high = 0, math.pi / 2  # of x, as above
    for _ in range(50):
        x = (low + high) / 2
        t = math.sqrt(degrees) * math.tan(x)
        if student_tail(numpy.array(t), numpy.array(float(degrees))) > level:
            low = x
        else:
            high = x
    return t
