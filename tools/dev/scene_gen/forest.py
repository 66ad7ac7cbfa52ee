"""A forest of millions of visible triangles, of one tree placed many times."""

import numpy

from scene_gen.parts import camera, diffuse, model, render
from scene_gen.shapes import Mesh, turn
from scene_gen.terrain import heights, height_field

PARAMETERS = {"trees": (2500, "how many"), "leaves": (5000, "triangles of each crown")}
SIDE = 120.0  # of the ground
TRUNK_SIDES = 12


def trunk():
    """A cone without a bottom."""
    angles = 2 * numpy.pi * numpy.arange(TRUNK_SIDES) / TRUNK_SIDES
    ring = numpy.stack([.12 * numpy.cos(angles), 0 * angles, -.12 * numpy.sin(angles)], axis=1)
    points = numpy.concatenate([ring - (0, .3, 0), [(0, 2.6, 0)]])
    corners = numpy.arange(TRUNK_SIDES)
    return Mesh(points, numpy.stack([corners, (corners + 1) % TRUNK_SIDES,
                                     numpy.full(TRUNK_SIDES, TRUNK_SIDES)], axis=1))


def crown(random, leaves):
    """Triangles here and there in a cone, denser towards its bark side than its axis."""
    up = 1 - numpy.sqrt(random.random_sample(leaves))
    around = 2 * numpy.pi * random.random_sample(leaves)
    out = 1.1 * (1 - up) * random.random_sample(leaves) ** .4
    centres = numpy.stack([out * numpy.cos(around), .7 + 2.2 * up, out * numpy.sin(around)], axis=1)
    corners = centres[:, None] + .11 * (random.random_sample((leaves, 3, 3)) - .5)
    return Mesh(corners.reshape(-1, 3), numpy.arange(3 * leaves).reshape(-1, 3))


def places(random, trees):
    """A jittered grid over the ground, by rows; the camera's clearing is left out."""
    side = int(numpy.ceil(numpy.sqrt(trees * 1.05))) + 1
    cells = numpy.stack(numpy.meshgrid(numpy.arange(side), numpy.arange(side)), -1).reshape(-1, 2)
    spots = ((cells + .15 + .7 * random.random_sample(cells.shape)) / side - .5) * .96 * SIDE
    clear = numpy.hypot(spots[:, 0], spots[:, 1] - .5 * SIDE) > 7
    return spots[clear][random.permutation(clear.sum())[:trees]]


def scene(meshes, random, trees, leaves):
    if trees < 1 or leaves < 1:
        raise ValueError("--trees and --leaves must be at least 1")
    ground = height_field(129, SIDE, 3.0)
    instances = [{"Translation": [x, heights(x, z, SIDE, 3.0), z],
                  "Scale": [scale, scale * taller, scale],
                  "Rotation": turn(degrees).tolist()}
                 for (x, z), scale, taller, degrees in zip(
                     places(random, trees), .8 + .7 * random.random_sample(trees),
                     .85 + .4 * random.random_sample(trees), 360 * random.random_sample(trees))]
    eye = [0., heights(0, .5 * SIDE - 2, SIDE, 3.0) + 5.5, .5 * SIDE - 2]
    return {
        "Render": render(640, 384),
        "Cameras": [camera(eye, [0, heights(0, .2 * SIDE, SIDE, 3.0) + 2, .2 * SIDE], 55)],
        "Environment": {"Radiance": [.35, .5, .8]},
        "Lights": [{"Type": "Directional", "Direction": [.5, .8, .45], "Intensity": [1., .93, .8]}],
        "Materials": [diffuse("ground", [.25, .2, .12]), diffuse("bark", [.22, .15, .1]),
                      diffuse("leaf", [.14, .32, .08])],
        "Models": [model(meshes.add("ground", ground), "ground"),
                   model(meshes.add("trunk", trunk()), "bark", Instances=instances),
                   model(meshes.add("crown", crown(random, leaves)), "leaf", Instances=instances)]}
