"""Runs candela: pictures with their statistics, and comparisons."""

import dataclasses
import functools
import hashlib
import json
import pathlib

from processes import ProgramFailed, run_checked


class CandelaFailed(ProgramFailed):
    """candela ended with an error; the text is its own."""


def rendering_cpu_seconds(told):
    """Of all threads, without reading, building and writing. Decoding images is none of it: the
    path that first meets one does that. `told`: `cpu_seconds` of the statistics; what earlier
    builds do not tell of decoding is not taken off."""
    return told["render"] - told.get("decoding", 0)


@dataclasses.dataclass
class Render:
    name: str
    exr: pathlib.Path
    png: pathlib.Path
    stats: dict

    @property
    def seconds(self):
        """By the clock on the wall, without reading, building and writing; images that paths meet
        are decoded within."""
        return self.stats["seconds"]["render"]

    @property
    def cpu_seconds(self):
        return rendering_cpu_seconds(self.stats["cpu_seconds"])

    @property
    def built_cpu_seconds(self):
        """The same with what making the scene and its trees took."""
        told = self.stats["cpu_seconds"]
        return self.cpu_seconds + told["compile"] + told["build"]

    @property
    def spp(self):
        return self.stats["spp"]


def square(side):
    """candela's --size of a square picture."""
    return f"{side}x{side}"


def _words_of(options):
    words = []
    for name, value in options.items():
        words += ["--" + name.replace("_", "-")] + ([] if value is True else [value])
    return words


def is_sound(exr, stats):
    """Whether a kept picture can be read."""
    from exr import read_exr
    try:
        json.loads(stats.read_text())
        read_exr(exr)
        return True
    except Exception:  # whatever damaged bytes lead to
        return False


class Candela:
    """The program, and the folder that its pictures go to as NAME.exr, .png and .json."""

    def __init__(self, program, folder):
        self.program = pathlib.Path(program)
        self.folder = pathlib.Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)

    def _output_of(self, *words, writes=()):
        return run_checked([self.program, *words], "candela", CandelaFailed, writes).stdout

    def version(self):
        return self._output_of("--version").strip()

    def render(self, name, scene, png=True, **options):
        """`options` are candela's own: spp=16 is --spp 16, lab_normals=True is --lab-normals."""
        base = self.folder / name
        files = Render(name, *(base.parent / (base.name + end) for end in (".exr", ".png")), {})
        stats = base.parent / (base.name + ".json")
        words = ["render", scene, "-o", files.exr, "--stats", stats, "--quiet"]
        words += ["-o", files.png] if png else []
        self._output_of(*words, *_words_of(options), writes=[files.exr, stats])
        return dataclasses.replace(files, stats=json.loads(stats.read_text()))

    def cached(self, name, scene, **options):
        """The same without PNG, once: what stays the same over many runs, such as references.
        Another program, content of the scene's files or option makes it anew."""
        asked = self.folder / f"{name}.asked.json"
        key = json.dumps([self.made_by, self.info(scene)["scene_hash"],
                          {k: str(v) for k, v in options.items()}])
        exr, stats = self.folder / f"{name}.exr", self.folder / f"{name}.json"
        if asked.exists() and asked.read_text() == key and is_sound(exr, stats):
            return Render(name, exr, None, json.loads(stats.read_text()))
        asked.unlink(missing_ok=True)  # it would vouch for the picture of a render that is stopped
        render = self.render(name, scene, png=False, **options)
        asked.write_text(key)
        return render

    @functools.cached_property
    def made_by(self):
        """Of the program's file, and of the codecs beside it: commits share a version."""
        codecs = self.program.resolve().parent / "candela_codecs.so"
        return hashlib.sha256(self.program.read_bytes() + (
            codecs.read_bytes() if codecs.exists() else b"")).hexdigest()

    def info(self, scene, **options):
        """What `candela info --json` says; `options` as for render()."""
        return json.loads(self._output_of("info", scene, "--json", *_words_of(options)))

    def convert(self, scene, file):
        """Writes the scene as a pbrt file, with its meshes in a folder beside it."""
        file.parent.mkdir(parents=True, exist_ok=True)
        self._output_of("convert", scene, file)

    def bench(self, scene, **options):
        """What `candela bench --json` says; `options` as for render()."""
        return json.loads(self._output_of("bench", scene, "--json", *_words_of(options)))

    def compare(self, render, reference):
        """relmse, mean_ratio and more of `candela compare --json`."""
        return json.loads(self._output_of("compare", render.exr, reference.exr, "--json"))
