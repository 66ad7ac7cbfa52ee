"""What stating an error costs: relMSE with 2, 4 and 8 replicates over that with one.

Without adaptive sampling, which one replicate does not have by default.
"""

import math

import truth
from arguments import at_least
from references import layers, reference, side_by_side
from renders import square
from results import begin
from scenes import asset
from student import student_t

ABOUT = "what stating an error costs: noise with more replicates over that with one"

SIZE = 48
COUNTS = (16, 64)
REPLICATES = (1, 2, 4, 8)
CASES = ("cornell_box_diffuse", "cornell_box", "glass_and_metal", "cutouts")


def add_arguments(parser):
    parser.add_argument("--seeds", type=at_least(2), default=16, help="pictures a case (16)")


def relmse(candela, path, right, spp, replicates, seeds):
    """Mean over the seeds, and its standard error."""
    def one(seed):
        render = candela.render(f"picture_{seed}", path, png=False, size=square(SIZE), spp=spp,
                                seed=seed, threads=1, replicates=replicates, adaptive="off",
                                aov="variance,heavy_tail")
        return right.relmse(layers(render)[0])

    values = side_by_side(one, range(1, seeds + 1))
    mean = sum(values) / seeds
    return mean, math.sqrt(sum((v - mean) ** 2 for v in values) / (seeds * (seeds - 1)))


def run(options):
    _, candela, results = begin(options, "Replicates", __doc__)
    rows = []
    for name in CASES:
        path = asset(name)
        right = reference(candela, f"reference_{path.stem}", path, size=square(SIZE),
                          spp=16 * max(COUNTS))
        for spp in COUNTS:
            found = [relmse(candela, path, right, spp, r, options.seeds) for r in REPLICATES]
            rows += [{"case": name, "spp": spp} | row
                     for row in rows_of(found, right, options.seeds)]
        print(f"{name}: done", flush=True)
    results.table("replicates", "relMSE over that of one replicate", rows,
                  "plus_minus: half of the 95 % interval.")
    results.finish()


def rows_of(found, right, seeds):
    """`found`: mean and standard error by number of replicates."""
    one, one_error = found[0]
    for replicates, (mean, error) in zip(REPLICATES[1:], found[1:]):
        ratio = mean / one
        yield {"replicates": replicates, "ratio": ratio,
               "plus_minus": student_t(seeds - 1) * ratio * math.hypot(error / mean,
                                                                       one_error / one),
               "reference": truth.judged(right, [mean], [one])}
