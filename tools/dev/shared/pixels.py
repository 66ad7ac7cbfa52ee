"""Arithmetic on pictures: arrays [row from the top, column], with channels or without."""

import numpy


def encoded(linear):
    """Linear Rec.709 as sRGB in [0, 1] [IEC 61966-2-1]."""
    x = numpy.clip(linear, 0, 1)
    return numpy.where(x <= .0031308, 12.92 * x, 1.055 * x ** (1 / 2.4) - .055)


def block_means(image, side):
    """Of side x side pixels, whose noise is smaller; what is left over at the ends is left out."""
    rows, columns = (pixels // side for pixels in image.shape[:2])
    blocks = image[:rows * side, :columns * side].reshape(rows, side, columns, side,
                                                          *image.shape[2:])
    return blocks.mean(axis=(1, 3))
