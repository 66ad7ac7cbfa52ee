"""Reads the EXR files that candela writes: scan lines, 32-bit floats, ZIP or no compression.

[OpenEXR] https://openexr.com/en/latest/OpenEXRFileLayout.html
"""

import struct
import zlib

import numpy

LINES_A_BLOCK = {0: 1, 2: 1, 3: 16}  # by the compression's number: none, ZIPS, ZIP
FLOAT = 2


def _attributes(data, at):
    """The header's attributes by name, and where the table of offsets begins."""
    found = {}
    while data[at] != 0:
        name, kind, rest = data[at:at + 512].split(b"\0", 2)
        at += len(name) + len(kind) + 2
        size, = struct.unpack_from("<i", data, at)
        found[name.decode()] = data[at + 4:at + 4 + size]
        at += 4 + size
    return found, at + 1


def _channels(value):
    """Names in the file's order, which is alphabetic. Each has 16 bytes after its name."""
    names = []
    while value[0] != 0:
        name, rest = value.split(b"\0", 1)
        kind, = struct.unpack_from("<i", rest)
        if kind != FLOAT:
            raise ValueError("a channel that is not of 32-bit floats")
        names.append(name.decode())
        value = rest[16:]
    return names


def _unpacked(block, size):
    """ZIP keeps differences of bytes, first all even ones and then all odd ones; a block that
    would not shrink is stored as it is."""
    if len(block) == size:
        return block
    differences = numpy.frombuffer(zlib.decompress(block), numpy.uint8).astype(numpy.int64)
    differences[1:] -= 128
    values = numpy.cumsum(differences).astype(numpy.uint8)
    unpacked = numpy.empty(size, numpy.uint8)
    half = (size + 1) // 2
    unpacked[0::2], unpacked[1::2] = values[:half], values[half:]
    return unpacked.tobytes()


def read_channels(path):
    """The data window's channels by their names: arrays [row from the top, column]."""
    data = path.read_bytes()
    attributes, at = _attributes(data, 8)
    names = _channels(attributes["channels"])
    compression = attributes["compression"][0]
    x0, y0, x1, y1 = struct.unpack("<4i", attributes["dataWindow"])
    width, height = x1 - x0 + 1, y1 - y0 + 1
    lines = LINES_A_BLOCK[compression]
    image = numpy.empty((height, len(names), width), numpy.float32)
    for offset in struct.unpack_from(f"<{-(-height // lines)}Q", data, at):
        y, size = struct.unpack_from("<2i", data, offset)
        count = min(lines, y1 + 1 - y)
        raw = _unpacked(data[offset + 8:offset + 8 + size], 4 * width * len(names) * count)
        image[y - y0:y - y0 + count] = numpy.frombuffer(raw, "<f4").reshape(
            count, len(names), width)
    return {name: image[:, i].astype(float) for i, name in enumerate(names)}


def stacked(channels, names):
    """Some of the channels as one array [row from the top, column, channel]."""
    return numpy.stack([channels[name] for name in names], axis=2)


def read_exr(path):
    """Linear R, G, B: an array [row from the top, column, channel]."""
    return stacked(read_channels(path), "RGB")
