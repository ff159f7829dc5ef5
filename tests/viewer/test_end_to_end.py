# SPDX-License-Identifier: Apache-2.0
"""The window from end to end, under Xvfb with real clicks and keys. Exit status 77: Xvfb or xdotool is missing."""

import json
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from window import PATIENCE_S, SCENES, Display, Window, missing_tools, without_a_display

PROGRAM = Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else None
DATA = Path(__file__).resolve().parents[1] / "data"
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

    def explained(self, text=None):
        """Stokes vector of PIXEL as `polariscope explain` has it; of another scene than the test's if given as text."""
        scene = self.scene
        if text is not None:
            scene = self.folder / "other.yaml"
            scene.write_text(text)
        run = subprocess.run([PROGRAM, "explain", scene, "--pixel", *map(str, PIXEL), "--wavelength", "580",
                              "--json"], check=True, capture_output=True, text=True)
        return json.loads(run.stdout)["stokes"]

    def scene_hash(self, scene):
        statistics = self.folder / "statistics.json"
        subprocess.run([PROGRAM, "render", scene, "-o", self.folder / "hash.exr", "--stats", statistics], check=True,
                       capture_output=True)
        return json.loads(statistics.read_text())["scene_hash"]

    def pixels(self, picture, crop):
        return subprocess.run(["convert", picture, "-crop", crop, "-depth", "8", "rgb:-"], check=True,
                              capture_output=True).stdout

    def assert_on_screen(self, window, values):
        # At most 1e-3 of the lamp's light of 1 is missing: digits end at 1e-4, two digits into the bar.
        shown = window.numbers()
        for value in values:
            self.assertTrue(any(abs(n - value) <= 2e-4 * abs(value) + 0.5e-4 for n in shown),
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

        window.quit_with("ctrl+q")
        self.assertEqual(window.wait(), 0)
        self.assertEqual(window.output, "")

    def test_edit_undo_export_and_reopen(self):
        window = self.open(self.scene)
        self.rendered(window)
        window.key("2")
        window.click_pixel(*PIXEL)
        before = self.explained()
        self.assert_on_screen(window, before)

        window.click("tab Scene")
        window.type_into("field n of glass", "1.7")
        self.rendered(window)
        self.assertTrue(window.state["dirty"])
        window.click("tab Pixel")
        self.assert_on_screen(window, self.explained(self.scene.read_text().replace("glass: 1.5", "glass: 1.7")))

        window.key("ctrl+z")
        self.rendered(window)
        self.assertFalse(window.state["dirty"])
        self.assert_on_screen(window, before)

        window.key("ctrl+s", "ctrl+e", "ctrl+shift+e")
        files = [self.folder / name for name in ("cube.exr", "cube-intensity.png", "cube-window.png")]
        window.wait_for(lambda w: all(file.exists() for file in files), "the exports")
        window.settle()
        for crop in ("1280x18+0+0", "250x300+0+20"):  # the menus and the list of maps, which look like nothing else
            self.assertEqual(self.pixels(files[2], crop), self.pixels(window.screenshot(self.folder / "seen.png"), crop))

        window.key("ctrl+o")
        window.key("ctrl+a")
        window.type(str(files[0]))
        window.key("Return")
        self.assertEqual(window.state["document"], str(files[0]))
        self.assert_on_screen(window, before)  # the pixel is still pinned, and now read from the file

    def test_saving_under_another_name(self):
        window = self.open(self.scene)
        self.rendered(window)
        taken = self.folder / "taken.yaml"
        taken.write_text("not mine")
        window.key("ctrl+shift+a")
        self.assertIn("[ Save ]", window.text)
        window.key("ctrl+a")
        window.type(str(taken))
        window.key("Return")
        self.assertIn("This file exists", window.text)
        self.assertEqual(taken.read_text(), "not mine")
        window.key("ctrl+a")
        window.type(str(self.folder / "mine.yaml"))
        window.click("entry Save")
        self.assertEqual(window.state["document"], str(self.folder / "mine.yaml"))
        self.assertNotIn("[ Save ]", window.text)
        hashes = {self.scene_hash(self.scene), self.scene_hash(self.folder / "mine.yaml")}
        self.assertEqual(len(hashes), 1)

    def test_the_difference_from_the_twin_is_one_key_away(self):
        window = self.open(self.scene)
        self.rendered(window)
        window.key("2")
        window.key("shift+i")
        self.rendered(window)
        self.assertIn("minus that of cube.yaml", window.text)
        window.move(*window.place_of_pixel(*PIXEL))
        window.settle()
        with_polarization = self.explained()[0]
        without = self.explained(self.scene.read_text().replace("spp: 1", "spp: 1, unpolarized: on"))[0]
        self.assertNotAlmostEqual(with_polarization, without, places=4)
        row = next(line for line in window.text.splitlines() if " minus " in line and "x 30" in line)
        shown = [float(n) for n in re.findall(r"-?\d+\.\d+(?:e-?\d+)?", row.replace("\u2212", "-"))]
        self.assertAlmostEqual(shown[0] / shown[1], without / with_polarization, places=4)
        self.assertAlmostEqual(shown[2], shown[0] - shown[1], places=5)
        window.key("x")
        self.assertNotIn("minus that of cube.yaml", window.text)

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

    def test_a_folder_for_settings_that_cannot_be_made_costs_nothing_but_the_settings(self):
        taken = self.folder / "taken"
        taken.write_text("not a folder")
        with subprocess.Popen([PROGRAM, "view", self.scene], text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              env=self.display.environment | {"XDG_CONFIG_HOME": str(taken)}) as window:
            find = ["xdotool", "search", "--sync", "--pid", str(window.pid)]
            subprocess.run(find, env=self.display.environment, check=True, capture_output=True, timeout=PATIENCE_S)
            window.send_signal(signal.SIGTERM)
            _, errors = window.communicate(timeout=PATIENCE_S)
        self.assertEqual(window.returncode, 0)
        self.assertIn("settings are not remembered", errors)
        self.assertIn(str(taken), errors)

    def test_a_probe_without_its_folder_is_refused(self):
        missing = self.folder / "missing"
        run = subprocess.run([PROGRAM, "view", "--probe", missing, self.scene], env=self.display.environment,
                             capture_output=True, text=True, timeout=PATIENCE_S)
        self.assertEqual(run.returncode, 2)
        self.assertIn(f"there is no folder '{missing}'", run.stderr)

    def test_without_a_display_it_says_what_to_do(self):
        run = subprocess.run([PROGRAM, "view", self.scene], env=without_a_display(), capture_output=True, text=True, timeout=60)
        self.assertEqual(run.returncode, 2)
        self.assertIn("polariscope render", run.stderr)

    # Pictures of other programs --------------------------------------------------------------------------------------

    def listening(self, *arguments):
        """A window that listens on a port of its own: (window, port)."""
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            port = probe.getsockname()[1]
        return self.open("--listen", f"127.0.0.1:{port}", *arguments), port

    def test_a_picture_that_another_program_sends_is_shown(self):
        window, port = self.listening(self.scene)
        vectors = json.loads((DATA / "tev_messages/messages.json").read_text())
        sent = {vector["name"]: bytes.fromhex(vector["hex"]) for vector in vectors["good"]}
        with socket.create_connection(("127.0.0.1", port)) as client:
            for bad in vectors["bad"]:
                if not bad["name"].startswith("length"):  # those close the connection
                    client.sendall(bytes.fromhex(bad["hex"]))
            for name in ("create_stokes", "update_v3_all", "vector_graphics"):
                client.sendall(sent[name])
            window.wait_for(lambda w: w.state["documents"] == 2, "the picture that was sent")
        window.key("Page_Down")
        self.assertIn("stokes", window.text)
        self.assertEqual(window.end(), 0)

    def test_a_picture_of_tevclient_is_shown(self):
        try:
            import tevclient
            import numpy
        except ImportError as missing:
            self.skipTest(f"{missing.name} is not installed")
        window, port = self.listening(self.scene)
        with tevclient.Ipc("127.0.0.1", port) as client:
            names = ["S0", "S1", "S2", "S3"]
            client.create_image("from python", 300, 200, names)
            light = numpy.zeros((200, 300, 4), dtype=numpy.float32)
            light[..., 0], light[..., 1] = 2.0, 1.0
            client.update_image("from python", light, names)  # in tiles of 128 x 128
            window.wait_for(lambda w: w.state["documents"] == 2, "the picture that was sent")
        window.key("3")
        window.wait_for(lambda w: "from python" in w.text, "its name")
        window.click_pixel(299, 199)
        window.wait_for(lambda w: 0.5 in w.numbers(), "the degree of polarization of its last tile")

    def test_ours_and_a_picture_of_mitsuba_side_by_side_with_the_verdict(self):
        mitsuba = DATA / "pictures/mitsuba_exr/mono_luminance_f32.exr"
        ours = self.folder / "ours.exr"
        subprocess.run([PROGRAM, "render", DATA / "pictures/mitsuba_exr/spheres.yaml", "--size", "64x64", "--mode",
                        "area", "--spp", "16", "-o", ours, "--quiet"], check=True)
        window = self.open(ours, mitsuba)
        self.assertEqual(window.state["document"], str(mitsuba))
        window.key("Page_Up")
        self.assertEqual(window.state["document"], str(ours))
        window.key("shift+x", "Page_Down", "5")
        looks = [window.picture()]
        for keys in (["w"], ["w", "shift+w"], ["shift+w", "x"]):
            window.key(*keys)
            time.sleep(0.5)
            looks.append(window.picture())
        self.assertEqual(len(set(looks)), 4, "alone, wipe, side by side and difference look different")
        window.key("v")
        window.wait_for(lambda w: "same convention" in w.text, "the doctor's verdict")
        window.click("tab Picture")
        self.assertIn("Mitsuba 3, mono", window.text)
        window.key("ctrl+1")
        self.assertEqual(window.state["document"], str(ours))


if __name__ == "__main__":
    if missing := missing_tools():
        print(f"skipped: {', '.join(missing)} not installed; tests/run.sh installs them")
        sys.exit(77)
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]], verbosity=2)
