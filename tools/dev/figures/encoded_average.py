"""Where dark pictures can come from: samples encoded for display one by one, then averaged."""

import math

import matplotlib.image
import numpy

import plots
from exr import read_exr
from renders import square
from scenes import asset
from workshop import figure

SCENE = "cornell_box_diffuse"
# Columns and rows of a picture of 512 x 512: the ceiling in front of the lamp, and the tall box's
# shadow on the floor.
REGIONS = {"ceiling": ((150, 360), (8, 60)), "shadow": ((110, 150), (395, 410))}
STRATEGIES = {"uniform": "C0", "cosine": "C1"}
GAMMA = 2.2  # the lab's display


def make(workshop):
    rows = []
    curves = {region: [] for region in REGIONS}
    for sampling, colour in STRATEGIES.items():
        linear, codes = one_sample_renders(workshop, sampling)
        for region in REGIONS:
            found = [averages(n, region_of(linear, region), region_of(codes, region))
                     for n in powers_of_two(len(linear))]
            rows += [{"caption": f"{region}, {sampling}", **entry} for entry in found]
            spp = [entry["spp"] for entry in found]
            for key, label, line in (("encoded_once", "averaged, then encoded", "-"),
                                     ("encoded_each", "each sample encoded", "--")):
                curves[region].append((f"{sampling}: {label}", spp, [e[key] for e in found],
                                       {"color": colour, "ls": line}))
    shown = []
    for region, its_curves in curves.items():
        path = workshop.plot(f"encoded_average_{region}")
        plots.line_plot(path, its_curves, "samples a pixel", "mean display value (0 to 1)",
                        log_x=True)
        shown.append((workshop.relative(path), f"The {region} of the all-diffuse box."))
    return figure(
        "encoded_average", "Where darkness can come from: encoding before averaging",
        ["The course's framework encodes each sample for display (power 1/2.2, values above 1 cut "
         "off) and averages the codes. The power is concave: the mean of codes is at most the code "
         "of the mean, the noisier the samples the more so, and more samples do not mend it. That "
         "makes uniform directions dark where others are not so dark, as the report saw. Averaged "
         "as linear light and encoded once, both come to the same brightness; where few samples "
         "are darker, it is their noise that is encoded.",
         f"{workshop.scale.encoded_seeds} renders of one sample a pixel, with seeds 1, 2, ..., "
         "written by candela as PNG (--tonemap lab3) and as linear EXR, averaged in groups. The "
         "mean of linear light has its standard error over the renders. docs/report.md, section "
         "4.2."],
        [("spp", "spp"), ("encoded_each", "each sample encoded"),
         ("encoded_once", "averaged, then encoded"), ("linear", "mean of linear light"),
         ("standard_error", "± (standard error)")],
        rows, shown)


def one_sample_renders(workshop, sampling):
    """Linear pixels and display values of each, as [render, row, column, channel]."""
    linear, codes = [], []
    for seed in range(1, workshop.scale.encoded_seeds + 1):
        render = workshop.candela.render(
            f"one_sample_{sampling}_{seed}", asset(SCENE), sampling=sampling, spp=1,
            seed=seed, size=square(workshop.scale.encoded_size), filter="box", tonemap="lab3")
        linear.append(read_exr(render.exr))
        codes.append(matplotlib.image.imread(render.png)[..., :3].astype(float))
    return numpy.array(linear), numpy.array(codes)


def region_of(images, name):
    factor = images.shape[2] / 512
    (x0, x1), (y0, y1) = ((int(a * factor), max(int(a * factor) + 1, int(b * factor)))
                          for a, b in REGIONS[name])
    return images[:, y0:y1, x0:x1]


def averages(spp, linear, codes):
    """Mean display values of pictures of `spp` samples, made both ways."""
    groups = linear.reshape(-1, spp, *linear.shape[1:]).mean(axis=1)
    means = linear.mean(axis=(1, 2, 3))
    return {"spp": spp, "encoded_each": float(codes.mean()),
            "encoded_once": float((groups.clip(0, 1) ** (1 / GAMMA)).mean()),
            "linear": float(means.mean()),
            "standard_error": float(means.std(ddof=1) / math.sqrt(len(means)))}


def powers_of_two(count):
    return [2 ** k for k in range(count.bit_length()) if 2 ** k <= count]
