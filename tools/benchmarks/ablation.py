"""Each technique off in turn: what that does to error, to time, and to the time to the same error.

A scene's picture is rendered with everything on and with one technique off, in pairs of one seed
that take turns; above 1 the technique pays. relMSE falls as a power of the time, which pictures of
half the samples tell; so the time to the same error follows from both ratios. On by default stays
what gains 5 % in the geometric mean and loses no more than 3 % on any scene.
"""

import dataclasses

import chosen_scenes
import truth
from fits import geometric_mean, ratio_of_errors, spread, times_to_same_error, with_factor
from renders import CandelaFailed

ABOUT = "each technique off in turn: time to the same error"


@dataclasses.dataclass(frozen=True)
class Technique:
    name: str
    off: dict  # candela's options
    same_picture: bool = False  # the same bits or the same noise: only the time is compared
    # Strategies other than the default have a kernel of their own, which costs a little more, and
    # the reference BVH the general one alone. So that this does not count as theirs, the time with
    # everything on is that of these options.
    timed_on: dict | None = None
    # Other strategies, splitting and guiding have no walks that choose a roulette (render.cpp). So
    # that this does not count as theirs, these options hold on both sides.
    both: dict = dataclasses.field(default_factory=dict)


SAME_KERNEL = {"heuristic": "balance"}
USUAL_ROULETTE = {"roulette": .5}  # what is taken where nothing is chosen (path_plan.h)

TECHNIQUES = (  # a row is a line
    Technique("kernel for what the scene needs", {"kernel": "general"}, same_picture=True),
    Technique("Embree and lists of few faces (off: reference BVH)", {"accel": "bvh"},
              same_picture=True, timed_on={"kernel": "general"}),
    Technique("lists of few faces (off: Embree alone)", {"accel": "embree"}, same_picture=True),
    Technique("robust mode", {"robust": "off"}, same_picture=True),
    Technique("packets of rays", {"without": "packets"}, same_picture=True),
    Technique("trees of high quality", {"without": "high-quality"}, same_picture=True),
    Technique("denormals as zero", {"without": "flushing"}, same_picture=True),
    Technique("large pages for images", {"without": "large-pages"}, same_picture=True),
    Technique("pixels that share blocks", {"without": "shared-blocks"}, same_picture=True),
    Technique("blocks in convoys", {"without": "convoys"}, same_picture=True),
    Technique("background without rays", {"without": "background"}, same_picture=True),
    Technique("grids of opacity", {"without": "opacity-grids"}, same_picture=True),
    Technique("adaptive sampling", {"adaptive": "off"}),
    Technique("no splitting (off: by two)", {"splitting": 2}, both=USUAL_ROULETTE),
    Technique("no splitting (off: by four)", {"splitting": 4}, both=USUAL_ROULETTE),
    Technique("roulette by what walks tell (off: from 1/2 on)", {"roulette": .5}),
    Technique("roulette by what walks tell (off: from 1/4 on)", {"roulette": .25}),
    Technique("roulette by what walks tell (off: at any throughput)", {"roulette": 1}),
    Technique("no path guiding (off: everywhere)", {"guiding": "on"}, both=USUAL_ROULETTE),
    Technique("no path guiding (off: where a trial says that it pays)", {"guiding": "auto"},
              both=USUAL_ROULETTE),
    Technique("Sobol points (off: plain random numbers)", {"sampler": "independent"}),
    Technique("pairs of a path together (off: each shuffled by itself)", {"sampler": "padded"}),
    Technique("no light samples for a constant sky", {"sky_samples": "on"}),
    Technique("dim parts of skies left to BSDF samples", {"sky_compensation": "off"}),
    Technique("more camera rays at lamps' edges", {"lamp_rays": 0}),
    Technique("two triangles as one lamp (off: apart)", {"light_sampling": "triangles"}),
    Technique("lights by place (off: by power)", {"light_cells": "off"}),
    Technique("near lamps by area (off: by solid angle)", {"light_sampling": "solid_angle"}),
    Technique("four replicates (off: one, no stated error)", {"replicates": 1}),
    Technique("light and BSDF samples (off: light alone)", {"sampling": "light"},
              timed_on=SAME_KERNEL, both=USUAL_ROULETTE),
    Technique("light and BSDF samples (off: BSDF alone)", {"sampling": "bsdf"},
              timed_on=SAME_KERNEL, both=USUAL_ROULETTE),
    Technique("directions by the BSDF (off: by the cosine)", {"sampling": "cosine"},
              timed_on=SAME_KERNEL, both=USUAL_ROULETTE),
    Technique("power heuristic (off: balance)", {"heuristic": "balance"}, timed_on=SAME_KERNEL,
              both=USUAL_ROULETTE),
)
GAIN, LOSS = 1.05, .97


def add_arguments(parser):
    chosen_scenes.add_argument(parser, "the shipped and the generated ones")
    parser.add_argument("--quick", action="store_true", help="48x48, 16 spp, 3 pairs")
    parser.add_argument("--pairs", type=int, help="pictures with and without (8)")
    parser.add_argument("--size", type=int, metavar="N", help="pixels a side (96)")
    parser.add_argument("--spp", type=int,
                        help="samples of a picture (128; adaptive sampling begins at 64)")
    parser.add_argument("--technique", action="append", metavar="WORDS",
                        help="only rows whose name has these words; may be given several times")
    parser.add_argument("--same-picture", action="store_true",
                        help="only rows that change time alone: no reference is needed")
    parser.add_argument("--threads", type=int, default=1, help="(1)")


def wanted(options):
    words = options.technique or [""]
    found = [t for t in TECHNIQUES if any(w.lower() in t.name.lower() for w in words)
             and (t.same_picture or not options.same_picture)]
    if not found:
        names = ", ".join(f"'{t.name}'" for t in TECHNIQUES)
        raise CandelaFailed(f"no technique is called {' or '.join(words)}; there are {names}")
    return found


def run(options):
    from convergence import default_scenes
    from renders import Candela
    from results import Results
    out = options.out.resolve()
    candela = Candela(options.program, out / "renders")
    results = Results(out, "Ablation", __doc__, candela.version())
    size = options.size or (48 if options.quick else 96)
    spp = options.spp or (16 if options.quick else 128)
    pairs = options.pairs or (3 if options.quick else 8)
    scenes = chosen_scenes.chosen(candela, out, options.scenes, default_scenes(),
                                  results.note)
    techniques = wanted(options)
    rows = []
    for name, scene in scenes.items():
        common = {"size": f"{size}x{size}", "spp": spp, "threads": options.threads}
        right = rate = None
        if not all(technique.same_picture for technique in techniques):
            right = truth.reference(candela, name, scene, size, 16 * spp)
            rate = rate_of(candela, scene, right, pairs, common)
        for technique in techniques:
            try:
                rows.append(row(candela, name, scene, right, technique, pairs, common, rate))
            except CandelaFailed as reason:
                results.note(f"{name}, {technique.name}: left out. {str(reason).splitlines()[0]}")
        print(f"{name}: done", flush=True)
    results.table("ablation", f"Off over on, {size}x{size}, {spp} spp, {pairs} pairs", rows)
    results.table("verdicts", "Time to the same error, off over on, over all scenes",
                  verdicts(rows))
    results.finish()


def rate_of(candela, scene, right, pairs, common):
    """With everything on."""
    fewer, more = ([truth.measured(candela, scene, right, seed=seed, **common | {"spp": spp})
                    for seed in range(1, pairs + 1)] for spp in (common["spp"] // 2, common["spp"]))
    return truth.rate_of_runs(fewer, more)


def row(candela, name, scene, right, technique, pairs, common, rate):
    on, off = [], []
    for seed in range(1, pairs + 1):
        own = common | technique.both | {"seed": seed}
        picture = None if technique.same_picture else right
        on.append(truth.measured(candela, scene, picture, **own))
        if technique.timed_on:
            timed = truth.measured(candela, scene, None, **own, **technique.timed_on)
            on[-1] = dataclasses.replace(on[-1], cpu_seconds=timed.cpu_seconds,
                                         seconds=timed.seconds)
        off.append(truth.measured(candela, scene, picture, **own, **technique.off))
    word = None if technique.same_picture else truth.judged(
        right, *([run.relmse for run in runs] for runs in (on, off)))
    return ({"technique": technique.name, "scene": name}
            | compared(on, off, technique.same_picture, rate) | {"reference": word})


def compared(on, off, same_picture, rate):
    """Ratios off / on: of CPU time by pairs, of error by medians, and of both together by pairs:
    the geometric mean, with twice its standard error; nan where an error is lost in the
    reference's noise."""
    cpu = spread(b.cpu_seconds / a.cpu_seconds for a, b in zip(on, off))
    wall = spread(b.seconds / a.seconds for a, b in zip(on, off))
    row = {"cpu": cpu.median, "cpu_low": cpu.low, "cpu_high": cpu.high, "wall": wall.median}
    if same_picture:
        return row | {"relmse": 1.0, "rate": rate, "time_to_error": cpu.median, "low": cpu.low,
                      "high": cpu.high}
    error = spread(r.relmse for r in off).median / spread(r.relmse for r in on).median
    mean, factor = with_factor(times_to_same_error(b.cpu_seconds / a.cpu_seconds,
                                                   ratio_of_errors(b.relmse, a.relmse), rate)
                               for a, b in zip(on, off))
    return row | {"relmse": error, "rate": rate, "time_to_error": mean, "low": mean / factor,
                  "high": mean * factor}


def verdicts(rows):
    lines = []
    for technique in TECHNIQUES:
        own = [r for r in rows if r["technique"] == technique.name and r["time_to_error"] > 0]
        if not own:
            continue
        least = min(own, key=lambda r: r["time_to_error"])
        mean = geometric_mean(r["time_to_error"] for r in own)
        lines.append({"technique": technique.name, "scenes": len(own), "geometric_mean": mean,
                      "least": least["time_to_error"], "where": least["scene"],
                      "pays": "yes" if mean >= GAIN and least["time_to_error"] >= LOSS else "no"})
    return lines
