#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`polariscope compare`: two pictures, what the doctor says of their conventions, and how it ends."""

import json
import math
import unittest

from program import REPOSITORY, SCENES, ProgramTest, main

PICTURES = REPOSITORY / "tests" / "data" / "pictures"
CASES = PICTURES / "cases"
MITSUBA = PICTURES / "mitsuba_exr"
SPHERES = MITSUBA / "spheres.yaml"  # the scene of Mitsuba's pictures, ours
# What a Gaussian pixel filter, which is Mitsuba's, and a box, which is ours, make different at edges; our noise moves the digit.
FILTERS = r"1\.[1-6] %"
PLAIN = CASES / "plain.exr"
SAME, DIFFERENT = 0, 5

# Option that takes the picture for another one, what is said of it, and the way back.
FLIPS = {("--from-handedness", "left"): ("S3 with the other sign", "--from-handedness right"),
         ("--from-y", "down"): ("S2 and S3 with the other sign: its y axis points down", "--from-y up"),
         ("--from-zero", "up"): ("S1 and S2 with the other sign: its azimuth counts from the vertical", "--from-zero right")}


class Compare(ProgramTest):
    def compare(self, code, *arguments):
        """What is printed, and as JSON."""
        done = self.run_program("compare", *arguments)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        self.assertEqual(done.stderr, "")
        as_json = self.run_program("compare", *arguments, "--json")
        self.assertEqual(as_json.returncode, code)
        report = json.loads(as_json.stdout)
        self.assertIn(report["doctor"]["sentence"] + "\n", done.stdout)
        return done.stdout, report


class TwoFiles(Compare):
    def test_a_picture_is_the_same_as_itself(self):
        text, report = self.compare(SAME, PLAIN, PLAIN)
        self.assertIn("\nBoth have the same convention; the pictures are the same up to rounding.\n", text)
        self.assertTrue(text.endswith("\nSAME: all 768 numbers are equal.\n"))
        self.assertIs(report["same"], True)
        self.assertEqual(report["doctor"]["verdict"], "same convention")
        self.assertEqual(report["metrics"]["fro_c"], {"whole": 0.0, "p99": 0.0, "largest": 0.0})
        self.assertEqual((report["numbers"]["numbers"], report["numbers"]["equal"]), (768, 768))

    def test_every_convention_is_named_and_can_be_adopted(self):
        for flip, (says, back) in FLIPS.items():
            with self.subTest(flip[1]):
                text, report = self.compare(DIFFERENT, PLAIN, PLAIN, *flip)
                self.assertIn("\nB has " + says, text)
                self.assertEqual(report["doctor"]["verdict"], "explained")
                self.assertIs(report["same"], False)
                self.assertEqual(report["metrics_with_adoptable"]["fro_c"]["whole"], 0.0)
                text, report = self.compare(SAME, PLAIN, PLAIN, *flip, "--adopt")
                self.assertIn(back, text)
                self.assertIs(report["adopted"], True)
                self.assertEqual(report["adoptable"], {"handedness": "right", "y": "up", "azimuth_zero_deg": 0.0})

    def test_a_converted_picture_is_the_same_for_its_name_says_how_it_is_written(self):
        for flip in (["--handedness", "left"], ["--y", "down"], ["--zero", "up"]):
            with self.subTest(flip[1]):
                self.assertEqual(self.run_program("convert", PLAIN, "-o", "b.npz", "--as", "npz", *flip).returncode, 0)
                self.compare(SAME, PLAIN, "b.npz")

    def test_an_array_that_does_not_say_how_it_is_written_is_found_out(self):
        for flip, says in ((["--handedness", "left"], "S3"), (["--y", "down"], "S2 and S3"), (["--zero", "up"], "S1 and S2")):
            with self.subTest(flip[1]):
                self.run_program("convert", PLAIN, "-o", "b.npy", "--as", "npy", *flip)
                text, _ = self.compare(DIFFERENT, PLAIN, "b.npy")
                self.assertIn(f"\nB has {says} with the other sign", text)
                self.compare(SAME, PLAIN, "b.npy", "--adopt")

    def test_a_crop_is_compared_where_it_lies(self):
        text, report = self.compare(SAME, PLAIN, CASES / "crop.exr")
        self.assertIn("note: Compared are the 8 x 6 pixels that both pictures have.\n", text)
        self.assertEqual(report["numbers"]["numbers"], 8 * 6 * 4)
        self.assertEqual(report["metrics"]["fro_c"]["largest"], 0.0)
        self.assertEqual(report["b"]["first_pixel"], [4, 3])

    def test_what_one_of_them_did_not_measure_is_not_compared_and_that_is_said(self):
        text, report = self.compare(SAME, PLAIN, CASES / "s0only.exr")
        self.assertIn("No polarization is measured in both: only S0 can be compared.", text)
        self.assertTrue(text.endswith("\nSAME in S0, which both know: all 192 numbers are equal.\n"))
        self.assertEqual(report["doctor"]["judged"], [])
        self.assertNotIn("fro_c", report["metrics"])

    def test_a_camera_measures_no_s3_and_nothing_is_said_of_it(self):
        self.run_program("convert", PLAIN, "-o", "camera.png", "--as", "png4")
        photographs = [self.folder / f"camera_{angle}.png" for angle in ("000", "045", "090", "135")]
        text, report = self.compare(SAME, PLAIN, *photographs, "--angles", "0,45,90,135", "--tolerance", "1e-4")
        self.assertIn("S3 is not measured in both: nothing is said of it.", text)
        self.assertEqual(report["doctor"]["judged"], ["S1", "S2"])

    def test_sizes_and_bands_that_do_not_fit_are_refused(self):
        mono = MITSUBA / "mono_luminance_f32.exr"
        self.refuse(2, ["16 x 12", "64 x 64", "whole multiple"], "compare", PLAIN, mono)
        self.refuse(2, ["580 nm", "R, G, B", "--wavelengths 380:780:20"], "compare", PLAIN, CASES / "mitsuba16.exr")
        self.refuse(2, ["'600'", "580 nm"], "compare", PLAIN, PLAIN, "--band", "600")

    def test_what_is_no_pair_of_pictures_is_refused_with_the_way_to_one(self):
        self.refuse(2, ["no pictures", "--scene"], "compare")
        self.refuse(2, ["one picture only", "--scene"], "compare", PLAIN)
        self.refuse(2, ["3 pictures", "--angles"], "compare", PLAIN, PLAIN, PLAIN)
        self.refuse(2, ["is a scene", f"--scene {SPHERES}"], "compare", PLAIN, SPHERES)
        self.refuse(2, ["is a picture", "--scene"], "compare", PLAIN, "--scene", PLAIN)
        self.refuse(2, ["--tolerance", "0.02"], "compare", PLAIN, PLAIN, "--tolerance", "-1")
        self.refuse(3, ["none.exr", "no such file"], "compare", PLAIN, "none.exr")

    def test_a_number_that_is_none_is_not_within_any_tolerance(self):
        text, report = self.compare(DIFFERENT, CASES / "crop-bad.exr", PLAIN, "--tolerance", "1e9")
        self.assertIn("DIFFERENT: 1 of 768 numbers are finite in one picture only", text)
        self.assertIs(report["within_tolerance"], False)


class OfScenes(Compare):
    """Against ours, rendered here."""

    def test_two_renders_of_one_scene_differ_by_chance(self):
        for seed in (1, 2):
            self.succeed("render", SPHERES, "-o", f"{seed}.exr", "--size", "64x64", "--spp", "16", "--seed", seed, "--quiet")
        text, report = self.compare(SAME, "1.exr", "2.exr")
        self.assertIn("Against the error bars of both pictures:", text)
        self.assertIn("SAME: all differences are chance by the error bars.", text)
        self.assertLess(report["numbers"]["equal"], report["numbers"]["numbers"])

    def test_a_scene_alone_is_rendered_and_compared(self):
        self.succeed("render", SCENES / "cube-glass.yaml", "-o", "cube.exr", "--size", "64x64", "--quiet")
        text, report = self.compare(SAME, "cube.exr", "--scene", SCENES / "cube-glass.yaml")
        self.assertEqual(report["a"]["file"], str(SCENES / "cube-glass.yaml"))
        text, _ = self.compare(DIFFERENT, "cube.exr", "--scene", SPHERES)
        self.assertRegex(text, "\nThese are not pictures of the same view|\nNo convention explains|\nOnly one of the")


class Mitsuba(Compare):
    """Pictures of Mitsuba 3.9.1 against ours of the same scene. Correlations of another implementation: 0.996, 0.996,
    0.980 for S1, S2, S3, scale 1.0003; significance in the hundreds."""

    def assert_same_convention(self, report):
        doctor = report["doctor"]
        self.assertEqual(doctor["verdict"], "same convention")
        self.assertEqual((doctor["signs"], doctor["order"], doctor["geometry"]), ([1, 1, 1], [1, 2, 3], "same"))
        self.assert_significant(doctor)

    def assert_significant(self, doctor):
        for component, expected in (("S1", 0.996), ("S2", 0.996), ("S3", 0.980)):
            # 1 - r is half the square of noise by light: at most twice that of the other implementation's render.
            self.assertGreater(doctor["correlation"][component], 1 - 2 * (1 - expected))
            self.assertGreaterEqual(doctor["z"][component], 6)  # decided
        self.assertEqual(doctor["undecided"], [])

    def test_one_wavelength_agrees_in_half_and_in_single_precision(self):
        for name in ("mono_luminance_f32", "mono_luminance_f16"):
            with self.subTest(name):
                text, report = self.compare(DIFFERENT, MITSUBA / f"{name}.exr", "--scene", SPHERES)
                self.assertRegex(text, rf"\nBoth have the same convention; the pictures agree to {FILTERS}\.\n")
                self.assertIn("note: 580 nm of A is taken for what mono of B is.", text)
                self.assertRegex(text, rf"DIFFERENT: by {FILTERS} of the light;")
                self.assertIn("B has no error bars: its noise is a difference. --tolerance says how much is allowed.", text)
                self.assert_same_convention(report)
                # Six standard errors of a mean over boxes.
                noise = report["metrics"]["rel_rmse_s0"]["whole"] / math.sqrt(report["doctor"]["boxes"])
                self.assertAlmostEqual(report["doctor"]["scale"], 1.0003, delta=6 * noise)

    def test_a_tolerance_takes_the_noise_for_the_same(self):
        picture = MITSUBA / "mono_luminance_f32.exr"
        text, report = self.compare(SAME, picture, "--scene", SPHERES, "--tolerance", "0.02")
        self.assertRegex(text, rf"WITHIN TOLERANCE: they are apart by {FILTERS} of the light, 2 % is allowed\.")
        self.assertEqual((report["same"], report["within_tolerance"]), (False, True))
        self.assertAlmostEqual(report["numbers"]["distance"], report["metrics"]["fro_c"]["whole"], delta=1e-12)
        self.compare(DIFFERENT, picture, "--scene", SPHERES, "--tolerance", "0.01")

    def test_colors_agree_although_ours_is_written_for_one_wavelength(self):
        text, report = self.compare(DIFFERENT, MITSUBA / "spectral_rgb_f32.exr", "--scene", SPHERES)
        self.assertRegex(text, rf"\nBoth have the same convention; the pictures agree to {FILTERS}\.")
        self.assertIn("note: Compared are linear sRGB colors", text)
        self.assertEqual(report["bands"], ["R", "G", "B"])
        self.assert_same_convention(report)

    def test_the_other_handedness_is_named_and_no_tolerance_excuses_it(self):
        for name in ("mono_luminance_f32", "spectral_rgb_f32"):
            with self.subTest(name):
                flipped = [MITSUBA / f"{name}.exr", "--scene", SPHERES, "--from-handedness", "left"]
                text, report = self.compare(DIFFERENT, *flipped, "--tolerance", "0.2")
                self.assertRegex(text, "\nB has S3 with the other sign: it uses the source's view, or the handedness of radio "
                                 rf"and IEEE; with that the pictures agree to {FILTERS}\. Set handedness: right for B\?")
                self.assertEqual(report["doctor"]["signs"], [1, 1, -1])
                self.assert_significant(report["doctor"])
                self.compare(SAME, *flipped, "--tolerance", "0.2", "--adopt")


if __name__ == "__main__":
    main()
