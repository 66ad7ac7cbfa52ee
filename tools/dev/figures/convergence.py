"""Figure 1: one scene with ever more samples a pixel."""

import plots
from renders import square
from scenes import asset
from workshop import SEED, figure, reference_note, row

SCENE = "cornell_box"


def make(workshop):
    reference = workshop.reference(SCENE)
    rows = []
    for spp in workshop.scale.spp:
        render = workshop.candela.render(f"figure_1_{spp}", asset(SCENE), spp=spp,
                                         size=square(workshop.scale.size), seed=SEED,
                                         adaptive="off")
        rows.append(row(workshop, render, f"{spp} spp",
                        relmse=workshop.candela.compare(render, reference)["relmse"]))
    return figure(
        "figure_1", "Figure 1: samples a pixel",
        ["The report: much noise at first, nearly none at 256 samples a pixel, and far longer "
         "renders. Here with the time and the error of each. Independent samples halve the relMSE "
         "whenever they double, which is the dotted line's slope; candela's are spread evenly over "
         "what they sample and may do a little better.",
         reference_note(workshop, SCENE)],
        [("spp", "spp"), ("seconds", "seconds"), ("relmse", "relMSE")], rows,
        [(workshop.relative(plot(workshop, rows)), "Error against samples a pixel.")])


def plot(workshop, rows):
    path = workshop.plot("figure_1")
    spp = [r["spp"] for r in rows]
    first = rows[0]["relmse"]
    plots.line_plot(
        path, [("measured", spp, [r["relmse"] for r in rows], {}),
               ("1 / spp", spp, [first * spp[0] / n for n in spp], {"ls": ":", "color": "0.4"})],
        "samples a pixel", "relMSE", log=True)
    return path
