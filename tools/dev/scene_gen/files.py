"""Meshes as OBJ, large ones as binary PLY; scenes as YAML."""

import numpy

LARGE = 100_000  # triangles: text would take longer to read than to render


class MeshFolder:
    def __init__(self, folder):
        self.folder = folder

    def add(self, name, mesh):
        """The file's name, as a model's `Mesh`. The folder is made with its first mesh, so that a
        scene that is refused leaves none."""
        self.folder.mkdir(parents=True, exist_ok=True)
        if len(mesh.faces) > LARGE:
            write_ply(self.folder / f"{name}.ply", mesh)
            return f"{name}.ply"
        write_obj(self.folder / f"{name}.obj", mesh)
        return f"{name}.obj"


def write_obj(path, mesh):
    normals, of_corner = mesh.obj_normals()
    with path.open("w") as file:
        file.writelines("v %.9g %.9g %.9g\n" % tuple(p) for p in mesh.points.tolist())
        file.writelines("vn %.6g %.6g %.6g\n" % tuple(n) for n in normals.tolist())
        file.writelines("f %d//%d %d//%d %d//%d\n" % (a, i, b, j, c, k)
                        for (a, b, c), (i, j, k) in zip((mesh.faces + 1).tolist(),
                                                        (of_corner + 1).tolist()))


def write_ply(path, mesh):
    """Flat meshes share no points in the file, so that candela, which makes smooth normals where it
    finds none, makes flat ones."""
    points, faces, names = mesh.points, mesh.faces, "xyz"
    if mesh.normals is not None:
        points, names = numpy.concatenate([points, mesh.normals], axis=1), ("x", "y", "z", "nx",
                                                                            "ny", "nz")
    elif len(points) != faces.size:
        points, faces = points[faces].reshape(-1, 3), numpy.arange(faces.size).reshape(-1, 3)
    lines = ["ply", "format binary_little_endian 1.0", f"element vertex {len(points)}",
             *(f"property float {name}" for name in names), f"element face {len(faces)}",
             "property list uchar int vertex_indices", "end_header"]
    records = numpy.empty(len(faces), [("count", "u1"), ("indices", "<i4", 3)])
    records["count"], records["indices"] = 3, faces
    with path.open("wb") as file:
        file.write("".join(line + "\n" for line in lines).encode())
        points.astype("<f4").tofile(file)
        records.tofile(file)


def write_yaml(path, content, comment):
    """Every entry of the file's lists on lines of its own, what is deeper within one line."""
    lines = [f"# {line}" for line in comment.splitlines()]
    for key, value in content.items():
        lines.append("")
        if not isinstance(value, list):
            lines.append(f"{key}: {flow(value)}")
            continue
        lines.append(f"{key}:")
        for entry in value:
            begin = "- "
            for name, item in entry.items():
                lines += block(f"  {begin}{name}", item)
                begin = "  "
    path.write_text("\n".join(lines) + "\n")


def block(head, item):
    """Long lists of entries (instances) a line each, since lines have a limit."""
    if isinstance(item, list) and item and isinstance(item[0], dict):
        return [f"{head}:"] + [f"      - {flow(entry)}" for entry in item]
    return [f"{head}: {flow(item)}"]


def flow(value):
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key}: {flow(item)}" for key, item in value.items()) + "}"
    if isinstance(value, (list, tuple, numpy.ndarray)):
        return "[" + ", ".join(flow(item) for item in value) + "]"
    if isinstance(value, bool):
        return "true" if value else "false"
    return f"{value:.7g}" if isinstance(value, (float, numpy.floating)) else str(value)
