#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What is written is whole or not there: missing folders, full disks, kills and signals."""

import os
import random
import resource
import select
import signal
import time
import unittest

from program import SCENES, ProgramTest, main

GLASS = SCENES / "cube-glass.yaml"
LONG = (SCENES / "paper-calcite-unpolarized.yaml", "--size", "1024x1024", "--residual", "1e-9", "--threads", "1")


class Refusals(ProgramTest):
    def test_an_output_that_cannot_be_written_is_refused_before_the_work(self):
        (self.folder / "folder.exr").mkdir()
        (self.folder / "folder.png").mkdir()
        self.succeed("render", GLASS, "-o", "good.exr", "--size", "8x8", "--quiet")
        for target in ("no/out.exr", "folder.exr", "good.exr/out.exr"):
            with self.subTest(target):
                began = time.monotonic()
                self.refuse(4, [target], "render", *LONG, "-o", target)
                self.refuse(4, ["no/stats.json"], "render", *LONG, "-o", "out.exr", "--stats", "no/stats.json")
                self.assertLess(time.monotonic() - began, 60)
        for target in ("no/dop.png", "folder.png"):
            with self.subTest(target):
                self.refuse(4, [target], "maps", "good.exr", "--map", "dop", "-o", target)

    def test_a_folder_that_may_not_be_written_is_refused(self):
        self.folder.chmod(0o555)
        self.addCleanup(self.folder.chmod, 0o755)
        as_nobody = {"user": 65534} if os.getuid() == 0 else {}
        self.refuse(4, ["out.exr", "ermission"], "render", GLASS, "-o", "out.exr", "--size", "8x8", **as_nobody)

    def test_a_result_never_replaces_what_it_was_made_from(self):
        scene = self.write("scene.exr", GLASS.read_text())
        self.refuse(2, ["scene.exr"], "render", scene, "-o", "scene.exr", "--size", "8x8")
        self.refuse(2, ["out.exr"], "render", GLASS, "-o", "out.exr", "--stats", "out.exr", "--size", "8x8")
        self.succeed("render", GLASS, "-o", "good.png.exr", "--size", "8x8", "--quiet")
        (self.folder / "good.png").symlink_to("good.png.exr")
        self.refuse(2, ["good.png"], "maps", "good.png.exr", "--map", "dop", "-o", "good.png")

    def test_a_picture_gets_the_ending_of_its_format(self):
        self.refuse(2, ["out.png", ".exr"], "render", GLASS, "-o", "out.png", "--size", "8x8")
        self.succeed("render", GLASS, "-o", "good.EXR", "--size", "8x8", "--quiet")
        self.refuse(2, ["dop.exr", ".png"], "maps", "good.EXR", "--map", "dop", "-o", "dop.exr")

    def test_a_full_disk_leaves_the_old_file_and_nothing_else(self):
        self.write("out.exr", "old")
        self.succeed("render", GLASS, "-o", "good.exr", "--size", "64x64", "--quiet")
        self.write("dop.png", "old")
        self.write("stats.json", "old")

        def at_most(size):
            return lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))

        for restore_signals in (True, False):  # with and without a deadly SIGXFSZ
            for size in (0, 1, 1000, 10000):
                with self.subTest(size=size):
                    self.refuse(4, ["out.exr", "large"], "render", GLASS, "-o", "out.exr", "--size", "64x64", "--quiet",
                                preexec_fn=at_most(size), restore_signals=restore_signals)
            self.refuse(4, ["dop.png", "large"], "maps", "good.exr", "--map", "dop", "-o", "dop.png",
                        preexec_fn=at_most(1000), restore_signals=restore_signals)

    def test_a_picture_beyond_all_memory_ends_with_33(self):
        def limited():
            resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))

        if self.run_program("--version", preexec_fn=limited).returncode != 0:
            self.skipTest("a sanitizer needs more address space than the limit")
        done = self.run_program("render", GLASS, "-o", "out.exr", "--size", "46000x46000", preexec_fn=limited)
        self.assertEqual(done.returncode, 33, done.stderr)
        self.assertIn("memory", done.stderr)
        self.assertEqual(self.files(), {})

    def test_standard_output_that_cannot_be_written_is_an_error(self):
        for command in (("plan", GLASS), ("plan", GLASS, "--json"), ("explain", GLASS, "--pixel", "9,9"),
                        ("interface", "--from", "air", "--to", "1.5"),
                        ("render", GLASS, "-o", "out.exr", "--size", "8x8")):
            with self.subTest(command[0]), open("/dev/full", "w") as full:
                done = self.run_program(*command, capture_output=False, stdout=full, stderr=-1)
                self.assertEqual(done.returncode, 4, done.stderr)
                self.assertIn("standard output", done.stderr)


class Kills(ProgramTest):
    COMMAND = (GLASS, "-o", "out.exr", "--wavelengths", "500:700:10", "--quiet", "--size")

    def temporaries(self):
        return [name for name in os.listdir(self.folder) if name.endswith(".tmp")]

    def test_a_kill_leaves_the_old_picture_or_the_new_one(self):
        began = time.monotonic()
        self.succeed("render", *self.COMMAND, "256x256")
        duration = time.monotonic() - began
        new = (self.folder / "out.exr").read_bytes()
        self.succeed("render", *self.COMMAND, "16x16")
        old = (self.folder / "out.exr").read_bytes()
        self.assertNotEqual(old, new)
        moments = random.Random(1)
        during_writing = 0
        for attempt in range(20):
            self.write("out.exr", old)
            process = self.start_program("render", *self.COMMAND, "256x256")
            if attempt % 2 == 0:
                time.sleep(duration * moments.uniform(0.0, 1.1))
            else:  # as soon as there is a piece of the new file
                while process.poll() is None and not self.pieces():
                    pass
                time.sleep(duration * moments.uniform(0.0, 0.01))
            process.kill()
            process.wait()
            during_writing += bool(self.pieces())
            self.assertIn((self.folder / "out.exr").read_bytes(), (old, new))
        self.assertGreater(during_writing, 0, "no kill came while the file was being written")
        self.succeed("render", *self.COMMAND, "256x256")
        self.assertEqual((self.folder / "out.exr").read_bytes(), new)
        self.assertEqual(os.listdir(self.folder), ["out.exr"], "leftovers of the killed are removed")

    def pieces(self):
        sizes = []
        for name in self.temporaries():
            try:
                sizes.append(os.path.getsize(self.folder / name))
            except FileNotFoundError:
                pass  # renamed meanwhile
        return any(sizes)


class Signals(ProgramTest):
    def wait_for_progress(self, process):
        """Until the first line of progress; returns it."""
        ready, _, _ = select.select([process.stdout], [], [], 120)
        self.assertTrue(ready, "no progress in two minutes")
        return process.stdout.readline()

    def test_a_stopped_render_writes_what_is_there_and_says_so(self):
        for sign, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            with self.subTest(sign.name):
                name = f"{sign.name}.exr"
                process = self.start_program("render", *LONG, "-o", name)
                self.wait_for_progress(process)
                process.send_signal(sign)
                began = time.monotonic()
                self.assertEqual(process.wait(60), code)
                self.assertLess(time.monotonic() - began, 5.0)  # performance.md 6.2
                self.assertIn("stopped", process.stderr.read())
                self.succeed("maps", name, "--map", "dop", "-o", "dop.png")

    def test_a_time_limit_writes_what_is_there_and_says_so(self):
        began = time.monotonic()
        done = self.run_program("render", *LONG, "-o", "out.exr", "--time", "1", "--spp", "1")
        self.assertEqual(done.returncode, 10, done.stderr)
        self.assertIn("time limit", done.stderr)
        self.assertGreater(time.monotonic() - began, 1.0)
        self.assertLess(time.monotonic() - began, 10.0)
        self.succeed("maps", "out.exr", "--map", "residual", "-o", "residual.png")

    def test_a_time_limit_alone_adds_samples_only_where_they_help(self):
        self.assertEqual(self.run_program("render", *LONG, "-o", "out.exr", "--time", "1").returncode, 10)
        began = time.monotonic()
        self.succeed("render", GLASS, "-o", "out.exr", "--size", "16x16", "--time", "60")
        self.assertLess(time.monotonic() - began, 30)
        self.succeed("render", GLASS, "-o", "out.exr", "--size", "16x16", "--mode", "area", "--time", "1")

    def test_a_pause_does_not_count_as_rendering(self):
        process = self.start_program("render", *LONG, "-o", "out.exr", "--time", "4", "--spp", "1")
        self.wait_for_progress(process)
        process.send_signal(signal.SIGSTOP)
        time.sleep(5)
        process.send_signal(signal.SIGCONT)
        time.sleep(1)
        self.assertIsNone(process.poll(), "the limit of 4 s must not have passed in 5 s of pause")
        self.assertEqual(process.wait(60), 10)


if __name__ == "__main__":
    main()
