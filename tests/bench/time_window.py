# SPDX-License-Identifier: Apache-2.0
"""How quick is the window here? Prints frame time while workers trace, latency of keys and clicks, CPU of the idle window
and the tracer's speed next to its headless speed. Asserts nothing: a shared machine is not a stopwatch.

Usage: time_window.py PROGRAM      (needs Xvfb and xdotool)
"""

import json
import os
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "viewer"))
from window import SCENES, Display, Window, missing_tools  # noqa: E402

SCENE = SCENES / "paper-calcite-unpolarized.yaml"
MEASURE_S = 10.0


def cpu_seconds(pid):
    """User and system time of all threads of a process."""
    fields = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def report(what, value, unit, target):
    print(f"{what:<52} {value:8.1f} {unit:<4} (target {target})")


def median_ms(values):
    return 1e3 * statistics.median(values) if values else float("nan")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    if missing := missing_tools():
        sys.exit(f"time_window.py: not installed: {', '.join(missing)}")
    program = Path(sys.argv[1]).resolve()
    display = Display()
    try:
        measure(program, display)
    finally:
        display.close()


def measure(program, display):
    # So many samples that workers trace all the time; few branches each and few pixels, so that tiles come often and all
    # pixels are done several times while the speed is measured: some take ten times as long as others.
    folder = Path(tempfile.mkdtemp(prefix="polariscope-time-"))
    scene = folder / "slow.yaml"
    text = re.sub(r"^render:.*\n(?:[ ].*\n)*", "", SCENE.read_text(), flags=re.MULTILINE)
    scene.write_text(text + "render: {size: [128, 128], mode: area, spp: 4096, node_budget: 100, wavelengths: 580}\n")
    window = Window(program, display, scene)
    time.sleep(1.0)

    # The cursor over the picture: every move is a frame.
    window.look()
    end = time.monotonic() + 4.0
    while time.monotonic() < end:
        window.do("mousemove", 400 + int(100 * (time.monotonic() % 1.0)), 300)
    window.look()
    report("frame while two workers trace, 1280x800, median", median_ms(window.state["frame_s"]), "ms", "20 ms")

    for key in "345612" * 2:
        window.do("key", key)
        time.sleep(0.2)
    window.look()
    report("map key to picture, median", median_ms(window.state["latency_s"]), "ms", "one frame")

    for i in range(8):
        window.move(*window.place_of_pixel(50 + 3 * i, 62))
        time.sleep(0.1)
        window.do("click", 1)
        time.sleep(0.4)
    window.look()
    report("click to matrix, median", median_ms(window.state["latency_s"]), "ms", "50 ms")

    # Open and still, against headless: samples per second of CPU, which does not depend on what else runs here. What
    # drawing takes, with the rasterizer's own threads, is in the window's CPU time.
    samples, cpu = window.look()["samples"], cpu_seconds(window.process.pid)
    time.sleep(MEASURE_S)
    samples, cpu = window.look()["samples"] - samples, cpu_seconds(window.process.pid) - cpu
    window.key("space")
    subprocess.run([program, "render", scene, "-o", folder / "slow.exr", "--time", str(MEASURE_S), "--stats",
                    folder / "stats.json"], capture_output=True, check=False)
    headless = json.loads((folder / "stats.json").read_text())
    headless_speed = headless["camera_samples"] / headless["t_render_cpu_s"]
    report("tracer's speed, window open and still", 100.0 * samples / cpu / headless_speed, "%", "90 % of headless")

    time.sleep(1.0)
    before = cpu_seconds(window.process.pid)
    time.sleep(MEASURE_S)
    report("CPU of the idle window, share of one core", 100.0 * (cpu_seconds(window.process.pid) - before) / MEASURE_S,
           "%", "3 %")
    window.end()
    shutil.rmtree(folder)


if __name__ == "__main__":
    main()
