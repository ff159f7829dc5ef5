#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`polariscope check`: what it prints, what it writes, and how it ends."""

import json
import re
import unittest

from program import SCENES, ProgramTest, main


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


class Stiff(ProgramTest):
    def test_cases_are_chosen_by_name_or_group_and_end_in_a_verdict(self):
        text = self.succeed("check", "stiff", "--sweep", "states", "--sweep", "grazing-glass")
        self.assertRegex(text, r"\nincidence +grazing-glass .* sound\n")
        self.assertRegex(text, r"\nstates +almost-unpolarized .* sound\n")
        self.assertIn("6 of 6 cases are sound", text)

    def test_json_has_every_point_with_its_inputs(self):
        report = json.loads(self.succeed("check", "stiff", "--sweep", "dark", "--json"))
        (case,) = report["cases"]
        self.assertGreaterEqual(len(case["points"]), 12)
        for point in case["points"]:
            self.assertLessEqual(point["error"], point["limit"] * point["condition"])
            self.assertEqual(len(point["inputs"]), 4)
        self.assertEqual(case["group"], "states")
        self.assertIn("biaxial, on an optic axis", [one["subject"] for one in report["untested"]])

    def test_a_folder_gets_plots_and_one_page_with_all_of_them(self):
        self.succeed("check", "stiff", "--sweep", "dark", "-o", "report")
        self.assertEqual(sorted(self.files()), ["report/dark.svg", "report/stiff.html"])
        page = (self.folder / "report" / "stiff.html").read_text()
        self.assertIn((self.folder / "report" / "dark.svg").read_text(), page)
        self.assertNotIn("http", page.replace("http://www.w3.org/2000/svg", ""))

    def test_a_case_that_does_not_exist_is_refused_with_a_hint(self):
        self.refuse(2, ["darc", "did you mean 'dark'"], "check", "stiff", "--sweep", "darc")
        self.refuse(2, ["inzidence", "did you mean 'incidence'"], "check", "stiff", "--sweep", "inzidence")
        self.refuse(2, ["33", "axis, incidence, index"], "check", "stiff", "--sweep", "33")
        self.write("file", "")
        self.refuse(4, ["file", "folder"], "check", "stiff", "--sweep", "dark", "-o", "file")


class Files(ProgramTest):
    def test_a_scene_keeps_all_invariants(self):
        text = self.succeed("check", SCENES / "cube-glass.yaml", "--size", 8)
        self.assertIn("\nreciprocity ", text)
        self.assertNotIn("FAIL", text)
        report = json.loads(self.succeed("check", SCENES / "cube-glass.yaml", "--size", 8, "--json"))
        outcomes = {entry["name"]: entry["outcome"] for entry in report["invariants"]}
        self.assertEqual(outcomes.pop("isotropic twin"), "does not apply")
        self.assertEqual(set(outcomes.values()), {"pass"})
        self.assertEqual(report["invariants"][0]["tested"], 64)

    def test_light_along_an_axis_that_grazes_a_face_keeps_its_energy(self):
        # The axis is 1e-12 rad from the line of sight, the slope of the prism 0.86 degrees from it.
        self.write("grazing.yaml", """
camera: {type: orthographic, position: [0, 0, 10], target: [0, 0, 0], up: [0, 1, 0], width: 3}
background: 1
media:
  spar: {crystal: calcite, axis: [1e-12, 0, 1], axis_space: world}
objects:
  - name: wedge
    shape: {extrusion: {polygon: [[-1, -40], [-0.5, -40], [0.1, 0], [-1, 0]], height: 1}}
    transform: [{rotate: {axis: [1, 0, 0], angle: 90}}]
    medium: spar
""")
        # A sample whose energy does not add up ends the program with 5. Of o and e by themselves nothing is asked: so near
        # the axis their directions are known to 1e-4.
        self.succeed("render", "grazing.yaml", "-o", "grazing.exr", "--size", "24x24")

    def test_the_command_that_shows_the_worst_pixel_works(self):
        report = json.loads(self.succeed("check", SCENES / "cube-glass.yaml", "--size", 8, "--json"))
        command = report["invariants"][0]["explain"].split()
        self.assertEqual(command[:2], ["polariscope", "explain"])
        self.succeed(*command[1:])

    def test_a_picture_of_ours_is_light(self):
        self.succeed("render", SCENES / "cube-glass.yaml", "-o", "cube.exr", "--size", "24x24", "--quiet")
        text = self.succeed("check", "cube.exr")
        self.assertIn("cube.exr: 24x24 pixels", text)
        self.assertEqual(text.count("pass"), 3)
        report = json.loads(self.succeed("check", "cube.exr", "--json"))
        self.assertTrue(report["physical"])
        self.assertEqual([defect["count"] for defect in report["defects"]], [0, 0, 0])
        self.assertEqual(report["dop"]["lit"] + report["dop"]["dark"], 24 * 24 * len(report["wavelengths_nm"]))

    def test_what_is_no_scene_and_no_picture_is_refused(self):
        self.write("broken.exr", b"no picture")
        self.write("broken.yaml", "camera: 3")
        self.refuse(3, ["broken.exr"], "check", "broken.exr")
        self.refuse(3, ["broken.yaml:1"], "check", "broken.yaml")
        self.refuse(3, ["missing.exr"], "check", "missing.exr")


if __name__ == "__main__":
    main()
