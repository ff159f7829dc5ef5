#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The command line itself: help that is true, and exit code 2 for what cannot be asked."""

import re
import shlex
import unittest

from program import REPOSITORY, SCENES, ProgramTest, main

COMMANDS = ("render", "maps", "compare", "send", "convert", "explain", "interface", "plan", "check", "converge", "view", "manual")
GLASS = SCENES / "cube-glass.yaml"

BAD_USAGE = [
    ((), "subcommand"),
    (("rendr",), "'render'"),
    (("--versoin",), "'--version'"),
    (("render", GLASS, "-o", "out.exr", "--sise", "8x8"), "'--size'"),
    (("render", GLASS), "--output"),
    (("render", "-o", "out.exr"), "SCENE"),
    (("render", GLASS, GLASS, "-o", "out.exr"), "not expected"),
    (("render", GLASS, "-o", "out.exr", "--size"), "--size"),
    (("render", GLASS, "-o", "out.exr", "--size", "8"), "--size"),
    (("render", GLASS, "-o", "out.exr", "--size", "8x"), "--size"),
    (("render", GLASS, "-o", "out.exr", "--size", "0x8"), "--size"),
    (("render", GLASS, "-o", "out.exr", "--size", "-8x8"), "--size"),
    (("render", GLASS, "-o", "out.exr", "--size", "1000000000x1000000000"), "--size"),
    (("render", GLASS, "-o", "out.exr", "--size", "65536x65536"), "2^31"),
    (("render", GLASS, "-o", "out.exr", "--spp", "0"), "--spp"),
    (("render", GLASS, "-o", "out.exr", "--spp", "many"), "--spp"),
    (("render", GLASS, "-o", "out.exr", "--spp", "1e99"), "--spp"),
    (("render", GLASS, "-o", "out.exr", "--mode", "pont"), "point"),
    (("render", GLASS, "-o", "out.exr", "--residual", "nan"), "--residual"),
    (("render", GLASS, "-o", "out.exr", "--residual", "-1"), "--residual"),
    (("render", GLASS, "-o", "out.exr", "--residual", "2"), "--residual"),
    (("render", GLASS, "-o", "out.exr", "--depth", "-1"), "--depth"),
    (("render", GLASS, "-o", "out.exr", "--node-budget", "0"), "--node-budget"),
    (("render", GLASS, "-o", "out.exr", "--wavelengths", "blue"), "--wavelengths"),
    (("render", GLASS, "-o", "out.exr", "--wavelengths", "780:380:20"), "--wavelengths"),
    (("render", GLASS, "-o", "out.exr", "--wavelengths", "380:780:0"), "--wavelengths"),
    (("render", GLASS, "-o", "out.exr", "--wavelengths", "380:780:1e-9"), "--wavelengths"),
    (("render", GLASS, "-o", "out.exr", "--wavelengths", "nan"), "--wavelengths"),
    (("render", GLASS, "-o", "out.exr", "--seed", "-1"), "--seed"),
    (("render", GLASS, "-o", "out.exr", "--seed", "18446744073709551616"), "--seed"),
    (("render", GLASS, "-o", "out.exr", "--threads", "0"), "--threads"),
    (("render", GLASS, "-o", "out.exr", "--threads", "1000000"), "--threads"),
    (("render", GLASS, "-o", "out.exr", "--time", "0"), "--time"),
    (("render", GLASS, "-o", "out.exr", "--time", "nan"), "--time"),
    (("render", GLASS, "-o", "out.exr", "--time", "inf"), "--time"),
    (("render", GLASS, "-o", ""), "name.exr"),
    (("render", GLASS, "-o", ".exr"), "name.exr"),
    (("render", GLASS, "-o", "pictures/"), "pictures/name.exr"),
    (("explain", GLASS), "--pixel"),
    (("explain", GLASS, "--pixel", "1,2", "--least", "nan"), "--least"),
    (("explain", GLASS, "--pixel", "1,2", "--least", "-1"), "--least"),
    (("explain", GLASS, "--pixel", "1"), "--pixel"),
    (("explain", GLASS, "--pixel", "1,2,3"), "--pixel"),
    (("explain", GLASS, "--pixel", "-1,2"), "512x512"),
    (("explain", GLASS, "--pixel", "512,2"), "512x512"),
    (("explain", GLASS, "--pixel", "1,2", "--sample", "1"), "--sample"),
    (("explain", GLASS, "--pixel", "1,2", "--sample", "-1"), "--sample"),
    (("explain", GLASS, "--pixel", "1,2", "--wavelength", "600"), "--wavelengths 600"),
    (("maps", "in.exr", "--map", "dpo", "-o", "dop.png"), "did you mean dop"),
    (("maps", "in.exr", "--map", "dop", "-o", "dop.png", "--style", "papr"), "paper"),
    (("maps", "in.exr", "--map", "dop", "-o", "dop.png", "--range", "1,0"), "--range"),
    (("maps", "in.exr", "--map", "dop", "-o", "dop.png", "--range", "1"), "--range"),
    (("maps", "in.exr", "--map", "dop", "-o", "dop.png", "--exposure", "inf"), "--exposure"),
    (("maps", "in.exr", "--map", "dop", "-o", "dop.png", "--wavelength", "600"), "580"),
    (("interface",), "--from"),
    (("interface", "--from", "air"), "--to"),
    (("interface", "--from", "air", "--to", "calcite"), "--axis"),
    (("interface", "--from", "air", "--to", "calcite", "--axis", "0,0,0"), "--axis"),
    (("interface", "--from", "air", "--to", "nan"), "--to"),
    (("interface", "--from", "air", "--to", "-1.5"), "--to"),
    (("interface", "--from", "air", "--to", "1.5,"), "no medium"),
    (("interface", "--from", "air", "--to", "0.3-2.8i"), "no medium"),
    (("interface", "--from", "air", "--to", "1.5", "--wavelength", "0.58"), "were micrometres meant"),
    (("render", GLASS, "-o", "out.exr", "--wavelengths", "0.38:0.78:0.02"), "were micrometres meant"),
    (("explain", GLASS, "--pixel", "1,2", "--wavelength", "0.58"), "were micrometres meant"),
    (("maps", "in.exr", "--map", "dop", "-o", "dop.png", "--wavelength", "0.58"), "were micrometres meant"),
    (("interface", "--from", "gold", "--to", "air"), "--from"),
    (("interface", "--from", "air", "--to", "1.5", "--angle", "90"), "--angle"),
    (("interface", "--from", "air", "--to", "1.5", "--angle", "nan"), "--angle"),
    (("interface", "--from", "air", "--to", "1.5", "--wavelength", "0"), "--wavelength"),
    (("plan",), "SCENE"),
    (("check",), "nothing to check"),
    (("check", GLASS, "--size", "0"), "--size"),
    (("check", GLASS, "--size", "many"), "--size"),
    (("check", "fatcs"), "'facts'"),
    (("check", "facts", "T99x"), "no fact 'T99x'"),
    (("check", "facts", "TI9"), "did you mean 'T9'"),
    (("check", "facts", "--jsno"), "'--json'"),
]


class Usage(ProgramTest):
    def test_what_cannot_be_asked_is_refused_with_a_hint(self):
        self.succeed("render", GLASS, "-o", "in.exr", "--size", "4x4", "--quiet")
        for arguments, said in BAD_USAGE:
            with self.subTest(arguments):
                self.refuse(2, [said], *arguments)

    def test_options_may_stand_anywhere_and_paths_may_hold_anything(self):
        for name in ("with space", "Größe 光", "-dash", "quote'\"", "new\nline", "%s%n{}"):
            with self.subTest(name):
                folder = self.folder / name
                folder.mkdir()
                (folder / "scene.yaml").write_text(GLASS.read_text())
                here = f"./{name}/"
                self.succeed("render", "--size", "4x4", "-o", here + "out.exr", "--stats", here + "s.json", here +
                             "scene.yaml")
                self.succeed("maps", "--map", "dop", here + "out.exr", "-o", here + "dop.png")
                self.succeed("plan", here + "scene.yaml", "--json")

    def test_names_that_are_no_text_do_no_harm(self):
        name = b"\xff\x1b[31m.yaml"
        scene = self.folder.joinpath(name.decode(errors="surrogateescape"))
        scene.write_text(GLASS.read_text())
        self.succeed("render", scene, "--size", "4x4", "-o", "out.exr", "--stats", "s.json")
        self.succeed("maps", "out.exr", "--map", "dop", "-o", "dop.png")
        (self.folder / "s.json").read_text()
        done = self.run_program("plan", name.replace(b".yaml", b".yml").decode(errors="surrogateescape"))
        self.assertIn("\\xff\\x1b[31m.yml", done.stderr)


class Help(ProgramTest):
    def test_every_command_has_help_with_examples(self):
        self.assertIn("Example", self.succeed("--help"))
        for command in COMMANDS:
            with self.subTest(command):
                text = self.succeed(command, "--help")
                self.assertIn(f"\n  polariscope {command} ", text)
                self.assertIn("Example", text)
                self.assertLessEqual(max(map(len, text.splitlines())), 160)
        self.assertRegex(self.succeed("--version"), r"^\d+\.\d+\.\d+\n$")

    def options_of(self, command):
        """Every --name that the help of a command mentions."""
        return set(re.findall(r"--[a-z][a-z-]*", self.succeed(command, "--help")))

    def test_examples_use_only_options_that_exist_and_scenes_that_ship(self):
        texts = [(REPOSITORY / "README.md").read_text(), self.succeed("--help")]
        texts += [self.succeed(command, "--help") for command in COMMANDS]
        examples = [line for text in texts for line in text.splitlines() if re.match(r"\s+polariscope [a-z]+ ", line)]
        self.assertGreater(len(examples), 20)
        for example in examples:
            with self.subTest(example):
                words = shlex.split(example.split("   (")[0])
                self.assertIn(words[1], COMMANDS)
                known = self.options_of(words[1])
                for word in words[2:]:
                    if word.startswith("--"):
                        self.assertIn(word, known)
                    if word.startswith("assets/"):
                        self.assertTrue((REPOSITORY / word).is_file(), word)


if __name__ == "__main__":
    main()
