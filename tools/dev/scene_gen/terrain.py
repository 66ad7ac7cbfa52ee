"""Hills of a regular grid: what a tree likes best.

There is nothing random in it: with more triangles the same hills become smoother."""

import numpy

from scene_gen.parts import camera, diffuse, model, render
from scene_gen.shapes import Mesh, unit

PARAMETERS = {"triangles": (10_000, "about how many")}


def heights(x, z, side, height):
    """Waves of five lengths, each half as high as the one before."""
    total = 0
    for octave in range(5):
        turn, k = 1.1 * octave, 2 ** octave * 7 / side
        along = numpy.cos(turn) * x + numpy.sin(turn) * z
        across = numpy.cos(turn) * z - numpy.sin(turn) * x
        total = total + numpy.sin(k * along + octave) * numpy.cos(.8 * k * across) / 2 ** octave
    return height * total / 2


def height_field(points_a_side, side, height):
    """Smooth, faces up."""
    line = numpy.linspace(-side / 2, side / 2, points_a_side)
    x, z = numpy.meshgrid(line, line)  # [row z, column x]
    y = heights(x, z, side, height)
    slope_z, slope_x = numpy.gradient(y, line, line)
    normals = unit(numpy.stack([-slope_x, numpy.ones_like(y), -slope_z], axis=-1))
    points = numpy.stack([x, y, z], axis=-1)
    index = numpy.arange(points_a_side ** 2).reshape(points_a_side, points_a_side)
    a, b, c, d = (part.ravel() for part in (index[:-1, :-1], index[1:, :-1], index[1:, 1:],
                                            index[:-1, 1:]))
    return Mesh(points.reshape(-1, 3),
                numpy.concatenate([numpy.stack([a, b, c], 1), numpy.stack([a, c, d], 1)]),
                normals.reshape(-1, 3))


def scene(meshes, random, triangles):
    if triangles < 2:
        raise ValueError(f"--triangles is {triangles}; expected at least 2")
    points_a_side = int(round(numpy.sqrt(triangles / 2))) + 1
    return {"Render": render(), "Cameras": [camera((0, 1.3, 2.4), (0, -.1, 0), 45)],
            "Environment": {"Radiance": [.5, .6, .8]},
            "Lights": [{"Type": "Directional", "Direction": [.6, .5, .3], "Intensity": [1, 1, 1]}],
            "Materials": [diffuse("grass", [.3, .4, .2])],
            "Models": [model(meshes.add("terrain", height_field(points_a_side, 4.0, .5)),
                             "grass")]}
