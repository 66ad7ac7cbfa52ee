"""Figures 2 to 4: lab 3's shading and path tracing of the same all-diffuse box."""

import numpy

import plots
from exr import read_exr
from renders import square
from scenes import asset
from workshop import SEED, figure, row

SCENE = "cornell_box_diffuse"
# Light from everywhere, as lab 3's shading needs it for sides that no lamp reaches: about the lab's
# own .1, and of the lamp's colour.
AMBIENT = ",".join(f"{radiance / 200:g}" for radiance in (23, 20.7, 16.1))
# What a white surface under the lamp has of red over green: profiles are in units of it.
WHITE = (.725 * 23) / (.71 * 20.7)
# Pixels x0, y0, x1, y1 of a picture of 512 x 512; profiles run through the middle one.
BLEEDING_CROP = (290, 340, 420, 450)
BLEEDING_ROWS = (380, 420)
BOX_SIDE = (381, 391)
PENUMBRA_CROP = (50, 390, 180, 500)
PENUMBRA_COLUMNS = (98, 102)
PENUMBRA_ROWS = (420, 468)


def overview(workshop):
    scale = workshop.scale
    options = {"size": square(scale.size), "seed": SEED}
    local = {**options, "spp": 16, "ambient": AMBIENT}
    rows = []
    for integrator, caption, settings in (
            ("raster", "raster: no shadows, no further rays", local),
            ("whitted", "whitted: the lab's ray tracing", local),
            ("path", "path", {**options, "spp": scale.overview_spp})):
        render = workshop.candela.render(f"figure_2_{integrator}", asset(SCENE),
                                         integrator=integrator, **settings)
        rows.append(row(workshop, render, caption))
    return figure(
        "figure_2", "Figure 2: rasterised, ray traced, path traced",
        ["The report: under 1 minute by the lab's ray tracer and 23 minutes by path tracing with "
         "64 samples a pixel, on a processor and at a size that it does not tell. Those are "
         "history; the times below are of this run.",
         "All boxes diffuse. raster and whitted take the lamp for a point and have ambient light "
         f"of the lamp's colour (--ambient {AMBIENT}); path needs none."],
        [("spp", "spp"), ("seconds", "seconds")], rows)


def crop_pair(workshop, name, crop):
    """The same crop by both integrators, enlarged: rows, and pixels by integrator."""
    scale = workshop.scale
    enlarged = ",".join(str(side * scale.detail_size // 512) for side in crop)
    rows, pixels = [], {}
    for integrator, settings in (("whitted", {"spp": 16, "ambient": AMBIENT}),
                                 ("path", {"spp": scale.detail_spp})):
        render = workshop.candela.render(f"{name}_{integrator}", asset(SCENE),
                                         integrator=integrator, size=square(scale.detail_size),
                                         crop=enlarged, seed=SEED, **settings)
        rows.append(row(workshop, render, integrator))
        pixels[integrator] = read_exr(render.exr)
    return rows, pixels


def window(workshop, crop, columns, rows):
    """Slices of the crop's own pixels, from coordinates in the picture of 512 x 512."""
    factor = workshop.scale.detail_size / 512

    def span(low, high, origin):
        first = int(low * factor) - int(origin * factor)
        return slice(first, max(first + 1, int(high * factor) - int(origin * factor)))

    return span(*rows, crop[1]), span(*columns, crop[0])


def positions(low, count, factor):
    """Of pixels' centres, in pixels of the picture of 512 x 512."""
    return low + (numpy.arange(count) + .5) / factor


def colour_bleeding(workshop):
    crop = BLEEDING_CROP
    rows, pixels = crop_pair(workshop, "figure_3", crop)
    across = window(workshop, crop, (340, 400), BLEEDING_ROWS)
    side = window(workshop, crop, BOX_SIDE, BLEEDING_ROWS)
    curves = []
    for entry in rows:
        image = pixels[entry["caption"]]
        mean = image[across].mean(axis=0)
        curves.append((entry["caption"],
                       positions(340, len(mean), workshop.scale.detail_size / 512),
                       mean[:, 0] / mean[:, 1] / WHITE, {}))
        red, green, _ = image[side].mean(axis=(0, 1))
        entry["redness"] = float(red / green / WHITE)
    path = workshop.plot("figure_3")
    plots.line_plot(path, curves, "column of pixels (of 512)", "red / green of its own white",
                    marks="", spans=[(*BOX_SIDE, "measured: the box's side")])
    return figure(
        "figure_3", "Figure 3: colour bleeding",
        ["The report: the boxes' sides take the colour of the walls beside them, and do not in the "
         "lab's ray tracer. That stands. No lamp reaches this side of the short box; what it has "
         "is light from the red wall. Red over green is in units of what white has under the lamp.",
         "docs/report.md, section 4.1."],
        [("spp", "spp"), ("seconds", "seconds"), ("redness", "red / green of its own white")],
        rows, [(workshop.relative(path), "Along a row across the short box, from its front to its "
                "side and the wall's foot.")])


def penumbra(workshop):
    crop = PENUMBRA_CROP
    rows, pixels = crop_pair(workshop, "figure_4", crop)
    along = window(workshop, crop, PENUMBRA_COLUMNS, PENUMBRA_ROWS)
    factor = workshop.scale.detail_size / 512
    curves = []
    for entry in rows:
        green = pixels[entry["caption"]][along].mean(axis=1)[:, 1]
        curves.append((entry["caption"], positions(PENUMBRA_ROWS[0], len(green), factor),
                       way_to_the_light(green), {}))
        entry["penumbra"] = penumbra_width(green) / factor
    path = workshop.plot("figure_4")
    plots.line_plot(path, curves, "row of pixels (of 512)", "from shadow (0) to light (1)",
                    marks="")
    return figure(
        "figure_4", "Figure 4: penumbrae",
        ["The report: shadows have soft edges by path tracing and hard ones by the lab's. That "
         "stands, and it is the lamp's doing: one with an area is partly hidden at the edge, a "
         "point is not. The width is of the part from 10 to 90 % of the way.",
         "docs/report.md, section 4.1."],
        [("spp", "spp"), ("seconds", "seconds"), ("penumbra", "width in pixels (of 512)")],
        rows, [(workshop.relative(path), "Down a column of the floor, across the front edge of the "
                "tall box's shadow.")])


def way_to_the_light(values):
    """0 for the mean of the darkest tenth, 1 for that of the brightest."""
    ordered = numpy.sort(values)
    tenth = max(1, len(values) // 10)
    dark, light = ordered[:tenth].mean(), ordered[-tenth:].mean()
    return (values - dark) / max(light - dark, 1e-9)


def penumbra_width(values):
    way = way_to_the_light(values)
    return int(((way > .1) & (way < .9)).sum())
