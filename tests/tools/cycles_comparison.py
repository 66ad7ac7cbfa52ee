"""What cycles_comparison_test.cpp asks of tools/benchmarks/blender, printed as JSON.

    cycles_comparison.py SOURCE_FOLDER QUESTION [arguments]
"""

import json
import pathlib
import sys

ROOT = pathlib.Path(sys.argv[1])
sys.path += [str(ROOT / "tools" / "benchmarks"), str(ROOT / "tools" / "dev" / "shared")]

import numpy  # noqa: E402

from blender import agreement, blender_scene, closed_form, cycles_renders  # noqa: E402
from exr import read_channels, stacked  # noqa: E402


def scene(path, scale="1"):
    return blender_scene.read(path, float(scale))


def refused(path):
    try:
        blender_scene.read(path)
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
    described = blender_scene.read(path)
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
