# SPDX-License-Identifier: Apache-2.0
"""How much faster is one polariscope than another one at equal error? against.sh runs it.

Both programs render the same scenes with one thread and take turns. Per scene, from all seeds: CPU seconds and error
at the largest setting that both were given, squared error x CPU seconds (lower is better), and how often the new program's CPU
time to a given error goes into the old one's, on the curves through all settings; ~ is extrapolated. In mode area so, too, where the
new program is told errors (--error) instead of samples, and gives them to the pixels that need them: "aimed". The truth is rendered once, by the
new program with many samples, and kept in FOLDER/references until that is deleted.
"""

import argparse
import csv
import statistics
import sys
from dataclasses import dataclass, field
from pathlib import Path

from error_curves import ROOT, Color, Frobenius, Polariscope, Runner, climb, median_curve, ratio_at

SCENES = ROOT / "assets/scenes"
SAMPLES = [["--spp", 2**power] for power in range(1, 13)]
AIMS = [["--error", float(f"{0.4 * 2 ** (-step / 2):.2g}")] for step in range(18)]


@dataclass
class Row:
    what: str
    scene: str
    size: int
    error: float | None  # where the programs are compared; None: the old one's at the last setting
    samples: int  # of the reference
    options: list = field(default_factory=list)
    ladder: list = field(default_factory=lambda: SAMPLES)
    mode: str = "area"
    color: list | None = None  # wavelengths whose X, Y, Z are compared instead of coherence matrices


ROWS = [
    Row("G1", "bench/g1", 256, 1e-2, 512),
    Row("G1, large", "bench/g1", 1024, 3e-3, 256, ["--residual", 1e-3]),
    Row("G2", "bench/g2", 256, 1e-2, 512),
    Row("four stones", "bench/four-stones", 256, 1e-2, 512),
    Row("glass ball", "bench/glass-ball", 256, 1e-2, 512),
    Row("nested balls", "bench/nested-balls", 256, 1e-2, 512),
    Row("stone in water", "bench/stone-in-water", 256, 1e-2, 512),
    Row("calcite jewel", "paper-calcite-unpolarized", 96, 1e-2, 1024),
    Row("calcite jewel, point", "paper-calcite-unpolarized", 256, None, 0, mode="point",
        ladder=[["--residual", residual] for residual in (8e-3, 4e-3, 2e-3, 1e-3)]),
    Row("twins", "twinned-crystals", 64, 3e-2, 1024),
    Row("N-BK7, 21 wavelengths", "bench/g1-n-bk7", 128, 1e-2, 256, color=list(range(380, 781, 20))),
    Row("water drop", "water-drop", 128, 1e-2, 1024),
]


def compare(row, old, new, arguments):
    """A line of the table, as a dictionary; and the curves."""
    scene = SCENES / f"{row.scene}.yaml"
    size = max(16, row.size // (4 if arguments.quick else 1))
    common = ["--size", f"{size}x{size}", "--mode", row.mode]
    measure = Color(ROOT / "assets/observer/cie_1931_2deg_xyz_1nm.csv", row.color) if row.color else Frobenius()
    samples = row.samples // (4 if arguments.quick else 1)
    colors = ["--wavelengths", ",".join(map(str, row.color))] if row.color else []
    reference = new.reference(arguments.folder / "references", measure, scene, size, samples, row.mode, colors)

    def runner_of(program, folder, ladder):
        theirs = folder / f"{row.scene}.yaml"

        def run(setting, seed):
            options = [*common, *colors, *row.options, *setting]
            stats = program.render(theirs if theirs.exists() else scene, options, seed)
            return reference.error_of(program.picture()), stats["t_render_cpu_s"]

        return Runner(ladder, 2, run)

    target = (row.error or 0.0) * (2 if arguments.quick else 1)
    runners = {"old": runner_of(old, arguments.old_scenes, row.ladder), "new": runner_of(new, SCENES, row.ladder)}
    if row.mode == "area":
        runners["aimed"] = runner_of(new, SCENES, AIMS)
    curves = climb(runners, range(1, arguments.seeds + 1), target, arguments.longest)
    middle = {name: median_curve(each) for name, each in curves.items()}
    shared = [(a, b) for a in middle["old"].points for b in middle["new"].points if a.setting == b.setting]
    line = {"what": row.what, "error": row.color and "XYZ" or "fro_c", "reference_error": reference.own_error()}
    if shared:
        a, b = shared[-1]
        target = target or a.error
        line |= {"setting": " ".join(map(str, a.setting)), "old_s": a.seconds, "new_s": b.seconds, "old_error": a.error,
                 "new_error": b.error}
    if target and middle["old"].points and middle["new"].points:
        ratio, least, most, guessed = ratio_at(target, curves["old"], curves["new"])
        line |= {"old_variance_s": middle["old"].variance_seconds(), "new_variance_s": middle["new"].variance_seconds(), "at": target,
                 "old_s_at": middle["old"].seconds_at(target)[0], "new_s_at": middle["new"].seconds_at(target)[0],
                 "ratio": ratio, "least": least, "most": most, "extrapolated": guessed}
    if target and middle["old"].points and "aimed" in middle and middle["aimed"].points:
        ratio, least, most, guessed = ratio_at(target, curves["old"], curves["aimed"])
        line |= {"aimed_s_at": middle["aimed"].seconds_at(target)[0], "aimed_ratio": ratio, "aimed_least": least, "aimed_most": most,
                 "aimed_extrapolated": guessed}
    return line


def two_threads(program, size):
    """Wall seconds of one thread over those of two, tracing alone."""
    ratios = []
    for _ in range(3):
        options = ["--size", f"{size}x{size}", "--mode", "area", "--spp", 64]
        wall = [program.render(SCENES / "bench/g1.yaml", options, 1, threads)["t_render_wall_s"] for threads in (1, 2)]
        ratios.append(wall[0] / wall[1])
    return statistics.median(ratios)


HEADS = f"{'':22} {'setting':>16} {'CPU s old':>10} {'new':>8} {'error old':>10} {'new':>8} {'err2 x s old':>13} {'new':>8} " \
        f"{'at error':>9} {'CPU s old':>10} {'new':>8} {'old / new':>22} {'aimed':>8} {'old / aimed':>22}"


def text_of(line):
    def number(key, width):
        return f"{line[key]:{width}.2g}" if key in line else "-".rjust(width)

    def ratio(kind):
        if f"{kind}ratio" not in line:
            return "-".rjust(22)
        guessed = "~" if line[f"{kind}extrapolated"] else ""
        return f"{guessed}{line[f'{kind}ratio']:.3g} ({line[f'{kind}least']:.3g} to {line[f'{kind}most']:.3g})".rjust(22)

    return (f"{line['what']:22} {line.get('setting', '-'):>16} {number('old_s', 10)} {number('new_s', 8)} {number('old_error', 10)} "
            f"{number('new_error', 8)} {number('old_variance_s', 13)} {number('new_variance_s', 8)} {number('at', 9)} "
            f"{number('old_s_at', 10)} {number('new_s_at', 8)} {ratio('')} {number('aimed_s_at', 8)} {ratio('aimed_')}")


def main():
    names = [row.what for row in ROWS]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old", type=Path, help="polariscope executable to compare with")
    parser.add_argument("new", type=Path, help="polariscope executable of this tree")
    parser.add_argument("folder", type=Path, help="where the table and references go")
    parser.add_argument("--old-scenes", type=Path, default=SCENES, metavar="FOLDER",
                        help="the old program's scenes, whose defaults may be others; it takes those that are not there from this tree")
    parser.add_argument("--only", nargs="+", choices=names, default=names, metavar="ROW", help=", ".join(names))
    parser.add_argument("--quick", action="store_true", help="pictures of a quarter the width, twice the error: a few minutes")
    parser.add_argument("--seeds", type=int, default=2)
    parser.add_argument("--longest", type=float, help="no rendering is begun that will take more CPU seconds (30; quick: 2)")
    parser.add_argument("--with", dest="environment", action="append", default=[], metavar="NAME=VALUE",
                        help="for the new program's environment")
    arguments = parser.parse_args()
    arguments.longest = arguments.longest or (2.0 if arguments.quick else 30.0)

    old = Polariscope(arguments.old, arguments.folder / "old")
    new = Polariscope(arguments.new, arguments.folder / "new", arguments.environment)
    lines = []
    print(HEADS, flush=True)
    for row in ROWS:
        if row.what in arguments.only:
            lines.append(compare(row, old, new, arguments))
            print(text_of(lines[-1]), flush=True)
    size = 128 if arguments.quick else 512
    print(f"two threads over one, wall seconds of G1: old {two_threads(old, size):.2f}, new {two_threads(new, size):.2f}")
    with (arguments.folder / "against.csv").open("w", newline="", encoding="utf-8") as output:
        keys = list(dict.fromkeys(key for line in lines for key in line))
        writer = csv.DictWriter(output, keys)
        writer.writeheader()
        writer.writerows(lines)


if __name__ == "__main__":
    sys.exit(main())
