"""Long references, and how far a picture is from one."""

import concurrent.futures
import dataclasses
import os

SEEDS = (900001, 900002)
# The plainest ways that lead to the picture: what is wrong with others is not in the truth as well.
PLAIN = {"integrator": "path", "adaptive": "off", "reuse": "off", "roulette": .5, "lamp_rays": 0,
         "kernel": "general"}


def side_by_side(work, items):
    """One thread each: small pictures gain nothing from more."""
    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        return list(pool.map(work, items))


def long_enough(made, lengths, is_good):
    """made(length) with the first of the lengths for which it is good, or else with the last."""
    for length in lengths:
        found = made(length)
        if is_good(found):
            break
    return found


def layers(render, spread="variance"):
    """The picture, its variance (or interval), and the mask of heavy tails."""
    from exr import read_channels, stacked
    channels = read_channels(render.exr)
    return (stacked(channels, "RGB"), stacked(channels, [f"{spread}.{c}" for c in "RGB"]),
            channels["heavy_tail.V"] > 0)


@dataclasses.dataclass
class Reference:
    image: "numpy.ndarray"
    variance: "numpy.ndarray"  # of the image
    weight: "numpy.ndarray"  # 1 / (r^2 + epsilon)

    def errors(self, image):
        """What each value brings to relMSE times their number, without the reference's noise."""
        return ((image - self.image) ** 2 - self.variance) * self.weight

    def relmse(self, image):
        """As candela compare, without the reference's own noise."""
        return float(self.errors(image).mean())

    def noisy(self):
        """Where rounding is not all that a picture can be wrong by, as on a constant background."""
        import numpy
        if not self.variance.any():
            return numpy.ones_like(self.image, bool)
        return self.variance > 1e-12 * self.image ** 2

    def own_relmse(self):
        return float((self.variance * self.weight).mean())


def with_weight(image, variance):
    epsilon = 1e-2 * image.mean() ** 2
    return Reference(image, variance, 1 / (image ** 2 + epsilon))


def rendered_once(candela, name, scene, **options):
    """layers() of a picture for references, kept in a file of that name."""
    return layers(candela.cached(name, scene, threads=1, aov="variance,heavy_tail",
                                 **PLAIN, **options))


def reference(candela, name, scene, **options):
    """Of two seeds; `options` are candela's own, `name` is that of the files."""
    parts = side_by_side(
        lambda seed: rendered_once(candela, f"{name}_{seed}", scene, seed=seed, **options), SEEDS)
    return with_weight(sum(p[0] for p in parts) / len(parts),
                       sum(p[1] for p in parts) / len(parts) ** 2)
