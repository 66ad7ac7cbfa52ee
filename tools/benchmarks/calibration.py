"""Is the stated error the true one? Over scenes, samples a pixel and seeds.

The true relMSE is measured against a long reference of other seeds, whose own variance is taken
off; the stated one is what the program says of itself. docs/accuracy.md tells what came out."""

import dataclasses
import math
import pathlib
import statistics
import sys

import analytic_scenes
import calibration_goals as goals
from arguments import at_least, numbers
from chosen_scenes import present, safe, tell_absent
from fits import spread
from references import (SEEDS, layers, long_enough, reference, rendered_once, side_by_side,
                        with_weight)
from renders import CandelaFailed, square
from results import FAILED, begin
from scenes import shipped_pbrt_scenes
from student import student_t

ABOUT = "the stated error against the true one"
# Samples a pixel of each seed over those of the longest picture measured with it. Adaptive pictures
# have up to ten times the mean where they are noisiest, and light rarer than the reference's
# samples would count as an error of those that met it.
REFERENCE_LENGTH = 64
# How many times as long it may become where pictures' error hangs on pixels that it is unsure of.
LONGER = (1, 8, 64)
LONGEST = 1 << 20
# A pixel that holds so much of the pictures' error gets reference samples of its own: the level
# that its error is held against decides then, and rare light can be half of it.
HEAVY_SHARE = .01
HEAVY_PIXEL_SPP = 1 << 22

# Few pictures hold most of the error of these: highlights of small lamps and of the sun, narrower
# than a pixel. Twenty would say nothing of the mean.
RARE = ("lab3/sports_car", "pbrt/veach-mis")


def none_or_two(text):
    return 0 if text == "0" else at_least(2)(text)


def add_arguments(parser):
    parser.add_argument("--quick", action="store_true",
                        help="4 to 64 samples a pixel only, references accordingly")
    parser.add_argument("--scenes", metavar="NAMES", help="only these, by comma")
    parser.add_argument("--spp", type=numbers(2), metavar="LIST", help="only these, by comma")
    parser.add_argument("--seeds", type=at_least(2), default=20, help="pictures a case (20)")
    parser.add_argument("--rare-seeds", type=at_least(2), default=200, metavar="N",
                        help="the same of scenes where few pictures hold most of the error (200)")
    parser.add_argument("--stops", type=none_or_two, default=200, metavar="N",
                        help="pictures that end by --error, a case (200); 0: none")
    parser.add_argument("--no-cases", action="store_true", help="only those that end by --error")


@dataclasses.dataclass
class Scene:
    name: str
    path: pathlib.Path
    radiance: float = None  # of every pixel, where it is known


def all_scenes(options):
    found = present() | (shipped_pbrt_scenes() if options.scenes else {})
    scenes = [Scene(name, path) for name, path in found.items()]
    for name, path, radiance in analytic_scenes.write(options.out / "scenes"):
        scenes.append(Scene(name, path, radiance))
    names = [scene.name for scene in scenes]
    wanted = options.scenes.split(",") if options.scenes else names
    for name in wanted:
        if name not in names:
            raise CandelaFailed(f"no scene '{name}'; expected one of " + ", ".join(names))
    return [scene for scene in scenes if scene.name in wanted]


def size_of(spp):
    """Pixels a side: fewer where samples are many, so that a case takes seconds."""
    return 48 if spp <= 64 else 24


def unsure(renders, truth):
    """How unsure the reference is of the pixels that these pictures' error hangs on: its variance
    over the square of the level, on average by the error."""
    import numpy
    errors = sum((r.image - truth.image) ** 2 * truth.weight for r in renders)
    doubt = numpy.minimum(truth.variance * truth.weight, 1)
    return float((errors * doubt).sum() / errors.sum()) if errors.any() else 0


def truth_of(candela, scene, size, spp):
    import numpy
    if scene.radiance is not None:
        image = numpy.full((size, size, 3), scene.radiance)
        return with_weight(image, numpy.zeros_like(image))
    return reference(candela, f"reference_{safe(scene.name)}_{size}_{spp}", scene.path,
                     size=square(size), spp=spp, replicates=16)


def with_heavy_pixels(candela, scene, size, renders, truth):
    """References of their own for the pixels that hold much of the pictures' error."""
    import numpy
    if scene.radiance is not None:
        return truth
    errors = sum(truth.errors(r.image) for r in renders).mean(axis=2)
    heavy = [tuple(map(int, at)) for at in numpy.argwhere(errors > HEAVY_SHARE * errors.sum())]

    def closely(at):
        y, x = at
        return rendered_once(candela, f"reference_{safe(scene.name)}_{size}_pixel_{x}_{y}",
                             scene.path, size=square(size),
                             crop=f"{x},{y},{x + 1},{y + 1}", spp=HEAVY_PIXEL_SPP, seed=SEEDS[0],
                             replicates=16)

    image, variance = truth.image.copy(), truth.variance.copy()
    for at, (mean_of_pixel, variance_of_pixel, _) in zip(heavy, side_by_side(closely, heavy)):
        image[at], variance[at] = mean_of_pixel[0, 0], variance_of_pixel[0, 0]
    return with_weight(image, variance)


@dataclasses.dataclass
class Rendered:
    image: "numpy.ndarray"
    interval: "numpy.ndarray"
    mask: "numpy.ndarray"
    stats: dict


@dataclasses.dataclass
class Picture:
    stated: float
    true: float
    interval_holds: bool
    covered: float  # share of pixel intervals that hold the truth, where it is noisy and not masked
    covered_everywhere: float  # masked or not
    masked: float
    looked_at: float  # samples that only told how bright pixels are, over those of the picture


def rendered(candela, scene, spp, seed):
    render = candela.render(f"picture_{seed}", scene.path, png=False, integrator="path",
                            size=square(size_of(spp)), spp=spp, seed=seed, threads=1,
                            aov="interval,heavy_tail")
    return Rendered(*layers(render, "interval"), render.stats)


def picture(render, truth):
    # The reference's own noise is normal: 1.96 standard errors.
    reach = (render.interval ** 2 + 1.96 ** 2 * truth.variance) ** .5
    holds = abs(render.image - truth.image) <= reach
    noisy = truth.noisy()
    error = render.stats["error"]
    true = truth.relmse(render.image)
    low, high = error["interval95"]
    samples = render.stats["mean_samples"] * render.mask.size
    return Picture(error["relmse"], true, low <= true <= high,
                   share(holds[noisy & ~render.mask[..., None]]), share(holds[noisy]),
                   float(render.mask.mean()), error["looked_at"]["samples"] / samples)


def share(flags):
    return float(flags.mean()) if flags.size else math.nan


def ratio_with_range(pictures):
    """Of the means, stated over true, and its 95 % interval by the jackknife."""
    stated, true = (sum(getattr(p, k) for p in pictures) for k in ("stated", "true"))
    ratio = stated / true
    n = len(pictures)
    if any(p.true == true for p in pictures):
        return ratio, math.nan  # one picture has all of the error
    without = [(stated - p.stated) / (true - p.true) for p in pictures]
    centre = sum(without) / n
    error = math.sqrt((n - 1) / n * sum((r - centre) ** 2 for r in without))
    return ratio, student_t(n - 1) * error


def is_exact(pictures):
    """Where nothing is random, or all is known."""
    return all(p.true == 0 and p.stated == 0 for p in pictures)


def measured(candela, scene, spp, most, options):
    """The pictures of a case, held against a reference that is long enough for them; and how unsure
    it is."""
    seeds = options.rare_seeds if scene.name in RARE else options.seeds
    renders = side_by_side(lambda seed: rendered(candela, scene, spp, seed), range(1, seeds + 1))

    def held_against(longer):
        truth = truth_of(candela, scene, size_of(spp),
                         min(REFERENCE_LENGTH * most * longer, LONGEST))
        truth = with_heavy_pixels(candela, scene, size_of(spp), renders, truth)
        return truth, unsure(renders, truth)

    truth, doubt = long_enough(held_against, LONGER, lambda found: found[1] <= goals.SURE)
    return [picture(render, truth) for render in renders], truth, doubt


def mean(values):
    values = [v for v in values if not math.isnan(v)]
    return sum(values) / len(values) if values else math.nan


def case_row(scene, spp, pictures, truth):
    ratio, reach = ratio_with_range(pictures)
    true = mean(p.true for p in pictures)
    return {"scene": scene.name, "is_analytic": scene.radiance is not None, "spp": spp,
            "seeds": len(pictures), "true_relmse": true,
            "stated_over_true": ratio, "plus_minus": reach,
            "reference_share": truth.own_relmse() / true,
            "interval_holds": mean(float(p.interval_holds) for p in pictures),
            "pixels_covered": mean(p.covered for p in pictures),
            "pixels_covered_with_masked": mean(p.covered_everywhere for p in pictures),
            "masked": mean(p.masked for p in pictures),
            "looked_at": mean(p.looked_at for p in pictures)}


def cases(results, candela, options, counts):
    rows = []
    for scene in all_scenes(options):
        for spp in counts:
            with results.attempt(f"{scene.name} at {spp} samples"):
                most = max(n for n in counts if size_of(n) == size_of(spp))
                pictures, truth, doubt = measured(candela, scene, spp, most, options)
                if is_exact(pictures):
                    results.note(f"{scene.name} at {spp} samples has no noise, and none is stated")
                    continue
                rows.append(case_row(scene, spp, pictures, truth) | {"reference_unsure": doubt})
                results.keep("calibration", rows)
                print(" ".join(f"{k}={v:.4g}" if isinstance(v, float) else f"{k}={v}"
                               for k, v in rows[-1].items()), file=sys.stderr, flush=True)
    return rows


STOP_SCENES = ("cornell_box_diffuse", "cornell_box", "cutouts", "glass_and_metal", "furnace")
STOP_SPP = (64, 256)  # what errors are asked for: those of that many samples


def stops(results, candela, options):
    """Does --error X end with a true error near X, and is what is stated then still true?"""
    size, rows = 64, []
    for scene in all_scenes(options):
        if scene.name not in STOP_SCENES:
            continue
        with results.attempt(f"{scene.name} by --error"):
            truth = truth_of(candela, scene, size, 1 << 13)
            for spp in STOP_SPP:
                rows.append(stop_row(candela, scene, size, spp, truth, options))
                results.keep("stops", rows)
                print(rows[-1], file=sys.stderr, flush=True)
    return rows


@dataclasses.dataclass
class Stopped:
    stated: float
    true: float  # relMSE, as stated
    interval_holds: bool
    samples: float


def stopped(candela, scene, size, goal, seed, truth):
    render = candela.render(f"stop_{seed}", scene.path, png=False, integrator="path", error=goal,
                            size=square(size), seed=seed, threads=1, aov="variance,heavy_tail")
    error = render.stats["error"]
    true = truth.relmse(layers(render)[0])
    low, high = error["interval95"]
    return Stopped(error["relmse"], true, low <= true <= high, render.stats["mean_samples"])


def stop_row(candela, scene, size, spp, truth, options):
    once = candela.render("stop", scene.path, png=False, integrator="path", spp=spp,
                          size=square(size), seed=1)
    goal = float(f"{once.stats['error']['rmse']:.2g}")  # reached near `spp` samples
    runs = side_by_side(lambda seed: stopped(candela, scene, size, goal, seed, truth),
                        range(1, options.stops + 1))
    ratios = sorted(math.sqrt(max(run.true, 0)) / goal for run in runs)
    ratio, reach = ratio_with_range(runs)
    return {"scene": scene.name, "goal": goal, "runs": len(runs),
            "samples": statistics.median(run.samples for run in runs),
            "at_most_1.1": mean(float(r <= 1.1) for r in ratios),
            "at_least_0.8": mean(float(r >= .8) for r in ratios),
            "least": ratios[0], "median": statistics.median(ratios), "most": ratios[-1],
            "stated_over_true": ratio, "plus_minus": reach,
            "interval_holds": mean(float(run.interval_holds) for run in runs)}


def table(rows):
    """For docs/accuracy.md: a line a scene, a column a number of samples."""
    counts = sorted({r["spp"] for r in rows})
    lines = []
    for key, title, form in (("stated_over_true", "stated / true", "{:.2f}"),
                             ("interval_holds", "pictures within their interval", "{:.0%}"),
                             ("pixels_covered", "pixels within theirs", "{:.1%}"),
                             ("masked", "masked", "{:.1%}")):
        lines += [f"| {title}, by spp | " + " | ".join(map(str, counts)) + " |",
                  "|---|" + "---:|" * len(counts)]
        for scene in dict.fromkeys(r["scene"] for r in rows):
            by_spp = {r["spp"]: r for r in rows if r["scene"] == scene}
            cells = ["" if n not in by_spp else "-" if math.isnan(by_spp[n][key])
                     else form.format(by_spp[n][key]) for n in counts]
            lines.append(f"| {scene} | " + " | ".join(cells) + " |")
        lines.append("")
    return "\n".join(lines)


SHOWN = (.25, 4)  # what lies beyond is drawn at the edge


def plot(out, rows):
    import matplotlib.pyplot
    import plots
    figure, axes = matplotlib.pyplot.subplots(figsize=(8, 4), layout="constrained")
    marks = "os^vDP*X"
    for index, scene in enumerate(dict.fromkeys(r["scene"] for r in rows)):
        mine = [r for r in rows if r["scene"] == scene]
        axes.plot([r["spp"] * 1.03 ** (index - 7) for r in mine],
                  [min(max(r["stated_over_true"], SHOWN[0]), SHOWN[1]) for r in mine],
                  marks[index % len(marks)] + "-", lw=.6, ms=5, label=scene)
    counts = sorted({r["spp"] for r in rows})
    axes.axhspan(*goals.RATIO, color="0.9", label="goal from 16 on")
    axes.set_xscale("log", base=2)
    axes.set_xticks(counts, counts)
    axes.set_yscale("log", base=2)
    ticks = [SHOWN[0], .5, *goals.RATIO, 1, 2, SHOWN[1]]
    axes.set_yticks(ticks, [f"{t:g}" for t in ticks])
    axes.set(xlabel="samples a pixel", ylabel="stated / true relMSE", ylim=(.22, 4.5))
    axes.legend(loc="center left", bbox_to_anchor=(1, .5), fontsize=8)
    plots.save(figure, out / "calibration.png")


def run(options):
    options.out, candela, results = begin(options, "Calibration", __doc__)
    counts = options.spp or ((4, 16, 64) if options.quick else (4, 16, 64, 256, 1024))
    if not options.scenes:
        tell_absent(results.note)
    rows, stop_rows = [], []
    if not options.no_cases:
        rows = cases(results, candela, options, counts)
        tell_cases(results, rows)
    if options.stops:
        stop_rows = stops(results, candela, options)
        results.table("stops", "Pictures that end by --error", stop_rows)
    missed = list(goals.misses(goals.sure(rows, results.note), stop_rows))
    for sentence in missed:
        results.note(f"missed: {sentence}")
    results.finish()
    return FAILED if missed or not rows + stop_rows else 0


def tell_cases(results, rows):
    results.table("calibration", "Stated over true", rows)
    if not rows:
        return
    for key, what in (("stated_over_true", "stated / true"),
                      ("interval_holds", "share of the pictures within their interval")):
        of = spread(r[key] for r in rows)
        results.note(f"{what}: median {of.median:.3f}, from {of.low:.3f} to {of.high:.3f}")
    (results.out / "calibration.md").write_text(table(rows))
    plot(results.out, rows)
    results.plot("calibration.png", "Stated over true relMSE, by samples a pixel")
