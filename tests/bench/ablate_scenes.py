#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What leaving code out saves on every shipped scene, as a table in Markdown.

Usage: ablate_scenes.py PROGRAM SCENES [OPTION...]
  PROGRAM  the polariscope executable
  SCENES   folder that is searched for *.yaml
  OPTION   handed on to `polariscope plan --ablate`: --rounds 11, --size 128x128, --mode area

A cell is the share of the time that leaving the feature out saves; needed: the scene has it; -: no code would run. Exits 1 if a
picture changed, and names it.
"""

import json
import subprocess
import sys
from pathlib import Path


def ablated(program, scene, options):
    """The report of one scene; none, with the reason on stderr, if there is no such report."""
    command = [program, "plan", scene, "--ablate", "--json", "--quiet", *options]
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, stdin=subprocess.DEVNULL)
    sys.stderr.write(done.stderr)
    return json.loads(done.stdout) if done.stdout else None


def cell(row):
    if row is None:
        return "needed"
    text = f"{100 * row['saved']:.0f} %"
    if "agreement" in row:
        text += f" ({100 * row['agreement']:.1f} %)"
    return text if row["holds"] else f"**{text}: ANOTHER PICTURE**"


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    program, folder, options = Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3:]
    reports = {}
    broken = []
    for scene in sorted(folder.rglob("*.yaml")):
        name = scene.relative_to(folder).with_suffix("").as_posix()
        report = ablated(program, scene, options)
        if report is None:
            broken.append(name)
            continue
        reports[name] = report
        if not report["holds"]:
            broken.append(name)
        print(f"{name}: {report['width']} x {report['height']}", file=sys.stderr, flush=True)

    features = list(dict.fromkeys(row["feature"] for report in reports.values() for row in report["features"]))
    print("| scene | " + " | ".join(features) + " | all together |")
    print("| --- |" + " ---: |" * (len(features) + 1))
    for name, report in reports.items():
        rows = {row["feature"]: row for row in report["features"]}
        unmeasured = {row["feature"] for row in report["not_keepable"] + report["nothing_to_keep"]}
        cells = ["-" if feature in unmeasured else cell(rows.get(feature)) for feature in features]
        print(f"| {name} | " + " | ".join([*cells, cell(report["all"]) if "all" in report else "-"]) + " |")
    print("\nOf the time that a render would take with it. In brackets: pixels that agree, where flat solids are met as meshes.")
    if broken:
        sys.exit("not the same picture, or no report: " + ", ".join(broken))


if __name__ == "__main__":
    main()
