"""Four plates from polished to rough under four lamps from small to large [Veach97].

Light samples suit the small lamps on rough plates, BSDF samples the large ones on polished plates;
all lamps have one power. The plates reflect all that they keep, so that other renderers can have
them too."""

import numpy

from scene_gen.parts import camera, diffuse, lamp, model, render
from scene_gen.shapes import box, quad, sphere, unit

PARAMETERS = {}
ROUGHNESS = (.005, .02, .06, .15)
RADII = (.04, .12, .36, .9)
WIDTH, DEPTH = 8, 1.1  # of each plate
EYE = numpy.array((0, 2, 15.))
LAMPS = numpy.array((0, 0, 0.))  # the middle of their row
ALBEDO = .8


def plate(centre):
    """Mirrors the lamps' row to the eye."""
    normal = unit(unit(LAMPS - centre) + unit(EYE - centre))
    along = unit(numpy.cross((1, 0, 0), normal)) * DEPTH / 2
    across = numpy.array((WIDTH / 2, 0, 0))
    return quad(centre - across - along, centre - across + along, centre + across + along,
                centre + across - along)


def scene(meshes, random):
    materials = [diffuse("grey", .35)]
    models = [model(meshes.add("room", box((-12, -4.6, -4), (12, 12, 20), inward=True)), "grey")]
    for index, roughness in enumerate(ROUGHNESS):
        name = f"plate_{index}"
        centre = numpy.array((0, -2.5 - .5 * index, 1.2 * index))
        materials.append({"Name": name, "Type": "cook_torrance", "kd": 0, "ks": ALBEDO, "F0": 1.0,
                          "geometry": "smith", "roughness": roughness})
        models.append(model(meshes.add(name, plate(centre)), name))
    for index, radius in enumerate(RADII):
        name = f"lamp_{index}"
        place = LAMPS + (2.5 * (index - 1.5), 0, 0)
        materials.append(lamp(name, .9 / radius ** 2))
        models.append(model(meshes.add(name, sphere(place, radius, 2, smooth=False)), name))
    return {"Render": render(768, 512), "Cameras": [camera(EYE, (0, -2, 2.5), 26)],
            "Materials": materials, "Models": models}
