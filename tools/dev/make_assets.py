#!/usr/bin/env python3
"""Writes the generated files of assets/: meshes, textures and the studio environment.

Standard library only, no randomness: the same files come out everywhere.
    tools/dev/make_assets.py [folder of assets]
"""

import math
import pathlib
import struct
import sys
import zlib


def hash01(*keys):
    """A number in [0, 1) that looks random and depends on the keys alone."""
    return zlib.crc32(repr(keys).encode()) / 2**32


def smooth_noise(x, y, period, seed):
    """Value noise on a grid that repeats every `period` cells."""
    x0, y0 = math.floor(x), math.floor(y)
    fx, fy = x - x0, y - y0
    fx, fy = fx * fx * (3 - 2 * fx), fy * fy * (3 - 2 * fy)

    def corner(i, j):
        return hash01(seed, (x0 + i) % period, (y0 + j) % period)

    low = corner(0, 0) * (1 - fx) + corner(1, 0) * fx
    high = corner(0, 1) * (1 - fx) + corner(1, 1) * fx
    return low * (1 - fy) + high * fy


def to_byte(value):
    return max(0, min(255, round(255 * value)))


# --- files -------------------------------------------------------------------------------------


def write_png(path, width, height, pixel):
    """`pixel(x, y)` gives 1, 3 or 4 stored values in [0, 1]; y counts from the top."""
    rows = [[tuple(map(to_byte, pixel(x, y))) for x in range(width)] for y in range(height)]
    colour_type = {1: 0, 3: 2, 4: 6}[len(rows[0][0])]
    raw = b"".join(b"\0" + bytes(v for p in row for v in p) for row in rows)

    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data +
                struct.pack(">I", zlib.crc32(kind + data)))

    header = struct.pack(">IIBBBBB", width, height, 8, colour_type, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) +
                     chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b""))


def rgbe(colour):
    largest = max(colour)
    if largest < 1e-32:
        return (0, 0, 0, 0)
    mantissa, exponent = math.frexp(largest)
    scale = mantissa * 256 / largest
    return tuple(min(255, int(c * scale)) for c in colour) + (exponent + 128,)


def run_lengths(values):
    """Radiance's run-length code of one component of a scan line."""
    out, i = bytearray(), 0
    while i < len(values):
        run = 1
        while i + run < len(values) and run < 127 and values[i + run] == values[i]:
            run += 1
        if run > 2:
            out += bytes((128 + run, values[i]))
            i += run
            continue
        start = i
        while i < len(values) and i - start < 128:
            if i + 2 < len(values) and values[i] == values[i + 1] == values[i + 2]:
                break
            i += 1
        out += bytes((i - start,)) + bytes(values[start:i])
    return bytes(out)


def write_hdr(path, width, height, pixel):
    out = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + f"-Y {height} +X {width}\n".encode()
    for y in range(height):
        row = [rgbe(pixel(x, y)) for x in range(width)]
        out += struct.pack(">BBH", 2, 2, width)
        out += b"".join(run_lengths([p[c] for p in row]) for c in range(4))
    path.write_bytes(out)


def number(value):
    text = f"{value:.4f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


class Obj:
    def __init__(self, comment):
        self.comment = comment
        self.lines = {"v": {}, "vt": {}, "vn": {}}
        self.faces = []

    def index(self, kind, values):
        text = " ".join(map(number, values))
        table = self.lines[kind]
        return table.setdefault(text, len(table) + 1)

    def face(self, corners):
        """Corners are (position, uv or None, normal)."""
        words = []
        for position, uv, normal in corners:
            v, n = self.index("v", position), self.index("vn", normal)
            words.append(f"{v}/{self.index('vt', uv)}/{n}" if uv else f"{v}//{n}")
        self.faces.append("f " + " ".join(words))

    def write(self, path):
        lines = ["# " + self.comment]
        for kind, table in self.lines.items():
            lines += [f"{kind} {text}" for text in table]
        path.write_text("\n".join(lines + self.faces) + "\n")


# --- vectors -----------------------------------------------------------------------------------


def normalise(v):
    length = math.sqrt(sum(c * c for c in v))
    return tuple(c / length for c in v)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def add(*vectors):
    return tuple(map(sum, zip(*vectors)))


def scale(v, s):
    return tuple(c * s for c in v)


# --- meshes ------------------------------------------------------------------------------------


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


# --- pictures ----------------------------------------------------------------------------------


def tiles(x, y):
    """512 x 512: 4 x 4 stone tiles with grout, each of its own shade."""
    size = 128
    i, j = x // size, y // size
    u, v = x % size, y % size
    grey = min(u, v, size - 1 - u, size - 1 - v) < 3
    if grey:
        return (0.36, 0.34, 0.31)
    shade = 0.62 + 0.1 * hash01("tile", i, j) + (0.12 if (i + j) % 2 else -0.06)
    grain = round(4 * smooth_noise(x / 16, y / 16, 32, "stone")) / 4
    shade += 0.05 * (grain - 0.5)
    return (shade, shade * 0.93, shade * 0.83)


def brick_cell(x, y):
    """256 x 256, 4 rows of 2 bricks: which brick, and the distance to the mortar in pixels."""
    row = y // 64
    shifted = (x + (64 if row % 2 else 0)) % 256
    u, v = shifted % 128, y % 64
    return row, shifted // 128, min(u, v, 127 - u, 63 - v)


def bricks(x, y):
    row, column, inside = brick_cell(x, y)
    if inside < 4:
        return (0.66, 0.64, 0.6)
    shade = 0.85 + 0.3 * (hash01("brick", row, column) - 0.5)
    shade += 0.12 * (round(6 * smooth_noise(x / 8, y / 8, 32, "clay")) / 6 - 0.5)
    return (0.62 * shade, 0.33 * shade, 0.25 * shade)


def brick_heights(x, y):
    inside = brick_cell(x, y)[2]
    ramp = max(0.0, min(1.0, (inside - 2) / 5))
    rough = round(8 * smooth_noise(x / 8, y / 8, 32, "clay")) / 8
    return (ramp * (0.85 + 0.15 * rough),)


def wire_fence(x, y):
    """64 x 64, one mesh of a wire fence; repeats both ways."""
    u, v = (x + 0.5) / 64, (y + 0.5) / 64
    along = min(abs((u + v) % 1 - 0.5), abs((u - v) % 1 - 0.5))
    cover = max(0.0, min(1.0, (0.075 - along) * 30 + 0.5))
    round_shade = 1 - 3.5 * along
    return (0.55 * round_shade, 0.6 * round_shade, 0.58 * round_shade, cover)


def leaf(x, y):
    """128 x 256, one leaf, stalk at the bottom."""
    u, v = (x + 0.5) / 128 * 2 - 1, 1 - (y + 0.5) / 256
    half_width = 0.9 * math.sin(math.pi * min(1, v) ** 0.8) ** 0.75 if v > 0.06 else 0.05
    half_width *= 1 + 0.05 * math.sin(40 * v)
    cover = max(0.0, min(1.0, (half_width - abs(u)) * 30 + 0.5))
    vein = abs(u) < 0.03 or abs((v - 0.55 * abs(u)) * 9 % 1 - 0.5) < 0.05
    tone = 0.85 + 0.15 * v
    colour = (0.42, 0.58, 0.2) if vein else (0.2, 0.42, 0.12)
    return tuple(tone * c for c in colour) + (cover,)


def studio(x, y, width=256, height=128):
    """Radiance of a dim room with two soft boxes and a strip; row 0 is straight up."""
    azimuth, elevation = 360 * (x + 0.5) / width, 90 - 180 * (y + 0.5) / height
    level = 0.18 + 0.22 * max(0.0, elevation / 90) if elevation > 0 else 0.12

    def soft_box(centre, half_width, low, high):
        away = abs((azimuth - centre + 180) % 360 - 180)
        edge_u = max(0.0, min(1.0, (half_width - away) / 3))
        edge_v = max(0.0, min(1.0, (elevation - low) / 3)) * max(
            0.0, min(1.0, (high - elevation) / 3))
        return edge_u * edge_v

    warm, cool, strip = soft_box(60, 22, 15, 60), soft_box(285, 16, 10, 55), soft_box(170, 50, 5, 12)
    base = (level * 0.85, level * 0.95, level * 1.15)
    quantised = [round(c * 64) / 64 for c in base]
    return (quantised[0] + 5 * warm + 2 * cool + 1.5 * strip,
            quantised[1] + 4.2 * warm + 2.6 * cool + 1.5 * strip,
            quantised[2] + 3 * warm + 3.4 * cool + 1.5 * strip)


def ground_checks(x, y):
    """8 x 8: a checkerboard of single texels' squares would blur, so each square has 32 texels."""
    light = (x // 32 + y // 32) % 2
    return (0.78, 0.77, 0.74) if light else (0.3, 0.32, 0.36)


def stained_glass(x, y):
    """96 x 64: panes of colour between lead, brighter towards the middle."""
    u, v = (x + 0.5) / 96, (y + 0.5) / 64
    i, j = int(6 * u), int(4 * v)
    inside = min(x % 16, 15 - x % 16, y % 16, 15 - y % 16)
    if inside < 1:
        return (0.02, 0.02, 0.02)
    tint = 0.45 + 0.5 * hash01("pane", i, j)
    bright = 1 - 0.5 * (abs(2 * u - 1) + abs(2 * v - 1)) / 2
    colours = ((1, 0.35, 0.2), (0.25, 0.5, 1), (1, 0.85, 0.3), (0.3, 0.8, 0.4), (0.9, 0.9, 1))
    return tuple(c * tint * bright for c in colours[int(5 * hash01("hue", i, j))])


def equal_area_direction(x, y, size):
    """The direction of a texel of an octahedron unfolded to equal areas [Clarberg08]."""
    u, v = 2 * (x + 0.5) / size - 1, 2 * (y + 0.5) / size - 1
    signed = 1 - (abs(u) + abs(v))
    r = 1 - abs(signed)
    phi = (math.pi / 4) * ((abs(v) - abs(u)) / r + 1 if r else 1)
    z = math.copysign(1 - r * r, signed)
    side = r * math.sqrt(2 - r * r)
    return (math.copysign(side * math.cos(phi), u), math.copysign(side * math.sin(phi), v), z)


def street_lamp(x, y, size=64):
    """Four beams downwards and to the sides, little upwards."""
    dx, dy, dz = equal_area_direction(x, y, size)
    beam = max(0.0, math.cos(2 * math.atan2(dy, dx))) ** 2 * max(0.0, 1 - (dz + 0.45) ** 2 * 3)
    return (min(1.0, 0.25 + 0.75 * max(beam, max(0.0, -dz) ** 6)) if dz < 0.3 else 0.25,)


def make_textured_lights(folder):
    write_png(folder / "stained_glass.png", 96, 64, stained_glass)
    write_png(folder / "street_lamp.png", 64, 64, street_lamp)


def make_cutouts(folder):
    rectangle((-6, 0, 4), (12, 0, 0), (0, 0, -8), 3, 2, "the terrace").write(folder / "ground.obj")
    rectangle((-6, 0, -4), (12, 0, 0), (0, 4.5, 0), 8, 3, "the wall").write(folder / "wall.obj")
    rectangle((-1.7, 0, 0), (3.4, 0, 0), (0, 1.5, 0), 17, 7.5, "the fence's wire"
              ).write(folder / "fence.obj")
    box((-0.04, 0, -0.04), (0.04, 1.6, 0.04), "a post of the fence").write(folder / "post.obj")
    pot = [(0, 0), (0.17, 0), (0.24, 0.34), (0.27, 0.34), (0.27, 0.4), (0.23, 0.4), (0.22, 0.33),
           (0, 0.33)]
    lathe(pot, 32, "a flower pot").write(folder / "pot.obj")
    plant(26, "plant").write(folder / "plant.obj")
    write_png(folder / "tiles.png", 512, 512, tiles)
    write_png(folder / "bricks.png", 256, 256, bricks)
    write_png(folder / "bricks_height.png", 256, 256, brick_heights)
    write_png(folder / "wire.png", 64, 64, wire_fence)
    write_png(folder / "leaf.png", 128, 256, leaf)


def make_glass_and_metal(folder):
    icosphere(4).write(folder / "sphere.obj")
    box((-0.5, -0.5, -0.5), (0.5, 0.5, 0.5), "unit cube").write(folder / "cube.obj")
    rectangle((-8, 0, 8), (16, 0, 0), (0, 0, -16), 4, 4, "the floor").write(folder / "ground.obj")
    rectangle((-0.5, -0.5, 0), (1, 0, 0), (0, 1, 0), 1, 1, "a thin pane, 1 x 1"
              ).write(folder / "pane.obj")
    rectangle((-1, 0, -1), (2, 0, 0), (0, 0, 2), 1, 1, "2 x 2, facing down"
              ).write(folder / "lamp.obj")
    write_png(folder / "checks.png", 256, 256, ground_checks)
    write_hdr(folder / "studio.hdr", 256, 128, studio)


def main():
    default = pathlib.Path(__file__).resolve().parents[2] / "assets"
    assets = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else default
    for name, make in (("cutouts", make_cutouts), ("glass_and_metal", make_glass_and_metal),
                       ("pbrt_textured_lights", make_textured_lights)):
        (assets / name).mkdir(parents=True, exist_ok=True)
        make(assets / name)


if __name__ == "__main__":
    main()
