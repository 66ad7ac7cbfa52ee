"""Runs Blender's Cycles on scene descriptions; one Blender process renders a whole list."""

import collections
import dataclasses
import json
import pathlib
import re
import shutil

from exr import read_channels, stacked
from processes import ProgramFailed, run_checked

SCRIPT = pathlib.Path(__file__).with_name("render_in_cycles.py")
BESIDE = ("cycles_materials.py", "equal_area.py")  # what it imports


class CyclesFailed(ProgramFailed):
    """Blender is not there or gave up; the text says which."""


@dataclasses.dataclass(frozen=True)
class Job:
    scene: str
    width: int
    height: int
    spp: int  # at most, where there is a noise threshold
    seed: int
    noise_threshold: float | None = None
    bounces: int = 100  # after the first surface; 0: direct light
    # Cycles sends sample 0 of every pixel through the pixel's centre, whatever the filter.
    first_sample: int = 0

    @property
    def name(self):
        return "_".join(str(part) for part in dataclasses.astuple(self))


@dataclasses.dataclass
class Picture:
    colour: object  # array [row from the top, column, channel]
    spp: float  # samples a pixel, the mean
    seconds: float | None = None  # of rendering alone
    cpu_seconds: float | None = None  # of all threads, with synchronization and writing


class Cycles:
    def __init__(self, folder, threads, program="blender", settings=None):
        """`settings`: of Blender's scene.cycles, where they are to differ from the plain ones."""
        self.program, self.folder, self.threads = program, folder, threads
        self.settings = settings or {}
        self.folder.mkdir(parents=True, exist_ok=True)

    def version(self):
        if not shutil.which(self.program):
            raise CyclesFailed(f"'{self.program}' is not installed; expected Debian's package "
                               "blender, which `tools/setup --dev` installs.")
        told = run_checked([self.program, "--version"], "Blender", CyclesFailed).stdout
        return told.splitlines()[0]

    def made_by(self):
        """What pictures depend on beside scene and job."""
        scripts = [SCRIPT, *(SCRIPT.with_name(name) for name in BESIDE)]
        return [self.version(), self.settings, *(script.read_text() for script in scripts)]

    def render(self, scenes, jobs):
        """`scenes`: what blender_scene.read() gives, by name. -> Picture by Job."""
        file = self.folder / "jobs.json"
        file.write_text(json.dumps({
            "threads": self.threads, "scenes": scenes, "settings": self.settings,
            "renders": [dataclasses.asdict(job) | {"exr": str(self._exr(job))} for job in jobs]}))
        for job in jobs:
            self._exr(job).unlink(missing_ok=True)
        log = self.folder / "blender.log"
        done = run_checked([self.program, "-b", "--factory-startup", "--python-exit-code", 1,
                            "-P", SCRIPT, "--debug-cycles", "--", file],
                           "Blender", CyclesFailed, map(self._exr, jobs), log)
        rounds = samples_taken(done.stdout)
        seconds, cpu_seconds = times(done.stdout + done.stderr)
        in_order = sorted(jobs, key=lambda job: job.scene)  # as the script takes them
        if not len(jobs) == len(seconds) == len(cpu_seconds):
            raise CyclesFailed(f"{len(jobs)} pictures but {len(seconds)} times in {log}")
        return {job: dataclasses.replace(self._picture(job, rounds[str(self._exr(job))]),
                                         seconds=wall, cpu_seconds=cpu)
                for job, wall, cpu in zip(in_order, seconds, cpu_seconds)}

    def _exr(self, job):
        return self.folder / f"{job.name}.exr"

    def _picture(self, job, rounds):
        channels = read_channels(self._exr(job))
        spp = job.spp
        if job.noise_threshold is not None:
            share = channels["ViewLayer.Debug Sample Count.X"]
            counts = share * rounds
            if abs(counts - counts.round()).max() > .01:
                raise CyclesFailed(f"{self._exr(job)}: sample counts that are no whole numbers")
            spp = float(counts.mean())
        return Picture(stacked(channels, [f"ViewLayer.Combined.{c}" for c in "RGB"]), spp)


def samples_taken(log):
    """How many samples the pixels that took most took, by the file that was written then: the
    sample counts in the files are shares of it, and it is told in the log alone."""
    taken, latest = collections.defaultdict(int), 0
    for line in log.splitlines():
        sample = re.search(r"\| Sample (\d+)/\d+", line)
        if sample:
            latest = max(latest, int(sample[1]))
        saved = re.match(r"Saved: '(.+)'", line)
        if saved:
            taken[saved[1]], latest = latest, 0
    return taken


def times(log):
    """Of each picture in order: seconds of rendering alone, and CPU seconds of the whole call."""
    return [[float(value) for value in re.findall(pattern, log)] for pattern in
            (r"Render time \(without synchronization\): ([\d.e+-]+)", r"CPU seconds: ([\d.]+)")]
