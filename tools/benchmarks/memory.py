"""Peak memory of renders against what their scenes must hold: docs/performance.md, "Memory". Then
what a triangle costs, geometry and Embree together, and what a forest of instances does."""

import pathlib

import renders
import scenes

ABOUT = "peak memory of a render against the scene's meshes and textures; bytes a triangle"
ROOT = pathlib.Path(__file__).resolve().parents[2]
GOAL = 3.0
LEAST_MEGABYTES = 3.0  # of meshes and textures: below, the libraries' pages are all there is to see
GOAL_BYTES = 150  # a triangle, geometry and Embree, without textures
GOAL_FOREST = 500e6  # bytes, of more than 10^7 triangles that are seen
MANY = 10_000  # triangles; with few the tables' own sizes show
ONE_TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"


def add_arguments(parser):
    parser.add_argument("--size", default="256x256", help="of the pictures (256x256)")
    parser.add_argument("--quick", action="store_true", help="generated scenes only, small ones")


def peak_megabytes(candela, name, scene, size):
    return candela.render(name.replace("/", "_"), scene, png=False, size=size, spp=1).stats["peak_memory_bytes"] * 1e-6


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


def bytes_a_triangle(candela, out, quick):
    """Untextured scenes, and what is generated."""
    from generated import generated
    count = 20_000 if quick else 1_000_000
    files = {f"{shape} of {count}": generated(out, shape, triangles=count)
             for shape in ("soup", "terrain")}
    if not quick:
        files |= {path.stem: path for path in scenes.course_scenes(ROOT)}
    print("\n| scene | triangles | meshes, bytes a triangle | Embree | both |\n|---|---|---|---|---|")
    for name, path in files.items():
        info = candela.info(path, accel="embree")
        triangles, held = info["triangles"], info["memory_bytes"]
        if info["textures"] or triangles < MANY:
            continue
        both = (held["meshes"] + held["embree"]) / triangles
        print(f"| {name} | {triangles} | {held['meshes'] / triangles:.0f} | "
              f"{held['embree'] / triangles:.0f} | "
              f"{f'{both:.0f}' if both < GOAL_BYTES else f'**{both:.0f}**'} |", flush=True)


def forest(candela, out, size):
    from generated import generated
    scene = generated(out, "forest")
    peak = peak_megabytes(candela, "forest", scene, size)
    seen = candela.info(scene)["instanced_triangles"]
    print(f"\nA forest of {seen} triangles peaks at {peak:.0f} MB, all in all"
          + ("" if peak * 1e6 < GOAL_FOREST else f"; **expected under {GOAL_FOREST * 1e-6:.0f}**"))


def run(options):
    candela = renders.Candela(options.program, options.out)
    if not options.quick:
        peaks(candela, options)
    bytes_a_triangle(candela, options.out, options.quick)
    forest(candela, options.out, options.size)


def peaks(candela, options):
    triangle = options.out / "one_triangle.obj"
    triangle.write_text(ONE_TRIANGLE)
    baseline = peak_megabytes(candela, "one_triangle", triangle, options.size)
    print(f"A scene of one triangle peaks at {baseline:.1f} MB. In MB, less that:\n")
    print("| scene | peak | meshes | textures | peak / (meshes + textures) | Embree |")
    print("|---|---|---|---|---|---|")
    files = {path.stem: path for path in scenes.course_scenes(ROOT)} | scenes.pbrt_scenes(ROOT)
    for name, path in files.items():
        row(candela, name, path, options.size, baseline)
