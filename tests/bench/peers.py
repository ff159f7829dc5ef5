# SPDX-License-Identifier: Apache-2.0
"""Error against CPU time of polariscope and Mitsuba 3 on scenes that both can render. peers.sh runs it.

Both programs use one thread and take turns. Of both, time is the CPU time of tracing: scene, compilation and output lie outside. The
truth is ours, two independent pictures of many samples; whether Mitsuba's pictures agree with it within their noise is measured and
said for each scene. Mitsuba renders with its default sampler, and with the one that is best for these scenes.
"""

import argparse
import csv
import json
import math
import subprocess
import sys
from itertools import combinations
from pathlib import Path

import numpy as np

from error_curves import Frobenius, Polariscope, Runner, climb, median_curve, ratio_at, square_of

SCENES = ["g1", "g2", "four-stones", "glass-ball", "nested-balls", "stone-in-water"]
# samples per pixel, residual: light is cut off well below the noise of so many samples
OURS = [(4, 3e-3), (8, 3e-3), (16, 3e-3), (32, 3e-3), (64, 1e-3), (128, 1e-3), (256, 3e-4), (512, 3e-4), (1024, 1e-4)]
ERRORS = [0.16, 0.08, 0.04, 0.02, 0.01, 0.005]  # for --error, which chooses both
SAMPLERS = {"independent": "Mitsuba, default sampler", "multijitter": "Mitsuba, multijitter"}
THEIRS = [16, 64, 256, 1024, 4096]
REFERENCE = 512  # samples per pixel
TILE = 16  # pixels along the sides of the tiles whose noise is independent


class Mitsuba:
    """A process that renders with Mitsuba and one of its samplers, one scene after another."""

    def __init__(self, folder, sampler):
        self.sampler = sampler
        self.output = folder / f"mitsuba-{sampler}.npy"
        worker = Path(__file__).with_name("mitsuba_worker.py")
        self.process = subprocess.Popen([sys.executable, str(worker)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.about = self.answer()

    def answer(self):
        line = self.process.stdout.readline()
        if not line:
            raise RuntimeError("Mitsuba ended without an answer")
        return json.loads(line)

    def render(self, scene, size, samples, seed):
        task = {"scene": str(scene), "size": size, "sampler": self.sampler, "samples": samples, "seed": seed,
                "output": str(self.output)}
        self.process.stdin.write(json.dumps(task) + "\n")
        self.process.stdin.flush()
        seconds = self.answer()["seconds"]
        return np.load(self.output)[np.newaxis], seconds

    def close(self):
        self.process.stdin.close()
        self.process.wait()


def tiles(values):
    """Sums over tiles of a picture's pixels, as one row."""
    height, width = (side // TILE * TILE for side in values.shape)
    return values[:height, :width].reshape(height // TILE, TILE, width // TILE, TILE).sum(axis=(1, 3)).ravel()


def agreement(pictures, reference):
    """What Mitsuba's pictures and ours differ by once noise is taken out.

    With M_i its pictures and A, B the halves of the reference, all independent, the mean over i < j of <M_i - A, M_j - B> has no
    noise in it: its expectation is the squared difference of what the two programs converge to. Tiles give its standard error.
    """
    pairs = []
    for first, second in combinations(pictures, 2):
        for a, b in (reference.halves, reversed(reference.halves)):
            pairs.append(0.5 * ((first - a) * (second - b)).sum(axis=-1)[0])
    parts = tiles(np.mean(pairs, axis=0)) / reference.unit
    pixels = parts.size * TILE**2
    square = parts.sum() / pixels
    deviation = parts.std(ddof=1) * math.sqrt(parts.size) / pixels
    seen = math.sqrt(square_of(np.mean(pictures, axis=0) - reference.mean).mean() / reference.unit)
    noise = math.sqrt(max(seen**2 - square, 0.0))
    return {"seen": seen, "noise": noise, "square": square, "deviation": deviation, "z": square / deviation,
            "at most": math.sqrt(max(square, 0.0) + 2 * deviation)}


def measure(name, arguments, ours, mitsuba, folder):
    """Curves of all programs on one scene, and whether the pictures agree."""
    scene = arguments.scenes / f"{name}.yaml"
    common = ["--size", f"{arguments.size}x{arguments.size}", "--mode", "area"]
    samples = REFERENCE // (4 if arguments.quick else 1)
    reference = ours.reference(arguments.folder / "references", Frobenius(), scene, arguments.size, samples)
    latest = {}

    def by_samples(setting, seed):
        stats = ours.render(scene, [*common, "--spp", setting[0], "--residual", setting[1]], seed)
        return reference.error_of(ours.picture()), stats["t_render_cpu_s"]

    def by_error(setting, seed):
        stats = ours.render(scene, [*common, "--error", setting], seed)
        return reference.error_of(ours.picture()), stats["t_render_cpu_s"]

    def by_mitsuba(sampler):
        def run(samples, seed):
            picture, seconds = mitsuba[sampler].render(scene, arguments.size, samples, seed)
            if sampler == "multijitter":
                latest[seed] = picture  # of the most samples
            return reference.error_of(picture), seconds

        return run

    runners = {"polariscope": Runner(OURS, 2, by_samples), "polariscope --error": Runner(ERRORS, 3, by_error)}
    for sampler, label in SAMPLERS.items():
        runners[label] = Runner(THEIRS, 4, by_mitsuba(sampler))
    curves = climb(runners, range(1, arguments.seeds + 1), arguments.error, arguments.longest)
    return curves, agreement(list(latest.values()), reference), reference.own_error()


def verdict(found, error):
    if abs(found["z"]) < 3:
        return "agree within noise"
    if found["square"] > 0 and math.sqrt(found["square"]) < 0.1 * error:
        return f"agree to {math.sqrt(found['square']):.1e}"
    return "DIFFER"


def sentence(name, found, own, error):
    return (f"{name}: {verdict(found, error)}: the mean of Mitsuba's pictures is {found['seen']:.1e} from ours, of which "
            f"{found['noise']:.1e} is noise; without noise at most {found['at most']:.1e} (z = {found['z']:+.1f}; the reference's "
            f"own error is {own:.1e})")


def table(results, error):
    """CPU seconds to an error, and how often ours go into Mitsuba's."""
    lines = [f"CPU seconds of one thread to fro_c = {error:g}; in brackets the least and largest of the seeds; ~ extrapolated", "",
             f"{'scene':16} {'program':28} {'CPU s':>10} {'against ours':>22}"]
    rows = []
    for name, curves in results.items():
        best = min(("polariscope", "polariscope --error"), key=lambda label: median_curve(curves[label]).seconds_at(error)[::-1])
        for label, each in curves.items():
            seconds, far = median_curve(each).seconds_at(error)
            ratio, least, most, guessed = ratio_at(error, each, curves[best])
            rows.append([name, label, error, seconds, far, ratio, least, most, guessed])
            lines.append(f"{name:16} {label:28} {'~' if far else ''}{seconds:.3g}".ljust(56)
                         + (f"{'~' if guessed else ''}{ratio:.3g} ({least:.3g} to {most:.3g})" if label != best else "1"))
    return lines, rows


def draw(results, error, file):
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot, ticker

    styles = {"polariscope": ("tab:blue", "o"), "polariscope --error": ("tab:cyan", "D"),
              "Mitsuba, default sampler": ("tab:orange", "s"), "Mitsuba, multijitter": ("tab:red", "^")}
    columns = min(3, len(results))
    figure, axes = pyplot.subplots(-(-len(results) // columns), columns, figsize=(4.2 * columns, 3.4 * -(-len(results) // columns)),
                                   squeeze=False)
    for panel in axes.flat[len(results):]:
        panel.remove()
    for panel, (name, curves) in zip(axes.flat, results.items()):
        for label, each in curves.items():
            color, marker = styles[label]
            middle = median_curve(each).points
            if not middle:
                continue
            for curve in each:
                panel.plot([p.seconds for p in curve.points], [p.error for p in curve.points], color=color, alpha=0.25, linewidth=0.8)
            panel.plot([p.seconds for p in middle], [p.error for p in middle], color=color, marker=marker, markersize=4, label=label)
            seconds, far = median_curve(each).seconds_at(error)
            if far:
                near = min(middle, key=lambda point: abs(math.log(point.seconds / seconds)))
                panel.plot([near.seconds, seconds], [near.error, error], color=color, linestyle=":", marker=marker, markersize=4,
                           markevery=[1], markerfacecolor="white")
        panel.axhline(error, color="gray", linewidth=0.8)
        panel.set(title=name, xscale="log", yscale="log", xlabel="CPU seconds")
        for axis, limits, set_limits in ((panel.xaxis, panel.get_xlim(), panel.set_xlim), (panel.yaxis, panel.get_ylim(), panel.set_ylim)):
            set_limits(10 ** math.floor(math.log10(limits[0])), 10 ** math.ceil(math.log10(limits[1])))
            axis.set_minor_formatter(ticker.NullFormatter())
        panel.grid(True, which="major", linewidth=0.3)
    for row in axes:
        row[0].set_ylabel("error (fro_c)")
    handles, labels = axes.flat[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", ncols=4, frameon=False)
    figure.text(0.99, 0.995, "dotted, hollow: extrapolated", ha="right", va="top", fontsize=8)
    figure.tight_layout(rect=(0, 0.05, 1, 0.99))
    figure.savefig(file, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=Path, help="the polariscope executable")
    parser.add_argument("folder", type=Path, help="where table, plot, runs and references go")
    parser.add_argument("--scenes", type=Path, default=Path(__file__).parents[2] / "assets/scenes/bench")
    parser.add_argument("--only", nargs="+", choices=SCENES, default=SCENES, metavar="SCENE", help=", ".join(SCENES))
    parser.add_argument("--quick", action="store_true", help="64 x 64 pixels, 2 seeds, seconds instead of minutes")
    parser.add_argument("--size", type=int)
    parser.add_argument("--seeds", type=int)
    parser.add_argument("--error", type=float, help="where the programs are compared (default: 0.01; quick: 0.03)")
    parser.add_argument("--longest", type=float, help="no rendering is begun that will take more CPU seconds (30; quick: 1)")
    parser.add_argument("--with", dest="environment", action="append", default=[], metavar="NAME=VALUE",
                        help="for polariscope's environment")
    arguments = parser.parse_args()
    for key, usual, quick in (("size", 256, 64), ("seeds", 5, 2), ("error", 0.01, 0.03), ("longest", 30.0, 1.0)):
        if getattr(arguments, key) is None:
            setattr(arguments, key, quick if arguments.quick else usual)

    arguments.folder.mkdir(parents=True, exist_ok=True)
    ours = Polariscope(arguments.program, arguments.folder, arguments.environment)
    mitsuba = {sampler: Mitsuba(arguments.folder, sampler) for sampler in SAMPLERS}
    results, said, differ = {}, [], False
    for name in arguments.only:
        results[name], found, own = measure(name, arguments, ours, mitsuba, arguments.folder)
        said.append(sentence(name, found, own, arguments.error))
        differ |= verdict(found, arguments.error) == "DIFFER"
        print(said[-1], flush=True)
    for process in mitsuba.values():
        process.close()

    lines, rows = table(results, arguments.error)
    about = mitsuba["multijitter"].about
    about = (f"polariscope and Mitsuba {about['version']}, {about['variant']}, one thread each, "
             f"{arguments.size} x {arguments.size} pixels, {arguments.seeds} seeds")
    text = "\n".join([about, "", *lines]) + "\n"
    print("\n" + text)
    (arguments.folder / "peers.txt").write_text("\n".join([text, *said]) + "\n", encoding="utf-8")
    with (arguments.folder / "peers.csv").open("w", newline="", encoding="utf-8") as output:
        writer = csv.writer(output)
        writer.writerow(["scene", "program", "fro_c", "cpu_s", "extrapolated", "times_ours", "least", "most", "ratio_extrapolated"])
        writer.writerows(rows)
    with (arguments.folder / "peers-runs.csv").open("w", newline="", encoding="utf-8") as output:
        writer = csv.writer(output)
        writer.writerow(["scene", "program", "seed", "setting", "fro_c", "cpu_s"])
        for name, curves in results.items():
            for label, each in curves.items():
                for seed, curve in enumerate(each, 1):
                    writer.writerows([name, label, seed, point.setting, point.error, point.seconds] for point in curve.points)
    draw(results, arguments.error, arguments.folder / "peers.png")
    print(f"in {arguments.folder}: peers.txt, peers.csv, peers-runs.csv, peers.png")
    return 1 if differ else 0


if __name__ == "__main__":
    sys.exit(main())
