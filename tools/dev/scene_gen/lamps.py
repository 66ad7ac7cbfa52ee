"""A hall with thousands of small lamps, few of which matter to any point.

Powers are spread over a factor of 100, and pillars stand between."""

import numpy

from scene_gen.parts import camera, diffuse, lamp, model, render
from scene_gen.shapes import Mesh, box, joined

PARAMETERS = {"lamps": (10_000, "how many, two triangles each")}
COLOURS = ((1, .85, .6), (1, .6, .35), (.7, .8, 1), (1, .45, .5), (.6, 1, .7), (.85, .7, 1))
STRENGTHS = (.1, 1., 10.)
HALL = ((-20, 0, -40), (20, 8, 2))
POWER = 4e3  # of all lamps together, whatever their number


def lamp_quads(centres, sides):
    """Rectangles that face down."""
    corners = numpy.array(((-.5, 0, -.5), (.5, 0, -.5), (.5, 0, .5), (-.5, 0, .5)))
    points = centres[:, None] + sides[:, None, None] * corners
    first = 4 * numpy.arange(len(centres))[:, None, None]
    return Mesh(points.reshape(-1, 3),
                (first + numpy.array(((0, 1, 2), (0, 2, 3)))).reshape(-1, 3))


def scene(meshes, random, lamps):
    if lamps < 1:
        raise ValueError(f"--lamps is {lamps}; expected at least 1")
    low, high = (numpy.array(corner, float) for corner in HALL)
    centres = low + (.3, 3.5, .3) + random.random_sample((lamps, 3)) * (high - low - (.6, 4, .6))
    sides = .02 + .06 * random.random_sample(lamps)
    kinds = random.randint(len(COLOURS) * len(STRENGTHS), size=lamps)
    area = (sides ** 2 * numpy.array(STRENGTHS)[kinds % len(STRENGTHS)]).sum()
    materials = [diffuse("floor", [.5, .48, .45]), diffuse("pillar", [.65, .62, .58])]
    pillars = [box((x, 0, z), (x + .8, 8, z + .8)) for x in (-12, -4.4, 3.6, 11.2)
               for z in range(-36, -3, 8)]
    models = [model(meshes.add("hall", box(low, high, inward=True)), "floor"),
              model(meshes.add("pillars", joined(*pillars)), "pillar")]
    for kind in sorted(set(kinds.tolist())):
        colour = numpy.array(COLOURS[kind // len(STRENGTHS)])
        strength = STRENGTHS[kind % len(STRENGTHS)] * POWER / (numpy.pi * area)
        chosen = kinds == kind
        materials.append(lamp(f"lamp_{kind}", colour * strength))
        models.append(model(meshes.add(f"lamps_{kind}", lamp_quads(centres[chosen], sides[chosen])),
                            f"lamp_{kind}"))
    return {"Render": render(512, 384), "Cameras": [camera((2, 2.2, 0), (-1, 2.4, -12), 60)],
            "Materials": materials, "Models": models}
