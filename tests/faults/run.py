#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Plants one fault after the other and reports which check catches it. A fault that nothing catches is a hole in the checks.

Usage: run.py PROGRAM [NUMBER...]     PROGRAM: polariscope built with -DPOL_FAULTS=ON

Checks in this order, until one complains: facts, the picture and scene invariants of a few shipped scenes, stiff cases.
Prints a table and exits 1 if a fault was missed, or if a check complains without any fault.
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

from faults import FAULTS

SCENES = Path(__file__).resolve().parents[2] / "assets" / "scenes"
CHECKS = [
    ("facts", ["check", "facts"]),
    ("check paper-calcite-polarized", ["check", SCENES / "paper-calcite-polarized.yaml", "--size", "12"]),
    ("check crossed-polarizers", ["check", SCENES / "crossed-polarizers.yaml", "--size", "12"]),
    ("check water-drop", ["check", SCENES / "water-drop.yaml", "--size", "12"]),
    ("check metal-spheres", ["check", SCENES / "metal-spheres.yaml", "--size", "12"]),
    ("check of three wavelengths", ["check", "three-wavelengths.yaml", "--size", "12"]),
    ("stiff", ["check", "stiff"]),
]
# One tree for three wavelengths of which each has its own light.
THREE_WAVELENGTHS = """camera: {position: [0, 0, 5], target: [0, 0, 0], up: [0, 1, 0], fov: 30}
render: {wavelengths: [450, 550, 650]}
media: {glass: 1.5}
objects:
  - {name: ball, shape: {sphere: {radius: 0.5}}, medium: glass}
  - name: lamp
    shape: {rectangle: {size: 4}}
    transform: [{translate: [0, 0, -2]}]
    emission: {radiance: {table: [[450, 1], [550, 2], [650, 3]]}}
"""


def complaints(program, fault, check):
    """None if the check holds; else the first lines that say FAIL, or how it ended."""
    environment = dict(os.environ, POLARISCOPE_FAULT=str(fault))
    run = subprocess.run([program, *map(str, check)], env=environment, capture_output=True, text=True, timeout=900)
    if run.returncode == 0:
        return None
    failed = []
    title = ""
    for line in run.stdout.splitlines():
        if line[:1] not in (" ", ""):
            title = line.split()[0]
        if "FAIL" in line or "unsound" in line.lower():
            failed.append(title if line.startswith(" ") else line.split("  ")[0].strip())
    return ", ".join(dict.fromkeys(failed)) or (run.stderr.strip().splitlines() or [f"exit code {run.returncode}"])[0]


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    program = str(Path(sys.argv[1]).resolve())
    folder = tempfile.TemporaryDirectory()
    os.chdir(folder.name)
    Path("three-wavelengths.yaml").write_text(THREE_WAVELENGTHS, encoding="utf-8")
    chosen = [int(number) for number in sys.argv[2:]] or range(len(FAULTS) + 1)
    missed = 0
    for fault in chosen:
        name = FAULTS[fault - 1][0] if fault else "no fault"
        caught = None
        for title, check in CHECKS:
            what = complaints(program, fault, check)
            if what is not None:
                caught = f"{title}: {what}"
                break
        wrong = (caught is None) if fault else (caught is not None)
        missed += wrong
        print(f"{fault:3} {'MISSED' if wrong else 'ok':7}{name:55} {(caught or 'all checks hold')[:150]}", flush=True)
    print(f"{len(list(chosen)) - missed} as they should be, {missed} not")
    sys.exit(missed > 0)


if __name__ == "__main__":
    main()
