# SPDX-License-Identifier: Apache-2.0
"""Error against CPU time: renders with polariscope, references, and curves through measured points. For peers.py and against.py."""

import hashlib
import json
import math
import os
import statistics
import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
# References are cut by budget: one random path stands for what is left, so that many samples have no bias. Mode point has but one.
MANY = ["--residual", 1e-6, "--node-budget", 20]
DEEP = ["--residual", 1e-6, "--node-budget", 10_000]
FARTHEST_SEED = 900_001  # of references; runs that are measured have small seeds


def square_of(stokes):
    """|C|_F^2 of every pixel, the light's coherence matrix C: (S0^2 + S1^2 + S2^2 + S3^2) / 2 (CUTTING.md 3)."""
    return 0.5 * np.square(stokes).sum(axis=-1)


class Frobenius:
    """fro_c: root mean square of |dC|_F over pixels and wavelengths, over that of |C|_F."""

    name = "fro_c"

    def values(self, picture):
        return picture

    def square(self, values):
        return square_of(values)


class Color:
    """The error of X, Y, Z together, over their own root mean square, in light of equal energy."""

    name = "XYZ"

    def __init__(self, observer, wavelengths):
        rows = np.loadtxt(observer, delimiter=",", skiprows=1)
        self.weights = np.array([rows[rows[:, 0] == wavelength][0, 1:4] for wavelength in wavelengths])

    def values(self, picture):
        return np.einsum("byx,bc->yxc", picture[..., 0], self.weights)

    def square(self, values):
        return np.square(values).sum(axis=-1)


@dataclass
class Reference:
    """Two independent pictures of many samples. Their mean is the truth; how far they are apart, the mean's own error."""

    measure: object
    halves: list

    def __post_init__(self):
        first, second = (self.measure.values(half) for half in self.halves)
        self.mean = 0.5 * (first + second)
        self.unit = self.measure.square(self.mean).mean()
        self.noise = 0.25 * self.measure.square(first - second).mean()

    def error_of(self, picture):
        """Relative error of a picture with the reference's own taken out; None where that is most of it."""
        square = self.measure.square(self.measure.values(picture) - self.mean).mean()
        return math.sqrt((square - self.noise) / self.unit) if square > 2 * self.noise else None

    def own_error(self):
        return math.sqrt(self.noise / self.unit)


class Polariscope:
    """A polariscope executable."""

    def __init__(self, program, folder, environment=()):
        self.program = Path(program).resolve()
        self.folder = Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)
        # One set of indices and textures for all programs, wherever they came from.
        self.environment = os.environ | {"POLARISCOPE_ASSETS": str(ROOT / "assets")} | dict(w.split("=", 1) for w in environment)

    def run(self, *words, allowed=(0,)):
        done = subprocess.run([str(self.program), *map(str, words)], stdin=subprocess.DEVNULL, capture_output=True, text=True,
                              env=self.environment, check=False)
        if done.returncode not in allowed:
            raise RuntimeError(f"{self.program} {' '.join(map(str, words))}: exit code {done.returncode}\n{done.stderr}")

    def render(self, scene, options, seed, threads=1):
        """What one rendering says about itself, as a dictionary; its EXR file is named by picture()."""
        stats = self.folder / "stats.json"
        # 10: --error or --time was not met, which the measured error shows
        self.run("render", scene, "-o", self.folder / "picture.exr", "--quiet", "--seed", seed, "--threads", threads,
                 "--stats", stats, *options, allowed=(0, 10))
        return json.loads(stats.read_text(encoding="utf-8"))

    def picture(self):
        """Stokes components of the last rendering: wavelengths, rows, columns, component."""
        array = self.folder / "picture.npy"
        self.run("convert", self.folder / "picture.exr", "-o", array, "--as", "npy")
        return np.load(array)

    def reference(self, cache, measure, scene, size, samples, mode="area", more=()):
        """Rendered once by all cores, then kept in the folder `cache` until that is deleted; samples: in mode area."""
        options = ["--size", f"{size}x{size}", "--mode", mode, *more, *(DEEP if mode == "point" else [*MANY, "--spp", samples])]
        name = f"{scene.stem}-{hashlib.sha256(scene.read_bytes() + ' '.join(map(str, options)).encode()).hexdigest()[:12]}"
        cache.mkdir(parents=True, exist_ok=True)
        halves = []
        for half in range(2):
            file = cache / f"{name}-{half}.npy"
            if not file.exists():
                self.render(scene, options, FARTHEST_SEED + half, os.cpu_count())
                unfinished = file.with_suffix(".part")
                with unfinished.open("wb") as output:
                    np.save(output, self.picture())
                unfinished.rename(file)
            halves.append(np.load(file))
        return Reference(measure, halves)


@dataclass
class Point:
    setting: object
    error: float
    seconds: float


class Curve:
    """Error against seconds, a point for each setting."""

    def __init__(self, points):
        self.points = sorted((point for point in points if point.error and point.seconds > 0), key=lambda point: point.seconds)

    def seconds_at(self, error):
        """Seconds to an error, and whether they are extrapolated. Straight in logarithms between the points on its two sides; beyond
        the last, along the last two, no flatter than random points (N^-1/2) and no steeper than good ones where edges are (N^-3/4)."""
        logs = [(math.log(point.error), math.log(point.seconds)) for point in self.points]
        wanted = math.log(error)
        if not logs:
            return math.nan, True
        for (above, early), (below, late) in zip(logs, logs[1:]):
            if above >= wanted >= below and above > below:
                return math.exp(early + (late - early) * (above - wanted) / (above - below)), False
        first = wanted > logs[0][0]
        near, far = (logs[0], logs[1 % len(logs)]) if first else (logs[-1], logs[-2 % len(logs)])
        power = (near[0] - far[0]) / (far[1] - near[1]) if near[1] != far[1] else 0.5
        power = min(0.75, max(0.5, power))
        return math.exp(near[1] + (near[0] - wanted) / power), True

    def variance_seconds(self):
        """Squared error x seconds of the longest rendering: lower is better."""
        return self.points[-1].error ** 2 * self.points[-1].seconds if self.points else math.nan


@dataclass
class Runner:
    """A program that climbs a ladder of settings, the cheapest first."""

    ladder: list
    growth: float  # how much longer a step takes than the one before
    run: object  # (setting, seed) -> error or None, seconds
    points: dict = None
    done: bool = False


def climb(runners, seeds, target, longest):
    """Lets runners, by name, take turns on their ladders, until the error is met and passed by, or a rendering would take longer
    than `longest` seconds. Gives a list of curves, one a seed, for each name."""
    for runner in runners.values():
        runner.points = {seed: [] for seed in seeds}
    for step in range(max(len(runner.ladder) for runner in runners.values())):
        names = [name for name, runner in runners.items() if not runner.done and step < len(runner.ladder)]
        for turn, seed in enumerate(seeds):
            for name in names if turn % 2 == 0 else reversed(names):
                runner = runners[name]
                error, seconds = runner.run(runner.ladder[step], seed)
                runner.points[seed].append(Point(runner.ladder[step], error, seconds))
        for name in names:
            runner = runners[name]
            last = [runner.points[seed][-1] for seed in seeds]
            worst = max(point.error or 0.0 for point in last)
            seconds = statistics.median(point.seconds for point in last)
            runner.done = worst < 0.8 * target or seconds * runner.growth > longest
    return {name: [Curve(points) for points in runner.points.values()] for name, runner in runners.items()}


def median_curve(curves):
    """Medians over seeds of the settings that all of them have."""
    points = []
    for setting in [point.setting for point in curves[0].points]:
        same = [point for curve in curves for point in curve.points if point.setting == setting]
        if len(same) == len(curves):
            points.append(Point(setting, statistics.median(p.error for p in same), statistics.median(p.seconds for p in same)))
    return Curve(points)


def ratio_at(error, slow, fast):
    """Median, least and largest ratio of seconds over seeds, and whether an extrapolation is in it."""
    pairs = [(a.seconds_at(error), b.seconds_at(error)) for a, b in zip(slow, fast)]
    ratios = sorted(a[0] / b[0] for a, b in pairs)
    return statistics.median(ratios), ratios[0], ratios[-1], any(a[1] or b[1] for a, b in pairs)
