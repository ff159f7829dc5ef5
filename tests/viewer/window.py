# SPDX-License-Identifier: Apache-2.0
"""The real window on a virtual display, used like a person does: clicks, keys, and what can be read off the screen."""

import hashlib
import json
import os
import re
import shutil
import signal
import subprocess
import tempfile
import time
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[2]
SCENES = REPOSITORY / "assets" / "scenes"
PATIENCE_S = 120  # a busy machine, a sanitizer
NEEDED = ["Xvfb", "xdotool", "import"]


def missing_tools():
    """Programs that are needed and not installed."""
    return [name for name in NEEDED if shutil.which(name) is None]


def without_a_display():
    """The environment as if nobody sat at this machine."""
    return {name: value for name, value in os.environ.items()
            if name not in ("DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET", "XDG_SESSION_TYPE")}


class Display:
    """A virtual screen of its own; the number is free, whoever else runs here."""

    def __init__(self, width=1280, height=800):
        read_end, write_end = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write_end), "-screen", "0", f"{width}x{height}x24", "-nolisten", "tcp"],
            pass_fds=[write_end], stderr=subprocess.DEVNULL)
        os.close(write_end)
        with os.fdopen(read_end) as answer:
            number = answer.readline().strip()
        if not number:
            raise RuntimeError("Xvfb did not start")
        self.environment = without_a_display() | {"DISPLAY": f":{number}"}

    def close(self):
        self.server.terminate()
        self.server.wait()


class Window:
    """`polariscope view` on a Display."""

    def __init__(self, program, display, *arguments, folder=None):
        self.display = display
        self.probe = Path(tempfile.mkdtemp(prefix="polariscope-probe-"))
        self.process = subprocess.Popen(
            [str(program), "view", "--probe", str(self.probe), *map(str, arguments)],
            env=display.environment | {"XDG_CONFIG_HOME": str(self.probe)},  # remembers nothing of other runs
            cwd=folder or self.probe, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.output = None
        self.state = {}
        self.look()

    # What is on screen ----------------------------------------------------------------------------------------------

    def look(self):
        """Has the program describe its next frame: returns window.json, keeps it as .state and the texts as .text."""
        answer = self.probe / "window.json"
        answer.unlink(missing_ok=True)
        end = time.monotonic() + PATIENCE_S
        asked = 0.0
        while not answer.exists():
            if self.process.poll() is not None:
                raise RuntimeError(f"the window ended: {self.process.stdout.read()}")
            now = time.monotonic()
            if now > end:
                raise TimeoutError("the window does not answer")
            if now > asked + 5.0 and self._takes_signals():
                self.process.send_signal(signal.SIGUSR1)
                asked = now
            time.sleep(0.01)
        self.state = json.loads(answer.read_text())
        self.text = (self.probe / "panels.txt").read_text(errors="replace")
        return self.state

    def _takes_signals(self):
        """SIGUSR1 ends a program that has not blocked it yet."""
        blocked = re.search(r"SigBlk:\s*([0-9a-f]+)", Path(f"/proc/{self.process.pid}/status").read_text())
        return int(blocked.group(1), 16) >> (signal.SIGUSR1 - 1) & 1

    def wait_for(self, condition, what):
        """Looks until condition(self) holds."""
        end = time.monotonic() + PATIENCE_S
        while True:
            self.look()
            if condition(self):
                return
            if time.monotonic() > end:
                raise TimeoutError(f"never came: {what}\n{self.text}")
            time.sleep(0.05)

    def numbers(self):
        """All numbers on screen."""
        return [float(n) for n in re.findall(r"[-+]?\d+\.?\d*(?:[eE][-+]?\d+)?", self.text.replace("\u2212", "-"))]

    def picture(self):
        """A hash of the viewport's pixels. Rests the cursor in the corner first, so that it changes nothing."""
        self.move(1279, 1)
        self.settle()
        x, y, width, height = (int(v) for v in self.state["viewport"])
        raw = subprocess.run(["import", "-window", "root", "-crop", f"{width}x{height}+{x}+{y}", "-depth", "8", "rgb:-"],
                             env=self.display.environment, capture_output=True, check=True).stdout
        return hashlib.sha256(raw).hexdigest()

    def screenshot(self, path):
        subprocess.run(["import", "-window", "root", str(path)], env=self.display.environment, check=True)
        return path

    # What a person does ---------------------------------------------------------------------------------------------

    def do(self, *command):
        """The question at the end waits until the server has passed the events on."""
        subprocess.run(["xdotool", *map(str, command), "getmouselocation"], env=self.display.environment, check=True,
                       stdout=subprocess.DEVNULL)

    def quit_with(self, chord):
        """Asks nothing afterwards: the window under the cursor may be gone."""
        subprocess.run(["xdotool", "key", chord], env=self.display.environment, check=True, stdout=subprocess.DEVNULL)

    def settle(self):
        """Three looks: ImGui needs two frames more to give the keyboard back after a text field is closed."""
        for _ in range(3):
            self.look()

    def key(self, *chords):
        for chord in chords:
            self.do("key", chord)
        self.settle()

    def type(self, text):
        self.do("type", "--delay", 20, "--args", 1, text)
        self.settle()

    def move(self, x, y):
        self.do("mousemove", round(x), round(y))

    def click_at(self, x, y):
        self.move(x, y)
        time.sleep(0.05)
        self.do("click", 1)
        self.settle()

    def type_into(self, widget, text):
        """Ctrl+click makes a text entry of a slider or drag field, all of it marked."""
        self.do("keydown", "ctrl")
        self.click(widget)
        self.do("keyup", "ctrl")
        self.type(text)
        self.key("Return")

    def click(self, widget):
        if widget not in self.state["widgets"]:
            raise KeyError(f"no widget '{widget}' among {sorted(self.state['widgets'])}")
        x, y, width, height = self.state["widgets"][widget]
        self.click_at(x + width / 2, y + height / 2)

    def place_of_pixel(self, x, y):
        """Window coordinates of the middle of a pixel of the picture."""
        state = self.state
        return [state["viewport"][i] + state["offset"][i] + state["scale"] * (p + 0.5) for i, p in enumerate((x, y))]

    def click_pixel(self, x, y):
        self.click_at(*self.place_of_pixel(x, y))

    def wheel(self, x, y, steps):
        self.move(x, y)
        for _ in range(abs(steps)):
            self.do("click", 4 if steps > 0 else 5)
            time.sleep(0.03)
        self.settle()

    def end(self, how=signal.SIGTERM):
        """Ends the program if it still runs; returns its exit status. What it printed is in .output."""
        if self.process.poll() is None:
            self.process.send_signal(how)
        return self.wait()

    def wait(self):
        self.output, _ = self.process.communicate(timeout=PATIENCE_S)
        shutil.rmtree(self.probe, ignore_errors=True)
        return self.process.returncode
