#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Pictures of other programs at the command line: what `check`, `maps` and `convert` say of them. The cases are those of
the samples in tests/data/pictures/cases."""

import json
import re
import shutil
import unittest

from program import REPOSITORY, SCENES, ProgramTest, main

PICTURES = REPOSITORY / "tests" / "data" / "pictures"
CASES = PICTURES / "cases"
MITSUBA = PICTURES / "mitsuba_exr"
NO_FRAME = "assumed: azimuth is taken from image right, counter-clockwise: the file does not say"


class Pictures(ProgramTest):
    def checked(self, code, *arguments):
        """What `check` prints, and its JSON."""
        done = self.run_program("check", *arguments)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        self.assertEqual(done.stderr, "")
        as_json = self.run_program("check", *arguments, "--json")
        self.assertEqual(as_json.returncode, code)
        return done.stdout, json.loads(as_json.stdout)

    def assert_polarized_by(self, expected, report):
        """Everywhere, to the rounding of 32-bit floats."""
        self.assertEqual((report["dop"]["lit"], report["dop"]["dark"]), (16 * 12, 0))
        self.assertEqual(report["dop"]["measured"], 16 * 12)
        for what in ("least", "median", "most", "mean"):
            self.assertAlmostEqual(report["dop"][what], expected, delta=1e-6)


class StokesChannels(Pictures):
    """Case 01."""

    def test_components_without_a_band_are_read_and_what_is_assumed_is_said(self):
        text, report = self.checked(0, CASES / "mono4.exr")
        self.assertIn("16x12 pixels, 1 band\nread as: Stokes components without a band\n" + NO_FRAME, text)
        self.assert_polarized_by(0.8, report)
        self.assertEqual(report["assumed"], [NO_FRAME.removeprefix("assumed: ")])

    def test_mitsubas_picture_of_one_band_is_read(self):
        self.run_program("convert", CASES / "mono4.exr", "-o", "mitsuba.exr", "--as", "mitsuba")
        text, report = self.checked(0, "mitsuba.exr")
        self.assertIn("read as: Mitsuba 3, mono\n", text)
        self.assertNotIn("assumed:", text)  # convert says in the file which convention it wrote
        self.assertEqual(report["bands"], ["mono"])
        self.assert_polarized_by(0.8, report)

    def test_bands_of_mitsuba_stand_in_place_of_wavelengths_and_their_luminance_is_judged(self):
        # The samples have P = 0.8 in band R alone: G and B hold the four numbers in other orders, which no light has.
        for name in ("mitsuba16.exr", "mitsuba13.exr"):
            with self.subTest(name):
                text, report = self.checked(5, CASES / name)
                self.assertIn("16x12 pixels, 3 bands\nread as: Mitsuba 3, RGB\n", text)
                self.assertIn("the luminance is judged", text)
                self.assertEqual(report["bands"], ["R", "G", "B"])
                self.succeed("maps", CASES / name, "--map", "dop", "--band", "R", "-o", "dop.png")

    def test_every_picture_that_mitsuba_wrote_is_light(self):
        for name in ("mono_luminance_f16", "mono_luminance_f32", "spectral_rgb_f16", "spectral_rgb_f32",
                     "spectral_luminance_f32", "scalar_spectral_rgba_f16", "tensor_unnamed_f32"):
            with self.subTest(name):
                _, report = self.checked(0, MITSUBA / f"{name}.exr")
                self.assertTrue(report["physical"])

    def test_a_band_is_drawn_by_its_name_and_a_wrong_name_gets_the_right_ones(self):
        picture = MITSUBA / "spectral_rgb_f32.exr"
        drawn = set()
        for band in ("R", "G", "B"):
            self.succeed("maps", picture, "--map", "dop", "--band", band, "--plain", "-o", "dop.png")
            self.assertEqual(self.png_size("dop.png"), (64, 64))
            drawn.add((self.folder / "dop.png").read_bytes())
        self.assertEqual(len(drawn), 3)
        self.refuse(2, ["'X'", "R, G, B"], "maps", picture, "--map", "dop", "--band", "X", "-o", "x.png")
        self.refuse(2, ["without wavelengths", "--band"], "maps", picture, "--map", "dop", "--wavelength", "580", "-o",
                    "x.png")
        self.refuse(2, ["'R'", "580 nm"], "maps", CASES / "plain.exr", "--map", "dop", "--band", "R", "-o", "x.png")


    def test_what_was_not_measured_is_no_reference_of_convergence(self):
        done = self.run_program("converge", SCENES / "crossed-polarizers.yaml", "-o", "runs", "--size", "16x12",
                                "--wavelengths", "580", "--reference", CASES / "s0only.exr")
        self.assertEqual(done.returncode, 2)
        self.assertIn("does not have all Stokes components at 580 nm", done.stderr)

    def test_a_bound_of_a_picture_that_has_none_is_not_drawn_without_a_word(self):
        for name in ("residual", "dop_error", "ellipticity_error", "azimuth_error"):
            with self.subTest(name):
                done = self.run_program("maps", MITSUBA / "mono_luminance_f32.exr", "--map", name, "-o", "map.png")
                self.assertEqual(done.returncode, 0)
                self.assertIn(f"'{name}' is not known: the picture has no residual", done.stderr)
        self.succeed("maps", MITSUBA / "mono_luminance_f32.exr", "--map", "dop", "-o", "map.png")


class Crops(Pictures):
    """Case 02."""

    def test_the_worst_pixel_is_one_of_the_picture_not_of_the_crop(self):
        text, report = self.checked(5, CASES / "crop-bad.exr")
        self.assertRegex(text, r"\nnot a number or infinite +1  FAIL   worst: pixel 63,42 at 580 nm, S0 = nan\n")
        self.assertIn("16x12 pixels from pixel 60,40 of the picture on", text)
        self.assertEqual(report["first_pixel"], [60, 40])
        self.assertEqual([one["worst"]["pixel"] for one in report["defects"] if one["count"]], [[63, 42]])

    def test_a_pixel_that_is_no_number_is_drawn_and_counted(self):
        done = self.run_program("maps", CASES / "crop-bad.exr", "--map", "dop", "--plain", "-o", "dop.png")
        self.assertEqual(done.returncode, 0)
        self.assertIn("1 pixels of 'dop' are not a number", done.stderr)
        self.assertEqual(self.png_size("dop.png"), (16, 12))


class Parts(Pictures):
    """Case 03."""

    def test_channels_of_all_parts_are_gathered(self):
        for name in ("parts-each.exr", "parts-rgb-first.exr"):
            with self.subTest(name):
                text, report = self.checked(0, CASES / name)
                self.assertIn("16x12 pixels, 1 wavelength\nread as: spectral layout\n", text)
                self.assertEqual(report["bands"], ["580 nm"])
                self.assert_polarized_by(0.8, report)


class WhatIsNotRead(Pictures):
    """Case 04."""

    def test_subsampled_channels_are_refused_by_that_name(self):
        says = ["channel S1.580,000000nm has sampling 2 x 2; only full resolution is read",
                "write all channels at full resolution"]
        picture = CASES / "subsampled.exr"
        for command in (["check", picture], ["maps", picture, "--map", "dop", "-o", "x.png"],
                        ["compare", CASES / "plain.exr", picture], ["convert", picture, "-o", "x.npy", "--as", "npy"]):
            with self.subTest(command[0]):
                self.assertNotIn("damaged", self.refuse(3, says, *command))


class WithoutPolarization(Pictures):
    """Case 06."""

    def test_what_was_not_measured_is_unknown_and_not_unpolarized(self):
        text, report = self.checked(0, CASES / "s0only.exr")
        for component in ("S1", "S2", "S3"):
            self.assertIn(f"note: {component} was not measured: what depends on it is unknown, not 0", text)
        self.assertNotIn("degree of polarization", text)
        self.assertEqual(report["dop"]["measured"], 0)

    def test_its_color_is_drawn_and_its_maps_of_polarization_say_why_they_are_empty(self):
        picture = CASES / "s0only.exr"
        self.succeed("maps", picture, "--map", "color", "-o", "color.png")
        done = self.run_program("maps", picture, "--map", "dop", "-o", "dop.png")
        self.assertEqual(done.returncode, 0)
        self.assertIn("'dop' needs a Stokes component that was not measured", done.stderr)


class LossyCompression(Pictures):
    """Case 09."""

    def test_rounding_by_pxr24_is_allowed_and_named(self):
        text, report = self.checked(0, CASES / "pxr24.exr")
        self.assertIn("note: an excess of |s| over S0 up to 3.1e-05 comes from PXR24, which keeps 24 bits", text)
        self.assertNotIn("32-bit", text)
        self.assertEqual(report["bits"], 24)

    def test_what_b44_loses_is_named_as_its_loss(self):
        text, report = self.checked(5, CASES / "b44.exr")
        self.assertIn("may come from B44, a lossy compression: write ZIP or PIZ", text)
        self.assertEqual(report["lossy_compression"], "B44")


class Wilkie(Pictures):
    def test_the_four_pictures_have_the_names_that_polvis_gives_them(self):
        self.succeed("maps", MITSUBA / "mono_luminance_f32.exr", "--style", "wilkie", "-o", "maps")
        self.assertEqual(sorted(self.files()),
                         [f"maps/mono_luminance_f32_{kind}.png" for kind in ("cir", "dop", "lin", "top")])

    def test_nothing_is_left_where_a_picture_has_not_measured_what_they_need(self):
        self.refuse(3, ["S0 to S3"], "maps", CASES / "s0only.exr", "--style", "wilkie", "-o", "maps")
        self.assertFalse((self.folder / "maps").exists())

    def test_a_name_of_a_picture_is_no_folder(self):
        for options in (["--style", "wilkie"], ["--map", "all"]):
            with self.subTest(options[-1]):
                self.refuse(2, ["maps.png", "folder"], "maps", CASES / "plain.exr", *options, "-o", "maps.png")


class WrongInput(Pictures):
    def test_layouts_are_listed_and_one_that_does_not_fit_says_what_is_there(self):
        picture = CASES / "plain.exr"
        self.refuse(2, ["no layout 'mitsba'", "spectral, mitsuba"], "check", picture, "--layout", "mitsba")
        self.refuse(3, ["layout mitsuba", "S0.580,000000nm"], "check", picture, "--layout", "mitsuba")

    def test_content_decides_whatever_the_name(self):
        for name in ("noending", "picture.txt", "picture.yaml.bak"):
            shutil.copyfile(CASES / "plain.exr", self.folder / name)
            self.assertIn("spectral layout", self.succeed("check", name))

    def test_a_name_cannot_speak_to_the_terminal(self):
        shutil.copyfile(CASES / "plain.exr", self.folder / "\x1b[31mred.exr")
        text = self.succeed("check", "\x1b[31mred.exr")
        self.assertTrue(text.startswith("\\x1b[31mred.exr: "), text)

    def test_two_files_are_no_picture(self):
        self.refuse(2, ["2 files", "--angles"], "check", CASES / "plain.exr", CASES / "crop.exr")

    def test_a_picture_is_never_written_over_itself(self):
        shutil.copy(CASES / "plain.exr", self.folder / "in.exr")
        self.refuse(2, ["would be written over"], "convert", "in.exr", "-o", "in.exr", "--as", "spectral")

    def test_a_broken_file_is_refused_wherever_it_is_cut(self):
        content = (CASES / "plain.exr").read_bytes()
        for length in (0, 4, 8, 60, 300, len(content) // 2, len(content) - 1):
            with self.subTest(length):
                self.write("cut.exr", content[:length])
                self.refuse(3, ["cut.exr"], "check", "cut.exr", "--layout", "spectral")
                self.refuse(3, ["cut.exr"], "compare", CASES / "plain.exr", "cut.exr")

    def test_help_lists_every_layout_and_says_how_to_save_from_mitsuba(self):
        text = self.succeed("convert", "--help")
        for name in ("spectral", "mitsuba", "wave_tracer", "mosaic"):
            self.assertRegex(text, rf"\n  {name} +\w")
        self.assertIn("mi.Bitmap(img, channel_names=['R','G','B'] + scene.integrator().aov_names()).write('x.exr')",
                      re.sub(r"\s+", " ", text))


if __name__ == "__main__":
    main()
