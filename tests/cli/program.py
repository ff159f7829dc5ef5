# SPDX-License-Identifier: Apache-2.0
"""Runs the built program the way a user does. Its path is the first argument of every test script of this folder."""

import ctypes
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = str(Path(sys.argv[1]).resolve()) if len(sys.argv) > 1 else ""
REPOSITORY = Path(__file__).resolve().parents[2]
SCENES = REPOSITORY / "assets" / "scenes"
CASES = REPOSITORY / "assets" / "cases"
PATIENCE_S = 300  # a sanitizer on a busy machine

CAMERA = "camera: {position: [0, 0, 5], target: [0, 0, 0], up: [0, 1, 0], fov: 30}\n"


def bound_by_permissions():
    """Options of subprocess: root, too, may only do what the permissions of a file say. The program keeps its user, so
    that it can be reached wherever the tree lies."""
    if os.getuid() != 0:
        return {}
    libc = ctypes.CDLL(None)
    drop_from_bounding_set, override, read_search = 24, 1, 2  # linux/prctl.h, linux/capability.h

    def give_up():
        for capability in (override, read_search):
            libc.prctl(drop_from_bounding_set, capability, 0, 0, 0)  # fails where root has no capabilities anyway

    return {"preexec_fn": give_up}


class ProgramTest(unittest.TestCase):
    """Every test has a folder of its own, self.folder, in which the program runs."""

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="polariscope-cli-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def write(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def run_program(self, *arguments, **options):
        """Waits for the end; the result has returncode, stdout and stderr."""
        options = {"cwd": self.folder, "capture_output": True, "text": True, "timeout": PATIENCE_S} | options
        return subprocess.run([PROGRAM, *map(str, arguments)], **options)

    def start_program(self, *arguments, **options):
        options = {"cwd": self.folder, "text": True, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE} | options
        process = subprocess.Popen([PROGRAM, *map(str, arguments)], **options)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        return process

    def succeed(self, *arguments):
        done = self.run_program(*arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr, "")
        return done.stdout

    def refuse(self, code, says, *arguments, **options):
        """The program exits with `code`, every text of `says` and a hint stand on stderr, and no file appears."""
        before = self.files()
        done = self.run_program(*arguments, **options)
        self.assertEqual(done.returncode, code, f"{arguments}\n{done.stdout}{done.stderr}")
        for text in says:
            self.assertIn(text, done.stderr)
        self.assertRegex(done.stderr, r"^polariscope: .")
        self.assertRegex(done.stderr, r"\n  hint: .")
        self.assertEqual(done.stdout, "")
        self.assertEqual(self.files(), before, "a refusal writes nothing")
        return done.stderr

    def png_size(self, name):
        content = (self.folder / name).read_bytes()
        self.assertEqual(content[:8], b"\x89PNG\r\n\x1a\n")
        return struct.unpack(">II", content[16:24])

    def files(self):
        """All files below the folder with their bytes, hidden ones included."""
        return {str(Path(top, name).relative_to(self.folder)): Path(top, name).read_bytes()
                for top, _, names in os.walk(self.folder) for name in names}


def main():
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
