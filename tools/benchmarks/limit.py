"""How near a render is to the cost of its rays alone, and where the rest of its time goes.

The ratio is candela's own (`candela render --ray-limit`): CPU time of a share of the tiles over
that of the same rays through bare calls of Embree, tile by tile in turn. Where the rest goes is
told twice: by perf, which samples time, and by callgrind, which counts instructions and knows the
source line of what was inlined, as `tools/bench budget` does. Fails where a ratio is above its
goal.
"""

import collections
import os
import re
import shutil

import budget
import callgrind
import chosen_scenes
from arguments import at_least
from fits import geometric_mean, spread
from processes import run_checked
from renders import square
from results import begin, status

ABOUT = "CPU time over that of the rays alone, and where the rest of it goes"
SHOWN = 14  # lines of each profile
MANY_TRIANGLES = 50_000


def add_arguments(parser):
    chosen_scenes.add_argument(parser)
    parser.add_argument("--quick", action="store_true", help="small pictures, 2 runs a scene")
    parser.add_argument("--runs", type=at_least(1), help="measurements a scene (5)")
    parser.add_argument("--no-profile", action="store_true", help="ratios only")


def goal_of(info):
    """What the ratio is to be at most."""
    if info["textures"]:
        return 1.3
    return 1.2 if info["instanced_triangles"] > MANY_TRIANGLES else 1.25


def run(options):
    out, candela, results = begin(options, "Nearness to the rays alone", __doc__)
    runs = options.runs or (2 if options.quick else 5)
    # Every 17th tile of 16 x 16 is measured: in small pictures too few to stand for the
    # whole. Samples are traced in blocks of 16.
    size, spp = ("256x256", 16) if options.quick else ("512x512", 32)
    scenes = chosen_scenes.chosen(candela, out, options.scenes, chosen_scenes.names(),
                                  results.note)
    rows = []
    for name, scene in scenes.items():
        with results.attempt(name):
            rows.append(row(candela, name, scene, runs, size=size, spp=spp))
            results.keep("limit", rows)
            print(f"{name}: {rows[-1]['ratio']:.3f}", flush=True)
    results.table("limit", f"CPU time over that of the rays alone, {size}, {spp} spp, {runs} runs",
                  rows)
    if rows:
        results.note(f"geometric mean {geometric_mean(r['ratio'] for r in rows):.3f}")
    if not options.no_profile:
        for name, scene in scenes.items():
            profile(results, candela, name, scene, options.quick)
    results.finish()
    return status(row["met"] for row in rows)


def row(candela, name, scene, runs, **options):
    seen = [candela.render("limit", scene, png=False, ray_limit=True, seed=seed, **options).stats
            for seed in range(1, runs + 1)]
    ratio = spread(stats["limit_ratio"] for stats in seen)
    limits = [stats["ray_limit"] for stats in seen]
    info = candela.info(scene)
    goal = goal_of(info)
    return {"scene": name, "triangles": info["instanced_triangles"], "kernel": seen[0]["kernel"],
            "ratio": ratio.median, "low": ratio.low, "high": ratio.high, "goal": goal,
            "met": "yes" if ratio.median <= goal else "no",
            "ns_a_ray": spread(1e9 * x["render_cpu_seconds"] / x["rays"] for x in limits).median,
            "ns_a_ray_alone": spread(1e9 * x["rays_cpu_seconds"] / x["rays"]
                                     for x in limits).median}


def profile(results, candela, name, scene, quick):
    folder, safe = candela.folder, chosen_scenes.safe(name)
    if shutil.which("perf"):
        with results.attempt(f"{name}: where the time goes"):
            rows = perf_rows(candela, folder / f"{safe}.perf", scene, 3.0 if quick else 10.0)
            results.table(f"time_{safe}", f"{name}: where the time goes, by perf", rows)
    else:
        results.note("perf is not installed (Debian's linux-perf): no profile of time")
    if shutil.which("valgrind"):
        with results.attempt(f"{name}: instructions"):
            rows = instruction_rows(candela, folder / f"{safe}.callgrind", scene)
            results.table(f"instructions_{safe}", f"{name}: instructions a camera sample by source "
                          "file, inlined or not", rows)
    else:
        results.note("valgrind is not installed: no profile of instructions")


def perf_rows(candela, file, scene, seconds):
    """Of one thread that renders for so long; what links the program is left out."""
    words = [candela.program, "render", scene, "-o", file.with_suffix(".exr"), "--size", "256x256",
             "--time", seconds, "--threads", 1, "--quiet"]
    perf("record", "-q", "-e", "cpu-clock", "-F", "1999", "-o", file, "--", *words)
    report = perf("report", "-i", file, "--stdio", "--no-children", "-g", "none", "--sort",
                  "dso,symbol", "-t", ";", "--percent-limit", "0")
    shares = [(share, where, what) for share, where, what in perf_shares(report)
              if not where.startswith("ld-linux")]
    whole = sum(share for share, _, _ in shares)
    by_kind = collections.Counter()
    for share, where, _ in shares:
        by_kind[kind_of(where)] += share
    rows = [{"what": kind, "share": share / whole} for kind, share in by_kind.most_common()]
    own = [(share, what) for share, where, what in shares
           if kind_of(where) == "candela"][:SHOWN]
    return rows + [{"what": f"candela: {short(what)}", "share": share / whole}
                   for share, what in own]


def perf(*words):
    """What it prints; it may not be allowed to look."""
    return run_checked(["perf", *words], env=os.environ | {"DEBUGINFOD_URLS": ""}).stdout


def perf_shares(report):
    """(share, object, symbol) of each line `37.68%;libc.so.6;[.] malloc`; more may follow."""
    for line in report.splitlines():
        if match := re.match(r"\s*([\d.]+)%\s*;\s*(.*?)\s*;\s*\[[.k]\]\s*([^;]*?)\s*(?:;|$)", line):
            yield float(match[1]), match[2], match[3]


def kind_of(where):
    if callgrind.is_embree(where):
        return "Embree"
    if where.startswith("candela"):
        return "candela"
    return "kernel" if where.startswith("[") else "other libraries"


def short(symbol):
    """Without arguments, and of template arguments no more than their beginning."""
    return re.sub(r"<.*", "<...>", symbol.replace("(anonymous namespace)::", "").split("(")[0])


def instruction_rows(candela, file, scene):
    side, spp = 24, 16
    words = [candela.program, "render", scene, "-o", file.with_suffix(".exr"), "--size",
             square(side), "--spp", spp, *budget.OPTIONS]
    counted = callgrind.count(file, words)
    samples = side * side * spp
    embree, _ = callgrind.embree_of(counted)
    files = collections.Counter()
    for path, cost in counted.by_file.items():
        files[relative(path)] += cost
    files["???"] -= embree  # libraries without line numbers
    lines = [("Embree", embree)] + files.most_common(SHOWN)
    lines.append(("the rest", counted.total - sum(cost for _, cost in lines)))
    return [{"where": where, "instructions": cost / samples, "share": cost / counted.total}
            for where, cost in lines] + [{"where": "all", "instructions": counted.total / samples,
                                          "share": 1.0}]


def relative(path):
    """Below the project's root, or below the system's include folder."""
    for mark in ("/integrators/", "/renderer/", "/tools/"):
        if mark in path:
            return mark[1:] + path.split(mark, 1)[1]
    return re.sub(r"^/usr/include/", "", path) if path != "???" else path
