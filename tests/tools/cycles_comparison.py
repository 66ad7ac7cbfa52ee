"""What cycles_comparison_test.cpp asks of tools/benchmarks/blender, printed as JSON.

    cycles_comparison.py SOURCE_FOLDER QUESTION [arguments]
"""

import pathlib

from answers import print_answer  # first: it tells where the modules below are

import numpy
from blender import (agreement, blender_scene, closed_form, cycles_renders, equal_area,
                     pbrt_nearest, pbrt_scene)
from exr import read_channels, read_exr, stacked
from pixels import block_means


def scene(path, scale="1"):
    reader = pbrt_scene if path.endswith(".pbrt") else blender_scene
    return reader.read(path, float(scale))


def nearest(path, scale="1"):
    return pbrt_scene.read(path, float(scale), nearest=True)


def apart(path, other, scale):
    """The largest difference between two scenes' numbers; None where more than numbers differ."""
    return most_apart(scene(path, scale), scene(other, scale))


def most_apart(a, b):
    if isinstance(a, dict) and isinstance(b, dict) and a.keys() == b.keys():
        parts = [(a[key], b[key]) for key in a]
    elif isinstance(a, list) and isinstance(b, list) and len(a) == len(b):
        parts = list(zip(a, b))
    elif isinstance(a, (int, float)) and isinstance(b, (int, float)):
        return abs(a - b)
    else:
        return 0 if a == b else None
    found = [most_apart(*part) for part in parts]
    return None if None in found else max(found, default=0)


def lamps(path, exr):
    """Of each lamp: whether Blender's front faces the camera, what it shines, from both sides or
    not, and what candela's camera sees at its middle."""
    picture, described = read_exr(pathlib.Path(exr)), scene(path)
    height, width = picture.shape[:2]
    eye = numpy.array(described["camera"]["to_world"])[:3, 3]
    found = []
    for mesh in described["meshes"]:
        if not any(mesh["emission"]):
            continue
        a, b, c = numpy.array(mesh["corners"][0])
        middle = numpy.mean(mesh["corners"], axis=(0, 1))
        x, y = closed_form.project(described["camera"], middle[None], width, height)[0]
        found.append({"faces": bool(numpy.cross(b - a, c - a) @ (eye - middle) > 0),
                      "shines": mesh["emission"], "two_sided": mesh["two_sided"],
                      "seen": picture[int(y), int(x)].tolist()})
    return found


def refused(path):
    try:
        scene(path)
        return None
    except blender_scene.Unsupported as reason:
        return str(reason)


def positions(path, exr):
    """Of candela's surface points, at most: how far they lie from the pixels that saw them, in
    pixels, and from the nearest triangle that Blender gets, as a part of the camera's distance."""
    channels = read_channels(pathlib.Path(exr))
    points = stacked(channels, ["position.X", "position.Y", "position.Z"])
    height, width = points.shape[:2]
    depth = channels["depth.Z"]
    seen = depth > 0
    described = scene(path)
    points = blender_scene.axes(points[seen])
    pixels = closed_form.project(described["camera"], points, width, height)
    rows, columns = numpy.nonzero(seen)
    centres = numpy.stack([columns, rows], axis=1) + .5
    triangles = numpy.concatenate([corners for mesh in described["meshes"]
                                   for corners in placed(mesh)])
    off = numpy.min([distances(points, triangle) for triangle in triangles], axis=0) / depth[seen]
    return {"count": int(seen.sum()), "pixels": float(numpy.abs(pixels - centres).max()),
            "off_surface": float(off.max())}


def checks(path, exr):
    """Where the textures of Blender's meshes, by its own formula, are the albedos that candela
    saw."""
    channels = read_channels(pathlib.Path(exr))
    seen = channels["depth.Z"] > 0
    points = blender_scene.axes(
        stacked(channels, ["position.X", "position.Y", "position.Z"])[seen])
    albedos = stacked(channels, ["albedo.R", "albedo.G", "albedo.B"])[seen]
    found, least = numpy.zeros_like(albedos), numpy.full(len(points), numpy.inf)
    for mesh in nearest(path)["meshes"]:
        texture = mesh["albedo"]
        for triangle, uvs in zip(numpy.array(mesh["corners"]), numpy.array(mesh["uvs"])):
            off, at = distances(points, triangle), barycentric(points, triangle)[:2].T
            uv = uvs[0] + at @ (uvs[1:] - uvs[0])
            # Blender's checker texture: its second colour where both are even or both odd.
            odd = numpy.floor(uv * texture["uv_scale"]).sum(axis=1) % 2
            nearer = off < least
            found[nearer] = numpy.where(odd[:, None], *reversed(texture["checks"]))[nearer]
            least = numpy.minimum(off, least)
    right = numpy.abs(found - albedos).max(axis=1) < 1e-6
    dark = albedos[:, 0] < .5
    return {"dark": int(dark.sum()), "light": int((~dark).sum()), "wrong": int((~right).sum())}


def sky(path, exr):
    """Mean and largest difference of what candela's camera sees of a sky from what the map that
    Cycles looks up has there, over the mean."""
    picture, described = read_exr(pathlib.Path(exr)), nearest(path)
    image = read_exr(pathlib.Path(described["environment"]["map"]))
    found = equal_area.lat_long(image, described["environment"]["map_from_world"])
    parts, size = 16, picture.shape[0]
    across = (numpy.arange(parts * size) + .5) / (parts * size) * 2 - 1
    x, y = numpy.meshgrid(across, -across)
    reach = numpy.tan(described["camera"]["fovy"] / 2)
    towards = (numpy.stack([reach * x, reach * y, -numpy.ones_like(x)], axis=-1)
               @ numpy.array(described["camera"]["to_world"])[:3, :3].T)
    towards /= numpy.linalg.norm(towards, axis=-1, keepdims=True)
    rows, columns = found.shape[:2]
    row = (.5 - numpy.arcsin(towards[..., 2]) / numpy.pi) * rows
    column = (.5 - numpy.arctan2(towards[..., 1], towards[..., 0]) / (2 * numpy.pi)) * columns
    seen = found[row.astype(int), column.astype(int) % columns]
    seen = seen.reshape(size, parts, size, parts, 3).mean(axis=(1, 3))
    off = numpy.abs(seen - picture) / picture.mean()
    return {"mean": float(off.mean()), "largest": float(off.max()),
            "contrast": float(picture.std() / picture.mean())}


def cycles_beside(path, exr, folder, spp):
    """How far candela's picture is above Cycles' of the nearest scene: the means, by channel, and
    blocks of 8 x 8 pixels."""
    ours = read_exr(pathlib.Path(exr))
    job = cycles_renders.Job("near", *ours.shape[1::-1], int(spp), 1, first_sample=4)
    cycles = cycles_renders.Cycles(pathlib.Path(folder), 1)
    theirs = cycles.render({"near": nearest(path)}, [job])[job].colour
    a, b = (block_means(picture, agreement.BLOCK).mean(axis=2) for picture in (ours, theirs))
    return {"means": (ours.mean(axis=(0, 1)) / theirs.mean(axis=(0, 1))).tolist(),
            "blocks": sorted(numpy.abs(a / b - 1).ravel().tolist())}


def ball(radius):
    """Of the mesh in place of a sphere."""
    corners, normals = pbrt_nearest.sphere(float(radius))
    edges = corners[:, [1, 2, 0]] - corners
    faces = numpy.cross(edges[:, 0], edges[:, 1])
    areas = numpy.linalg.norm(faces, axis=1)
    middles = corners.mean(axis=1)
    outwards = (faces * middles).sum(axis=1) / areas / numpy.linalg.norm(middles, axis=1)
    return {"area": float(areas.sum() / 2), "least_outwards": float(outwards.min()),
            "unclosed": float(numpy.abs(faces.sum(axis=0)).max()),
            "volume": float((faces * middles).sum() / 6),
            "normals": float(numpy.abs(corners / numpy.linalg.norm(corners, axis=2, keepdims=True)
                                       - normals).max())}


def mean(exr):
    return read_exr(pathlib.Path(exr)).mean(axis=(0, 1)).tolist()


def placed(mesh):
    """A mesh's corners, once for each instance."""
    corners = numpy.array(mesh["corners"])
    for to_world in map(numpy.array, mesh["instances"] or [numpy.identity(4)]):
        yield corners @ to_world[:3, :3].T + to_world[:3, 3]


def barycentric(points, triangle):
    """Along the two edges from the first corner, and off the plane."""
    a, b, c = triangle
    normal = numpy.cross(b - a, c - a)
    normal /= numpy.linalg.norm(normal)
    return numpy.linalg.solve(numpy.stack([b - a, c - a, normal], axis=1), (points - a).T)


def distances(points, triangle):
    """To the triangle's plane; where a point lies beside the triangle, infinite."""
    uvw = barycentric(points, triangle)
    inside = (uvw[0] > -1e-3) & (uvw[1] > -1e-3) & (uvw[0] + uvw[1] < 1.001)
    return numpy.where(inside, numpy.abs(uvw[2]), numpy.inf)


def pictures(seed, shift):
    """Two renderers of the same noise; one's block in row 1, column 2 is brighter by `shift`."""
    random = numpy.random.default_rng(int(seed))
    ours, theirs = (1 + .1 * random.standard_normal((8, 96, 128, 3)) for _ in range(2))
    ours[:, 8:16, 16:24] += float(shift)
    ours[:, :8, :8] = theirs[:, :8, :8] = 0  # a black block
    result = agreement.compare(ours, theirs)
    return {"failures": result.failures(result.tests), "spread": result.spread.tolist(),
            "black_p": float(result.p[0, 0, 0])}


def tail(t, freedom):
    return float(agreement.student_tail(numpy.array([float(t)]), numpy.array([float(freedom)]))[0])


def corner_irradiance(width, height, distance):
    """Of a rectangle whose corner is straight above the point."""
    a, b, c = float(width), float(height), float(distance)
    return float(closed_form.irradiance(
        numpy.array([[0, 0, c], [a, 0, c], [a, b, c], [0, b, c]]), numpy.array([0, 0, 1])))


def samples(log):
    return cycles_renders.samples_taken(pathlib.Path(log).read_text())


def times(log):
    return cycles_renders.times(pathlib.Path(log).read_text())


print_answer(globals())
