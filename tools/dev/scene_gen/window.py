"""A room lit by a window as wide as its wall and a panel on its floor: lamps near what they light.
"""

from scene_gen.parts import camera, diffuse, lamp, model, render
from scene_gen.shapes import box, joined, quad, sphere, turned_box

PARAMETERS = {"width": (3., "of the window, up to 3.9")}


def scene(meshes, random, width):
    if not .01 <= width <= 3.9:
        raise ValueError(f"--width is {width:g}; expected .01 to 3.9")
    things = joined(box((-2, 0, -2), (2, 3, 2.2), inward=True),
                    turned_box((.8, 1.2, .7), (-.2, .6, -.85), 10))
    half = width / 2
    window = quad((-1.995, .6, half), (-1.995, .6, -half), (-1.995, 2.6, -half),
                  (-1.995, 2.6, half))
    panel = quad((1.2, 0, -1.5), (1.5, 0, -.9), (1.5, 1.5, -.9), (1.2, 1.5, -1.5))
    return {"Render": render(), "Cameras": [camera((.5, 1.5, 2.1), (-.1, 1.25, -1), 68)],
            "Materials": [diffuse("walls", .6), diffuse("ball", [.7, .4, .2]), lamp("window", 3),
                          lamp("panel", 2)],
            "Models": [model(meshes.add("room", things), "walls"),
                       model(meshes.add("ball", sphere((.5, .35, .1), .35)), "ball"),
                       model(meshes.add("window", window), "window"),
                       model(meshes.add("panel", panel), "panel")]}
