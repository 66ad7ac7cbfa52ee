"""Glass balls between mirrors that face each other: long specular paths, caustics."""

import numpy

from scene_gen.parts import camera, diffuse, lamp, model, render
from scene_gen.shapes import box, joined, lamp_below, quad, sphere

PARAMETERS = {"balls": (7, "how many balls of glass")}


def floor_places(random, count):
    """Centres and radii of balls that stand on the floor and touch nothing."""
    placed = []
    for _ in range(1000 * count):
        if len(placed) == count:
            break
        radius = .22 + .2 * random.random_sample()
        x, z = (random.random_sample(2) - .5) * (2.6, 2.2)
        if all(numpy.hypot(x - p[0], z - p[2]) > radius + r + .03 for p, r in placed):
            placed.append((numpy.array((x, radius + .002, z)), radius))
    return placed


def scene(meshes, random, balls):
    if balls < 0:
        raise ValueError(f"--balls is {balls}; expected at least 0")
    places = floor_places(random, balls)
    if len(places) < balls:
        raise ValueError(f"--balls is {balls}; only {len(places)} have room")
    materials = [diffuse("floor", [.6, .58, .55]), diffuse("back", [.25, .4, .55]),
                 {"Name": "mirror", "Type": "mirror", "kd": .9},
                 {"Name": "glass", "Type": "dielectric", "ior": 1.5},
                 lamp("lamp", [22., 20., 17.])]
    room = joined(quad((-2, 0, 3.5), (2, 0, 3.5), (2, 0, -2), (-2, 0, -2)),
                  quad((-2, 2.6, -2), (2, 2.6, -2), (2, 2.6, 3.5), (-2, 2.6, 3.5)))
    ends = joined(quad((-2, 0, -2), (2, 0, -2), (2, 2.6, -2), (-2, 2.6, -2)),
                  quad((2, 0, 3.5), (-2, 0, 3.5), (-2, 2.6, 3.5), (2, 2.6, 3.5)))
    mirrors = joined(quad((-2, 0, 3.5), (-2, 0, -2), (-2, 2.6, -2), (-2, 2.6, 3.5)),
                     quad((2, 0, -2), (2, 0, 3.5), (2, 2.6, 3.5), (2, 2.6, -2)))
    models = [model(meshes.add("floor_and_ceiling", room), "floor"),
              model(meshes.add("ends", ends), "back"),
              model(meshes.add("mirrors", mirrors), "mirror"),
              model(meshes.add("cube", box((-.2, 0, -1.75), (.2, .4, -1.35))), "mirror"),
              model(meshes.add("lamp", lamp_below((0, 2.58, .2), .9, .9)), "lamp")]
    models += [model(meshes.add(f"ball_{index}", sphere(place, radius, 4)), "glass")
               for index, (place, radius) in enumerate(places)]
    return {"Render": render(), "Cameras": [camera((.4, 1.5, 3.4), (0, .7, -.5), 50)],
            "Materials": materials, "Models": models}
