"""Embree's tutorial path tracer (Debian: embree-tools): CPU seconds a sample at equal samples.

candela sends as many camera rays, but for one in 400 that chooses the roulette: it does not adapt,
states no error, looks for no lamps' edges, and no pixels share paths. What a picture costs once is
taken off on both sides, by one of fewer samples.
"""

import pathlib
import shutil

import numpy

from fits import spread
from processes import cpu_seconds_of
from renders import square

from . import blender_scene

PROGRAM = "pathtracer"
SCENE = pathlib.Path(__file__).with_name("scenes") / "point_lit.yaml"
FEW, MANY = 1, 65  # samples a pixel
EQUAL = {"adaptive": "off", "replicates": 1, "lamp_rays": 0, "reuse": "off"}


def compare(results, candela, folder, size, pairs, threads):
    """A table of the two on the scene with a point light, or a note that it is not here."""
    if not shutil.which(PROGRAM):
        return results.note("Embree's tutorial path tracer is not here: no program 'pathtracer', "
                            "which Debian's package embree-tools brings")
    folder.mkdir(parents=True, exist_ok=True)
    arguments = written(folder, blender_scene.read(SCENE))
    ours, theirs = [], []
    for seed in range(1, pairs + 1):
        ours.append(candela_seconds(candela, size, seed, threads))
        theirs.append(embree_seconds(folder, arguments, size, threads))
    nanoseconds = 1e9 / (size * size * (MANY - FEW))
    ratio = spread(b / a for a, b in zip(ours, theirs))
    results.table("embree_path_tracer", "Embree's tutorial path tracer, one point light: CPU time "
                  "a camera sample", [
                      {"scene": "point_lit", "candela_ns": nanoseconds * spread(ours).median,
                       "pathtracer_ns": nanoseconds * spread(theirs).median,
                       "ratio": ratio.median, "low": ratio.low, "high": ratio.high}],
                  "It ends paths whose weight is under .01 and has no roulette: its paths are not "
                  "candela's.")


def candela_seconds(candela, size, seed, threads):
    few, many = (candela.render("point_lit", SCENE, png=False, size=square(size), spp=spp,
                                seed=seed, threads=threads, filter="box", **EQUAL).cpu_seconds
                 for spp in (FEW, MANY))
    return many - few


def embree_seconds(folder, arguments, size, threads):
    few, many = (cpu_seconds_of(
        [PROGRAM, *arguments, "--rtcore", f"threads={threads}", "--threads", threads, "--size",
         size, size, "--spp", spp, "--max-path-length", 100, "-o", folder / "picture.ppm"])
                 for spp in (FEW, MANY))
    return many - few


def written(folder, scene):
    """The scene as an OBJ file with its MTL; what else it is, as arguments."""
    lines, materials, count = ["mtllib scene.mtl"], [], 0
    for index, mesh in enumerate(scene["meshes"]):
        materials.append(f"newmtl m{index}\nKd {' '.join(map(str, mesh['albedo']))}\n")
        lines.append(f"usemtl m{index}")
        for triangle in mesh["corners"]:
            lines += ["v " + " ".join(map(str, corner)) for corner in triangle]
            lines.append(f"f {count + 1} {count + 2} {count + 3}")
            count += 3
    (folder / "scene.obj").write_text("\n".join(lines) + "\n")
    (folder / "scene.mtl").write_text("\n".join(materials))
    camera, (light,) = numpy.array(scene["camera"]["to_world"]), scene["lights"]
    eye, back, up = camera[:3, 3], camera[:3, 2], camera[:3, 1]
    return ["-i", folder / "scene.obj", "--righthanded", "--vp", *eye, "--vi", *(eye - back),
            "--vu", *up, "--fov", numpy.degrees(scene["camera"]["fovy"]), "--pointlight",
            *light["position"], *light["radiant_intensity"]]
