#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""polariscope plan --ablate: what leaving code out saves, as people and as programs read it."""

import json
import signal
import unittest

from program import SCENES, ProgramTest, main

GLASS = SCENES / "cube-glass.yaml"
SHORT = ("--ablate", "--size", "8x6", "--rounds", "1")


class Ablation(ProgramTest):
    def test_every_feature_stands_in_the_table_with_what_it_saved(self):
        done = self.run_program("plan", GLASS, *SHORT)
        self.assertEqual(done.returncode, 0, done.stderr)
        for feature in ("crystals (o and e rays)", "absorption along rays", "shared faces", "all of them together"):
            self.assertRegex(done.stdout, rf"(?m)^{feature.replace('(', '.').replace(')', '.')} .* %  same bits$")
        self.assertRegex(done.stdout, r"(?m)^Embree scene .* % of the pixels agree$")
        self.assertRegex(done.stdout, r"(?ms)^no code would run for$.*^  metals +no conductor$")
        self.assertIn("progress", done.stderr)

    def test_programs_read_it_as_json_and_progress_is_not_in_it(self):
        done = self.run_program("plan", GLASS, *SHORT, "--json", "--wavelengths", "450,650")
        self.assertEqual(done.returncode, 0, done.stderr)
        report = json.loads(done.stdout)
        self.assertEqual((report["width"], report["height"], report["samples"], report["holds"]), (8, 6, 1, True))
        plan = json.loads(self.succeed("plan", GLASS, "--json", "--wavelengths", "450,650"))
        left_out = [row["name"] for row in plan["features"] if not row["needed"]]
        told = [row["feature"] for part in ("features", "not_keepable", "nothing_to_keep") for row in report[part]]
        self.assertEqual(sorted(told), sorted(left_out), "whatever plan lists as left out, and each once")
        for row in report["features"]:
            self.assertTrue(row["holds"])
            self.assertAlmostEqual(row["saved"], 1 - 1 / row["ratio"])
            if "agreement" not in row:
                self.assertEqual(row["hash"], report["hash"], row["feature"])

    def test_it_is_short_and_silent_where_nothing_else_is_asked(self):
        self.assertIn("all of them together", self.succeed("plan", GLASS, "--ablate", "--rounds", "1", "--quiet"))

    def test_what_makes_no_sense_is_refused(self):
        self.refuse(2, ["--rounds", "goes with --ablate"], "plan", GLASS, "--rounds", "3")
        self.refuse(2, ["--quiet", "goes with --ablate"], "plan", GLASS, "--quiet")
        self.refuse(2, ["--rounds", "1 to 1000"], "plan", GLASS, "--ablate", "--rounds", "0")
        self.refuse(2, ["--size"], "plan", GLASS, "--ablate", "--size", "0x1")
        self.refuse(3, ["missing.yaml"], "plan", "missing.yaml", "--ablate")

    def test_ctrl_c_ends_it(self):
        process = self.start_program("plan", GLASS, "--ablate", "--size", "2000x2000", "--rounds", "1000")
        self.assertIn("progress", process.stderr.readline())
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(60), 130)
        self.assertEqual(process.stdout.read(), "")
        self.assertIn("stopped", process.stderr.read())


if __name__ == "__main__":
    main()
