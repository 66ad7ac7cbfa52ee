"""A room that is lit through a door that is nearly closed, from a lamp in the next room.

No point that is seen sees the lamp, and few directions lead through the gap."""

import numpy

from scene_gen.parts import camera, diffuse, lamp, model, render
from scene_gen.shapes import Mesh, box, joined, lamp_below, sphere, turn, turned_box

PARAMETERS = {"gap": (12.0, "degrees that the door is open")}
DOOR = (.9, 2.1, .04)  # width, height, thickness
HINGE = numpy.array((-.2, 0, -2.0))  # of the door, at the wall's near side


def walls():
    """Two rooms in one shell, and between them a wall of three boxes about the door's hole."""
    x, height, width = HINGE[0], DOOR[1], DOOR[0]
    return joined(box((-2.5, 0, -5), (2.5, 2.7, 2), inward=True),
                  box((-2.5, 0, -2.15), (x, 2.7, -2)),
                  box((x + width, 0, -2.15), (2.5, 2.7, -2)),
                  box((x, height, -2.15), (x + width, 2.7, -2)))


def door(gap):
    """Opens into the room that is seen."""
    leaf = box((0, .005, -DOOR[2]), (DOOR[0], DOOR[1] - .005, 0))
    return Mesh(leaf.points @ turn(-gap).T + HINGE, leaf.faces)


def table():
    top = box((-.6, .7, -.4), (.6, .75, .4))
    legs = [box((x, 0, z), (x + .06, .7, z + .06)) for x in (-.58, .52) for z in (-.38, .32)]
    return joined(top, *legs).moved((-1.2, 0, -.6))


def scene(meshes, random, gap):
    if not 0 < gap <= 90:
        raise ValueError(f"--gap is {gap:g} degrees; expected above 0 and at most 90")
    materials = [diffuse("white", [.75, .73, .7]), diffuse("wood", [.42, .25, .12]),
                 diffuse("red", [.6, .1, .08]), diffuse("blue", [.12, .2, .5]),
                 lamp("lamp", [90., 80., 65.])]
    models = [
        model(meshes.add("walls", walls()), "white"),
        model(meshes.add("door", door(gap)), "wood"),
        model(meshes.add("table", table()), "wood"),
        model(meshes.add("ball", sphere((-1.3, .93, -.6), .18)), "red"),
        model(meshes.add("crate", turned_box((.5, .5, .5), (1.4, .25, -.9), 25)), "blue"),
        model(meshes.add("lamp", lamp_below((.4, 2.6, -3.6), .6, .6)), "lamp")]
    return {"Render": render(512, 384), "Cameras": [camera((.3, 1.5, 1.85), (-.1, 1.05, -2), 62)],
            "Materials": materials, "Models": models}
