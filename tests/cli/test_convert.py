#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`polariscope convert`: every form of a picture comes back, says what it loses, or is refused with a reason."""

import array
import json
import struct
import sys
import unittest

from program import REPOSITORY, ProgramTest, main

SAMPLES = REPOSITORY / "tests" / "data" / "pictures" / "stokes_dialects"
ENDINGS = {"spectral": ".exr", "mitsuba": ".exr", "npy": ".npy", "npz": ".npz", "four": ".exr", "png4": ".png", "fits": ".fits"}


def npy(shape, numbers):
    """A picture as numpy writes it: little-endian 64-bit floats."""
    header = f"{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}, }}\n".encode()
    numbers = array.array("d", numbers)
    if sys.byteorder == "big":
        numbers.byteswap()
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header + numbers.tobytes()


def numbers_of(content):
    """Shape's text and the numbers of an .npy of 64-bit floats."""
    length = struct.unpack("<H", content[8:10])[0]
    header = content[10 : 10 + length].decode()
    numbers = array.array("d", content[10 + length :])
    if sys.byteorder == "big":
        numbers.byteswap()
    return header[header.index("'shape'") :], numbers.tolist()


class Convert(ProgramTest):
    def convert(self, source, form, name, *options):
        """What stderr says; of several files, `name` is what their names begin with."""
        done = self.run_program("convert", source, "-o", name + ENDINGS[form], "--as", form, *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout, "")
        return done.stderr

    def picture(self):
        """5 x 2 pixels of one band, all numbers floats and different."""
        numbers = []
        for pixel in range(10):
            size = 1.0 + pixel / 8.0
            numbers += [size, size / 2.0, -size / 4.0, size / 8.0]
        self.write("picture.npy", npy((2, 5, 4), numbers))
        return numbers

    def test_each_form_of_one_band_comes_back_to_the_bit(self):
        numbers = self.picture()
        for form, first in (("spectral", "x.exr"), ("mitsuba", "x.exr"), ("npz", "x.npz"), ("four", "x_I.exr"), ("fits", "x.fits")):
            with self.subTest(form):
                self.assertNotIn("lost", self.convert("picture.npy", form, "x"))
                self.convert(first, "npy", "back")
                shape, found = numbers_of((self.folder / "back.npy").read_bytes())
                self.assertIn("(1, 2, 5, 4)", shape)
                self.assertEqual(found, numbers)

    def test_photographs_say_what_they_lose(self):
        self.picture()
        said = self.convert("picture.npy", "png4", "x")
        self.assertIn("lost: S3", said)
        self.assertIn("65535th", said)
        self.assertEqual(sorted(name for name in self.files() if name.startswith("x")),
                         ["x_000.png", "x_045.png", "x_090.png", "x_135.png"])
        self.assertIn("Linear polarizers measure no S3", self.convert("x_000.png", "npz", "back"))

    def test_another_convention_is_written_named_and_read_back(self):
        numbers = self.picture()
        for form, first in (("mitsuba", "x.exr"), ("npz", "x.npz"), ("four", "x_I.exr"), ("fits", "x.fits")):
            for options in (["--handedness", "left"], ["--zero", "up"], ["--y", "down"], ["--handedness", "left", "--y", "down"]):
                with self.subTest(form, options=options):
                    self.assertNotIn("lost", self.convert("picture.npy", form, "x", *options))
                    self.assertNotIn("assumed", self.convert(first, "npy", "back"))
                    self.assertEqual(numbers_of((self.folder / "back.npy").read_bytes())[1], numbers)

    def test_the_numbers_of_a_file_without_names_are_in_the_convention_asked_for(self):
        numbers = self.picture()
        self.convert("picture.npy", "npy", "left", "--handedness", "left")
        found = numbers_of((self.folder / "left.npy").read_bytes())[1]
        self.assertEqual(found[3::4], [-s3 for s3 in numbers[3::4]])
        self.assertEqual(found[2::4], numbers[2::4])
        self.convert("left.npy", "npy", "back", "--from-handedness", "left")
        self.assertEqual(numbers_of((self.folder / "back.npy").read_bytes())[1], numbers)

    def test_what_is_assumed_of_the_input_is_said_once_and_kept(self):
        self.picture()
        self.assertIn("assumed: The azimuth counts from image right", self.convert("picture.npy", "spectral", "x"))
        report = json.loads(self.run_program("check", "x.exr", "--json").stdout)
        self.assertEqual(len(report["assumed"]), 1)

    def test_samples_of_other_programs_are_converted(self):
        for name in ("mitsuba_tensor_f4.npy", "iquv_iau.fits", "wt_rgb_I.exr"):
            with self.subTest(name):
                self.assertNotIn("lost", self.convert(SAMPLES / name, "npz", "x"))
                self.assertNotIn("lost", self.convert(SAMPLES / name, "mitsuba", "x"))
        self.assertNotIn("lost", self.convert(SAMPLES / "named.npz", "npz", "x"))
        self.assertIn("rounded to 32-bit floats", self.convert(SAMPLES / "named.npz", "mitsuba", "x"))


class Refusals(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("picture.npy", npy((2, 5, 4), [1.0, 0.5, 0.0, 0.0] * 10))
        self.write("linear.npy", npy((2, 5, 3), [1.0, 0.5, 0.0] * 10))

    def refuse_to_convert(self, says, *arguments, code=2):
        return self.refuse(code, says, "convert", *arguments)

    def test_an_unknown_form_names_those_that_there_are(self):
        self.refuse_to_convert(list(ENDINGS), "picture.npy", "-o", "x.exr", "--as", "tiff")
        self.refuse_to_convert(["--as"], "picture.npy", "-o", "x.exr")

    def test_the_ending_is_that_of_the_form(self):
        for form, ending in ENDINGS.items():
            self.refuse_to_convert([ending], "picture.npy", "-o", "x.txt", "--as", form)

    def test_no_input_is_written_over(self):
        self.refuse_to_convert(["picture.npy", "written over"], "picture.npy", "-o", "picture.npy", "--as", "npy")
        (self.folder / "link.npy").symlink_to("picture.npy")
        self.refuse_to_convert(["written over"], "picture.npy", "-o", "link.npy", "--as", "npy")
        self.run_program("convert", "picture.npy", "-o", "x.exr", "--as", "four")
        self.refuse_to_convert(["x_I.exr", "written over"], "--stokes", "s0=x_I.exr", "-o", "x.exr", "--as", "four")

    def test_what_a_form_cannot_hold_is_refused_with_another_form(self):
        self.refuse_to_convert(["--as", "S0 to S3", "npz"], "linear.npy", "-o", "x.exr", "--as", "mitsuba")
        self.refuse_to_convert(["--half"], "picture.npy", "-o", "x.npz", "--as", "npz", "--half")
        self.refuse_to_convert(["convention"], "picture.npy", "-o", "x.exr", "--as", "spectral", "--handedness", "left")

    def test_a_missing_folder_and_a_missing_input_are_told_apart(self):
        for form, ending in ENDINGS.items():
            self.refuse_to_convert(["none/x"], "picture.npy", "-o", "none/x" + ending, "--as", form, code=4)
        self.refuse_to_convert(["missing.npy"], "missing.npy", "-o", "x.npz", "--as", "npz", code=3)


if __name__ == "__main__":
    main()
