"""What Blender gets in place of what it has nothing exact for in a pbrt file, when that is asked
for (pbrt_scene.py): the nearest, and a sentence that says so.

Every description of a surface has `nearest`, a list of (what the file has, what Blender is given).
"""

import json
import math

import numpy

from . import coat
from .blender_scene import Unsupported, only

SMOOTH = .001  # widths below it are, as in pbrt
ROWS, AROUND = 64, 128  # parts of a sphere from pole to pole, and around

# (what the file has, what Blender is given)
METAL = ("metal by eta and k",
         "Principled BSDF, metallic: its own colour straight on and Schlick's rise to white; GGX "
         "without height-correlated masking")
HEIGHTS = ("heights", "Cycles' bump node")
COAT = ("coat over a diffuse surface",
        "a dielectric's GGX reflection, and a Lambert surface of what the coat lets in on average, "
        "of which Fresnel's term at the normal lets out a part")
GLASS = ("rough glass", "GGX without height-correlated masking")
IMAGES = ("images as textures", "what lies between 8-bit texels is taken before they are decoded")
SPHERE = ("sphere", f"a mesh of {2 * AROUND * (ROWS - 1)} triangles with its area and normals")
BALL = ("sphere that shines", "a point light with its radius, which is a disk until Blender 4.1")
SKY = ("sky on a square of equal areas", "the same light on a latitude-longitude map, bilinearly")


def surfaces(textures):
    """By type, as pbrt_scene.SURFACES: what of a material is read, and what Blender is told."""
    roughness = ("float roughness", "bool remaproughness")
    return {
        "diffuse": (("rgb reflectance", "texture reflectance"), lambda m: {
            "surface": "diffuse", "albedo": colour(m, textures), "nearest": images(m, textures)}),
        "conductor": (("rgb eta", "rgb k", "rgb reflectance", "texture reflectance", *roughness,
                       "texture displacement", "texture heights", "float heightscale"),
                      lambda m: metal(m, textures)),
        "coateddiffuse": (("rgb reflectance", "texture reflectance", *roughness, "float eta",
                           "float thickness", "integer maxdepth"), lambda m: coated(m, textures)),
        "dielectric": (("float eta", *roughness), lambda m: {
            "surface": "glass", "albedo": [1.0] * 3, "ior": m.get("float eta", 1.5),
            "roughness": blender_roughness(m), "nearest": [GLASS] if width(m) else []}),
    }


def width(material):
    """GGX's alpha."""
    said = material.get("float roughness", 0)
    alpha = math.sqrt(said) if material.get("bool remaproughness", True) else said
    return 0 if alpha < SMOOTH else alpha


def blender_roughness(material):
    return math.sqrt(width(material))


def colour(material, textures):
    name = material.get("texture reflectance")
    return material.get("rgb reflectance", [.5] * 3) if name is None else textures[name]


def images(material, textures):
    return [IMAGES] if "image" in textures.get(material.get("texture reflectance"), ()) else []


def metal(material, textures):
    is_bumped = "texture heights" in material
    described = {"surface": "metal", "albedo": colour(material, textures),
                 "roughness": blender_roughness(material),
                 "nearest": [METAL] + images(material, textures) + [HEIGHTS] * is_bumped}
    if "rgb eta" in material:
        eta, k = (numpy.array(material[f"rgb {name}"]) for name in ("eta", "k"))
        described["albedo"] = (((eta - 1) ** 2 + k ** 2) / ((eta + 1) ** 2 + k ** 2)).tolist()
    if is_bumped:
        described["bump"] = {"texture": textures[material["texture heights"]],
                             "height": material.get("float heightscale", 1)}
    return described


def coated(material, textures):
    eta, albedo = material.get("float eta", 1.5), colour(material, textures)
    described = {"surface": "coated", "ior": eta, "roughness": blender_roughness(material),
                 "nearest": [COAT] + images(material, textures)}
    crossed = coat.crossings(eta, material.get("float thickness", .01), width(material))
    if isinstance(albedo, dict):
        return described | {"albedo": albedo, "coat": crossed}
    bounces = (material.get("integer maxdepth", 10) + 1) // 2
    return described | {"albedo": [under(crossed, a, bounces) for a in albedo]}


def under(crossed, albedo, bounces):
    again = crossed["back"] * albedo
    return crossed["through"] * albedo * (1 - again ** bounces) / (1 - again)


def texture(words, said, folder):
    """`words`: name, value's and texture's type."""
    name, _, kind = map(json.loads, words)
    where = f"texture '{name}'"
    scale = [said.get("float uscale", 1), said.get("float vscale", 1)]
    if kind == "checkerboard":
        only(said, where, "float uscale", "float vscale", "rgb tex1", "rgb tex2")
        return {"checks": [said.get("rgb tex1", [1.0] * 3), said.get("rgb tex2", [0.0] * 3)],
                "uv_scale": scale}
    if kind != "imagemap":
        raise Unsupported(f"{where} is of the type {kind}; expected imagemap or checkerboard")
    only(said, where, "float uscale", "float vscale", "string filename", "string encoding",
         "string wrap")
    return {"image": str((folder / said["string filename"]).resolve()), "uv_scale": scale,
            "colour_space": known({"sRGB": "sRGB", "linear": "Non-Color"}, where,
                                  said.get("string encoding", "linear")),
            "beyond": known({"repeat": "REPEAT", "clamp": "EXTEND"}, where,
                            said.get("string wrap", "repeat"))}


def known(table, where, word):
    if word not in table:
        raise Unsupported(f"{where}: '{word}' is not compared; expected " + " or ".join(table))
    return table[word]


def absorption(name, said):
    """Of a length, which Blender's volumes have exactly."""
    where = f"medium '{name}'"
    only(said, where, "string type", "rgb sigma_a", "rgb sigma_s", "float g")
    if any(said["rgb sigma_s"]):
        raise Unsupported(f"{where} scatters; only media that absorb are compared")
    return said["rgb sigma_a"]


def sphere(radius):
    """Corners and normals of a mesh of the same area as the sphere, seen from all sides
    [Cauchy1850]."""
    down = numpy.pi * numpy.arange(ROWS + 1) / ROWS
    around = 2 * numpy.pi * numpy.arange(AROUND + 1) / AROUND
    points = numpy.stack(numpy.broadcast_arrays(
        numpy.sin(down)[:, None] * numpy.cos(around), numpy.sin(down)[:, None] * numpy.sin(around),
        numpy.cos(down)[:, None]), axis=-1)
    a, b, c, d = points[:-1, :-1], points[1:, :-1], points[1:, 1:], points[:-1, 1:]
    normals = numpy.concatenate([  # at the poles one of two triangles is none
        numpy.stack([a, b, c], axis=2)[:-1].reshape(-1, 3, 3),
        numpy.stack([a, c, d], axis=2)[1:].reshape(-1, 3, 3)])
    area = numpy.linalg.norm(numpy.cross(normals[:, 1] - normals[:, 0],
                                         normals[:, 2] - normals[:, 0]), axis=1).sum() / 2
    return radius * normals * math.sqrt(4 * math.pi / area), normals
