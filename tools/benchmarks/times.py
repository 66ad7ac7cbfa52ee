"""This candela against another build of it: CPU time of rendering the same samples.

For changes that leave pictures as they are, or nearly: no reference is needed, and both programs
draw the same number of samples of each pixel, without adaptive sampling and with one replicate, in
pairs of one seed that take turns. How far apart their pictures are stands beside the ratio.
"""

import json
import pathlib
import types

import chosen_scenes
from arguments import at_least
from fits import geometric_mean, spread
from processes import run_checked
from renders import CandelaFailed, rendering_cpu_seconds, square
from results import begin, status_of_rows

ABOUT = "against another build of candela: CPU time of the same samples"


def add_arguments(parser):
    parser.add_argument("before", type=pathlib.Path, metavar="PROGRAM", help="the other candela")
    chosen_scenes.add_argument(parser, "all but gen/shed and the shipped pbrt files")
    parser.add_argument("--quick", action="store_true", help="64x64, 16 spp, 2 pairs")
    parser.add_argument("--pairs", type=at_least(1), help="pictures of each program (5)")
    parser.add_argument("--size", type=at_least(1), metavar="N", help="pixels a side (160)")
    parser.add_argument("--spp", type=at_least(1), help="samples of a picture (32)")


def run(options):
    size = options.size or (64 if options.quick else 160)
    spp = options.spp or (16 if options.quick else 32)
    pairs = options.pairs or (2 if options.quick else 5)
    out, candela, results = begin(options, "CPU time before and now", __doc__)
    rows = []
    default = [*chosen_scenes.ANALYTIC, *chosen_scenes.names()]
    for name, scene in chosen_scenes.chosen(candela, out, options.scenes, default,
                                            results.note).items():
        words = [scene, "--size", square(size), "--spp", spp]
        with results.attempt(name):
            measured = [cpu_seconds(*(
                rendered(path.resolve(), out / f"renders/{which}.exr", words, seed)
                for which, path in (("before", options.before), ("now", options.program))))
                        for seed in range(1, pairs + 1)]
            rows.append({"scene": name} | compared(measured) | {"apart": apart(candela, out)})
            results.keep("times", rows)
            print(f"{name}: {rows[-1]['cpu_ratio']:.3f}", flush=True)
    results.table("times", f"CPU time, now over before, {square(size)}, {spp} spp, {pairs} pairs",
                  rows, "apart: relMSE between the last pair of pictures.")
    if rows:
        results.note(f"geometric mean {geometric_mean(r['cpu_ratio'] for r in rows):.3f}")
    results.finish()
    return status_of_rows(rows)


def rendered(program, exr, words, seed):
    """`cpu_seconds` of the statistics, with one thread."""
    stats = exr.with_suffix(".json")
    run_checked([program, "render", *words, "--seed", seed, "-o", exr, "--stats", stats,
                 "--adaptive", "off", "--replicates", 1, "--threads", 1, "--quiet"],
                failed=CandelaFailed, writes=[exr, stats])
    return json.loads(stats.read_text())["cpu_seconds"]


def cpu_seconds(*told):
    """Of rendering, by each of both programs' statistics: without what both tell of decoding."""
    keys = set.intersection(*map(set, told))
    return [rendering_cpu_seconds({key: of[key] for key in keys}) for of in told]


def compared(pairs):
    """`pairs`: CPU seconds [before, now] each."""
    ratio = spread(now / before for before, now in pairs)
    return {"cpu_ratio": ratio.median, "low": ratio.low, "high": ratio.high,
            "seconds": spread(now for _, now in pairs).median}


def apart(candela, out):
    now, before = (types.SimpleNamespace(exr=out / f"renders/{which}.exr")
                   for which in ("now", "before"))
    return candela.compare(now, before)["relmse"]
