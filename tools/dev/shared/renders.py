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

    def render(self, name, scene, **options):
        """`options` are candela's own: spp=16 is --spp 16, lab_normals=True is --lab-normals."""
        base = self.folder / name
        exr, png, stats = (base.with_suffix(end) for end in (".exr", ".png", ".json"))
        words = ["render", scene, "-o", exr, "-o", png, "--stats", stats, "--quiet"]
        for option, value in options.items():
            words += ["--" + option.replace("_", "-")] + ([] if value is True else [value])
        self._output_of(*words)
        return Render(name, exr, png, json.loads(stats.read_text()))

    def compare(self, render, reference):
        """relmse, mean_ratio and more of `candela compare --json`."""
        return json.loads(self._output_of("compare", render.exr, reference.exr, "--json"))
