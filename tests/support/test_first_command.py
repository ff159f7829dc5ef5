#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""run.sh on machines that are not this one: each is a folder of stand-ins for apt, sudo, cmake and the like, and is all that
the script can reach. What it cannot do is said on one line."""

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[2]
TOOLS = ("awk basename bash cat dirname env find grep head id mkdir mktemp paste realpath rm sed sort tail touch true uname").split()
PROGRAM = '#!/bin/sh\necho "polariscope $*"\nwhile [ $# -gt 0 ]; do [ "$1" != -o ] || echo picture >"$2"; shift; done\n'
# CMake that makes that program; its arguments are kept in cmake.log.
CMAKE = """
echo "$*" >>"$LOG/cmake.log"
case $1 in
--preset)
    mkdir -p "$4"
    printf 'CMAKE_HOME_DIRECTORY:INTERNAL=%s\\nCMAKE_CACHEFILE_DIR:INTERNAL=%s\\n' "$PWD" "$4" >"$4/CMakeCache.txt"
    for option in "$@"; do
        case $option in -DPOL_TESTS=*) echo "POL_TESTS:BOOL=${option#*=}" >>"$4/CMakeCache.txt" ;; esac
    done
    touch "$4/build.ninja"
    ;;
--build)
    cat "$LOG/program" >"$2/polariscope"
    chmod +x "$2/polariscope"
    ;;
esac
"""
DEBIAN = {"dpkg-query": 'grep -qx "$4" "$LOG/installed" && echo installed', "cmake": CMAKE,
          "apt-get": 'echo "$*" >>"$LOG/apt.log"; case "$*" in *update) ;; *) for p; do echo "$p"; done >>"$LOG/installed" ;; esac'}
RIGHTLESS = {"id": "echo 1000"}


def packages(system, group):
    rows = [line.split() for line in (REPOSITORY / "tests/support/packages.txt").read_text().splitlines()]
    column = next(row for row in rows if row[0] == "#who").index(system)
    return {row[column] for row in rows if row[0] == group and len(row) > column}


class FirstCommand(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="polariscope first command "))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.tree = self.folder / "a tree"
        (self.tree / "assets/scenes").mkdir(parents=True)
        (self.tree / "tests/support").mkdir(parents=True)
        for name in ("run.sh", "tests/support/setup.sh", "tests/support/packages.txt",
                     "assets/scenes/paper-calcite-unpolarized.yaml"):
            shutil.copy(REPOSITORY / name, self.tree / name)
        (self.folder / "program").write_text(PROGRAM)
        (self.folder / "installed").touch()
        self.path = self.folder / "bin"
        self.path.mkdir()
        for tool in TOOLS + ["chmod"]:
            os.symlink(shutil.which(tool), self.path / tool)

    def run_sh(self, *arguments, machine, system="ID=debian", **environment):
        for name, script in machine.items():
            (self.path / name).unlink(missing_ok=True)
            (self.path / name).write_text(f"#!{shutil.which('bash')}\n{script}\n")
            (self.path / name).chmod(0o755)
        (self.folder / "os-release").write_text(system + "\n")
        return subprocess.run(
            [self.tree / "run.sh", *arguments], capture_output=True, text=True, timeout=60, stdin=subprocess.DEVNULL,
            env={"PATH": str(self.path), "HOME": str(self.folder), "LOG": str(self.folder),
                 "OS_RELEASE": str(self.folder / "os-release")} | environment)

    def log(self, name):
        path = self.folder / name
        return path.read_text() if path.exists() else ""

    def refused(self, done, *said):
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        lines = done.stderr.splitlines()
        self.assertEqual(len(lines), 1, done.stderr)
        self.assertTrue(lines[0].startswith("run.sh: "), lines[0])
        for text in said:
            self.assertIn(text, lines[0])

    def everything_installed(self):
        (self.folder / "installed").write_text("\n".join(packages("debian", "run")) + "\n")

    def test_a_bare_debian_gets_what_running_needs_and_nothing_for_tests(self):
        done = self.run_sh(machine=DEBIAN | {"id": "echo 0"})
        self.assertEqual(done.returncode, 0, done.stderr)
        installed = set(self.log("installed").split())
        self.assertLessEqual(packages("debian", "run"), installed)
        self.assertFalse(packages("debian", "test") & installed)
        self.assertNotIn("POL_TESTS=ON", self.log("cmake.log"))
        self.assertIn("--target polariscope ", self.log("cmake.log"))
        self.assertTrue((self.tree / "out/paper-calcite-unpolarized-color.png").exists())

    def test_a_second_call_needs_neither_root_nor_a_network(self):
        self.everything_installed()
        offline = DEBIAN | RIGHTLESS | {"apt-get": 'echo "$*" >>"$LOG/apt.log"; exit 100'}
        for _ in range(2):
            done = self.run_sh(machine=offline)
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.log("apt.log"), "")
        self.assertEqual(self.log("cmake.log").count("--preset"), 1, "configured once")

    def test_without_a_network_the_missing_packages_and_the_complaint_of_apt_are_named(self):
        offline = DEBIAN | {"id": "echo 0", "apt-get": 'echo "E: Could not resolve mirror.example"; exit 100'}
        self.refused(self.run_sh(machine=offline), "libembree-dev", "Could not resolve mirror.example")

    def test_a_package_that_apt_does_not_have_is_named(self):
        machine = DEBIAN | {"id": "echo 0", "apt-get": 'case "$*" in *update) ;; *) echo "E: Unable to locate package x"; exit 100 ;; esac'}
        self.refused(self.run_sh(machine=machine), "Unable to locate package x")

    def test_another_package_manager_at_work_is_waited_for(self):
        busy = DEBIAN | {"id": "echo 0", "sleep": 'echo "$*" >>"$LOG/slept.log"',
                         "apt-get": 'case "$*" in *update) [ -f "$LOG/slept.log" ] || { echo "E: Could not get lock x"; exit 100; } ;; '
                                    '*) for p; do echo "$p"; done >>"$LOG/installed" ;; esac'}
        done = self.run_sh(machine=busy)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.log("slept.log"), "5\n")

    def test_a_repository_out_of_reach_does_not_matter_if_another_has_what_is_needed(self):
        machine = DEBIAN | {"id": "echo 0", "apt-get": 'case "$*" in *update) echo "E: no route to mirror.example"; exit 100 ;; '
                                                       '*) for p; do echo "$p"; done >>"$LOG/installed" ;; esac'}
        done = self.run_sh(machine=machine)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_without_root_and_sudo_the_missing_packages_are_named(self):
        self.refused(self.run_sh(machine=DEBIAN | RIGHTLESS), "needs root, or sudo", "libembree-dev")

    def test_a_sudo_that_refuses_is_no_dead_end(self):
        self.refused(self.run_sh(machine=DEBIAN | RIGHTLESS | {"sudo": "echo sudo: a password is required >&2; exit 1"}),
                     "as root, run: apt-get install --no-install-recommends ccache cmake")

    def test_a_user_with_sudo_installs(self):
        done = self.run_sh(machine=DEBIAN | RIGHTLESS | {"sudo": '[ "$1" != -n ] || shift; exec "$@"'})
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("libembree-dev", self.log("installed"))

    def test_builds_and_pictures_go_elsewhere_if_the_tree_cannot_be_written_to(self):
        self.everything_installed()
        # A file in their place stops root, too.
        (self.tree / "build").touch()
        (self.tree / "out").touch()
        self.refused(self.run_sh(machine=DEBIAN | RIGHTLESS), str(self.tree / "build"), "BUILD=FOLDER")
        done = self.run_sh(machine=DEBIAN | RIGHTLESS, BUILD=str(self.folder / "my build"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue((self.folder / "my build/out/paper-calcite-unpolarized.exr").exists())
        self.assertTrue((self.folder / "my build/release/polariscope").exists())

    def test_what_the_tests_configured_stays_and_what_was_moved_is_configured_anew(self):
        self.everything_installed()
        machine = DEBIAN | RIGHTLESS
        self.run_sh(machine=machine)
        with (self.tree / "build/release/CMakeCache.txt").open("a") as cache:
            cache.write("POL_TESTS:BOOL=ON\n")
        self.run_sh(machine=machine)
        self.assertEqual(self.log("cmake.log").count("--preset"), 1)
        moved = self.folder / "another tree"
        self.tree.rename(moved)
        self.tree = moved
        done = self.run_sh(machine=machine)
        self.assertEqual(done.returncode, 0, done.stderr)
        configured = [line for line in self.log("cmake.log").splitlines() if "--preset" in line]
        self.assertEqual(len(configured), 2)
        self.assertIn("--fresh", configured[1])

    def test_a_configuration_that_never_ended_is_begun_anew(self):
        self.everything_installed()
        (self.tree / "build/release").mkdir(parents=True)
        (self.tree / "build/release/CMakeCache.txt").write_text(
            f"CMAKE_HOME_DIRECTORY:INTERNAL={self.tree}\nPOL_TESTS:BOOL=ON\n")
        done = self.run_sh(machine=DEBIAN | RIGHTLESS)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("--fresh", self.log("cmake.log"))

    def test_what_cmake_misses_is_named_however_it_says_so(self):
        before = "-- No package 'imgui' found\n-- Checking for module 'cairo'\n--   Package 'cairo', required by 'virtual:world', not found\n"
        for said, named in (
                ("CMake Error at CMakeLists.txt:1 (find_package):\n  asked CMake to find a package configuration file provided by \"fmt\", but",
                 "no package fmt"),
                ('CMake Error at CMakeLists.txt:1 (find_package):\n  By not providing "Findfmt.cmake" in', "no package fmt"),
                ("CMake Error at FindPkgConfig.cmake:607 (message):\n  A required package was not found", "Package 'cairo'"),
                ("CMake Error at CMakeLists.txt:1 (find_path):\n  Could not find TINYGLTF_FOLDER using the following files: x", "TINYGLTF_FOLDER"),
                ('CMake Error: CMake was unable to find a build program corresponding to "Ninja".', '"Ninja"'),
                ("CMake Error at CMakeLists.txt:2 (project):\n  No CMAKE_CXX_COMPILER could be found.", "CMAKE_CXX_COMPILER"),
                ("CMake Error at CMakeLists.txt:46 (message):\n  Embree 2.1 in /x: 3.13 or 4 is needed; choose", "Embree 2.1")):
            with self.subTest(named):
                (self.folder / "said").write_text((before + said + "\nSee also \"x\".\n"))
                self.refused(self.run_sh(machine={"cmake": 'cat "$LOG/said"; exit 1'}, system="ID=fedora"), named, "dnf install")

    def test_other_systems_are_told_what_to_install_under_which_names(self):
        failing = {"cmake": "echo 'CMake Error: Could NOT find embree (missing: x)'; exit 1"}
        readme = (REPOSITORY / "README.md").read_text()
        for system, release, installer in (("fedora", "ID=fedora", "sudo dnf install"),
                                           ("fedora", 'ID=rocky\nID_LIKE="rhel centos fedora"', "sudo dnf install"),
                                           ("arch", "ID=arch", "sudo pacman -S --needed")):
            with self.subTest(release):
                done = self.run_sh(machine=failing, system=release)
                names = {name.split(":")[-1] for name in packages(system, "run") - {"-"}}
                self.refused(done, "Could NOT find embree", installer, *names)
                self.assertTrue(done.stderr[done.stderr.index(installer):].split(";")[0].strip() in readme, "in the README, too")
        self.refused(self.run_sh(machine=failing, system="ID=plan9"), "what Debian calls", "libembree-dev")

    def test_a_system_with_the_libraries_builds_whatever_it_is(self):
        done = self.run_sh(machine={"cmake": CMAKE}, system="ID=fedora")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_macos_is_told_the_names_before_any_tool_that_it_lacks_is_used(self):
        for tool in ("realpath", "mktemp", "find"):
            (self.path / tool).unlink()
        done = self.run_sh(machine={"uname": "echo Darwin"}, system="")
        self.refused(done, "brew install cairo")
        readme = (REPOSITORY / "README.md").read_text()
        self.assertTrue(done.stderr[done.stderr.index("brew install"):].split(";")[0] in readme, "in the README, too")


if __name__ == "__main__":
    unittest.main()
