#!/usr/bin/env python3
"""Writes the generated files of assets/: meshes, textures and the studio environment.

Standard library only, no randomness: the same files come out everywhere.
    tools/dev/make_assets.py [folder of assets]
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "assets"))

from image_files import write_hdr, write_png
from meshes import box, icosphere, lathe, plant, rectangle
from pictures import (brick_heights, bricks, ground_checks, leaf, stained_glass, street_lamp,
                      studio, tiles, wire_fence)


def make_textured_lights(folder):
    write_png(folder / "stained_glass.png", 96, 64, stained_glass)
    write_png(folder / "street_lamp.png", 64, 64, street_lamp)


def make_cutouts(folder):
    rectangle((-6, 0, 4), (12, 0, 0), (0, 0, -8), 3, 2, "the terrace").write(folder / "ground.obj")
    rectangle((-6, 0, -4), (12, 0, 0), (0, 4.5, 0), 8, 3, "the wall").write(folder / "wall.obj")
    rectangle((-1.7, 0, 0), (3.4, 0, 0), (0, 1.5, 0), 17, 7.5, "the fence's wire"
              ).write(folder / "fence.obj")
    box((-0.04, 0, -0.04), (0.04, 1.6, 0.04), "a post of the fence").write(folder / "post.obj")
    pot = [(0, 0), (0.17, 0), (0.24, 0.34), (0.27, 0.34), (0.27, 0.4), (0.23, 0.4), (0.22, 0.33),
           (0, 0.33)]
    lathe(pot, 32, "a flower pot").write(folder / "pot.obj")
    plant(26, "plant").write(folder / "plant.obj")
    write_png(folder / "tiles.png", 512, 512, tiles)
    write_png(folder / "bricks.png", 256, 256, bricks)
    write_png(folder / "bricks_height.png", 256, 256, brick_heights)
    write_png(folder / "wire.png", 64, 64, wire_fence)
    write_png(folder / "leaf.png", 128, 256, leaf)


def make_glass_and_metal(folder):
    icosphere(4).write(folder / "sphere.obj")
    box((-0.5, -0.5, -0.5), (0.5, 0.5, 0.5), "unit cube").write(folder / "cube.obj")
    rectangle((-8, 0, 8), (16, 0, 0), (0, 0, -16), 4, 4, "the floor").write(folder / "ground.obj")
    rectangle((-0.5, -0.5, 0), (1, 0, 0), (0, 1, 0), 1, 1, "a thin pane, 1 x 1"
              ).write(folder / "pane.obj")
    rectangle((-1, 0, -1), (2, 0, 0), (0, 0, 2), 1, 1, "2 x 2, facing down"
              ).write(folder / "lamp.obj")
    write_png(folder / "checks.png", 256, 256, ground_checks)
    write_hdr(folder / "studio.hdr", 256, 128, studio)


def main():
    default = pathlib.Path(__file__).resolve().parents[2] / "assets"
    assets = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else default
    for name, make in (("cutouts", make_cutouts), ("glass_and_metal", make_glass_and_metal),
                       ("pbrt_textured_lights", make_textured_lights)):
        (assets / name).mkdir(parents=True, exist_ok=True)
        make(assets / name)


if __name__ == "__main__":
    main()
