"""An OBJ file whose corners share what is equal, and vectors to make it of."""

import math


def normalise(v):
    length = math.sqrt(sum(c * c for c in v))
    return tuple(c / length for c in v)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def add(*vectors):
    return tuple(map(sum, zip(*vectors)))


def scale(v, s):
    return tuple(c * s for c in v)


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
