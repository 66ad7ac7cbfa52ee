"""An attic lit by a triangular window and a pyramid on its floor: triangles near what they light.
"""

from scene_gen.parts import camera, diffuse, lamp, model, render
from scene_gen.shapes import joined, quad, sphere, triangle

PARAMETERS = {"width": (3., "of the window, up to 3.9")}

LEFT, RIGHT, EAVES, RIDGE, BACK, FRONT = -2, 2, .6, 3, -2, 2.2


# The camera looks at the gable, which lies at the back.
def walls():
    return joined(
        quad((LEFT, 0, BACK), (LEFT, 0, FRONT), (RIGHT, 0, FRONT), (RIGHT, 0, BACK)),
        quad((LEFT, 0, BACK), (LEFT, EAVES, BACK), (LEFT, EAVES, FRONT), (LEFT, 0, FRONT)),
        quad((RIGHT, 0, FRONT), (RIGHT, EAVES, FRONT), (RIGHT, EAVES, BACK), (RIGHT, 0, BACK)),
        quad((LEFT, EAVES, BACK), (0, RIDGE, BACK), (0, RIDGE, FRONT), (LEFT, EAVES, FRONT)),
        quad((RIGHT, EAVES, FRONT), (0, RIDGE, FRONT), (0, RIDGE, BACK), (RIGHT, EAVES, BACK)),
        quad((LEFT, 0, BACK), (RIGHT, 0, BACK), (RIGHT, EAVES, BACK), (LEFT, EAVES, BACK)),
        triangle((LEFT, EAVES, BACK), (RIGHT, EAVES, BACK), (0, RIDGE, BACK)),
        quad((RIGHT, 0, FRONT), (LEFT, 0, FRONT), (LEFT, EAVES, FRONT), (RIGHT, EAVES, FRONT)),
        triangle((RIGHT, EAVES, FRONT), (LEFT, EAVES, FRONT), (0, RIDGE, FRONT)))


def pyramid(x, z, radius, height):
    corners = [(x - radius, 0, z), (x, 0, z + radius), (x + radius, 0, z), (x, 0, z - radius)]
    return joined(*(triangle(a, b, (x, height, z))
                    for a, b in zip(corners, corners[1:] + corners[:1])))


def scene(meshes, random, width):
    if not .01 <= width <= 3.9:
        raise ValueError(f"--width is {width:g}; expected .01 to 3.9")
    half = width / 2
    window = triangle((-half, EAVES, BACK + .005), (half, EAVES, BACK + .005),
                      (0, EAVES + 2.3 * half / 2, BACK + .005))
    return {"Render": render(), "Cameras": [camera((.3, 1.3, 2.1), (-.05, .9, -1), 68)],
            "Materials": [diffuse("walls", .6), diffuse("ball", [.7, .4, .2]), lamp("window", 3),
                          lamp("pyramid", 2)],
            "Models": [model(meshes.add("walls", walls()), "walls"),
                       model(meshes.add("ball", sphere((.7, .35, -.6), .35)), "ball"),
                       model(meshes.add("window", window), "window"),
                       model(meshes.add("pyramid", pyramid(-.8, -.3, .5, .6)), "pyramid")]}
