"""A pbrt-v4 file as `candela convert` writes it [docs/pbrt.md#writing], as Blender takes it: what
blender_scene.read() gives of candela's own files.

Of that form, not of pbrt's: each shape stands in a block of its own with its whole transform,
meshes are binary PLY files of triangles, and what candela reads beside pbrt's parameters stands in
comments that begin with #candela:. Read are diffuse surfaces and clear glass, meshes that shine,
point and distant lights, one radiance from everywhere, and a perspective camera; the limit of
bounces, the filter and the size are the measurement's. Anything else is refused. Metals are: what
Blender 3.4 has for a glossy surface knows nothing of eta and k at each microfacet. So are coats,
which it lays otherwise, and spheres: as a mesh one would be another shape and another lamp. Where
the nearest is asked for, Blender gets that [pbrt_nearest.py], and `approximated` lists it.
"""

import dataclasses
import json
import math
import pathlib
import re

import numpy

from . import blender_scene, pbrt_nearest
from .blender_scene import Unsupported, axes, only, unit, vector

WORD = re.compile(r'"(?:[^"\\]|\\.)*"|#candela:|#[^\n]*|[^\s"]+')
# Of what stands in a block, or before the camera.
ATTRIBUTES = ("Transform", "NamedMaterial", "AreaLightSource", "Scale", "LookAt", "MediumInterface")
# By directive: what may be said, since it changes nothing that is compared.
OF_NO_EFFECT = {
    "Film": ("integer xresolution", "integer yresolution", "string filename", "float exposure"),
    "PixelFilter": ("float xradius", "float yradius", "float sigma", "string filter"),
    "Sampler": ("integer pixelsamples", "integer seed"),
    "Integrator": ("integer maxdepth", "bool unlimited"),
}
READ_ELSEWHERE = ("MakeNamedMaterial", "MakeNamedMedium", "Texture", "WorldBegin")
# By type: what of a material is read, and what Blender is told.
SURFACES = {
    "diffuse": (("rgb reflectance",), lambda m: {
        "surface": "diffuse", "albedo": m.get("rgb reflectance", [.5] * 3)}),
    "dielectric": (("float eta", "float roughness", "bool remaproughness"), lambda m: glass(m)),
}


@dataclasses.dataclass
class Assets:
    """What shapes and lights name."""
    folder: pathlib.Path
    scale: float
    is_near_enough: bool  # the nearest that Blender has
    surfaces: dict  # SURFACES, or all that have something near
    materials: dict
    media: dict
    nearest: dict = dataclasses.field(default_factory=dict)  # (what, as what) -> names


def read(path, scale=1, nearest=False):
    """Lengths are multiplied by `scale`, as blender_scene.read() does. `nearest`: what has no exact
    counterpart gets the nearest one rather than refused; `approximated` lists it."""
    path = pathlib.Path(path)
    statements = statements_of(path.read_text())
    assets = assets_of(statements, path.parent, scale, nearest)
    scene = {"camera": None, "meshes": [], "lights": [], "environment": None}
    block = {}
    for name, words in statements:
        if name in ("AttributeBegin", "AttributeEnd"):
            block = {}
        elif name in ATTRIBUTES:
            block[name] = words
        elif name == "Camera":
            scene["camera"] = camera(block, words, scale)
        elif name == "LightSource":
            add_light(scene, block, words, assets)
        elif name == "Shape":
            add_shape(scene, block, words, assets)
        elif name in OF_NO_EFFECT:
            only(parameters(words[1:]), name, *OF_NO_EFFECT[name])
        elif name not in READ_ELSEWHERE:
            raise Unsupported(f"{name} is not compared")
    if not scene["camera"]:
        raise Unsupported("the scene has no camera")
    return scene | {"approximated": [
        {"what": what, "in_Cycles": as_what, "names": sorted(names)}
        for (what, as_what), names in assets.nearest.items()]}


def assets_of(statements, folder, scale, nearest):
    def named(directive):
        return {json.loads(words[0]): parameters(words[1:])
                for name, words in statements if name == directive}
    materials = named("MakeNamedMaterial")
    surfaces = SURFACES
    if nearest:
        surfaces = pbrt_nearest.surfaces({
            json.loads(words[0]): pbrt_nearest.texture(words[:3], parameters(words[3:]), folder)
            for name, words in statements if name == "Texture"})
    for name, material in materials.items():
        known_type(name, material, surfaces)  # tells more of a scene than its first texture does
    return Assets(folder, scale, nearest, surfaces, materials, named("MakeNamedMedium"))


def statements_of(text):
    """(directive, the words behind it); comments are left out, candela's own parameters are not."""
    found = []
    for word in WORD.findall(text):
        if word[0].isupper():
            found.append((word, []))
        elif word[0] != "#":
            found[-1][1].append(word)
    return found


def parameters(words):
    """'type name' -> value, which is a list where it stands in brackets. Its numbers, truths and
    quoted words are written as JSON's are."""
    found, words = {}, iter(words)
    for key in words:
        value = next(words)
        found[json.loads(key)] = ([json.loads(part) for part in iter(lambda: next(words), "]")]
                                  if value == "[" else json.loads(value))
    return found


def camera(block, words, scale):
    """pbrt's camera space is left-handed: without `Scale -1 1 1` the picture is mirrored."""
    said = parameters(words[1:])
    only(said, "the camera", "float fov", "float fovy")
    if json.loads(words[0]) != "perspective":
        raise Unsupported(f"a camera of the type {json.loads(words[0])}; expected perspective")
    if list(map(float, block.get("Scale", ()))) != [-1, 1, 1]:
        raise Unsupported("a camera that mirrors the picture; Blender's do not")
    eye, target, up = vector(block["LookAt"]).reshape(3, 3)
    # Of the shorter side, which is the height of the square pictures that are compared.
    return blender_scene.camera({"Eye": eye, "Target": target, "Up": up,
                                 "Fovy": said.get("float fovy", said["float fov"])}, scale)


def add_light(scene, block, words, assets):
    kind, said, scale = json.loads(words[0]), parameters(words[1:]), assets.scale
    if kind == "infinite" and "string filename" in said and assets.is_near_enough:
        return add_sky(scene, block, said, assets)
    if "Transform" in block:
        raise Unsupported(f"a light of the type {kind} that is turned")
    if kind == "point":
        only(said, "a point light", "rgb I", "point3 from")
        scene["lights"].append({
            "type": "POINT", "position": axes(scale * vector(said["point3 from"])).tolist(),
            "radiant_intensity": (scale ** 2 * vector(said["rgb I"])).tolist()})
    elif kind == "distant":
        only(said, "a distant light", "rgb L", "point3 from", "point3 to")
        towards = unit(vector(said["point3 from"]) - vector(said["point3 to"]))
        scene["lights"].append({"type": "SUN", "towards": axes(towards).tolist(),
                                "irradiance": said["rgb L"]})
    elif kind == "infinite" and not scene["environment"]:
        only(said, "an infinite light", "rgb L")
        scene["environment"] = {"map": None, "scale": said["rgb L"], "turn": 0}
    else:
        raise Unsupported(f"a light of the type {kind}, or a second sky, is not compared; expected "
                          "point, distant or one infinite")


def add_sky(scene, block, said, assets):
    """`map_from_world`: of Blender's axes."""
    only(said, "an infinite light", "string filename")
    if scene["environment"]:
        raise Unsupported("a second sky is not compared")
    note(assets, pbrt_nearest.SKY, said["string filename"])
    world_from_map = axes(placement(block.get("Transform"))[:3, :3].T).T
    scene["environment"] = {"map": str((assets.folder / said["string filename"]).resolve()),
                            "scale": [1.0] * 3,
                            "map_from_world": numpy.linalg.inv(world_from_map).tolist()}


def note(assets, nearest, name):
    assets.nearest.setdefault(tuple(nearest), set()).add(name)


def add_shape(scene, block, words, assets):
    kind = json.loads(words[0])
    kinds = ("plymesh", "sphere") if assets.is_near_enough else ("plymesh",)
    if kind not in kinds:
        raise Unsupported(f"a shape of the type {kind}; expected {' or '.join(kinds)}")
    name = json.loads(block["NamedMaterial"][0])
    described = (surface(name, assets) | emission(block.get("AreaLightSource"))
                 | inside(block.get("MediumInterface"), assets))
    to_world = placement(block.get("Transform"))
    if any(described["emission"]) and described["albedo"] != [0, 0, 0]:
        raise Unsupported(f"material '{name}': a lamp that also reflects is not compared")
    if kind == "sphere" and any(described["emission"]):
        note(assets, pbrt_nearest.BALL, name)
        scene["lights"].append(ball(words, described["emission"], to_world, assets.scale))
    else:
        scene["meshes"].append(mesh(name, words, described, to_world, assets))


def ball(words, radiance, to_world, scale):
    said, stretch = parameters(words[1:]), numpy.linalg.norm(to_world[:3, :3], axis=0)
    only(said, "a sphere", "float radius")
    if not numpy.allclose(stretch, stretch[0], rtol=1e-5):
        raise Unsupported("a lamp that is a stretched sphere is not compared")
    radius = float(scale * stretch[0] * said.get("float radius", 1))
    return {"type": "POINT", "position": axes(scale * to_world[:3, 3]).tolist(), "radius": radius,
            "radiant_intensity": [math.pi * radius ** 2 * x for x in radiance]}


def mesh(name, words, described, to_world, assets):
    """Triangles of corners, as blender_scene.mesh() makes them. Their front, which shines, is where
    the file's windings say; a transform that mirrors keeps it."""
    shape, corners, normals, uvs = triangles(words, name, assets)
    kept = apart(corners)
    corners, normals, uvs = (part if part is None else part[kept]
                             for part in (corners, normals, uvs))
    linear = to_world[:3, :3]
    corners = corners @ linear.T + to_world[:3, 3]
    if numpy.linalg.det(linear) < 0:
        corners, normals, uvs = (part if part is None else part[:, ::-1]
                                 for part in (corners, normals, uvs))
    if normals is not None:
        normals = normals @ numpy.linalg.inv(linear)
        normals /= numpy.linalg.norm(normals, axis=2, keepdims=True)
        if blender_scene.are_flat(corners, normals):
            normals = None
    if has_texture(described):
        if uvs is None:
            raise Unsupported(f"material '{name}' has a texture and a mesh without coordinates")
        described = described | {"uvs": uvs.tolist()}
    return {"name": shape, "instances": None, "corners": axes(assets.scale * corners).tolist(),
            "normals": None if normals is None else axes(normals).tolist()} | described


def triangles(words, material, assets):
    """The mesh's name, corners, normals and texture coordinates."""
    kind, said = json.loads(words[0]), parameters(words[1:])
    if kind == "plymesh":
        only(said, "a mesh", "string filename")
        return (pathlib.Path(said["string filename"]).stem,
                *read_ply(assets.folder / said["string filename"]))
    only(said, "a sphere", "float radius")
    note(assets, pbrt_nearest.SPHERE, material)
    return "sphere", *pbrt_nearest.sphere(said.get("float radius", 1)), None


def apart(corners):
    """Which triangles to keep so that none lies in another's place: what Cycles sends from one of
    two would meet the other."""
    points = numpy.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)[1].reshape(-1, 3)
    turned = (points.argmin(axis=1)[:, None] + numpy.arange(3)) % 3
    same = numpy.take_along_axis(points, turned, axis=1)
    return numpy.sort(numpy.unique(same, axis=0, return_index=True)[1])


def has_texture(described):
    return isinstance(described["albedo"], dict) or "bump" in described


def inside(words, assets):
    """The medium within, which dims by the length of the way. pbrt's mesh is closed."""
    name, outside = map(json.loads, words or ('""', '""'))
    if outside:
        raise Unsupported(f"a shape within the medium '{outside}' is not compared")
    if not name:
        return {}
    return {"absorption": [x / assets.scale for x in
                           pbrt_nearest.absorption(name, assets.media[name])]}


def placement(words):
    """pbrt writes matrices column by column."""
    return numpy.identity(4) if words is None else vector(words[1:-1]).reshape(4, 4).T


def emission(words):
    said = parameters(words[1:]) if words else {}
    only(said, "an area light", "rgb L", "bool twosided")
    return {"emission": said.get("rgb L", [0.0] * 3), "two_sided": said.get("bool twosided", False)}


def known_type(name, material, surfaces):
    kind = material["string type"]
    if kind not in surfaces:
        raise Unsupported(f"material '{name}' is of the type {kind}, which has no "
                          + ("near" if surfaces is not SURFACES else "exact")
                          + f" counterpart in Cycles; only {' and '.join(surfaces)} are compared")
    return surfaces[kind]


def surface(name, assets):
    material = assets.materials[name]
    keys, described = known_type(name, material, assets.surfaces)
    only(material, f"material '{name}'", "string type", *keys)
    described = described(material)
    for nearest in described.pop("nearest", ()):
        note(assets, nearest, name)
    return described


def glass(material):
    if material.get("float roughness", 0) != 0:
        raise Unsupported("rough glass is not compared")
    return {"surface": "glass", "albedo": [1.0] * 3, "ior": material.get("float eta", 1.5)}


def read_ply(path):
    """Corners, normals [triangle, corner, xyz] and texture coordinates; None where the file has
    none."""
    types = {"float": "<f4", "double": "<f8"}
    header, body = path.read_bytes().split(b"end_header\n", 1)
    lines = [line.split() for line in header.decode().splitlines()]
    vertices, triangles = (int(line[2]) for line in lines if line[0] == "element")
    layout = numpy.dtype([(line[2], types[line[1]]) for line in lines
                          if line[0] == "property" and line[1] in types])
    table = numpy.frombuffer(body, layout, vertices)
    face = numpy.dtype([("count", "u1"), ("corners", "<i4", 3)])
    indices = numpy.frombuffer(body, face, triangles, vertices * layout.itemsize)["corners"]
    return [numpy.stack([table[name] for name in names], axis=1).astype(float)[indices]
            if names[0] in layout.names else None for names in ("xyz", ("nx", "ny", "nz"), "uv")]
