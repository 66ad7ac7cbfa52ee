"""Pictures that others made of the same scenes, beside the scenes where these are present."""

import dataclasses
import pathlib

import matplotlib.image
import numpy
from PIL import Image

from exr import read_exr
from pixels import encoded

LONGEST = 384  # pixels of a picture on a page


def write_png(path, values):
    """`values` in [0, 1], as they are; large pictures become smaller ones."""
    path.parent.mkdir(parents=True, exist_ok=True)
    image = Image.fromarray((255 * values + .5).astype(numpy.uint8))
    image.thumbnail((LONGEST, LONGEST))
    image.save(path, optimize=True)


@dataclasses.dataclass
class Reference:
    by: str
    path: pathlib.Path

    @staticmethod
    def of_pbrt(folder):
        path = folder / "pbrt-v4.exr"
        return Reference("pbrt-v4", path) if path.exists() else None

    @staticmethod
    def of_course(folder, name):
        found = sorted(folder.glob(f"lab3-pictures/{name}-depth*.png"))
        return Reference("the course's ray tracer", found[0]) if found else None

    @property
    def is_linear(self):
        return self.path.suffix == ".exr"

    @property
    def size(self):
        height, width = self.encoded().shape[:2]
        return width, height

    def linear(self):
        return read_exr(self.path)

    def encoded(self):
        if self.is_linear:
            return encoded(self.linear())
        return matplotlib.image.imread(self.path)[:, :, :3]

    def ratio(self, exr):
        """The mean of a render over this one's, where they can be compared."""
        if not self.is_linear:
            return None
        return float(read_exr(exr).mean() / self.linear().mean())
