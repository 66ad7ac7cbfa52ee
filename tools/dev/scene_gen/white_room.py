"""A closed white room: paths are long, for nothing but its walls' last percents takes light away.
"""

from scene_gen.parts import camera, diffuse, lamp, model, render
from scene_gen.shapes import box, joined, lamp_below, sphere, turned_box

PARAMETERS = {"albedo": (.95, "of everything")}


def scene(meshes, random, albedo):
    if not 0 <= albedo < 1:
        raise ValueError(f"--albedo is {albedo:g}; expected 0 to below 1, or light never ends")
    things = joined(box((-2, 0, -2), (2, 2.6, 2.2), inward=True),
                    turned_box((.8, .8, .8), (-.9, .4, -.8), 20),
                    turned_box((.5, 1.5, .5), (.9, .75, -1.1), -15))
    return {"Render": render(), "Cameras": [camera((0, 1.4, 2.1), (0, .9, -1), 58)],
            "Materials": [diffuse("white", albedo), lamp("lamp", 60 * (1 - albedo))],
            "Models": [model(meshes.add("room", things), "white"),
                       model(meshes.add("ball", sphere((.1, .35, .1), .35)), "white"),
                       model(meshes.add("lamp", lamp_below((0, 2.595, -.3), .8, .8)), "lamp")]}
