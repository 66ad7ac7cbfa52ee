"""Figure 5: ways to choose directions, with equally many samples."""

import plots
from renders import square
from scenes import asset
from workshop import SEED, figure, reference_note, row

STRATEGIES = ("uniform", "cosine", "bsdf", "light", "mis")
BOXES = {"cornell_box": "metal", "cornell_box_diffuse": "all diffuse"}


def make(workshop):
    rows, errors = [], {}
    for scene, kind in BOXES.items():
        errors[kind] = {}
        for sampling in STRATEGIES:
            render = workshop.candela.render(
                f"figure_5_{scene}_{sampling}", asset(scene), sampling=sampling,
                spp=workshop.scale.strategy_spp, size=square(workshop.scale.size), seed=SEED,
                adaptive="off")
            comparison = workshop.candela.compare(render, workshop.reference(scene))
            errors[kind][sampling] = comparison["relmse"]
            rows.append(row(workshop, render, f"{kind}, {sampling}", relmse=comparison["relmse"],
                            mean_ratio=sum(comparison["mean_ratio"]) / 3))
    path = workshop.plot("figure_5")
    plots.bar_plot(path, errors, "relMSE")
    return figure(
        "figure_5", f"Figure 5: sampling strategies at {workshop.scale.strategy_spp} spp",
        ["The report: with uniform directions metal looks diffuse, and the ceiling and shadows are "
         "darker. Neither can be the sampling, whose mean is the same whatever the directions: "
         "the last column is 1 but for noise. What differs is the noise; what can make it dark is "
         "the next figure. docs/report.md, section 4.2.",
         "Each is --sampling NAME.",
         *(f"{BOXES[scene]}: {reference_note(workshop, scene)}" for scene in BOXES)],
        [("spp", "spp"), ("seconds", "seconds"), ("relmse", "relMSE"),
         ("mean_ratio", "mean / the reference's")],
        rows, [(workshop.relative(path), "Error of each strategy.")])
