#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What is written is whole or not there: missing folders, full disks, kills and signals."""

import contextlib
import os
import random
import resource
import select
import signal
import subprocess
import time
import unittest

from program import PATIENCE_S, SCENES, ProgramTest, bound_by_permissions, main

CALCITE = SCENES / "cube-calcite.yaml"
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
        self.refuse(4, ["out.exr", "ermission"], "render", GLASS, "-o", "out.exr", "--size", "8x8", **bound_by_permissions())

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
        for size in ("20000x20000", "46000x46000"):
            done = self.run_program("render", GLASS, "-o", "out.exr", "--size", size, preexec_fn=limited)
            self.assertEqual(done.returncode, 33, done.stderr)
            self.assertIn("memory", done.stderr)
            self.assertEqual(done.stdout, "", "found out before the work")
            self.assertEqual(self.files(), {})

    def test_standard_output_that_cannot_be_written_is_an_error(self):
        for command in (("--version",), ("render", "--help"),
                        ("plan", GLASS), ("plan", GLASS, "--json"), ("explain", GLASS, "--pixel", "9,9"),
                        ("interface", "--from", "air", "--to", "1.5"),
                        ("render", GLASS, "-o", "out.exr", "--size", "8x8")):
            with self.subTest(command[0]), open("/dev/full", "w") as full:
                done = self.run_program(*command, capture_output=False, stdout=full, stderr=-1)
                self.assertEqual(done.returncode, 4, done.stderr)
                self.assertIn("standard output", done.stderr)

    def test_work_goes_on_where_nothing_can_be_said(self):
        """Full or closed, the streams cost no picture and end up in no file."""
        def closed():
            os.close(1)
            os.close(2)

        self.succeed("render", GLASS, "-o", "good.exr", "--size", "256x256", "--quiet")
        good = (self.folder / "good.exr").read_bytes()
        for streams in ({"stdout": "/dev/full", "stderr": "/dev/full"}, {"preexec_fn": closed}):
            with self.subTest(streams), contextlib.ExitStack() as files:
                options = {name: files.enter_context(open(path, "w")) if isinstance(path, str) else path
                           for name, path in streams.items()}
                done = self.run_program("render", GLASS, "-o", "out.exr", "--size", "256x256", capture_output=False, **options)
                self.assertEqual(done.returncode, 4)
                self.assertEqual((self.folder / "out.exr").read_bytes(), good)
                done = self.run_program("render", GLASS, "-o", "out.exr", "--error", "0.1", "--size", "64x64",
                                        capture_output=False, **options)
                self.assertEqual(done.returncode, 4)
                self.assertEqual(self.run_program("check", "out.exr").returncode, 0)
                done = self.run_program("render", "no.yaml", "-o", "out.exr", capture_output=False, **options)
                self.assertEqual(done.returncode, 3)


class Kills(ProgramTest):
    def pieces(self):
        """Whether there is a part of a new file."""
        sizes = []
        for name in os.listdir(self.folder):
            try:
                sizes.append(name.endswith(".tmp") and os.path.getsize(self.folder / name))
            except FileNotFoundError:
                pass  # renamed meanwhile
        return any(sizes)

    def kills_leave_whole_files(self, *command):
        """Fifteen kills of `command`; returns how many came while a file was being written."""
        before = set(self.files())
        began = time.monotonic()
        self.assertEqual(self.run_program(*command).returncode, 0)
        duration = time.monotonic() - began
        new = {name: content for name, content in self.files().items() if name not in before}
        self.assertTrue(new)
        moments = random.Random(1)
        during_writing = 0
        for attempt in range(15):
            for name in new:
                self.write(name, "old")
            process = self.start_program(*command, stdout=subprocess.DEVNULL)
            if attempt % 2 == 0:
                time.sleep(duration * moments.uniform(0.0, 1.1))
            else:
                while process.poll() is None and not self.pieces():
                    pass
                time.sleep(duration * moments.uniform(0.0, 0.01))
            process.kill()
            process.wait()
            during_writing += self.pieces()
            for name, content in new.items():
                self.assertIn((self.folder / name).read_bytes(), (b"old", content))
        self.assertEqual(self.run_program(*command).returncode, 0)
        self.assertEqual(set(self.files()), before | set(new), "leftovers of the killed are removed")
        for name, content in new.items():
            self.assertEqual((self.folder / name).read_bytes(), content)
        return during_writing

    def test_a_kill_leaves_the_old_file_or_the_new_one(self):
        self.succeed("render", GLASS, "-o", "in.exr", "--size", "64x64", "--quiet")
        during_writing = 0
        for command in (("render", GLASS, "-o", "out.exr", "--wavelengths", "500:700:10", "--size", "256x256"),
                        ("maps", "in.exr", "--map", "dop", "-o", "dop.png"),
                        ("explain", CALCITE, "--pixel", "256,200", "--csv", "rays.csv", "--obj", "rays.obj"),
                        ("check", "facts", "T25", "--scenes", "."),
                        ("check", "stiff", "--sweep", "grazing-crystal", "-o", ".")):
            with self.subTest(command):
                during_writing += self.kills_leave_whole_files(*command)
        self.assertGreater(during_writing, 0, "no kill came while a file was being written")


class Pipes(ProgramTest):
    def test_a_reader_that_stops_ends_the_program_without_a_word(self):
        self.succeed("render", GLASS, "-o", "in.exr", "--size", "8x8", "--quiet")
        for command in (("--help",), ("--version",), ("render", "--help"), ("plan", GLASS), ("plan", GLASS, "--json"),
                        ("render", *LONG, "-o", "out.exr"),
                        ("explain", CALCITE, "--pixel", "256,200"), ("explain", CALCITE, "--pixel", "256,200", "--json"),
                        ("interface", "--from", "air", "--to", "1.5"),
                        ("check", "facts", "T1"), ("check", "facts", "T1", "--json"), ("check", "in.exr"),
                        ("check", GLASS, "--json"), ("check", "stiff", "--sweep", "grazing-crystal"),
                        ("check", "all", "-o", "all"),
                        ("converge", GLASS, "-o", "curves", "--size", "8x8", "--seeds", "1")):
            for parent_ignores_it in (False, True):
                with self.subTest(command, ignored=parent_ignores_it):
                    process = self.start_program(*command, restore_signals=not parent_ignores_it)
                    process.stdout.close()
                    self.assertEqual(process.wait(PATIENCE_S), -signal.SIGPIPE)
                    self.assertEqual(process.stderr.read(), "")
                    self.assertEqual([name for name in self.files() if name.endswith(".tmp")], [])

    def test_files_are_written_whoever_reads_the_text(self):
        for command, names in ((("explain", CALCITE, "--pixel", "256,200", "--csv", "r.csv", "--obj", "r.obj"),
                                ("r.csv", "r.obj")),
                               (("check", "stiff", "--sweep", "grazing-crystal", "-o", ".", "--json"),
                                ("grazing-crystal.svg", "stiff.html"))):
            with self.subTest(command):
                self.assertEqual(self.run_program(*command).returncode, 0)
                whole = {name: (self.folder / name).read_bytes() for name in names}
                for name in names:
                    self.write(name, "old")
                process = self.start_program(*command)
                process.stdout.close()
                self.assertEqual(process.wait(PATIENCE_S), -signal.SIGPIPE)
                self.assertEqual({name: (self.folder / name).read_bytes() for name in names}, whole)


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
                self.assertLess(time.monotonic() - began, 5.0)
                self.assertIn("stopped", process.stderr.read())
                self.assertNotIn("progress 100.0%", process.stdout.read())
                self.succeed("maps", name, "--map", "dop", "-o", "dop.png")

    def test_a_stopped_convergence_says_what_there_is(self):
        """Before the first run there is no report; later the report has the finished runs."""
        endless = ("--size", "512x512", "--wavelengths", "380:780:20", "--residual", "1e-9")
        process = self.start_program("converge", SCENES / "paper-calcite-unpolarized.yaml", "-o", "curves", *endless)
        self.wait_for_progress(process)
        process.send_signal(signal.SIGTERM)
        began = time.monotonic()
        self.assertEqual(process.wait(60), 143)
        self.assertLess(time.monotonic() - began, 5.0)
        self.assertIn("stopped before the first run", process.stderr.read())
        self.assertEqual(self.files(), {})

        process = self.start_program("converge", GLASS, "-o", "curves", "--size", "64x64", "--seeds", "1000")
        while not (self.folder / "curves" / "runs.csv").exists() and process.poll() is None:
            time.sleep(0.01)
        process.send_signal(signal.SIGTERM)
        self.assertEqual(process.wait(60), 143)
        self.assertIn("the same command goes on", process.stderr.read())
        self.assertIn("</html>", (self.folder / "curves" / "report.html").read_text())

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
