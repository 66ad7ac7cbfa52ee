"""What a dielectric coat lets through to a Lambert surface below it, and throws back onto it: the
means of renderer/bsdf/coat_table.h, for Blender, which lays coats by one Fresnel term."""

import numpy

COSINES = 256
TURNS, RINGS = 16, 32  # of normals that are seen


def crossings(eta, thickness, alpha):
    """Of the light that Fresnel's term lets out to the eye, through * a / (1 - back * a) comes from
    below, if the surface's albedo is a and light comes evenly from everywhere."""
    cosines = (numpy.arange(COSINES) + .5) / COSINES
    reflectance, _, inside = split(cosines, eta, alpha)
    entering = (1 - reflectance) * leaving(cosines, inside, thickness, alpha)
    reflectance, below, _ = split(cosines, 1 / eta, alpha)
    returning = (numpy.exp(-thickness / cosines)
                 * (reflectance * leaving(cosines, below, thickness, alpha)).mean(axis=1))
    let_out = 1 - fresnel(cosines, eta)[0]
    through = even(cosines, entering.mean(axis=1)) ** 2 / even(cosines, let_out) / eta ** 2
    return {"through": float(through), "back": float(even(cosines, returning))}


def even(cosines, values):
    """Of light from everywhere."""
    return (2 * cosines * values).mean()


def split(cosines, eta, alpha):
    """Reflectance, and the cosines reflected and transmitted, 0 or less where there is no such way:
    [cosine, microfacet], from the side of index 1; `eta` is the other side's."""
    x, z = normals(cosines, alpha)
    out = cosines[:, None]
    cosine = numpy.clip(numpy.sqrt(1 - out ** 2) * x + out * z, 0, 1)
    reflectance, beyond = fresnel(cosine, eta)
    transmitted = out / eta - z * (cosine / eta - beyond)
    return reflectance, 2 * cosine * z - out, numpy.where(beyond > 0, transmitted, 0)


def normals(cosines, alpha):
    """x and z of microfacets, each as visible as the others [Dupuy23, listing 3]."""
    if alpha == 0:
        return numpy.zeros((len(cosines), 1)), numpy.ones((len(cosines), 1))
    turn, ring = (part.ravel() for part in numpy.mgrid[:TURNS, :RINGS])
    stretched = numpy.stack([alpha * numpy.sqrt(1 - cosines ** 2), cosines])
    sine, cosine = (stretched / numpy.linalg.norm(stretched, axis=0))[..., None]
    z = (1 - (ring + (.5 + turn * .6180339887498949) % 1) / RINGS) * (1 + cosine) - cosine
    r, phi = numpy.sqrt(numpy.maximum(0, 1 - z * z)), numpy.pi * (turn + .5) / TURNS
    found = numpy.stack([alpha * (sine + r * numpy.cos(phi)), alpha * r * numpy.sin(phi),
                         cosine + z])
    found /= numpy.linalg.norm(found, axis=0)
    return found[0], found[2]


def leaving(cosines, towards, thickness, alpha):
    """What is left of light that a microfacet sends on: G2 / G1 [Heitz14], and the coat's share."""
    def smith(c):
        return (numpy.sqrt(1 + alpha ** 2 * (1 - c ** 2) / c ** 2) - 1) / 2
    leaves = towards > 0
    towards = numpy.clip(towards, 1e-6, 1)
    own, other = smith(cosines)[:, None], smith(towards)
    return leaves * (1 + own) / (1 + own + other) * numpy.exp(-thickness / towards)


def fresnel(cosine, eta):
    """Reflectance, and the cosine on the other side; 0 where there is none."""
    beyond = numpy.sqrt(numpy.maximum(0, 1 - (1 - cosine ** 2) / eta ** 2))
    along = (eta * cosine - beyond) / (eta * cosine + beyond)
    across = (cosine - eta * beyond) / (cosine + eta * beyond)
    return (along ** 2 + across ** 2) / 2, beyond
