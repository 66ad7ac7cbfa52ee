"""Triangle meshes of simple shapes. Fronts are where corners run counter-clockwise."""

import dataclasses

import numpy


@dataclasses.dataclass
class Mesh:
    points: numpy.ndarray  # [n, 3]
    faces: numpy.ndarray  # [m, 3] of indices
    normals: numpy.ndarray = None  # [n, 3], of smooth meshes; None: those of the triangles

    def face_normals(self):
        a, b, c = (self.points[self.faces[:, i]] for i in range(3))
        return unit(numpy.cross(b - a, c - a))

    def obj_normals(self):
        """The normals and, for each corner of each face, which one it has."""
        if self.normals is not None:
            return self.normals, self.faces
        return self.face_normals(), numpy.repeat(numpy.arange(len(self.faces))[:, None], 3, axis=1)

    def moved(self, translation):
        return Mesh(self.points + translation, self.faces, self.normals)


def unit(vectors):
    return vectors / numpy.linalg.norm(vectors, axis=-1, keepdims=True)


def joined(*meshes):
    """Either all smooth or all flat."""
    starts = numpy.cumsum([0] + [len(mesh.points) for mesh in meshes[:-1]])
    return Mesh(numpy.concatenate([mesh.points for mesh in meshes]),
                numpy.concatenate([mesh.faces + start for mesh, start in zip(meshes, starts)]),
                None if meshes[0].normals is None
                else numpy.concatenate([mesh.normals for mesh in meshes]))


def triangle(a, b, c):
    return Mesh(numpy.array([a, b, c], float), numpy.array([[0, 1, 2]]))


def quad(a, b, c, d):
    return Mesh(numpy.array([a, b, c, d], float), numpy.array([[0, 1, 2], [0, 2, 3]]))


def lamp_below(centre, width, depth):
    """A rectangle that faces down."""
    x, y, z = centre
    w, d = width / 2, depth / 2
    return quad((x - w, y, z - d), (x + w, y, z - d), (x + w, y, z + d), (x - w, y, z + d))


def box(low, high, inward=False):
    """With its faces to the outside, or to the inside: a room."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    sides = joined(
        quad((x0, y0, z0), (x0, y1, z0), (x1, y1, z0), (x1, y0, z0)),
        quad((x0, y0, z1), (x1, y0, z1), (x1, y1, z1), (x0, y1, z1)),
        quad((x0, y0, z0), (x0, y0, z1), (x0, y1, z1), (x0, y1, z0)),
        quad((x1, y0, z0), (x1, y1, z0), (x1, y1, z1), (x1, y0, z1)),
        quad((x0, y0, z0), (x1, y0, z0), (x1, y0, z1), (x0, y0, z1)),
        quad((x0, y1, z0), (x0, y1, z1), (x1, y1, z1), (x1, y1, z0)))
    return Mesh(sides.points, sides.faces[:, ::-1]) if inward else sides


def turned_box(size, centre, degrees):
    """Turned about the vertical axis through its centre."""
    half = numpy.array(size) / 2
    shape = box(-half, half)
    return Mesh(shape.points @ turn(degrees).T + numpy.array(centre), shape.faces)


def turn(degrees):
    """About +y: 90 takes +z to +x."""
    c, s = numpy.cos(numpy.radians(degrees)), numpy.sin(numpy.radians(degrees))
    return numpy.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])


def sphere(centre, radius, rounds=3, smooth=True):
    """An octahedron whose faces are cut into four, `rounds` times: 8 * 4^rounds triangles."""
    points = [numpy.array(p, float) for p in ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0),
                                              (0, 0, 1), (0, 0, -1))]
    faces = [(x, y, z) if (x + y + z) % 2 == 0 else (x, z, y)
             for x in (0, 1) for y in (2, 3) for z in (4, 5)]
    for _ in range(rounds):
        middles = {}

        def middle(a, b):
            key = min(a, b), max(a, b)
            if key not in middles:
                points.append(unit(points[a] + points[b]))
                middles[key] = len(points) - 1
            return middles[key]

        faces = [small for a, b, c in faces
                 for ab, bc, ca in [(middle(a, b), middle(b, c), middle(c, a))]
                 for small in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))]
    directions = numpy.array(points)
    return Mesh(directions * radius + numpy.array(centre), numpy.array(faces),
                directions if smooth else None)
