"""Scrambled Sobol points against plain random numbers: by how much relMSE is lower.

Box filter, each pixel's paths its own, roulette from 1/2 on, without splitting and adaptive
sampling, so that both take the same ways. Ratios are those of pictures in pairs of one
seed: median, range and geometric mean, with half of the 95 % interval of the mean's logarithm
(plus_minus); none where an error is lost in the reference's noise. cpu: the CPU time with Sobol
points over that without. Last, what such points take by themselves.
"""

import math

import chosen_scenes
import truth
from ablation import PLAIN_PATHS
from arguments import at_least
from fits import ratio_columns, ratio_of_errors, spread
from renders import square
from results import begin

ABOUT = "scrambled Sobol points against plain random numbers: by how much relMSE is lower"
# Squares far smaller than a pixel, so that every sample is a toss of a coin. Where a power of two
# of them make a pixel, the first digits of a sample's place decide.
SQUARES_A_PIXEL = (10.7, 8)
CHECKER = """LookAt 0 0 1  0 0 0  0 1 0
Camera "perspective" "float fov" 60
WorldBegin
LightSource "infinite" "rgb L" [1 1 1]
Texture "squares" "spectrum" "checkerboard" "float uscale" {squares} "float vscale" {squares}
  "rgb tex1" [.9 .9 .9] "rgb tex2" [.1 .1 .1]
Material "diffuse" "texture reflectance" "squares"
Shape "bilinearmesh" "point3 P" [-1 -1 0  1 -1 0  -1 1 0  1 1 0] "point2 uv" [0 0 1 0 0 1 1 1]
"""


def add_arguments(parser):
    parser.add_argument("--quick", action="store_true", help="48x48, 2 seeds")
    parser.add_argument("--seeds", type=at_least(1), help="pictures of each kind (8)")
    parser.add_argument("--size", type=at_least(1), metavar="N", help="pixels a side (128)")


def run(options):
    out, candela, results = begin(options, "Sobol points", __doc__)
    size = options.size or (48 if options.quick else 128)
    seeds = range(1, 1 + (options.seeds or (2 if options.quick else 8)))
    box = chosen_scenes.present()["cornell_box_diffuse"]
    pictures = [("Cornell box, direct light", box, {"max_depth": 1}),
                ("Cornell box", box, {"max_depth": "none"})]
    for squares in SQUARES_A_PIXEL:
        name = f"checker, {squares:g} squares a pixel"
        pictures.append((name, checker_of(squares, size, out), {"max_depth": 1}))
    rows = []
    for name, scene, extra in pictures:
        right = truth.reference(candela, name.replace(" ", "_").replace(",", ""), scene, size,
                                256 if options.quick else 4096, **extra)
        rows += [{"picture": name, "replicates": replicates, "spp": spp}
                 | gain(candela, scene, right, seeds, size=square(size), spp=spp,
                        replicates=replicates, **extra)
                 for replicates in (1, 4) for spp in (16, 64)]
        print(f"{name}: done", flush=True)
    results.table("sampler", "relMSE of plain random numbers over Sobol points', "
                  f"{square(size)}, {len(seeds)} seeds", rows)
    nanoseconds = candela.bench(box)["number_nanoseconds"]
    results.table("nanoseconds", "Of CPU time a dimension of Sobol points", [nanoseconds],
                  "block: of sixteen samples side by side, as most are drawn; single: of one.")
    results.finish()


def checker_of(squares_a_pixel, size, out):
    """A quad that is 2 wide and fills a picture of `size` pixels, which shows 2 / sqrt(3) of it."""
    checker = out / f"checker_{squares_a_pixel:g}.pbrt"
    checker.write_text(CHECKER.format(squares=squares_a_pixel * size * math.sqrt(3)))
    return checker


def gain(candela, scene, right, seeds, **options):
    plain, sobol = zip(*([truth.measured(candela, scene, right, seed=seed, threads=1,
                                         adaptive="off", sampler=sampler, **PLAIN_PATHS, **options)
                          for sampler in ("independent", "sobol")] for seed in seeds))
    errors = [[run.relmse for run in runs] for runs in (plain, sobol)]
    cpu = spread(s.cpu_seconds / p.cpu_seconds for p, s in zip(plain, sobol))
    return (ratio_columns("relmse", map(ratio_of_errors, *errors))
            | {"cpu": cpu.median, "reference": truth.judged(right, *errors)})
