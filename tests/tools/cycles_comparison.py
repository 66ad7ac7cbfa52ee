"""What cycles_comparison_test.cpp asks of tools/benchmarks/blender, printed as JSON.

    cycles_comparison.py SOURCE_FOLDER QUESTION [arguments]
"""

import json
import pathlib
import sys

ROOT = pathlib.Path(sys.argv[1])
sys.path += [str(ROOT / "tools" / "benchmarks"), str(ROOT / "tools" / "dev" / "shared")]

import numpy  # noqa: E402

from blender import agreement, blender_scene, closed_form, cycles_renders, pbrt_scene  # noqa: E402
from exr import read_channels, read_exr, stacked  # noqa: E402


def scene(path, scale="1"):
    reader = pbrt_scene if path.endswith(".pbrt") else blender_scene
    return reader.read(path, float(scale))


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


def placed(mesh):
    """A mesh's corners, once for each instance."""
    corners = numpy.array(mesh["corners"])
    for to_world in map(numpy.array, mesh["instances"] or [numpy.identity(4)]):
        yield corners @ to_world[:3, :3].T + to_world[:3, 3]


def distances(points, triangle):
    """To the triangle's plane; where a point lies beside the triangle, infinite."""
    a, b, c = triangle
    normal = numpy.cross(b - a, c - a)
    normal /= numpy.linalg.norm(normal)
    uvw = numpy.linalg.solve(numpy.stack([b - a, c - a, normal], axis=1), (points - a).T)
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


print(json.dumps(globals()[sys.argv[2]](*sys.argv[3:])))
