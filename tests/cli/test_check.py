#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`polariscope check`: what it prints, what it writes, and how it ends."""

import json
import re
import unittest

from program import ProgramTest, main


class Facts(ProgramTest):
    def test_all_facts_hold_and_stand_in_a_readable_table(self):
        text = self.succeed("check", "facts")
        self.assertRegex(text, r"\n\d+ facts hold, 0 fail, 4 are not modelled\.")
        self.assertLessEqual(max(map(len, text.splitlines())), 120)
        for number in range(1, 51):
            self.assertRegex(text, rf"\nT{number} +[A-Z]")
        self.assertEqual(len(re.findall(r"\n +not modelled: .", text)), 4)
        self.assertNotIn("FAIL", text)

    def test_json_has_every_reading_with_its_tolerance(self):
        report = json.loads(self.succeed("check", "facts", "--json"))
        self.assertEqual((report["failed"], report["not_modelled"]), (0, 4))
        self.assertEqual(report["passed"] + 4, len(report["facts"]))
        for fact in report["facts"]:
            self.assertEqual(fact["verdict"] == "not modelled", fact["readings"] == [])
            for reading in fact["readings"]:
                with self.subTest(f"{fact['id']} {reading['view']}: {reading['what']}"):
                    difference = abs(reading["measured"] - reading["expected"])
                    self.assertLessEqual(difference, reading["tolerance"])
                    self.assertNotEqual(reading["tolerance_from"], "")

    def test_facts_are_chosen_by_id_in_any_case_and_order(self):
        text = self.succeed("check", "facts", "t9", "T3", "T9")
        self.assertEqual(re.findall(r"\n(T\d+) ", text), ["T3", "T9"])

    def test_scenes_are_written_with_what_they_show_and_can_be_explained(self):
        self.assertEqual(self.succeed("check", "facts", "T20", "T40", "--scenes", "facts"), "")
        self.assertEqual(list(self.files()), ["facts/T20-1.yaml"])
        scene = (self.folder / "facts" / "T20-1.yaml").read_text()
        self.assertIn("# radiance: 0.426666666666667\n", scene)
        command = re.search(r"polariscope (explain .*)", scene).group(1).split()
        tree = json.loads(self.succeed(*command, "--json"))
        self.assertAlmostEqual(tree["stokes"][0], 0.96 / 2.25, delta=1e-14)

    def test_scenes_go_into_a_folder(self):
        self.write("file", "")
        self.refuse(4, ["file", "folder"], "check", "facts", "T1", "--scenes", "file")


if __name__ == "__main__":
    main()
