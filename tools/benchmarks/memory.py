"""Peak memory of renders against what their scenes must hold. Then what a triangle costs, geometry
and Embree together, held and at the peak, and what a forest of instances does.

docs/performance.md, "Memory", has the figures. Fails where one is exceeded.
"""

import chosen_scenes
import scenes
from arguments import size
from results import begin, status

ABOUT = "peak memory of a render against the scene's meshes and textures; bytes a triangle"
GOAL = 3.0
LEAST_MEGABYTES = 3.0  # of meshes and textures: below, the libraries' pages are all there is to see
GOAL_BYTES = 150  # a triangle, geometry and Embree, without textures
GOAL_FOREST = 500e6  # bytes, of more than 10^7 triangles that are seen
MANY = 10_000  # triangles; with few the tables' own sizes show
SMALL = "64x64"  # a picture that takes no memory itself
TOO_SMALL = "too small to tell"
ONE_TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"


def add_arguments(parser):
    parser.add_argument("--size", type=size, default="256x256", metavar="WxH",
                        help="of the forest's picture (256x256)")
    parser.add_argument("--quick", action="store_true", help="generated scenes only, small ones")


def run(options):
    out, candela, results = begin(options, "Memory", __doc__)
    (out / "one_triangle.obj").write_text(ONE_TRIANGLE)
    verdicts = [] if options.quick else peaks(results, candela)
    verdicts += of_a_triangle(results, candela, options.quick)
    verdicts += forest(results, candela, options.size)
    results.finish()
    return status(verdicts)


def peak_megabytes(candela, name, scene, size):
    return candela.render(name.replace("/", "_"), scene, png=False, size=size,
                          spp=1).stats["peak_memory_bytes"] * 1e-6


def baseline(results, candela):
    """Of a small picture: a scene of one triangle peaks when the picture is written, a large one
    while its tree is built and there is no picture yet."""
    return peak_megabytes(candela, "one_triangle", results.out / "one_triangle.obj", SMALL)


def peaks(results, candela):
    """Verdicts, as of_a_triangle() and forest()."""
    plain = baseline(results, candela)
    files = {path.stem: path for path in scenes.course_scenes()} | scenes.pbrt_scenes()
    chosen_scenes.tell_absent(results.note)
    rows = []
    for name, path in files.items():
        with results.attempt(name):
            rows.append(row(candela, name, path, plain))
    results.table("peaks", f"MB above the {plain:.1f} of a scene of one triangle", rows,
                  f"Wanted is a peak below {GOAL:g} times meshes and textures, of pictures of "
                  f"{SMALL} pixels.")
    return [row["verdict"] for row in rows]


def row(candela, name, scene, one_triangle):
    """one_triangle: the peak of a scene of one."""
    info = candela.info(scene, accel="embree")
    held = info["memory_bytes"]
    peak = peak_megabytes(candela, name, scene, SMALL) - one_triangle
    meshes, textures, embree = (held[key] * 1e-6 for key in ("meshes", "textures", "embree"))
    ratio = peak / (meshes + textures)
    is_told = meshes + textures >= LEAST_MEGABYTES
    print(f"{name}: {peak:.1f} MB", flush=True)
    return {"scene": name, "peak": peak, "meshes": meshes, "textures": textures,
            "peak_over_both": ratio if is_told else None, "embree": embree,
            "verdict": verdict(ratio < GOAL) if is_told else TOO_SMALL}


def verdict(is_reached):
    return "reached" if is_reached else "exceeded"


def of_a_triangle(results, candela, quick):
    """Untextured scenes, and what is generated: what is held once the tree is built, and the peak
    of a small render, which is what the machine must have."""
    plain = baseline(results, candela)
    rows = []
    for name, path in many_triangles(results.out, quick).items():
        with results.attempt(name):
            info = candela.info(path, accel="embree")
            triangles, held = info["triangles"], info["memory_bytes"]
            if info["textures"] or triangles < MANY:
                continue
            both = (held["meshes"] + held["embree"]) / triangles
            peak = (peak_megabytes(candela, name, path, SMALL) - plain) * 1e6 / triangles
            rows.append({"scene": name, "triangles": triangles,
                         "meshes": held["meshes"] / triangles,
                         "embree": held["embree"] / triangles, "both": both,
                         "peak": peak, "verdict": TOO_SMALL if quick
                         else verdict(max(both, peak) < GOAL_BYTES)})
    results.table("triangles", "Bytes a triangle, untextured", rows,
                  f"Wanted is less than {GOAL_BYTES} at the peak: that of a render of {SMALL} "
                  "pixels, less that of one triangle.")
    return [row["verdict"] for row in rows]


def many_triangles(out, quick):
    from generated import generated
    count = 20_000 if quick else 1_000_000
    files = {f"{shape} of {count}": generated(out, shape, triangles=count)
             for shape in ("soup", "terrain")}
    return files if quick else files | {p.stem: p for p in scenes.course_scenes()}


def forest(results, candela, size):
    from generated import generated
    scene = generated(results.out, "forest")
    peak = peak_megabytes(candela, "forest", scene, size)
    seen = candela.info(scene)["instanced_triangles"]
    word = verdict(peak * 1e6 < GOAL_FOREST)
    results.note(f"A forest of {seen} triangles peaks at {peak:.0f} MB, all in all; wanted are "
                 f"less than {GOAL_FOREST * 1e-6:.0f}: {word}")
    return [word]
