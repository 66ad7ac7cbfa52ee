"""The assets' shapes."""

import math

from noise import hash01
from obj_file import Obj, add, cross, normalise, scale


def rectangle(corner, edge_u, edge_v, uv_u=1, uv_v=1, comment="a rectangle"):
    obj = Obj(comment)
    normal = normalise(cross(edge_u, edge_v))
    obj.face([(add(corner, scale(edge_u, u), scale(edge_v, v)), (u * uv_u, v * uv_v), normal)
              for u, v in ((0, 0), (1, 0), (1, 1), (0, 1))])
    return obj


def box(low, high, comment):
    obj = Obj(comment)
    for axis in range(3):
        for side in (0, 1):
            normal = tuple((2 * side - 1) if a == axis else 0 for a in range(3))
            u, v = (axis + 1) % 3, (axis + 2) % 3
            ring = [(0, 0), (1, 0), (1, 1), (0, 1)] if side else [(0, 0), (0, 1), (1, 1), (1, 0)]
            corners = []
            for cu, cv in ring:
                p = [0, 0, 0]
                p[axis] = (low, high)[side][axis]
                p[u] = (low, high)[cu][u]
                p[v] = (low, high)[cv][v]
                corners.append((tuple(p), None, normal))
            obj.face(corners)
    return obj


def icosphere(levels):
    g = (1 + math.sqrt(5)) / 2
    points = [normalise(p) for p in [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0),
                                     (0, -1, g), (0, 1, g), (0, -1, -g), (0, 1, -g),
                                     (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4),
             (11, 10, 2), (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8),
             (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    for _ in range(levels):
        middle = {}

        def between(a, b):
            key = (min(a, b), max(a, b))
            if key not in middle:
                middle[key] = len(points)
                points.append(normalise(add(points[a], points[b])))
            return middle[key]

        split = []
        for a, b, c in faces:
            ab, bc, ca = between(a, b), between(b, c), between(c, a)
            split += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        faces = split
    obj = Obj(f"unit sphere: an icosahedron divided {levels} times, normals of the true sphere")
    for face in faces:
        obj.face([(points[i], None, points[i]) for i in face])
    return obj


def lathe(profile, segments, comment):
    """Turns (radius, y) points, bottom to top, about +y; flat along the profile's segments."""
    obj = Obj(comment)
    for (r0, y0), (r1, y1) in zip(profile, profile[1:]):
        slope = normalise((y1 - y0, r0 - r1, 0))

        def corner(r, y, k):
            c, s = math.cos(math.tau * k / segments), math.sin(math.tau * k / segments)
            return ((r * c, y, r * s), None, (slope[0] * c, slope[1], slope[0] * s))

        for k in range(segments):
            ring = [corner(r0, y0, k), corner(r1, y1, k), corner(r1, y1, k + 1),
                    corner(r0, y0, k + 1)]
            unique = [c for i, c in enumerate(ring) if c[0] not in [d[0] for d in ring[:i]]]
            obj.face(unique)
    return obj


def plant(leaves, seed):
    """Leaves around an upright stem, each two quads bent along its length."""
    obj = Obj("a potted plant's leaves; the picture decides where a leaf ends")
    for k in range(leaves):
        turn = k * 2.39996 + 0.3 * hash01(seed, "turn", k)  # the golden angle
        up = 0.12 + 0.55 * (k / leaves) + 0.05 * hash01(seed, "up", k)
        length = 0.52 - 0.2 * (k / leaves) + 0.08 * hash01(seed, "length", k)
        width = 0.42 * length
        rise = math.radians(5 + 60 * (k / leaves) + 15 * hash01(seed, "rise", k))
        out = (math.cos(turn), 0, math.sin(turn))
        side = (-math.sin(turn), 0, math.cos(turn))
        root = add(scale(out, 0.02), (0, up, 0))
        directions = [rise, rise - math.radians(40)]
        points, normals = [root], []
        for angle in directions:
            step = add(scale(out, math.cos(angle)), (0, math.sin(angle), 0))
            points.append(add(points[-1], scale(step, length / 2)))
            normals.append(normalise(cross(side, step)))
        ends = [normals[0], normalise(add(*normals)), normals[1]]
        for i in range(2):
            corners = []
            for j, s in ((i, -1), (i, 1), (i + 1, 1), (i + 1, -1)):
                corners.append((add(points[j], scale(side, s * width / 2)),
                                (0.5 + 0.5 * s, j / 2), ends[j]))
            obj.face(corners)
    return obj
