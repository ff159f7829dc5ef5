#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Times whole renders of the benchmark gem and prints a table of medians and the ratios that matter.

Usage: time_renders.py PROGRAM SCENES
  PROGRAM  the polariscope executable
  SCENES   folder with g1.yaml (glass) and g2.yaml (diamond index)

All variants take turns, five rounds, so that a slow minute of the machine hits each of them alike.
"""

import json
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

ROUNDS = 5
COMMON = ["--size", "256x256", "--mode", "area", "--residual", "3e-3", "--quiet"]
# name -> scene, options
VARIANTS = {
    "g1, 1 wavelength, 1 thread": ("g1.yaml", ["--spp", "16", "--wavelengths", "580", "--threads", "1"]),
    "g1, 1 wavelength, 2 threads": ("g1.yaml", ["--spp", "16", "--wavelengths", "580", "--threads", "2"]),
    "g1, 21 wavelengths, 1 thread": ("g1.yaml", ["--spp", "16", "--wavelengths", "380:780:20", "--threads", "1"]),
    "g2, 1 wavelength, 1 thread": ("g2.yaml", ["--spp", "4", "--wavelengths", "580", "--threads", "1"]),
}
# what -> numerator, denominator (of wall seconds of the tracing alone)
RATIOS = {
    "two threads against one (at least 1.9)": ("g1, 1 wavelength, 1 thread", "g1, 1 wavelength, 2 threads"),
    "21 wavelengths against one (at most 2)": ("g1, 21 wavelengths, 1 thread", "g1, 1 wavelength, 1 thread"),
}


def render(program, scene, options, folder):
    """Statistics that one render writes about itself."""
    stats = folder / "stats.json"
    command = [program, "render", scene, "-o", folder / "out.exr", *COMMON, *options, "--stats", stats]
    subprocess.run([str(word) for word in command], check=True, stdin=subprocess.DEVNULL)
    return json.loads(stats.read_text(encoding="utf-8"))


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    program, scenes = Path(sys.argv[1]), Path(sys.argv[2])
    runs = {name: [] for name in VARIANTS}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(ROUNDS):
            for name, (scene, options) in VARIANTS.items():
                runs[name].append(render(program, scenes / scene, options, Path(folder)))

    def median(name, key):
        return statistics.median(run[key] for run in runs[name])

    print(f"== whole renders, medians of {ROUNDS}")
    print(f"{'variant':32} {'trace s':>8} {'M samples/s':>12} {'M rays/s':>9} {'B/pixel':>9}")
    for name in VARIANTS:
        seconds = median(name, "t_render_wall_s")
        print(
            f"{name:32} {seconds:8.3f} {median(name, 'camera_samples') / seconds / 1e6:12.3f} "
            f"{median(name, 'rays') / seconds / 1e6:9.2f} {median(name, 'film_bytes_per_pixel'):9.0f}"
        )
    for what, (above, below) in RATIOS.items():
        each = sorted(a["t_render_wall_s"] / b["t_render_wall_s"] for a, b in zip(runs[above], runs[below]))
        print(f"{what}: {statistics.median(each):.2f} (from {each[0]:.2f} to {each[-1]:.2f})")


if __name__ == "__main__":
    main()
