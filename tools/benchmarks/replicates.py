"""What stating an error costs: relMSE with 2, 4 and 8 replicates over that with one."""

import math
import pathlib

from references import layers, reference, side_by_side, square
from renders import Candela
from results import write_csv

ABOUT = "what stating an error costs: noise with more replicates over that with one"

ROOT = pathlib.Path(__file__).resolve().parents[2]
SIZE = 48
COUNTS = (16, 64)
REPLICATES = (1, 2, 4, 8)
CASES = ("cornell_box_diffuse", "cornell_box", "glass_and_metal", "cutouts")


def add_arguments(parser):
    parser.add_argument("--seeds", type=int, default=16, help="pictures a case (16)")


def relmse(candela, path, truth, spp, replicates, seeds):
    """Mean over the seeds, and its standard error."""
    def one(seed):
        render = candela.render(f"picture_{seed}", path, png=False, size=square(SIZE), spp=spp,
                                seed=seed, threads=1, replicates=replicates,
                                aov="variance,heavy_tail")
        return truth.relmse(layers(render)[0])

    values = side_by_side(one, range(1, seeds + 1))
    mean = sum(values) / seeds
    return mean, math.sqrt(sum((v - mean) ** 2 for v in values) / (seeds * (seeds - 1)))


def run(options):
    out = options.out.resolve()
    out.mkdir(parents=True, exist_ok=True)
    candela = Candela(options.program, out / "renders")
    rows = []
    print("| relMSE over that of one replicate | spp | " +
          " | ".join(map(str, REPLICATES[1:])) + " |")
    print("|---|---:|" + "---:|" * (len(REPLICATES) - 1))
    for name in CASES:
        path = ROOT / "assets" / name / f"{name}.yaml"
        truth = reference(candela, f"reference_{path.stem}", path, size=square(SIZE),
                          spp=16 * max(COUNTS))
        for spp in COUNTS:
            found = [relmse(candela, path, truth, spp, r, options.seeds) for r in REPLICATES]
            one, one_error = found[0]
            ratios = []
            for replicates, (mean, error) in zip(REPLICATES[1:], found[1:]):
                ratio = mean / one
                plus_minus = 2 * ratio * math.hypot(error / mean, one_error / one)
                ratios.append(f"{ratio:.2f} ± {plus_minus:.2f}")
                rows.append({"case": name, "spp": spp, "replicates": replicates, "ratio": ratio,
                             "plus_minus": plus_minus})
            print(f"| {name} | {spp} | " + " | ".join(ratios) + " |", flush=True)
    write_csv(out / "replicates.csv", rows)
