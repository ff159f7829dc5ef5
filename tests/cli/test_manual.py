#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The manual page and the completions, which the program makes from its own help; and the assets, which it finds again."""

import os
import re
import shlex
import shutil
import subprocess
import unittest
from pathlib import Path

from program import PROGRAM, REPOSITORY, SCENES, ProgramTest, main

COMMANDS = ("render", "maps", "compare", "send", "convert", "explain", "interface", "plan", "check", "converge", "manual")
# Types $1 and the tabulator, and reads until $2 stands there.
ZSH_CONVERSATION = r"""
zmodload zsh/zpty
zpty -b shell zsh -f -i
zpty -w shell 'PS1=; fpath=($PWD $fpath); autoload -U compinit; compinit -u -D; LISTMAX=10000; COLUMNS=200; echo re''ady'
zpty -r -m shell answer '*ready*'
zpty -w -n shell "$1"$'\t'
for i in {1..200}; do
    while zpty -r -t shell answer; do said+=$answer; done
    [[ ${said//[^[:print:]]/} != *$2* ]] || exit 0
    sleep 0.1
done
print -r -- $said
exit 1
"""


class Manual(ProgramTest):
    def manual(self, form):
        done = self.run_program("manual", form)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def help_of(self, *command):
        return self.run_program(*command, "--help").stdout

    def test_the_page_has_every_command_with_every_option_of_its_help(self):
        page = self.manual("page").replace("\\-", "-")
        for command in COMMANDS:
            begin = page.index(f"\n.SS polariscope {command}\n")
            section = page[begin:page.index("\n.S", begin + 4)]
            options = set(re.findall(r"^  (?:-\w,)?(--[a-z][a-z-]*)", self.help_of(command), re.M)) - {"--help"}
            for option in options:
                self.assertIn(f"\\fB{option}\\fR", section, command)

    def test_the_page_is_set_without_a_warning(self):
        page = self.write("polariscope.1", self.manual("page"))
        checks = {"man": ["man", "--warnings=w", "-l", "-Tutf8", "-P", "cat", page],
                  "mandoc": ["mandoc", "-Tlint", "-Wwarning", page]}
        found = [command for tool, command in checks.items() if shutil.which(tool)]
        if not found:
            self.skipTest("neither man nor mandoc is installed")
        for command in found:
            done = subprocess.run(command, capture_output=True, text=True, env=os.environ | {"LC_ALL": "C.UTF-8", "MANWIDTH": "80"})
            complaints = [line for line in (done.stderr + (done.stdout if command[0] == "mandoc" else "")).splitlines()
                          if "missing date" not in line]  # a build does not know when its release is
            self.assertEqual(complaints, [], command[0])

    def test_anything_else_is_refused_with_what_there_is(self):
        done = self.run_program("manual", "nothing")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("'nothing' is none of page, bash, zsh", done.stderr)

    def completed(self, line, **environment):
        """What bash offers for the last word of `line`, which is cut into words as bash does it."""
        script = self.write("completion.bash", self.manual("bash"))
        words = [word for part in shlex.split(line + "x")[:-1] + [shlex.split(line + "x")[-1][:-1]]
                 for word in (re.split("(=)", part) if part.startswith("--") else [part])]
        code = f'. {shlex.quote(str(script))}; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _polariscope; printf "%s\\n" "${{COMPREPLY[@]}}"'
        done = subprocess.run(["bash", "-c", code, "bash", *words], cwd=self.folder, capture_output=True, text=True,
                              env=os.environ | {"PATH": f"{Path(PROGRAM).parent}:{os.environ['PATH']}"} | environment)
        self.assertEqual(done.stderr, "", line)
        return done.stdout.split("\n")[:-1] if done.stdout != "\n" else []

    def test_bash_completes_commands_options_and_what_they_take(self):
        self.assertLessEqual(set(COMMANDS), set(self.completed("polariscope ")))
        self.assertEqual(self.completed("polariscope expl"), ["explain"])
        self.assertEqual(self.completed("polariscope check fa"), ["facts"])
        self.assertEqual(self.completed("polariscope render --wave"), ["--wavelengths"])
        self.assertEqual(self.completed("polariscope render --mode "), ["point", "area"])
        self.assertEqual(self.completed("polariscope render --spp "), [])
        self.assertEqual(self.completed("polariscope render maps --mo"), ["--mode"], "a scene may be called maps")
        self.assertEqual(self.completed("polariscope maps --map=dop_"), ["dop_error"])
        self.assertEqual(self.completed("polariscope maps --style wi"), ["wilkie"])
        self.assertEqual(self.completed("polariscope interface --to calc"), ["calcite"])
        self.assertIn("T25", self.completed("polariscope check facts T1 T2"))

    def test_every_word_that_bash_offers_for_an_option_is_taken(self):
        exr = self.folder / "light.exr"
        done = self.run_program("render", SCENES / "crossed-polarizers.yaml", "-o", exr, "--size", "4x4", "--wavelengths", "580")
        self.assertEqual(done.returncode, 0, done.stderr)
        for style in self.completed("polariscope maps --style "):
            self.assertEqual(self.run_program("maps", exr, "--map", "dop", "-o", "a.png", "--style", style).returncode, 0, style)
        for name in set(self.completed("polariscope maps --map ")) - {"all", "color"}:
            self.assertEqual(self.run_program("maps", exr, "--map", name, "-o", "a.png").returncode, 0, name)
        for medium in self.completed("polariscope interface --to "):
            done = self.run_program("interface", "--from", "air", "--to", medium, "--axis", "0,0,1", "--wavelength", "589.3")
            self.assertEqual(done.returncode, 0, medium + done.stderr)
        for mode in self.completed("polariscope plan --mode "):
            self.assertEqual(self.run_program("plan", SCENES / "cube-glass.yaml", "--mode", mode).returncode, 0, mode)

    def test_bash_completes_files_by_their_ending_and_then_shipped_scenes(self):
        for name in ("mine.yaml", "mine.exr", "mine.txt", "my scene.yaml"):
            self.write(name, "")
        (self.folder / "fold").mkdir()
        self.assertEqual(sorted(self.completed("polariscope render m")), ["mine.yaml", "my scene.yaml"])
        self.assertEqual(self.completed("polariscope maps m"), ["mine.exr"])
        self.assertEqual(sorted(self.completed("polariscope check m")), ["mine.exr", "mine.yaml", "my scene.yaml"])
        self.assertEqual(self.completed("polariscope render x.yaml -o fo"), ["fold"])
        self.assertEqual(self.completed("polariscope interface --cases mine.t"), ["mine.txt"])
        shipped = self.completed("polariscope render wolla")
        self.assertEqual([Path(path).name for path in shipped], ["wollaston.yaml"])
        self.assertTrue(Path(shipped[0]).is_file())
        elsewhere = self.folder / "other assets/scenes/wolla-2.yaml"
        elsewhere.parent.mkdir(parents=True)
        elsewhere.touch()
        self.assertEqual(self.completed("polariscope render wolla", POLARISCOPE_ASSETS=str(elsewhere.parents[1])), [str(elsewhere)])

    def assert_zsh_offers(self, line, offered):
        done = subprocess.run(["zsh", "-f", "-c", ZSH_CONVERSATION, "zsh", line, offered], cwd=self.folder, capture_output=True,
                              text=True, env=os.environ | {"PATH": f"{Path(PROGRAM).parent}:{os.environ['PATH']}", "TERM": "dumb"})
        self.assertEqual(done.returncode, 0, done.stdout)

    @unittest.skipUnless(shutil.which("zsh"), "zsh is not installed")
    def test_zsh_completes_too(self):
        script = self.write("_polariscope", self.manual("zsh"))
        self.assertEqual(subprocess.run(["zsh", "-n", script], capture_output=True, text=True).stderr, "")
        self.write("mine.exr", "")
        for line, offered in (("polariscope ", "explain"), ("polariscope expl", "explain"), ("polariscope check ", "facts"),
                              ("polariscope render --mode ", "area"), ("polariscope maps mine.exr --style ", "wilkie"),
                              ("polariscope maps mi", "mine.exr"), ("polariscope render --wavel", "--wavelengths"),
                              ("polariscope render wolla", "wollaston.yaml"), ("polariscope check facts T4", "T41")):
            with self.subTest(line):
                self.assert_zsh_offers(line, offered)


class Assets(ProgramTest):
    def installed(self, folder):
        """A copy of program and assets, laid out as `cmake --install` does it."""
        (folder / "bin").mkdir(parents=True)
        shutil.copy(PROGRAM, folder / "bin/polariscope")
        shutil.copytree(REPOSITORY / "assets/refractive_index", folder / "share/polariscope/refractive_index")
        return folder / "bin/polariscope"

    def refract(self, program, **environment):
        clean = {name: value for name, value in os.environ.items() if name != "POLARISCOPE_ASSETS"}
        return subprocess.run([program, "interface", "--from", "air", "--to", "n-bk7"], capture_output=True, text=True,
                              cwd=self.folder, env=clean | environment)

    def test_they_are_found_beside_an_installed_program_and_after_a_move(self):
        program = self.installed(self.folder / "a tree")
        self.assertEqual(self.refract(program).returncode, 0)
        (self.folder / "a tree").rename(self.folder / "moved")
        self.assertEqual(self.refract(self.folder / "moved/bin/polariscope").returncode, 0)
        (self.folder / "link").symlink_to(self.folder / "moved/bin/polariscope")
        self.assertEqual(self.refract(self.folder / "link").returncode, 0)

    def test_where_they_were_looked_for_is_said_if_they_are_nowhere(self):
        program = self.installed(self.folder / "tree")
        shutil.rmtree(self.folder / "tree/share")
        done = self.refract(program)
        if done.returncode == 0:
            self.skipTest("this machine has them installed")
        self.assertEqual(done.returncode, 3)
        self.assertIn("the files that ship with polariscope are not there", done.stderr)
        self.assertIn(f"{self.folder}/tree/share/polariscope, ", done.stderr)
        self.assertIn("POLARISCOPE_ASSETS", done.stderr)
        done = self.refract(program, POLARISCOPE_ASSETS="/nowhere")
        self.assertIn("looked for in /nowhere", done.stderr)


if __name__ == "__main__":
    main()
