"""What a picture of lamps must be where integrals are known: the judge where renderers differ.

Scenes are those of blender_scene.read(). Pixels count from the upper left corner.
"""

import numpy

SUBPIXELS = 4  # a side; what is averaged varies by less than a percent over a pixel


def lamps(scene):
    """(triangle, radiance) of all."""
    return [(numpy.array(triangle), numpy.array(mesh["emission"]))
            for mesh in scene["meshes"] if any(mesh["emission"]) for triangle in mesh["corners"]]


def seen_lamps(scene, width, height):
    """The sum over the picture's pixels if nothing but the lamps themselves is seen, all of them
    wholly: radiance by projected area."""
    return sum(radiance * area(project(scene["camera"], triangle, width, height))
               for triangle, radiance in lamps(scene))


def area(polygon):
    x, y = polygon.T
    return abs(x @ numpy.roll(y, -1) - y @ numpy.roll(x, -1)) / 2


def project(camera, points, width, height):
    to_world = numpy.array(camera["to_world"])
    x, y, z = ((points - to_world[:3, 3]) @ to_world[:3, :3]).T  # right, up, back
    pixels = height / (2 * numpy.tan(camera["fovy"] / 2))
    return numpy.stack([width / 2 - pixels * x / z, height / 2 + pixels * y / z], axis=1)


def direct_light(scene, columns, rows, width, height):
    """The mean radiance of some pixels that see the lamps directly and wholly."""
    return numpy.mean([radiance_at(scene, x, y, width, height)
                       for y in subpixels(rows) for x in subpixels(columns)], axis=0)


def subpixels(pixels):
    return (numpy.arange(pixels.start * SUBPIXELS, pixels.stop * SUBPIXELS) + .5) / SUBPIXELS


def radiance_at(scene, x, y, width, height):
    to_world = numpy.array(scene["camera"]["to_world"])
    pixels = height / (2 * numpy.tan(scene["camera"]["fovy"] / 2))
    direction = to_world[:3, :3] @ [(x - width / 2) / pixels, (height / 2 - y) / pixels, -1]
    _, point, normal, albedo = min((hit for mesh in scene["meshes"] for triangle in mesh["corners"]
                                    if (hit := intersect(to_world[:3, 3], direction,
                                                         numpy.array(triangle), mesh["albedo"]))),
                                   key=lambda hit: hit[0])
    light = sum(radiance * irradiance(triangle - point, normal)
                for triangle, radiance in lamps(scene))
    return numpy.array(albedo) / numpy.pi * light


def intersect(origin, direction, triangle, albedo):
    """(distance, point, normal to the viewer, albedo), or None."""
    a, b, c = triangle
    system = numpy.stack([b - a, c - a, -direction], axis=1)
    if numpy.linalg.det(system) == 0:
        return None
    u, v, distance = numpy.linalg.solve(system, origin - a)
    if not (u >= 0 and v >= 0 and u + v <= 1 and distance > 0):
        return None
    normal = numpy.cross(b - a, c - a)
    normal /= -numpy.linalg.norm(normal) * numpy.sign(normal @ direction)
    return distance, origin + distance * direction, normal, albedo


def irradiance(polygon, normal):
    """Of a polygon of radiance 1 above the horizon, about the point lit [Lambert1760]: half the sum
    over its edges of their angle and the cosine to the plane that they span with the point."""
    unit = polygon / numpy.linalg.norm(polygon, axis=1, keepdims=True)
    total = 0
    for a, b in zip(unit, numpy.roll(unit, -1, axis=0)):
        plane = numpy.cross(a, b)
        sine = numpy.linalg.norm(plane)
        total += numpy.arctan2(sine, a @ b) * (plane @ normal) / sine
    return abs(total) / 2
