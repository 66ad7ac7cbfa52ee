"""What benchmarks_inputs_test.cpp asks of tools/benchmarks, printed as JSON.

    benchmarks_inputs.py SOURCE_FOLDER QUESTION [arguments]
"""

import argparse
import contextlib
import dataclasses
import json
import pathlib
import struct
import types

from answers import print_answer  # first: it tells where the modules below are

import ablation
import before
import chosen_scenes
import main
import memory
import numpy
import peers
import processes
import references
import renders
import replicates
import results
import sampler
import stress
import truth


class AsksForRenders(renders.Candela):
    """Stands for candela: keeps the options of what it is asked for, and reads every scene."""

    def __init__(self):
        self.asked = []

    def info(self, scene, **_):
        return {"memory_bytes": {"meshes": 4e6, "textures": 0, "embree": 0}}

    def render(self, name, scene, png, **options):
        self.asked.append(options)
        if png is False and "spp" in options and options["spp"] == 1:
            return types.SimpleNamespace(stats={"peak_memory_bytes": 9e6})
        raise renders.CandelaFailed("nothing is rendered")

    def cached(self, name, scene, **options):
        return self.render(name, scene, False, **options)


def asked_by(measure):
    """The options of each picture, up to the first that is needed."""
    candela = AsksForRenders()
    with contextlib.suppress(processes.ProgramFailed):
        measure(candela)
    return candela.asked


def reference_options():
    return asked_by(lambda candela: truth.reference(candela, "box", "box.yaml", 4, 16))[0]


def rate_options(technique):
    """What both sides have, and the options of the first run that tells the rate."""
    both = next(t for t in ablation.TECHNIQUES if t.name == technique).both
    plan = ablation.Plan(4, 64, 1, 1)
    return both, asked_by(lambda of: ablation.ladder_of(of, "box.yaml", None, plan, both))[0]


def replicates_options():
    return asked_by(lambda of: replicates.relmse(of, "box.yaml", None, 64, 4, 2))[0]


def sampler_options():
    return asked_by(lambda of: sampler.gain(of, "box.yaml", None, [1], spp=64))[0]


def memory_sizes(folder):
    """Of the pictures that a scene's peak is told by."""
    out = types.SimpleNamespace(out=pathlib.Path(folder))

    def measure(candela):
        memory.row(candela, "box", "box.yaml", memory.baseline(out, candela))
    return [options["size"] for options in asked_by(measure)]


def scene_names():
    """Of the defaults, and of all that can be asked for."""
    return chosen_scenes.names(), chosen_scenes.all_names()


def told_of_absent(wanted):
    """Of the defaults where nothing is asked for."""
    notes, wanted = [], json.loads(wanted)
    default = chosen_scenes.names() if not wanted else []
    chosen_scenes.GENERATED = ()  # these take seconds to make
    chosen_scenes.chosen(AsksForRenders(), None, wanted, default, notes.append)
    return notes


def ended_by_cycles(folder):
    """What a measurement goes on with where Blender fails."""
    from blender.cycles_renders import CyclesFailed
    made = results.Results(pathlib.Path(folder), "Some", "", "")
    with made.attempt("box"):
        raise CyclesFailed("Blender ended with 11")
    return made.parts[-1]


def black_pixel():
    """The bytes of an EXR file."""
    def attribute(name, kind, value):
        return b"".join((name, b"\0", kind, b"\0", struct.pack("<i", len(value)), value))

    channels = b"".join(name + b"\0" + struct.pack("<4i", 2, 0, 1, 1)
                        for name in (b"B", b"G", b"R"))
    header = (b"\x76\x2f\x31\x01" + struct.pack("<i", 2)
              + attribute(b"channels", b"chlist", channels + b"\0")
              + attribute(b"compression", b"compression", b"\0")
              + attribute(b"dataWindow", b"box2i", struct.pack("<4i", 0, 0, 0, 0)) + b"\0")
    return header + struct.pack("<Q", len(header) + 8) + struct.pack("<2i3f", 0, 12, 0, 0, 0)


def remade(folder, *damages):
    """Whether a picture that is kept is rendered again: at first, by the same program, and after
    each of the damages to what there is."""
    program, made = pathlib.Path(folder) / "candela", []

    class Renders(renders.Candela):
        def info(self, _):
            return {"scene_hash": "a"}

        def render(self, name, scene, png, **options):
            made.append(name)
            (self.folder / f"{name}.exr").write_bytes(black_pixel())
            (self.folder / f"{name}.json").write_text("{}")

    def ask():
        Renders(program, folder).cached("r", "scene")
        made.append("|")

    program.write_text("one")
    ask()
    ask()
    for file, text in (damage.split("=") for damage in damages):
        (pathlib.Path(folder) / file).write_text(text)
        ask()
    return "".join(made)


def stress_status(folder, report):
    """With a program for the tests that passes and reports this."""
    tests = pathlib.Path(folder) / "tests"
    tests.write_text("#!/bin/sh\nfor word; do case $word in --gtest_output=json:*)\n"
                     f"echo '{report}' > \"${{word#--gtest_output=json:}}\";; esac; done\n")
    tests.chmod(0o755)
    renders.Candela.version = lambda self: "1"
    return stress.run(types.SimpleNamespace(out=pathlib.Path(folder), filter="X.*", light=True,
                                            tests=tests, program="candela"))


def before_allows(spp):
    parser = argparse.ArgumentParser()
    before.add_arguments(parser)
    try:
        return parser.parse_args(["candela", "--spp", spp]).spp
    except SystemExit:
        return None


def rungs(trials):
    """Which of the counts 32 to 64, 64 to 128 tell a rate. `trials`: {count: names of the samples
    that trials took}."""
    trials, asked = json.loads(trials), []

    def runs_of(count):
        asked.append(count)
        return [truth.Run(1, 1, 1, 1, count, stats=dict.fromkeys(trials[str(count)], 7))]

    try:
        truth.ladder(runs_of, (32, 64), (64, 128))
        return asked[-2:]
    except processes.ProgramFailed as reason:
        return str(reason)


def lengths_made(good_from):
    made = []

    def make(length):
        made.append(length)
        return length

    references.long_enough(make, truth.LONGER, lambda length: length >= int(good_from))
    return made


def means_before_and_now(rows):
    """What is noted. `rows`: {scene: [ratio of times, ratio of the pictures' means]}."""
    made = types.SimpleNamespace(notes=[])
    made.note = made.notes.append
    before.tell_all(made, [{"scene": scene, "cpu_ratio": ratio, "wall_ratio": ratio,
                            "means_before_over_now": means, "reference": "good"}
                           for scene, (ratio, means) in json.loads(rows).items()])
    return made.notes


class AskedOfCycles:
    """Stands for Cycles: keeps what it is asked for, and gives grey pictures."""

    def __init__(self, folder):
        self.folder, self.jobs = pathlib.Path(folder), []

    def made_by(self):
        return []

    def render(self, _, jobs):
        from blender.cycles_renders import Picture
        self.jobs += jobs
        return {job: Picture(numpy.ones((2, 2, 3)), job.spp, 2.0, 2.0) for job in jobs}


@dataclasses.dataclass
class KnowsHash:
    """Stands for candela: of every scene's files."""
    scene_hash: str

    def info(self, _):
        return {"scene_hash": self.scene_hash}


def cycles_reference_is_made(folder):
    """Whether it is: at first, again, where a file of the scene has changed, and where the kept one
    was cut short."""
    cycles, found = AskedOfCycles(folder), []

    def is_made(scene_hash):
        cycles.jobs = []
        peers.Bench(KnowsHash(scene_hash), cycles, 2, [4], 1, 1, False).cycles_reference(
            "scene", "file", {}, 64)
        return bool(cycles.jobs)

    for scene_hash in ("a", "a", "b", "b"):
        found.append(is_made(scene_hash))
    for file in cycles.folder.iterdir():
        file.write_bytes(file.read_bytes()[:100])
    return found + [is_made("b"), is_made("b")]


def asked_of_cycles(folder, counts):
    """[samples, first sample] of each picture of a pair, and of each of a reference."""
    counts, cycles = json.loads(counts), AskedOfCycles(folder)
    bench = peers.Bench(KnowsHash("a"), cycles, 2, counts, 1, 1, with_all=True)
    right = bench.cycles_reference("scene", "file", {}, 16 * counts[-1])
    references_asked, cycles.jobs = cycles.jobs, []
    bench.their_ladders("scene", {}, right, 1)
    return [[[job.spp, job.first_sample] for job in jobs]
            for jobs in (cycles.jobs, references_asked)]


def left_by_two_runs(folder):
    """Files of a run that told one table, and of one that was stopped within another; between them
    stands someone's own."""
    out = pathlib.Path(folder)

    def seen():
        return sorted(file.name for file in out.glob("[!.]*"))

    made = results.Results(out, "First", "", "")
    made.table("first", "First", [{"a": 1}])
    made.finish()
    (out / "own.csv").write_text("1\n")
    stopped = results.Results(out, "Second", "", "")
    found = seen()
    stopped.keep("second", [{"b": 2}])
    stopped.finish_stopped()
    return found, seen(), "<td>2</td>" in (out / "index.html").read_text()


def locks(folder):
    """Whether a second run may write into the folder while a first one does, and after it."""
    def is_free():
        try:
            main.locked(pathlib.Path(folder)).close()
            return True
        except SystemExit:
            return False

    with main.locked(pathlib.Path(folder)):
        found = is_free()
    return found, is_free()


def options_between(words):
    """The scenes and the size."""
    options = main.parsed(json.loads(words))
    return options.scenes, options.size


print_answer(globals())
