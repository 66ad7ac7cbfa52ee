"""Scenes of which the radiance of every pixel is known: closed boxes whose walls all shine. Within
is emission / (1 - albedo) everywhere [white furnace], and paths of every length bring it."""

# With normals, since an OBJ file without any gets smooth ones.
BOX = """v -1 -1 -1
v 1 -1 -1
v 1 1 -1
v -1 1 -1
v -1 -1 1
v 1 -1 1
v 1 1 1
v -1 1 1
vn 0 0 1
vn 0 0 -1
vn 0 1 0
vn 0 -1 0
vn 1 0 0
vn -1 0 0
f 1//1 2//1 3//1 4//1
f 8//2 7//2 6//2 5//2
f 5//3 6//3 2//3 1//3
f 4//4 3//4 7//4 8//4
f 5//5 1//5 4//5 8//5
f 2//6 6//6 7//6 3//6
"""

SCENE = """Cameras:
  - {{Eye: [.2, .1, .3], Target: [.5, .2, -1], Up: [0, 1, 0], Fovy: 80}}
Materials:
  - {{Name: wall, Type: diffuse, kd: {albedo}, Emission: {emission}}}
Models:
  - {{Mesh: box.obj, Material: wall}}
"""

ALBEDOS = {"furnace": .5, "white_furnace": .9}


def write(folder):
    """Their names, files and radiances."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "box.obj").write_text(BOX)
    for name, albedo in ALBEDOS.items():
        path = folder / f"{name}.yaml"
        path.write_text(SCENE.format(albedo=albedo, emission=1 - albedo))
        yield name, path, 1.0
