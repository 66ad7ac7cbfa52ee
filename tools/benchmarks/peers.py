"""The same scenes by candela and by Blender's Cycles, in pairs that take turns: time to an error.

Box filter, no denoising, no clamping, no adaptive sampling, depth without limit against 100;
candela with each pixel's paths its own, shared, or as its trial says, by what does best in the very
pairs that are told, which flatters it by some of their noise. Each renderer is measured
against a long reference of its own, of other seeds, so that no difference between the two counts as
an error of either; how far the references' means are apart is told beside. Neither states an error
(`--replicates 1`). Each pair tells ratios of its own: of them median, range and geometric mean,
with half of the 95 % interval of the mean's logarithm. Time is of rendering alone. Cycles' CPU time
is that of the call that renders, less what a picture of one sample costs (start-up,
synchronization, file), in proportion to the other samples. Beside it Embree's tutorial path tracer,
for speed at equal samples: it draws point lights only, ends paths early and writes 8 bits, so
nothing is said of its error.

With --nearest pbrt's scenes are compared where Blender has only something near to their metals,
coats and shapes: one answer each, two pictures that are alike. What is only near is listed, scene
by scene.

With --all each has the best of its settings: candela, which then adapts, four replicates and two,
by which it states its error, and one; Cycles a fixed number of samples and its noise threshold. Of
Cycles' that is the one to whose last error candela takes the longer, over Cycles' own time; of
candela's the one that does best against that.
"""

import dataclasses
import hashlib
import json
import math
import os
import statistics
import zipfile

import chosen_scenes
import truth
from arguments import at_least
from convergence import counts_to
from cycles import SCALES
from fits import geometric_mean, ratio_columns, ratio_of_errors, x_where
from page_parts import shown
from renders import Candela, CandelaFailed, square
from results import Results, status_of_rows

ABOUT = "the same scenes by Blender's Cycles: time to the same error; Embree's path tracer's speed"
GOALS = (1e-2, 1e-3)
RENDERERS = ("candela", "Cycles")
MEASURES = (("cpu", "relmse", "cpu_seconds"), ("wall", "relmse", "seconds"),
            ("trimmed_cpu", "trimmed", "cpu_seconds"))  # column, error, time
# Name -> candela's options.
OUR_SETTINGS = {f"candela, {words}{shared}": {"replicates": replicates, "reuse": reuse}
                for replicates, words in ((4, "four replicates"), (2, "two"), (1, "one"))
                for reuse, shared in (("off", ""), ("on", ", paths shared"),
                                      ("auto", ", paths shared by a trial"))}
PILOTS = 64  # samples a pixel from which on candela's sampling adapts
THRESHOLD = .4  # of Cycles' noise, over the root of the samples that it should about take
MOST_ADAPTIVE = 4096
# Times the most samples, twice over in both references. Independent ones then have 1/24 of Cycles'
# error; candela's own falls faster, and less of it is left by what adapts.
CYCLES_REFERENCE = 12
REFERENCE = 48


def default_scenes():
    return ("cornell_box_diffuse", *chosen_scenes.ANALYTIC,
            *(f"gen/{name}" for name in chosen_scenes.GENERATED))


def add_arguments(parser):
    parser.add_argument("scenes", nargs="*", metavar="SCENE",
                        help="names (" + ", ".join(default_scenes()) + "); also pbrt/NAME")
    parser.add_argument("--quick", action="store_true", help="48x48, 4 and 16 spp, 2 pairs")
    parser.add_argument("--all", action="store_true",
                        help="all that candela has against the better of Cycles' settings")
    parser.add_argument("--nearest", action="store_true",
                        help="pbrt/NAME: Blender gets the nearest to what it has nothing exact for")
    parser.add_argument("--pairs", type=at_least(1), help="runs of each renderer (5)")
    parser.add_argument("--size", type=at_least(1), metavar="N", help="pixels a side (128)")
    parser.add_argument("--most", type=at_least(4), metavar="SPP",
                        help="samples of the last point (256)")
    parser.add_argument("--threads", type=at_least(1), default=len(os.sched_getaffinity(0)),
                        help="of both (all processors)")
    parser.add_argument("--blender", default="blender", metavar="PROGRAM", help="Blender (blender)")


def run(options):
    from blender.cycles_renders import Cycles
    out = options.out.resolve()
    candela = Candela(options.program, out / "candela")
    # What a later Blender has to offer beside the plain settings counts for it.
    cycles = Cycles(out / "cycles", options.threads, options.blender, {"use_light_tree": True})
    results = Results(out, "candela and its peers", __doc__, f"{candela.version()}; "
                      f"{cycles.version()}; {options.threads} threads")
    bench = Bench(candela, cycles, options.size or (48 if options.quick else 128),
                  counts_to(options.most or (16 if options.quick else 256)),
                  options.pairs or (2 if options.quick else 5), options.threads, options.all)
    points, ratios, means, seen = [], [], [], []
    files = chosen_scenes.chosen(candela, out, options.scenes or default_scenes(), (),
                                 results.note)
    scenes = described(candela, out, files, options.nearest, results.note)
    tell_approximated(results, scenes)
    for name, scene in scenes.items():
        with results.attempt(name):
            own_points, own_ratios, references = bench.measure(name, files[name], scene)
            points += own_points
            ratios += own_ratios
            results.keep("points", points)
            results.keep("ratios", ratios)
            means.append({"scene": name} | means_of(*references) | {
                "approximated": "; ".join(part["what"] for part in scene["approximated"])})
            seen.append((name, *references))
            print(f"{name}: time to Cycles' last error, Cycles / candela: "
                  f"{shown(own_ratios[-1]['cpu_ratio'])}", flush=True)
    results.table("points", f"All points, {square(bench.size)}, {bench.pairs} pairs", points)
    results.table("ratios", "Cycles over candela: times as slow to the same error", ratios,
                  "To the relMSE that Cycles has at so many samples, and to a relMSE where both "
                  "get there; ranges over the pairs; plus_minus is half of the 95 % interval of "
                  "the mean's logarithm. relmse_cpu_s: relMSE times CPU seconds at so many "
                  "samples.")
    results.table("means", "The references' means, candela's over Cycles'", means)
    show_references(results, seen)
    tell_all(results, bench.counts[-1], ratios)
    from blender import embree_path_tracer
    with results.attempt("Embree's tutorial path tracer"):
        embree_path_tracer.compare(results, candela, out / "embree", bench.size, bench.pairs,
                                   options.threads)
    results.finish()
    return status_of_rows(ratios)


def show_references(results, seen):
    from blender import pictures
    if seen:
        pictures.references(results.out / "references.png", seen)
        results.plot("references.png", "The references, and how far candela's is above Cycles' in "
                     "blocks of 4 x 4 pixels")


def tell_all(results, count, ratios):
    last = truth.counted([r for r in ratios if r["by"] == f"{count} spp"],
                         [f"{key}_ratio" for key, *_ in MEASURES], results.note)
    if not last:
        return
    without = geometric_mean(r["trimmed_cpu_ratio"] for r in last)
    results.note(f"geometric mean over {len(last)} scenes at {count} spp: "
                 f"{geometric_mean(r['cpu_ratio'] for r in last):.2f} by CPU time, "
                 f"{geometric_mean(r['wall_ratio'] for r in last):.2f} by wall time; least "
                 f"{min(r['cpu_ratio'] for r in last):.2f}. Without the worst 0.1 % of the pixels, "
                 f"which fireflies otherwise dominate, {without:.2f} by CPU time")


def tell_approximated(results, scenes):
    rows = [{"scene": name, "what": part["what"], "names": ", ".join(part["names"]),
             "in_Cycles": part["in_Cycles"]}
            for name, scene in scenes.items() for part in scene["approximated"]]
    if rows:
        results.table("approximated", "What Cycles has only something near to", rows)


def means_of(ours, theirs):
    by_channel = ours.mean(axis=(0, 1)) / theirs.mean(axis=(0, 1))
    return {"all": float(ours.mean() / theirs.mean())} | dict(zip("RGB", map(float, by_channel)))


def described(candela, out, files, nearest=False, tell=print):
    """Name -> what Blender is told. What cannot be compared is left out with a sentence."""
    from blender import blender_scene, pbrt_scene
    scenes = {}
    for name, file in files.items():
        try:
            if file.suffix == ".pbrt":
                plain = out / "converted" / f"{chosen_scenes.safe(name)}.pbrt"
                candela.convert(file, plain)
                scenes[name] = pbrt_scene.read(plain, SCALES.get(name, 1), nearest)
            else:
                scenes[name] = blender_scene.read(file, SCALES.get(name, 1))
        except blender_scene.Unsupported as reason:
            tell(f"{name} is left out: {reason}")
    if not scenes:
        raise CandelaFailed("none of these scenes can be compared with Cycles")
    return scenes


@dataclasses.dataclass
class Bench:
    candela: object
    cycles: object
    size: int
    counts: list  # of samples a pixel
    pairs: int
    threads: int
    with_all: bool

    def measure(self, name, file, scene):
        """(points, ratios, references): rows of two tables, and the two long pictures."""
        most = self.counts[-1]
        ours = truth.reference(self.candela, name, file, self.size, REFERENCE * most,
                               max_depth="none")
        theirs = self.cycles_reference(name, file, scene, CYCLES_REFERENCE * most)
        apart = float(ours.image.mean() / theirs.image.mean())
        pairs = [(self.our_ladders(file, ours, seed), self.their_ladders(name, scene, theirs, seed))
                 for seed in range(1, self.pairs + 1)]
        own_setting, setting = better_settings(pairs)
        pairs = [(own[own_setting], ladders[setting]) for own, ladders in pairs]
        points = []
        for i in range(len(self.counts)):
            for who, part, right in ((own_setting, 0, ours), (setting, 1, theirs)):
                runs = [pair[part][i] for pair in pairs]
                points.append({"scene": name, "renderer": who,
                               "spp": statistics.median(run.spp for run in runs)}
                              | truth.summary(runs, right) | {"means_candela_over_Cycles": apart})
        return (points, [{"scene": name} | row | {"reference": judged(row, ours, theirs)}
                         for row in ratios_of(pairs, self.counts)], (ours.image, theirs.image))

    def our_ladders(self, file, right, seed):
        """By setting. Cycles tells no error of a picture: without --all candela does not either."""
        return {setting: [self.our_run(file, right, seed, spp, own) for spp in self.counts]
                for setting, own in OUR_SETTINGS.items()
                if self.with_all or own["replicates"] == 1}

    def our_run(self, file, right, seed, spp, own):
        adapts = self.with_all and spp >= PILOTS
        return truth.measured(self.candela, file, right, size=square(self.size), spp=spp,
                              seed=seed, threads=self.threads, max_depth="none",
                              adaptive="on" if adapts else "off", **own)

    def their_ladders(self, name, scene, right, seed):
        """One process: a picture to warm up, one of one sample to take off, and those that count.
        By setting. Every picture begins at a multiple of its samples: if it straddled two of the
        blocks over which Cycles spreads samples evenly, it would have more noise than a user's.
        The adaptive ones begin at 0."""
        first = 16 * self.counts[-1]
        start = [self.job(name, 1, seed + 1000, first), self.job(name, 1, seed, first)]
        ladders = {"Cycles": [self.job(name, spp, seed, 2 * first) for spp in self.counts]}
        if self.with_all:
            ladders["Cycles, adaptive"] = [
                dataclasses.replace(self.job(name, MOST_ADAPTIVE, seed, 0),
                                    noise_threshold=round(THRESHOLD / math.sqrt(spp), 4))
                for spp in self.counts]
        pictures = self.cycles.render({chosen_scenes.safe(name): scene},
                                      start + sum(ladders.values(), []))
        taken_off = pictures[start[1]].cpu_seconds
        return {setting: [their_run(pictures[job], right, taken_off) for job in jobs]
                for setting, jobs in ladders.items()}

    def job(self, name, spp, seed, first_sample):
        from blender.cycles_renders import Job
        return Job(chosen_scenes.safe(name), self.size, self.size, spp, seed,
                   first_sample=first_sample)

    def cycles_reference(self, name, file, scene, spp):
        """From eight seeds, whose spread tells its noise; kept as long as Blender's version, its
        scripts and the scene, with the content of its files, are the same. Sample 0, which goes
        through the pixel's centre, is not among them."""
        import numpy
        key = hashlib.sha256(json.dumps([self.cycles.made_by(), scene, self.size, spp,
                                         self.candela.info(file)["scene_hash"]]
                                        ).encode()).hexdigest()[:16]
        kept = self.cycles.folder / f"reference_{chosen_scenes.safe(name)}_{key}.npz"
        if (found := kept_reference(kept)) is not None:
            return found
        seeds, each = 8, spp // 4
        jobs = [self.job(name, each, 900001 + i, each) for i in range(seeds)]
        made = self.cycles.render({chosen_scenes.safe(name): scene}, jobs)
        images = numpy.array([made[job].colour for job in jobs])
        whole = kept.with_suffix(".part.npz")  # so that none is kept that was stopped half-way
        numpy.savez(whole, image=images.mean(axis=0), variance=images.var(axis=0, ddof=1) / seeds)
        whole.replace(kept)
        return kept_reference(kept)


def kept_reference(file):
    """None where there is none, or none that can be read."""
    import numpy
    from references import with_weight
    try:
        with numpy.load(file) as kept:
            return with_weight(kept["image"], kept["variance"])
    except (OSError, EOFError, ValueError, KeyError, zipfile.BadZipFile):
        return None


def their_run(picture, right, taken_off):
    """CPU seconds are nan where they are lost in what a picture costs once."""
    cpu = (picture.cpu_seconds - taken_off) * picture.spp / (picture.spp - 1)
    cpu = cpu if cpu > 0 else math.nan
    return truth.run_of(picture.colour, right, cpu, picture.seconds, picture.spp)


def better_settings(pairs):
    """candela's and Cycles'. Of Cycles' the one that is worse for candela, and of candela's the one
    that does better against that. `pairs`: ({setting: candela's runs}, {setting: Cycles' runs}), by
    point. One of Cycles' of which nothing can be told counts as the worst: better no figure than
    too good a one."""
    def ratio(own, other):
        ratios = [time_to_their_error(ours[own], theirs[other], -1, "relmse", "cpu_seconds")
                  for ours, theirs in pairs]
        return 0 if any(map(math.isnan, ratios)) else statistics.median(ratios)

    def against(own):
        return min(pairs[0][1], key=lambda other: ratio(own, other))
    best = max(pairs[0][0], key=lambda own: ratio(own, against(own)))
    return best, against(best)


def ratios_of(pairs, counts):
    """Rows: by the time to each goal, and to Cycles' error at each count. The last count's stands
    last: it is the one that is told."""
    goals = [goal_row(goal, pairs) for goal in GOALS]
    return [row for row in goals if row] + [count_row(pairs, i, count)
                                            for i, count in enumerate(counts)]


def count_row(pairs, i, count):
    runs = [(ours[i], theirs[i]) for ours, theirs in pairs]
    errors = [ratio_of_errors(theirs.relmse, ours.relmse) for ours, theirs in runs]
    row = {"by": f"{count} spp", "relmse_ratio": ratio_columns("relmse", errors)["relmse_ratio"]}
    for who, own in zip(RENDERERS, zip(*runs)):
        row[f"relmse_{who}"] = statistics.median(run.relmse for run in own)
        row[f"relmse_cpu_s_{who}"] = statistics.median(run.relmse * run.cpu_seconds for run in own)
    for key, error, seconds in MEASURES:
        row |= ratio_columns(key, [time_to_their_error(*pair, i, error, seconds)
                                   for pair in pairs])
    return row


def goal_row(goal, pairs):
    """None where the two do not get there."""
    found = {key: times_to(goal, pairs, error, seconds) for key, error, seconds in MEASURES}
    if not found["cpu"] or not found["wall"]:
        return None
    row = {"by": f"time to {goal:g}", "relmse_ratio": None}
    for who in RENDERERS:
        row |= {f"relmse_{who}": goal, f"relmse_cpu_s_{who}": None}
    for key, ratios in found.items():
        row |= ratio_columns(key, ratios)
    return row


def judged(row, *references):
    """Whether each renderer's reference is good enough for the error that the row tells of it."""
    words = {truth.judged(reference, [row[f"relmse_{who}"]])
             for who, reference in zip(RENDERERS, references)}
    return "good" if words == {"good"} else "too noisy"


def times_to(goal, pairs, error, seconds):
    """How many times as long Cycles takes to an error, by pairs; none unless both get there in
    all: the other pairs' alone would be those with the smaller errors."""
    times = [[x_where(goal, [getattr(run, seconds) for run in runs],
                      [getattr(run, error) for run in runs]) for runs in pair] for pair in pairs]
    return [theirs / ours for ours, theirs in times] if all(map(all, times)) else []


def time_to_their_error(ours, theirs, i, error, seconds):
    """How many times as long Cycles' picture i takes as candela does to that picture's error: by
    the line through candela's pictures of the pair. Where they begin below that error the first
    one's time counts; where they end above it the last one's, lengthened as plain random numbers
    would be. nan where an error is lost in the reference's noise."""
    goal = getattr(theirs[i], error)
    times, errors = ([getattr(run, key) for run in ours] for key in (seconds, error))
    if min(goal, *errors) <= 0:
        return math.nan
    own = x_where(goal, times, errors)
    if own is None:
        own = times[0] if errors[0] < goal else times[-1] * errors[-1] / goal
    return getattr(theirs[i], seconds) / own
