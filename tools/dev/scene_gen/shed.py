"""An open shed on a plain in the sun: most of the picture has no noise, and costs as much.
"""

from scene_gen.parts import camera, diffuse, model, render
from scene_gen.shapes import joined, quad, sphere

PARAMETERS = {"width": (1., "of the shed, up to 8")}


def scene(meshes, random, width):
    if not .01 <= width <= 8:
        raise ValueError(f"--width is {width:g}; expected .01 to 8")
    half, height = width / 2, .6 * width
    low = [(-half, 0, -half), (half, 0, -half), (half, 0, half), (-half, 0, half)]
    high = [(x, height, z) for x, _, z in low]
    walls = [quad(low[i], low[i + 1], high[i + 1], high[i]) for i in (0, 1)]
    walls.append(quad(low[3], low[0], high[0], high[3]))
    plain = quad((-30, 0, 30), (30, 0, 30), (30, 0, -30), (-30, 0, -30))
    ball = sphere((0, .2 * width, 0), .2 * width)
    return {"Render": render(), "Cameras": [camera((0, 9, 14), (0, 0, 0), 40)],
            "Environment": {"Radiance": [.35, .5, .8]},
            "Lights": [{"Type": "Directional", "Direction": [.5, .8, .45],
                        "Intensity": [1., .93, .8]}],
            "Materials": [diffuse("plain", [.5, .45, .35]), diffuse("boards", .8),
                          diffuse("ball", [.7, .4, .2])],
            "Models": [model(meshes.add("plain", plain), "plain"),
                       model(meshes.add("shed", joined(*walls, quad(*high))), "boards"),
                       model(meshes.add("ball", ball), "ball")]}
