# SPDX-License-Identifier: Apache-2.0
"""The window from end to end, under Xvfb with real clicks and keys. Exit status 77: Xvfb or xdotool is missing."""

import json
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from window import SCENES, Display, Window, missing_tools

PROGRAM = Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else None
MAP_KEYS = ["1", "2", "3", "4", "5", "6", "7", "8", "9", "0", "d", "shift+d"]

# One sample and no dispersion, so that the picture is what `explain` says of sample 0.
SCENE = """
title: Window test
render: {size: [60, 48], spp: 1, wavelengths: [500, 580, 640]}
camera: {position: [1.6, -3, 2.2], target: [0, 0, -0.1], fov: 28}
media: {glass: 1.5}
objects:
  - name: cube
    shape: {box: {size: 1}}
    medium: glass
  - name: light
    shape: {rectangle: {size: 3}}
    transform: [{translate: [0, 0, -0.6]}]
    emission: {radiance: 1}  # not white: color and intensity differ
"""
PIXEL = (30, 22)  # on the cube: partially polarized


class EndToEnd(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.display = Display()

    @classmethod
    def tearDownClass(cls):
        cls.display.close()

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="polariscope-window-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.scene = self.folder / "cube.yaml"
        self.scene.write_text(SCENE)

    def open(self, *arguments):
        window = Window(PROGRAM, self.display, *arguments, folder=self.folder)
        self.addCleanup(window.end, signal.SIGKILL)
        return window

    def rendered(self, window):
        window.wait_for(lambda w: w.state.get("done") == 1.0, "the end of the render")

    def explained(self):
        """Stokes vector of PIXEL as `polariscope explain` has it."""
        run = subprocess.run([PROGRAM, "explain", self.scene, "--pixel", *map(str, PIXEL), "--wavelength", "580",
                              "--json"], check=True, capture_output=True, text=True)
        return json.loads(run.stdout)["stokes"]

    def assert_on_screen(self, window, values):
        shown = window.numbers()
        for value in values:
            self.assertTrue(any(abs(n - value) <= 2e-4 * abs(value) + 1e-12 for n in shown),
                            f"{value} is not on screen:\n{window.text}")

    def test_a_session_of_a_user(self):
        window = self.open(self.scene)
        self.rendered(window)

        looks = {}
        for key in MAP_KEYS:
            window.key(key)
            look = window.picture()
            self.assertNotIn(look, looks, f"map on key {key} looks like that on key {looks.get(look)}")
            looks[look] = key
        window.key("3")
        self.assertEqual(window.state["map"], "dop")

        before = window.state["scale"]
        place = window.place_of_pixel(*PIXEL)
        window.wheel(*place, 4)
        self.assertGreater(window.state["scale"], 1.5 * before)
        for was, now in zip(place, window.place_of_pixel(*PIXEL)):
            self.assertAlmostEqual(was, now, delta=2.0)  # the cursor is at a whole point

        window.click_pixel(*PIXEL)
        self.assert_on_screen(window, self.explained())
        window.click("tab Paths")
        window.wait_for(lambda w: "branch 1" in w.state["widgets"], "the tree of the pixel")
        window.click("branch 1")
        self.assertEqual(window.state["node"], 1)
        window.key("Escape", "f")
        self.assertAlmostEqual(window.state["scale"], before, places=6)

        window.key("F1")
        self.assertIn("Keys and mouse", window.text)
        self.assertIn("Ctrl+Shift+Z", window.text)
        window.key("Escape")
        self.assertNotIn("Ctrl+Shift+Z", window.text)

        window.do("key", "ctrl+q")
        self.assertEqual(window.wait(), 0)
        self.assertEqual(window.output, "")

    def test_files_that_cannot_be_opened(self):
        broken = self.folder / "broken.yaml"
        broken.write_text(SCENE.replace("fov: 28", "fov: wide"))
        window = self.open(self.scene, broken)
        self.assertEqual(window.state["documents"], 1)
        self.assertIn("broken.yaml", window.text)
        self.assertEqual(window.end(), 0)
        self.assertRegex(window.output, r"broken\.yaml:4:\d+")

        refused = subprocess.run([PROGRAM, "view", broken], env=self.display.environment, capture_output=True, text=True)
        self.assertEqual(refused.returncode, 3)
        self.assertRegex(refused.stderr, r"broken\.yaml:4:\d+")

    def test_an_empty_window_offers_scenes_and_a_file_entry(self):
        window = self.open()
        self.assertIn("Nothing is open", window.text)
        window.click("scene cube-glass")
        self.assertEqual(window.state["document"], str(SCENES / "cube-glass.yaml"))
        window.key("ctrl+o")
        window.key("ctrl+a")
        window.type(str(self.scene))
        window.key("Return")
        self.assertEqual(window.state["documents"], 2)
        self.assertEqual(window.state["document"], str(self.scene))
        window.key("Up")
        self.assertEqual(window.state["document"], str(SCENES / "cube-glass.yaml"))
        self.assertEqual(window.end(signal.SIGINT), 0)

    def test_without_a_display_it_says_what_to_do(self):
        environment = {key: value for key, value in self.display.environment.items() if key != "DISPLAY"}
        run = subprocess.run([PROGRAM, "view", self.scene], env=environment, capture_output=True, text=True)
        self.assertEqual(run.returncode, 2)
        self.assertIn("polariscope render", run.stderr)


if __name__ == "__main__":
    if missing := missing_tools():
        print(f"skipped: {', '.join(missing)} not installed; tests/run.sh installs them")
        sys.exit(77)
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]], verbosity=2)
