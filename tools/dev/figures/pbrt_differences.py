"""Ours, pbrt-v4's and the difference, of the scenes that pbrt-v4 made a picture of."""

import io
import json
import math

import matplotlib
import numpy
from PIL import Image

import pbrt_means
import plots  # noqa: F401  (chooses the backend)
import scenes
from exr import read_exr
from pbrt_means import BLOCK, LUMINANCE
from pixels import block_means, encoded
from reference_pictures import Reference
from renders import Render

SEEDS = (1, 2)  # two halves tell the noise
TUNGSTEN_SPP = 16
SCALE = .1  # of the mean of both: what is shown in full colour
COLOURED = .7  # of the largest channel


def difference(ours, theirs):
    """(ours - theirs) / mean of both, of luminance in blocks; black blocks are equal."""
    a, b = (block_means(image @ LUMINANCE, BLOCK) for image in (ours, theirs))
    half = (a + b) / 2
    return numpy.divide(a - b, half, out=numpy.zeros_like(half), where=half > 0)


def statistics(ours, theirs):
    """The median block's difference, and that of blocks with little and with much colour (by their
    largest and smallest channel), where light may have met coloured walls more than once."""
    blocks = difference(ours, theirs)
    channels = block_means(theirs, BLOCK)
    largest, smallest = channels.max(axis=2), channels.min(axis=2)
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


def halves_of(candela, name, path, size, spp):
    """Two pictures with half of the samples each."""
    half = max(spp // 2, 1)
    return [read_exr(candela.render(f"{name.replace('/', '_')}_{seed}", path, png=False, spp=half,
                                    seed=seed, size="{}x{}".format(*size)).exr) for seed in SEEDS]


def against_tungsten(candela, name, path):
    """Linear Rec.709 as ours: of the Cornell box, whose files agree, at its full size."""
    picture = path.parent / "TungstenRender.exr"
    if path.parent.name != "cornell-box" or not picture.exists():
        return None
    render = candela.render(name.replace("/", "_") + "_full", path, png=False, spp=TUNGSTEN_SPP,
                            seed=SEEDS[0])
    found = candela.compare(render, Render("Tungsten", picture, None, {}))["mean_ratio"]
    return {"against": "Tungsten", "ratios": [round(ratio, 4) for ratio in found]}


def make(candela, out, options):
    """Renders the scenes at their references' sizes; pbrt_differences.png and .json in `out`."""
    rows, numbers = [], {}
    print(pbrt_means.HEAD, flush=True)
    for name, path in scenes.pbrt_scenes().items():
        reference = Reference.of_pbrt(path.parent)
        if reference is None or options.scene and name not in options.scene:
            continue
        ours = halves_of(candela, name, path, reference.size, options.spp)
        theirs = reference.linear()
        rows.append((path.parent.name, sum(ours) / 2, theirs))
        files = [path.parent / f"pbrt-v4-half{i}.exr" for i in (1, 2)]
        their_halves = [read_exr(file) for file in files if file.exists()]
        found = pbrt_means.row(path.parent.name, ours, theirs, their_halves)
        print(pbrt_means.line(path.parent.name, found), flush=True)
        numbers[path.parent.name] = found | statistics(*rows[-1][1:])
        if full := against_tungsten(candela, name, path):
            print(pbrt_means.line(path.parent.name, full), flush=True)
            numbers[path.parent.name]["tungsten"] = full["ratios"]
    if not rows:
        raise OSError("no scene with pbrt-v4's picture is here; CANDELA_SCENES names the folder "
                      "that holds them as pbrt/NAME/")
    (out / "pbrt_differences.json").write_text(json.dumps(numbers, indent=1) + "\n")
    sheet(rows).save(out / "pbrt_differences.png", optimize=True)
    return out / "pbrt_differences.png"
