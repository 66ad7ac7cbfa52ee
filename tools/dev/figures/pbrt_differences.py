"""Ours, pbrt-v4's and the difference, of the scenes that pbrt-v4 made a picture of."""

import io
import json
import math

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot  # noqa: E402  (the backend comes first: there is no display)
import numpy  # noqa: E402
from PIL import Image  # noqa: E402

from exr import read_exr  # noqa: E402
from reference_pictures import Reference, encoded  # noqa: E402

SEED = 1
BLOCK = 8  # as in tests/integrators/pbrt_pictures_test
SCALE = .1  # of the mean of both: what is shown in full colour
COLOURED = .7  # of the largest channel
LUMINANCE = numpy.array([.2126, .7152, .0722])


def block_means(image):
    """Of BLOCK x BLOCK pixels, whose noise is smaller; what is left over at the ends is left out."""
    height, width = (side - side % BLOCK for side in image.shape[:2])
    return image[:height, :width].reshape(height // BLOCK, BLOCK, width // BLOCK, BLOCK).mean((1, 3))


def difference(ours, theirs):
    """(ours - theirs) / mean of both, of luminance in blocks; black blocks are equal."""
    a, b = (block_means(image @ LUMINANCE) for image in (ours, theirs))
    half = (a + b) / 2
    return numpy.divide(a - b, half, out=numpy.zeros_like(half), where=half > 0)


def statistics(ours, theirs):
    """The median block's difference, and that of blocks with little and with much colour (by their
    largest and smallest channel), where light may have met coloured walls more than once."""
    blocks = difference(ours, theirs)
    channels = numpy.stack([block_means(theirs[..., c]) for c in range(3)])
    largest, smallest = channels.max(0), channels.min(0)
    coloured = largest - smallest >= COLOURED * largest
    median = lambda values: round(float(numpy.median(values)), 4) if values.size else None
    return {"size": median(abs(blocks)), "little_colour": median(blocks[~coloured]),
            "much_colour": median(blocks[coloured])}


def sheet(rows):
    """`rows`: (name, ours, theirs), linear. Two scenes side by side."""
    lines = math.ceil(len(rows) / 2)
    figure, axes = matplotlib.pyplot.subplots(lines, 6, figsize=(9.6, 1.3 * lines),
                                              layout="constrained", squeeze=False)
    for axis in axes.flat:
        axis.set_axis_off()
    for index, (name, ours, theirs) in enumerate(rows):
        trio = axes[index // 2, 3 * (index % 2):3 * (index % 2) + 3]
        for axis, image, title in zip(trio, (ours, theirs), (f"{name}: candela", "pbrt-v4")):
            axis.imshow(encoded(image))
            axis.set_title(title, fontsize=7)
        trio[2].imshow(difference(ours, theirs), cmap="RdBu_r", vmin=-SCALE, vmax=SCALE)
        trio[2].set_title(f"difference, ±{SCALE:.0%}", fontsize=7)
    data = io.BytesIO()
    figure.savefig(data, dpi=110, facecolor="white", metadata={"Software": None})
    matplotlib.pyplot.close(figure)
    # 256 colours: a third of the bytes.
    return Image.open(data).convert("RGB").quantize(256, dither=Image.Dither.NONE)


def make(candela, out, root, options):
    """Renders the scenes at their references' sizes; pbrt_differences.png and .json in `out`."""
    import scenes
    rows = []
    for name, path in scenes.pbrt_scenes(root).items():
        reference = Reference.of_pbrt(path.parent)
        if reference is None or options.scene and name not in options.scene:
            continue
        render = candela.render(name.replace("/", "_"), path, png=False, spp=options.spp, seed=SEED,
                                size="{}x{}".format(*reference.size))
        rows.append((path.parent.name, read_exr(render.exr), reference.linear()))
    if not rows:
        raise OSError("no scene with pbrt-v4's picture is here; CANDELA_SCENES names the folder "
                      "that holds them as pbrt/NAME/")
    numbers = {name: statistics(ours, theirs) for name, ours, theirs in rows}
    (out / "pbrt_differences.json").write_text(json.dumps(numbers, indent=1) + "\n")
    sheet(rows).save(out / "pbrt_differences.png", optimize=True)
    return out / "pbrt_differences.png"
