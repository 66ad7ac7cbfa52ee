"""Instructions per camera sample of the path kernel, held against those on record.

Counted within the tile function, so that starting, reading and building do not count, on one
thread, with one replicate, since samples that look closer at doubtful pixels, in order to state an
error, would count as well: the same program gives the same number. Which vectors candela's random
numbers and Embree use depends on the processor that valgrind shows, and all of it on the compiler:
only what was measured with the same is compared.
"""

import dataclasses
import json
import pathlib
import re
import subprocess
import sys

import callgrind
from renders import Candela
from results import FAILED, Results
from scenes import asset

ABOUT = "instructions per camera sample against those on record: may not grow by more than 3 %"
RECORD = pathlib.Path(__file__).with_name("budget.json")
GROWTH = .03
# --strict decodes the textures before the first tile; else the first that asks pays for it.
OPTIONS = ("--threads", 1, "--strict", "--quiet", "--roulette", 1, "--replicates", 1)
SIZE, SPP = "32x32", 16
SAMPLES = 32 * 32 * SPP
LAMPS = 200


def add_arguments(parser):
    parser.add_argument("--record", action="store_true", help="make these the figures on record")
    parser.add_argument("--kernels", action="store_true",
                        help="also count the general kernel: what the scene's own spares")
    parser.add_argument("--quick", action="store_true", help="the first two scenes only")
    parser.add_argument("--file", type=pathlib.Path, default=RECORD, metavar="FILE.json",
                        help="the figures on record (tools/benchmarks/budget.json)")


def fixed_scenes(out):
    """Small ones that stay as they are, each with something of its own."""
    from generated import generated
    found = {name: asset(name)
             for name in ("cornell_box_diffuse", "cornell_box", "glass_and_metal", "cutouts")}
    return found | {"lamps": generated(out, "lamps", lamps=LAMPS)}


@dataclasses.dataclass
class Count:
    all: float  # per camera sample
    embree: float
    measured_with: dict


def counted(options, name, scene, *more):
    words = [options.program, "render", scene, "-o", options.out / f"{name}.exr", "--size", SIZE,
             "--spp", SPP, *OPTIONS, *more]
    profile = callgrind.count(options.out / f"{name}.callgrind", words)
    embree, library = callgrind.embree_of(profile)
    return Count(round(profile.total / SAMPLES, 1), round(embree / SAMPLES, 1),
                 {"vectors": callgrind.vectors_of(profile), "embree": library,
                  "compiler": compiler_of(options.program)})


def compiler_of(program):
    comment = subprocess.run(["readelf", "-p", ".comment", str(program)], capture_output=True,
                             text=True).stdout
    found = re.findall(r"(GCC: .*\d|clang version \S+)", comment)
    return found[-1] if found else "unknown"


def grown(record, counts):
    """A sentence for each scene that needs more than it may."""
    sentences = []
    for name, count in counts.items():
        if name not in record:
            sentences.append(f"{name}: no figure on record; `tools/bench budget --record` makes "
                             "one")
        elif count.all > record[name]["all"] * (1 + GROWTH):
            sentences.append(f"{name}: {count.all:.1f} instructions a sample, "
                             f"{count.all / record[name]['all'] - 1:+.1%} of the "
                             f"{record[name]['all']:.1f} on record; expected at most {GROWTH:+.0%}")
    return sentences


def row(record, name, count):
    before = record.get(name, {}).get("all")
    return {"scene": name, "on_record": f"{before:.1f}" if before else None,
            "now": f"{count.all:.1f}",
            "change": f"{count.all / before - 1:+.2%}" if before else None,
            "of_it_embree": f"{count.embree:.1f}"}


def kernel_row(options, name, scene, own):
    """The scene's own kernel over the general one, which gives the same bits."""
    general = counted(options, name, scene, "--kernel", "general")
    return {"scene": name, "own_over_general": own.all / general.all,
            "without_embree": (own.all - own.embree) / (general.all - general.embree)}


def described(counts):
    """What figures must have in common to be compared."""
    return {"measured_with": next(iter(counts.values())).measured_with, "size": SIZE, "spp": SPP}


def write_record(path, counts):
    path.write_text(json.dumps(
        described(counts)
        | {"instructions_per_sample": {name: {"all": count.all, "embree": count.embree}
                                       for name, count in counts.items()}}, indent=1) + "\n")


def read_record(path):
    """{} where there is none."""
    try:
        return json.loads(path.read_text()) if path.exists() else {}
    except ValueError as problem:
        sys.exit(f"tools/bench: {path} is no JSON: {problem}")


def run(options):
    options.out = options.out.resolve()
    if options.record and options.quick:
        sys.exit("tools/bench: --record needs all scenes; expected no --quick beside it")
    results = Results(options.out, "The budget", __doc__,
                      Candela(options.program, options.out).version())
    scenes = dict(list(fixed_scenes(options.out).items())[:2 if options.quick else None])
    file = read_record(options.file)
    counts = {name: counted(options, name, scene) for name, scene in scenes.items()}
    record = file.get("instructions_per_sample", {})
    results.table("budget", f"Instructions a camera sample, {SIZE}, {SPP} spp",
                  [row(record, name, count) for name, count in counts.items()])
    if options.kernels:
        results.table("kernels", "Instructions, the scene's own kernel over the general one",
                      [kernel_row(options, name, scene, counts[name])
                       for name, scene in scenes.items()])
    if options.record:
        write_record(options.file, counts)
        sentences = []
    else:
        sentences = judged(results, file, record, counts)
    results.finish()
    return FAILED if sentences else 0


def judged(results, file, record, counts):
    """What has grown too much, a sentence each; none where the record is of something else."""
    now = described(counts)
    of_record = {key: file.get(key) for key in now}
    if record and of_record != now:
        results.note(f"not judged: the figures on record are of {of_record}, these of {now}")
        return []
    sentences = grown(record, counts)
    for sentence in sentences or ["within the budget"]:
        results.note(sentence)
    return sentences
