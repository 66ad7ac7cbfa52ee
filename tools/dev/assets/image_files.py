"""PNG and Radiance HDR files, by the standard library alone."""

import math
import struct
import zlib


def to_byte(value):
    return max(0, min(255, round(255 * value)))


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
