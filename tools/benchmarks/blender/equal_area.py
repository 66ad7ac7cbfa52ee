"""Skies on squares of equal areas [Clarberg08], as pbrt-v4 has them, made latitude-longitude."""

import numpy

ROWS_A_COLUMN = 2  # rows of the latitude-longitude map by columns of the square


def square_of(directions):
    """[..., xyz] in the map's axes -> [..., st] in [0, 1]; renderer/sampling/equal_area.h."""
    x, y, z = numpy.moveaxis(directions / numpy.linalg.norm(directions, axis=-1, keepdims=True),
                             -1, 0)
    r = numpy.sqrt(1 - numpy.abs(z))
    v = r * numpy.arctan2(numpy.abs(y), numpy.abs(x)) * 2 / numpy.pi
    u = r - v
    u, v = numpy.where(z < 0, 1 - v, u), numpy.where(z < 0, 1 - u, v)  # folded outwards
    return numpy.stack([numpy.copysign(u, x), numpy.copysign(v, y)], axis=-1) / 2 + .5


def directions_of(rows, columns):
    """Where Blender looks for the middles of a map's pixels: +x in the middle column, z up."""
    up = numpy.pi * (.5 - (numpy.arange(rows) + .5) / rows)[:, None]
    around = numpy.pi * (1 - 2 * (numpy.arange(columns) + .5) / columns)[None]
    return numpy.stack([numpy.cos(up) * numpy.cos(around), numpy.cos(up) * numpy.sin(around),
                        numpy.sin(up) + 0 * around], axis=-1)


def looked_up(image, st):
    """Bilinearly; rows count from the top."""
    size = numpy.array(image.shape[1::-1])
    place = numpy.clip(st * size - .5, 0, size - 1)
    low = numpy.minimum(place.astype(int), size - 2)
    x, y = numpy.moveaxis(low, -1, 0)
    right, down = numpy.moveaxis((place - low)[..., None], -2, 0)
    return ((1 - down) * ((1 - right) * image[y, x] + right * image[y, x + 1])
            + down * ((1 - right) * image[y + 1, x] + right * image[y + 1, x + 1]))


def lat_long(image, map_from_world):
    """`image`: [row from the top, column, channel]; `map_from_world`: of Blender's axes."""
    rows = ROWS_A_COLUMN * image.shape[1]
    towards = directions_of(rows, 2 * rows) @ numpy.array(map_from_world).T
    return looked_up(numpy.maximum(image, 0), square_of(towards))
