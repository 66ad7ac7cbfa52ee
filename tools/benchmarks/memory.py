"""Peak memory of renders against what their scenes must hold: docs/performance.md, "Memory"."""

import pathlib

import renders
import scenes

ABOUT = "peak memory of a render against the scene's meshes and textures"
ROOT = pathlib.Path(__file__).resolve().parents[2]
GOAL = 3.0
LEAST_MEGABYTES = 3.0  # of meshes and textures: below, the libraries' pages are all there is to see
ONE_TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"


def add_arguments(parser):
    parser.add_argument("--size", default="256x256", help="of the pictures (256x256)")


def peak_megabytes(candela, name, scene, size):
    return candela.render(name, scene, png=False, size=size, spp=1).stats["peak_memory_bytes"] * 1e-6


def row(candela, name, scene, size, baseline):
    peak = peak_megabytes(candela, name, scene, size) - baseline
    held = candela.info(scene, accel="embree")["memory_bytes"]
    meshes, textures, embree = (held[key] * 1e-6 for key in ("meshes", "textures", "embree"))
    ratio = peak / (meshes + textures)
    if meshes + textures < LEAST_MEGABYTES:
        verdict = "(too small to tell)"
    else:
        verdict = f"{ratio:.1f}" if ratio < GOAL else f"**{ratio:.1f}**"
    print(f"| {name} | {peak:.1f} | {meshes:.1f} | {textures:.1f} | {verdict} | {embree:.1f} |",
          flush=True)


def run(options):
    candela = renders.Candela(options.program, options.out)
    triangle = options.out / "one_triangle.obj"
    triangle.write_text(ONE_TRIANGLE)
    baseline = peak_megabytes(candela, "one_triangle", triangle, options.size)
    print(f"A scene of one triangle peaks at {baseline:.1f} MB. In MB, less that:\n")
    print("| scene | peak | meshes | textures | peak / (meshes + textures) | Embree |")
    print("|---|---|---|---|---|---|")
    for path in scenes.course_scenes(ROOT):
        row(candela, path.stem, path, options.size, baseline)
