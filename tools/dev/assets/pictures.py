"""The assets' pictures: functions of a pixel."""

import math

from noise import hash01, smooth_noise


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

    warm, cool = soft_box(60, 22, 15, 60), soft_box(285, 16, 10, 55)
    strip = soft_box(170, 50, 5, 12)
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
