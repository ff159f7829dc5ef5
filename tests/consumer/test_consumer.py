#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Installs the build to a folder, builds a program outside of the tree against it and runs it; then moves the folder
and does so again. Usage: test_consumer.py BUILD CMAKE CXX"""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

BUILD, CMAKE, CXX = sys.argv[1:4]
HERE = Path(__file__).resolve().parent
ENVIRONMENT = {key: value for key, value in os.environ.items() if key != "POLARISCOPE_ASSETS"}


def output(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, env=ENVIRONMENT)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout


def build(prefix, folder):
    output(CMAKE, "-S", HERE, "-B", folder, "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={CXX}", f"-DCMAKE_PREFIX_PATH={prefix}")
    output(CMAKE, "--build", folder)
    return folder / "consumer"


class Consumer(unittest.TestCase):
    def test_the_readme_shows_this_very_program(self):
        readme = (HERE.parents[1] / "README.md").read_text(encoding="utf-8")
        for file in (HERE / "CMakeLists.txt", HERE / "main.cpp"):
            code = re.sub(r"\A(//.*\n)+", "", file.read_text(encoding="utf-8"))
            self.assertIn(f"\n{code}```\n", readme, file)

    def test_the_library_works_where_it_is_installed_and_where_it_is_moved(self):
        with tempfile.TemporaryDirectory() as temporary:
            folder = Path(temporary)
            prefix = folder / "first" / "prefix"
            output(CMAKE, "--install", BUILD, "--prefix", prefix)
            headers = sorted(file.name for file in (prefix / "include/polariscope").iterdir())
            self.assertLessEqual(len(headers), 15, headers)
            self.assertNotIn("inside.h", headers)

            program = build(prefix, folder / "build")
            first = output(program)
            self.assertRegex(first, r"^J = \[0\.\d+, ")

            moved = folder / "second"
            prefix.rename(moved)
            again = build(moved, folder / "build of the second")
            self.assertEqual(output(again), first)

            # Installed beside the library it needs no new build: what is beside the program counts first.
            installed = moved / "bin" / "consumer"
            installed.parent.mkdir(exist_ok=True)
            program.rename(installed)
            self.assertEqual(output(installed), first)

            lone = folder / "lone"
            installed.rename(lone)
            refused = subprocess.run([lone], capture_output=True, text=True, env=ENVIRONMENT)
            if refused.returncode != 0:  # zero where polariscope is installed on this machine, too
                self.assertEqual(refused.returncode, 1)
                self.assertTrue(re.search("hint: .*POLARISCOPE_ASSETS", refused.stderr), refused.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
