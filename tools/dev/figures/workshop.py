"""What every figure is made with, and what it comes back as."""

import dataclasses
import pathlib

from renders import Candela, square
from scale import Scale
from scenes import asset

SEED = 1
REFERENCE_SEED = 2  # another one: else a picture would be compared with a part of itself


@dataclasses.dataclass
class Workshop:
    candela: Candela
    scale: Scale
    out: pathlib.Path
    references: dict = dataclasses.field(default_factory=dict)

    def reference(self, name):
        """Of an asset, by `path`; rendered once a run."""
        if name not in self.references:
            self.references[name] = self.candela.render(
                f"reference_{name}", asset(name), spp=self.scale.reference_spp[name],
                size=square(self.scale.size), seed=REFERENCE_SEED, adaptive="off")
        return self.references[name]

    def plot(self, name):
        return self.out / "plots" / f"{name}.png"

    def relative(self, path):
        return str(path.relative_to(self.out))


def row(workshop, render, caption, **values):
    """A picture of a figure with its line in the table: seconds and spp as candela wrote them."""
    return {"caption": caption, "picture": workshop.relative(render.png),
            "stats": workshop.relative(render.exr.with_suffix(".json")),
            "spp": render.spp, "seconds": render.seconds, **values}


def figure(name, title, text, columns, rows, plots=()):
    """`columns`: (key of the rows, heading); `plots`: (file relative to the page, caption)."""
    return {"name": name, "title": title, "text": text, "columns": columns, "rows": rows,
            "plots": list(plots)}


def reference_note(workshop, name):
    reference = workshop.reference(name)
    return (f"Reference: {reference.spp} spp with another seed, {reference.seconds:.1f} s. Its own "
            f"noise is part of each relMSE: about as much as a picture of {reference.spp} spp has.")
