"""A candela scene file as Blender takes it: numbers in Blender's axes, in units of physics.

Read is what the compared scenes use of docs/scene_format.md: diffuse surfaces, mirrors, clear
glass, white rough metals, lamps, point and directional lights, one lat-long map or one radiance
from everywhere, one camera, instances. Any other key is refused, so that nothing is left out of a
comparison silently.

Axes: candela's (x, y, z), y up, is Blender's (-z, -x, y), z up. It is a rotation, and the one that
takes the middle of a lat-long map from where candela has it, -z, to where Blender has it, +x.
"""

import math
import pathlib

import numpy
import yaml


class Unsupported(Exception):
    """The scene holds what this reader does not know."""


def read(path, scale=1):
    """Lengths are multiplied by `scale`, and what points shine by its square: the same picture."""
    path = pathlib.Path(path)
    file = yaml.safe_load(path.read_text())
    only(file, path, "Render", "Cameras", "Environment", "Lights", "Materials", "Models")
    materials = {material["Name"]: material for material in file["Materials"]}
    return {
        "camera": camera(file["Cameras"][0], scale),
        "meshes": [mesh(model, materials[model["Material"]], path.parent, scale)
                   for model in file["Models"]],
        "lights": [light(entry, scale) for entry in file.get("Lights", ())],
        "environment": environment(file["Environment"], path.parent)
        if "Environment" in file else None,
        "approximated": [],  # what has no exact counterpart [pbrt_scene.py]
    }


def only(entry, where, *keys):
    unknown = set(entry) - set(keys)
    if unknown:
        raise Unsupported(f"{where}: '{sorted(unknown)[0]}' is not compared; expected only "
                          + ", ".join(keys))


def axes(points):
    """candela's axes to Blender's, of points or directions in rows."""
    return numpy.asarray(points, float)[..., [2, 0, 1]] * [-1, -1, 1]


def unit(vector):
    return vector / numpy.linalg.norm(vector)


def vector(value):
    """YAML 1.1, which PyYAML reads, takes `-.1` for a word; candela takes it for a number."""
    return numpy.array(value, dtype=str).astype(float)


def rgb(value):
    return (vector(value) * numpy.ones(3)).tolist()


def camera(entry, scale):
    """`to_world`: columns right, up, back and the eye, as Blender's cameras look along their -z."""
    only(entry, "a camera", "Eye", "Target", "Up", "Fovy")
    eye = vector(entry["Eye"])
    back = unit(eye - vector(entry["Target"]))
    right = unit(numpy.cross(vector(entry.get("Up", [0, 1, 0])), back))
    up = numpy.cross(back, right)
    to_world = numpy.identity(4)
    to_world[:3] = axes([right, up, back, scale * eye]).T
    return {"to_world": to_world.tolist(), "fovy": math.radians(float(entry.get("Fovy", 60)))}


def light(entry, scale):
    """lab 3's intensities are 1 / pi of the physical ones [docs/scene_format.md]."""
    only(entry, "a light", "Type", "Position", "Direction", "Intensity")
    strength = [math.pi * x for x in rgb(entry["Intensity"])]
    if entry["Type"] == "Point":
        return {"type": "POINT", "position": axes(scale * vector(entry["Position"])).tolist(),
                "radiant_intensity": [scale ** 2 * x for x in strength]}
    if entry["Type"] == "Directional":
        return {"type": "SUN", "towards": axes(unit(vector(entry["Direction"]))).tolist(),
                "irradiance": strength}
    raise Unsupported(f"a light of the type '{entry['Type']}'; expected Point or Directional")


def environment(entry, folder):
    """`turn`: of the map about Blender's z. Without a map: `scale` from everywhere."""
    only(entry, "the environment", "Map", "Rotation", "Scale", "Radiance")
    if "Radiance" in entry:
        scale = vector(rgb(entry["Radiance"])) * vector(rgb(entry.get("Scale", 1)))
        return {"map": None, "scale": scale.tolist(), "turn": 0}
    return {"map": str((folder / entry["Map"]).resolve()), "scale": rgb(entry.get("Scale", 1)),
            "turn": math.radians(float(entry.get("Rotation", 0)))}


def mesh(model, material, folder, scale):
    """Triangles of corners: no vertex is shared, since each corner has the file's normal."""
    only(model, "a model", "Mesh", "Material", "Translation", "Scale", "Rotation", "Instances")
    described = surface(material)
    corners, normals = read_obj(folder / model["Mesh"])
    stretch, rotation, translation = placement(model)
    corners = (corners * stretch) @ rotation.T + translation
    normals = (normals / stretch) @ rotation.T
    normals /= numpy.linalg.norm(normals, axis=2, keepdims=True)
    if numpy.prod(stretch) * numpy.linalg.det(rotation) < 0:  # the front stays the front
        corners, normals = corners[:, ::-1], normals[:, ::-1]
    return {"name": pathlib.Path(model["Mesh"]).stem, "corners": axes(scale * corners).tolist(),
            "normals": None if are_flat(corners, normals) else axes(normals).tolist(),
            "instances": [instance(entry, scale) for entry in model["Instances"]]
            if "Instances" in model else None} | described


def placement(entry):
    """Scale, rotation and translation, in the order in which they are applied."""
    return (vector(entry.get("Scale", [1, 1, 1])), vector(entry.get("Rotation", numpy.identity(3))),
            vector(entry.get("Translation", [0, 0, 0])))


def instance(entry, scale):
    """A matrix of Blender's axes."""
    only(entry, "an instance", "Translation", "Scale", "Rotation")
    stretch, rotation, translation = placement(entry)
    to_world = numpy.identity(4)
    to_world[:3, :3] = axes(axes(rotation * stretch).T).T  # both its rows' and columns' axes
    to_world[:3, 3] = axes(scale * translation)
    return to_world.tolist()


# By `Type`: what of a material is read, and what Blender is told beside `surface`.
SURFACES = {
    "diffuse": (("kd", "Emission", "TwoSided"), lambda m: {
        "surface": "diffuse", "albedo": rgb(m.get("kd", .5)),
        "emission": rgb(m.get("Emission", 0)), "two_sided": bool(m.get("TwoSided", False))}),
    "mirror": (("kd",), lambda m: {
        "surface": "glossy", "albedo": rgb(m.get("kd", 1)), "roughness": 0.0}),
    "cook_torrance": (("kd", "ks", "F0", "geometry", "roughness"), lambda m: white_metal(m)),
    "dielectric": (("ior",), lambda m: {
        "surface": "glass", "albedo": [1.0] * 3, "ior": float(m.get("ior", 1.5))}),
}


def surface(material):
    where = f"material '{material['Name']}'"
    if material.get("Type") not in SURFACES:
        raise Unsupported(f"{where} is of none of the types that are compared: "
                          + ", ".join(SURFACES))
    keys, described = SURFACES[material["Type"]]
    only(material, where, "Name", "Type", *keys)
    return {"emission": [0.0] * 3, "two_sided": False} | described(material)


def white_metal(material):
    """GGX without a Fresnel term, which both have. Cycles' roughness is the root of the width."""
    white = rgb(material.get("F0", .04)) == [1.0] * 3 and not any(rgb(material.get("kd", .5)))
    if not white or material.get("geometry") != "smith":
        raise Unsupported(f"material '{material['Name']}': of cook_torrance only F0: 1 with kd: 0 "
                          "and geometry: smith is compared")
    return {"surface": "glossy", "albedo": rgb(material.get("ks", .5)),
            "roughness": math.sqrt(float(material.get("roughness", .3)))}


def are_flat(corners, normals):
    """Whether the normals say no more than the windings do."""
    faces = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    sizes = numpy.linalg.norm(faces, axis=1, keepdims=True)
    seen = sizes[:, 0] > 0
    return bool(numpy.abs(normals[seen] - (faces[seen] / sizes[seen])[:, None]).max(initial=0)
                < 1e-4)


def read_obj(path):
    """Corners and normals as [triangle, corner, xyz]; every corner of the file is `v//vn`."""
    points, directions, triangles = [], [], []
    for line in path.read_text().splitlines():
        kind, *words = line.split("#")[0].split() or [""]
        if kind == "v":
            points.append([float(word) for word in words])
        elif kind == "vn":
            directions.append([float(word) for word in words])
        elif kind == "f":
            face = [tuple(int(number) - 1 for number in word.split("//")) for word in words]
            triangles += split(face, points)
        elif kind:
            raise Unsupported(f"{path}: '{kind}' is not compared; expected v, vn and f")
    corners = numpy.array([[points[v] for v, _ in triangle] for triangle in triangles])
    normals = numpy.array([[directions[n] for _, n in triangle] for triangle in triangles])
    return corners, normals


def split(face, points):
    """Convex quads along their shorter diagonal, as candela does: a wall of the Cornell box is not
    plane, and the other diagonal would make another wall."""
    def distance(a, b):
        return math.dist(points[face[a][0]], points[face[b][0]])
    if len(face) == 3:
        return [face]
    if len(face) != 4:
        raise Unsupported(f"a face of {len(face)} corners; expected 3 or 4")
    a, b, c, d = face
    return [[a, b, c], [a, c, d]] if distance(0, 2) < distance(1, 3) else [[a, b, d], [b, c, d]]
