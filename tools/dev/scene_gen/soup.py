"""Triangles here and there in a cube: nothing that a tree could make use of.

Their sides shrink with the root of their number, so that as much of a ray's way is covered."""

import numpy

from scene_gen.parts import camera, diffuse, model, render
from scene_gen.shapes import Mesh

PARAMETERS = {"triangles": (10_000, "how many")}


def scene(meshes, random, triangles):
    if triangles < 1:
        raise ValueError(f"--triangles is {triangles}; expected at least 1")
    side = 2.0 / numpy.sqrt(triangles)
    corners = random.random_sample((triangles, 1, 3)) - .5
    points = corners + side * (random.random_sample((triangles, 3, 3)) - .5)
    mesh = Mesh(points.reshape(-1, 3), numpy.arange(3 * triangles).reshape(-1, 3))
    return {"Render": render(), "Cameras": [camera((1.1, .7, 1.3), (0, 0, 0), 45)],
            "Environment": {"Radiance": 1}, "Materials": [diffuse("grey", .6)],
            "Models": [model(meshes.add("soup", mesh), "grey")]}
