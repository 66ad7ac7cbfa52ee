"""Entries of scene files that several scenes have."""


def render(width=512, height=512, spp=64):
    return {"Width": width, "Height": height, "SamplesPerPixel": spp}


def camera(eye, target, fovy):
    return {"Eye": eye, "Target": target, "Up": [0, 1, 0], "Fovy": fovy}


def diffuse(name, kd):
    return {"Name": name, "Type": "diffuse", "kd": kd}


def lamp(name, radiance):
    """Reflects nothing."""
    return {"Name": name, "Type": "diffuse", "kd": 0, "Emission": radiance}


def model(mesh, material, **more):
    return {"Mesh": mesh, "Material": material} | more
