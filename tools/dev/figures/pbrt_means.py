"""How bright pbrt scenes are beside the pictures that others made of them: means of each channel
and of luminance, and the share of blocks that are off by more than noise and a tolerance."""

import numpy

from pixels import block_means

BLOCK = 8  # pixels a side, as in tests/integrators/pbrt_pictures_test, whose tolerances these are
BLOCKS_TOLERANCE = .03  # on top of the whole's
LUMINANCE = numpy.array([.2126, .7152, .0722])
NOISES = 3.5
# Of the whole's luminance against pbrt-v4's: with coats or textured metal, and without.
COATED, PLAIN = .03, .015
UNCOATED = {"cornell-box", "veach-mis"}


def ratios(ours, theirs):
    """Of the means: red, green, blue, luminance."""
    a, b = (numpy.append(image.mean((0, 1)), (image @ LUMINANCE).mean())
            for image in (ours, theirs))
    return [round(float(ratio), 4) for ratio in a / b]


def noise_of(first, second):
    """Of the mean of two independent halves, in blocks. Two numbers say little of their spread:
    relative to the light it is pooled with the 5 x 5 blocks around."""
    mean = (first + second) / 2
    relative = numpy.divide(first - second, 2 * mean, out=numpy.zeros_like(mean), where=mean > 0)
    around = numpy.pad(relative ** 2, 2, mode="reflect")
    height, width = mean.shape
    pooled = sum(around[y:y + height, x:x + width] for y in range(5) for x in range(5)) / 25
    return pooled ** .5 * mean


def odd_blocks(our_halves, their_halves, tolerance):
    """The share of blocks whose luminance is off by more than `tolerance`, BLOCKS_TOLERANCE and
    NOISES times the noise of both, which two independent halves of each tell."""
    ours, theirs = ([block_means(half @ LUMINANCE, BLOCK) for half in halves]
                    for halves in (our_halves, their_halves))
    mean = [(first + second) / 2 for first, second in (ours, theirs)]
    noise = numpy.hypot(noise_of(*ours), noise_of(*theirs))
    off = abs(mean[0] - mean[1]) > (tolerance + BLOCKS_TOLERANCE) * mean[1] + NOISES * noise
    return round(float(off.mean()), 4)


def row(name, our_halves, theirs, their_halves):
    tolerance = PLAIN if name in UNCOATED else COATED
    found = {"against": "pbrt-v4", "ratios": ratios(sum(our_halves) / 2, theirs),
             "tolerance": tolerance}
    if their_halves:
        found["odd_blocks"] = odd_blocks(our_halves, their_halves, tolerance)
    return found


def line(name, found):
    words = [f"{name:12} {found['against']:9}", *(f"{ratio:7.4f}" for ratio in found["ratios"])]
    if "odd_blocks" in found:
        words.append(f"{found['odd_blocks']:8.1%}")
    return " ".join(words)


HEAD = f"{'scene':12} {'against':9} " + " ".join(f"{c:>7}" for c in ("R", "G", "B", "lum.")) + \
    "  blocks off"
