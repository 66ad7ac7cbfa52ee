"""Runs candela: pictures with their statistics, and comparisons."""

import dataclasses
import json
import pathlib
import subprocess


class CandelaFailed(Exception):
    """candela ended with an error; the text is its own."""


@dataclasses.dataclass
class Render:
    name: str
    exr: pathlib.Path
    png: pathlib.Path
    stats: dict

    @property
    def seconds(self):
        """Of rendering alone: without reading, building and writing."""
        return self.stats["seconds"]["render"]

    @property
    def cpu_seconds(self):
        """The same, of all threads together."""
        return self.stats["cpu_seconds"]["render"]

    @property
    def spp(self):
        return self.stats["spp"]


class Candela:
    """The program, and the folder that its pictures go to as NAME.exr, .png and .json."""

    def __init__(self, program, folder):
        self.program = pathlib.Path(program)
        self.folder = pathlib.Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)

    def _output_of(self, *words):
        done = subprocess.run([str(self.program), *map(str, words)], capture_output=True, text=True)
        if done.returncode != 0:
            raise CandelaFailed(done.stderr.strip() or f"candela ended with {done.returncode}")
        return done.stdout

    def version(self):
        return self._output_of("--version").strip()

    def render(self, name, scene, png=True, **options):
        """`options` are candela's own: spp=16 is --spp 16, lab_normals=True is --lab-normals."""
        base = self.folder / name
        files = Render(name, *(base.parent / (base.name + end) for end in (".exr", ".png")), {})
        stats = base.parent / (base.name + ".json")
        words = ["render", scene, "-o", files.exr, "--stats", stats, "--quiet"]
        words += ["-o", files.png] if png else []
        for option, value in options.items():
            words += ["--" + option.replace("_", "-")] + ([] if value is True else [value])
        self._output_of(*words)
        return dataclasses.replace(files, stats=json.loads(stats.read_text()))

    def cached(self, name, scene, **options):
        """The same without PNG, once: what stays the same over many runs, such as references.
        Another version, content of the scene's files or option makes it anew; after a change of the
        program itself the folder is to be deleted."""
        asked = self.folder / f"{name}.asked.json"
        key = json.dumps([self.version(), self.info(scene)["scene_hash"],
                          {k: str(v) for k, v in options.items()}])
        exr, stats = self.folder / f"{name}.exr", self.folder / f"{name}.json"
        if asked.exists() and asked.read_text() == key and exr.exists():
            return Render(name, exr, None, json.loads(stats.read_text()))
        render = self.render(name, scene, png=False, **options)
        asked.write_text(key)
        return render

    def info(self, scene, **options):
        """What `candela info --json` says; `options` as for render()."""
        words = [word for name, value in options.items() for word in ("--" + name, value)]
        return json.loads(self._output_of("info", scene, "--json", *words))

    def convert(self, scene, file):
        """Writes the scene as a pbrt file, with its meshes in a folder beside it."""
        file.parent.mkdir(parents=True, exist_ok=True)
        self._output_of("convert", scene, file)

    def bench(self, scene, **options):
        """What `candela bench --json` says."""
        words = [word for name, value in options.items() for word in ("--" + name, value)]
        return json.loads(self._output_of("bench", scene, "--json", *words))

    def compare(self, render, reference):
        """relmse, mean_ratio and more of `candela compare --json`."""
        return json.loads(self._output_of("compare", render.exr, reference.exr, "--json"))
