#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`render --error`: stops when the picture is good enough, says why, and what there is if it cannot be."""

import json
import re

from program import SCENES, ProgramTest, main

GLASS = (SCENES / "paper-glass-polarized.yaml", "--size", "40x40")
PASS = re.compile(r"^([\d.]+) samples? per pixel, .*: bound of truncation (\S+), estimate of sampling (.*)$", re.M)


class ErrorStop(ProgramTest):
    def render(self, *options, code=0):
        done = self.run_program("render", *options, "-o", "out.exr", "--stats", "out.json")
        self.assertEqual(done.returncode, code, done.stderr)
        return done, json.loads((self.folder / "out.json").read_text())

    def test_samples_are_added_pass_by_pass_until_the_error_is_reached(self):
        done, said = self.render(*GLASS, "--error", "0.1")
        passes = PASS.findall(done.stderr)
        self.assertEqual([float(samples) for samples, _, _ in passes], [p["samples"] for p in said["error_rule"]["passes"]])
        self.assertEqual(passes[-1][0], str(said["spp"]))
        self.assertGreaterEqual(said["spp"], 16)
        self.assertEqual([p["samples"] for p in said["error_rule"]["passes"]], [4 * 2 ** k for k in range(len(passes))],
                         "few pixels make the error: all get twice as many")
        self.assertNotIn("(95 %)", passes[0][2], "too few samples to judge")
        self.assertIn("(68 %)", passes[-1][2])
        self.assertIn("(95 %)", passes[-1][2])
        self.assertEqual(said["stop_reason"], "error")
        self.assertEqual(said["mode"], "area")
        self.assertEqual(said["error_rule"]["target"], 0.1)
        truncation = 0.1 * said["error_rule"]["truncation_share"]
        self.assertLess(truncation, 0.02, "a branch more brings a face of glass a tenth of the light that is left")
        self.assertIn(f"at most {truncation:.2g} by light that is not traced", done.stderr)
        self.assertLessEqual(said["error"]["truncation"], truncation)
        last = said["error_rule"]["passes"][-1]
        self.assertLessEqual(last["sampling"], last["sampling_limit"])
        self.assertLessEqual(last["sampling_limit"], 0.1 - truncation)
        before = said["error_rule"]["passes"][-2]["sampling_limit"]
        self.assertTrue(before is None or before > 0.1 - truncation, "it could have stopped before")
        self.assertEqual(said["error_rule"]["last_to_fall"], "sampling")
        self.assertIn("sampling was the last to fall", done.stdout)
        self.assertEqual(said["camera_samples"], 40 * 40 * said["spp"])
        self.assertEqual((said["spp_mean"], said["spp_wanted"]), (said["spp"], None))

    def test_where_many_pixels_make_the_error_samples_go_to_the_noisy_ones(self):
        done, said = self.render(SCENES / "bench/g1.yaml", "--size", "128x128", "--error", "0.02")
        samples = [p["samples"] for p in said["error_rule"]["passes"]]
        self.assertEqual(samples[0], 4)
        for before, after in zip(samples, samples[1:]):
            self.assertTrue(after >= 1.25 * before or (before, after) == (4, 4), "a quarter more, unless it starts over")
        self.assertEqual(said["spp"], 4)
        self.assertGreater(said["spp_mean"], 4)
        self.assertAlmostEqual(samples[-1], said["spp_mean"])
        self.assertEqual(said["camera_samples"], round(128 * 128 * said["spp_mean"]))
        self.assertEqual(said["stop_reason"], "error")
        self.succeed("maps", "out.exr", "--map", "samples", "-o", "samples.png")

    def test_the_residual_is_refined_where_light_is_missing(self):
        done, said = self.render(*GLASS, "--residual", "0.5", "--error", "0.1")
        self.assertIn("too much light is untraced: residual", done.stderr)
        self.assertLess(said["residual_target"], 0.1)
        self.assertLessEqual(said["error"]["truncation"], 0.1 * said["error_rule"]["truncation_share"])
        # The picture is the one that the settings it ended with make.
        again = (*GLASS, "--mode", "area", "--residual", repr(said["residual_target"]), "--spp", said["spp"])
        self.succeed("render", *again, "-o", "again.exr", "--quiet")
        for name in ("out", "again"):
            self.succeed("maps", f"{name}.exr", "--map", "dop", "-o", f"{name}.png")
        self.assertEqual((self.folder / "out.png").read_bytes(), (self.folder / "again.png").read_bytes())

    def test_light_that_no_residual_brings_out_gets_its_share_of_the_error(self):
        done, said = self.render(SCENES / "bench/nested-balls.yaml", "--size", "128x128", "--error", "0.03")
        rule = said["error_rule"]
        self.assertEqual(said["stop_reason"], "error")
        self.assertGreater(said["residual_max"], 10 * said["residual_target"], "tails that came to no end")
        self.assertGreater(rule["truncation_share"], 0.05)
        self.assertLessEqual(rule["truncation_share"], 0.5)
        self.assertLessEqual(said["error"]["truncation"], 0.03 * rule["truncation_share"])
        self.assertLessEqual(said["error"]["truncation"] + rule["passes"][-1]["sampling_limit"], 0.03)

    def test_in_mode_point_the_bound_is_the_error(self):
        done, said = self.render(*GLASS, "--mode", "point", "--residual", "0.5", "--error", "0.1")
        self.assertEqual((said["mode"], said["spp"], said["error"]["sampling"]), ("point", 1, 0.0))
        # A residual that should do is found before the first sample, so that nothing was ever too large.
        self.assertIn("too much light is untraced: residual", done.stderr)
        self.assertEqual(len(said["error_rule"]["passes"]), 1)
        self.assertLessEqual(said["error"]["truncation"], 0.1)
        self.assertEqual((said["error_rule"]["last_to_fall"], said["stop_reason"]), (None, "error"))

    def test_what_ends_it_before_gives_exit_code_10_and_a_picture(self):
        calcite = (SCENES / "paper-calcite-unpolarized.yaml", "--size", "256x256")
        for options, reason, says in (((*calcite, "--error", "1e-4", "--time", "1"), "time", "time limit"),
                                      ((*GLASS, "--error", "1e-3", "--spp", "4"), "samples", "--spp"),
                                      ((*GLASS, "--error", "1e-3", "--depth", "2"), "truncation", "--depth")):
            with self.subTest(reason):
                done, said = self.render(*options, code=10)
                self.assertEqual(said["stop_reason"], reason)
                self.assertIn(says, done.stderr)
                self.assertIsNone(said["error_rule"]["last_to_fall"])
                self.succeed("maps", "out.exr", "--map", "intensity", "-o", "out.png")

    def test_the_statistics_say_the_samples_that_were_taken(self):
        _, said = self.render(*GLASS, "--mode", "area", "--time", "1")
        self.assertLessEqual(said["spp"], said["spp_mean"])
        self.assertAlmostEqual(said["camera_samples"], 40 * 40 * said["spp_mean"], delta=1e-6 * said["camera_samples"])
        _, said = self.render(*GLASS, "--error", "1e-3", "--spp", "4", code=10)
        self.assertEqual((said["spp"], said["spp_wanted"]), (4, 4))

    def test_nothing_sampled_is_not_done(self):
        done, said = self.render(GLASS[0], "--size", "600x600", "--mode", "area", "--time", "0.001", code=10)
        self.assertEqual(said["spp"], 0)
        self.assertIn("before every pixel had a sample", done.stderr)

    def test_quiet_is_quiet(self):
        done, _ = self.render(*GLASS, "--error", "0.2", "--quiet")
        self.assertEqual((done.stdout, done.stderr), ("", ""))

    def test_an_impossible_error_is_refused(self):
        for error in ("0", "-1", "nan", "inf", "10", "x"):
            with self.subTest(error):
                self.refuse(2, ["--error"], "render", *GLASS, "-o", "out.exr", "--error", error)


if __name__ == "__main__":
    main()
