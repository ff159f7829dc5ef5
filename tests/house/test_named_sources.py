#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Plants one dangling name at a time in a small house and expects exactly that one to be reported."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
import named_sources  # noqa: E402: after the switch above, which keeps the source tree clean

HOUSE = {
    "engine/PHYSICS.md": "# Physics\n\n## 2. Interfaces\n\n### 2.1 Glass\n\n## 4. Degenerate cases\n\n"
                         "| case | what | behavior | sweeps |\n|---|---|---|---|\n| 1 | axis | \\|a\\| | axis: `along-axis` |\n"
                         "| 2 | more | b | none |\n\n## 5. Facts\n\n| T1 | Brewster | P = 1 |\n| T58 | up | up |\n",
    "engine/CUTTING.md": "# Cutting\n\n## 3. Metrics\n",
    "engine/polarization/CONVENTIONS.md": "# Conventions\n\n## 2. Frame\n",
    "engine/optics/fresnel.h": "#pragma once\nFresnel fresnel(Real n1);\n",
    "engine/verify/degenerate/axis_cases.cpp": 'Case a{"along-axis"};\n',
    "tests/optics/oracle.py": "",
    "tests/optics/test_frame.cpp": "TEST(Frame, IsRightHanded) {\n}\n",
    "assets/scenes/cube.yaml": "",
    "assets/pictures/window.png": "",
}


class NamedSources(unittest.TestCase):
    def findings(self, path, text):
        with tempfile.TemporaryDirectory() as folder:
            for name, content in {**HOUSE, path: text}.items():
                file = Path(folder) / name
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(content, encoding="utf-8")
            return named_sources.findings(Path(folder))

    def expect_clean(self, path, *lines):
        for text in lines:
            self.assertEqual(self.findings(path, text + "\n"), [], text)

    def expect(self, path, text, line, missing):
        self.assertEqual(self.findings(path, text + "\n"), [f"{path}:{line}: {missing}"], text)

    def test_the_house_itself_is_whole(self):
        self.expect_clean("engine/a.cpp", "int x;")

    def test_a_file_is_found_at_the_top_in_its_tree_and_beside_the_one_that_names_it(self):
        for name in ("engine/optics/fresnel.h", "optics/fresnel.h", "fresnel.h", "tests/optics/oracle.py", "optics/oracle.py"):
            self.expect_clean("engine/optics/a.h", f"/// See {name}.", f"x();  // after {name}", f"/* {name} */")
        self.expect("engine/core/a.h", "int x;\n/// See fresnel.h, too.", 2, "there is no fresnel.h")

    def test_a_missing_file_is_named_with_its_line_in_every_kind_of_comment(self):
        missing = "there is no optics/gone.h"
        self.expect("engine/a.cpp", "\nint x;  // see optics/gone.h (long ago)", 2, missing)
        self.expect("shaders/a.frag", "// one\n// optics/gone.h", 2, missing)
        self.expect("tests/a.py", "#!/bin/sh\n# `optics/gone.h`", 2, missing)
        self.expect("tests/a.py", '"""One.\n\nSee optics/gone.h.\n"""', 3, missing)
        self.expect("tests/a.sh", "x=1  # optics/gone.h", 1, missing)
        self.expect("CMakeLists.txt", "# optics/gone.h", 1, missing)
        self.expect("engine/a.cmake", "# optics/gone.h", 1, missing)
        self.expect("assets/scenes/a.yaml", "size: 1  # optics/gone.h", 1, missing)
        self.expect("README.md", "# Title\n\n- `optics/gone.h`: what it was", 3, missing)

    def test_code_is_not_a_comment(self):
        self.expect_clean("engine/a.cpp", '#include "optics/gone.h"', "a = gone.h + b;", '  #  include "gone.h"  // gone.h')
        self.expect_clean("tests/a.py", 'x = "optics/gone.h"  # fine', "open(f'{folder}/gone.py')")
        self.expect_clean("tests/a.sh", "cat optics/gone.h", 'echo "$x#gone.h"')

    def test_texts_of_the_program_are_read_and_those_of_tests_are_not(self):
        self.expect("engine/a.cpp", 'const char* from = "optics/gone.py (110 digits)";', 1, "there is no optics/gone.py")
        self.expect("viewer/a.cpp", 'f("see performance.md 3");', 1, "there is no performance.md")
        self.expect_clean("engine/a.cpp", 'f("stiff.h");', 'f("tests/optics/oracle.py");')
        self.expect_clean("tests/a.cpp", 'f("optics/gone.h");', "// see optics/fresnel.h")

    def test_placeholders_patterns_and_files_of_users_are_left_alone(self):
        self.expect_clean("README.md", "    polariscope render scene.yaml -o calcite.exr", "`NAME.exr`, `FOLDER/FILE.yaml`", "`engine/optics/NAME_reader.cpp`",
                          "all of `*.cpp`, `facts_*.cpp`, <embree4/rtcore.h>, https://a.org/b/c.md", "`$OUT/stiff.md`",
                          "it needs `GL/glcorearb.h`", "`assets/scenes/*.yaml`", "a plain word.Then one")
        self.expect("README.md", "`assets/scenes/gone.yaml`", 1, "there is no assets/scenes/gone.yaml")
        self.expect("README.md", "`PHYSICS.md`, not `physics.md`", 1, "there is no physics.md")
        self.expect("README.md", "`engine/README.md`", 1, "there is no engine/README.md")

    def test_a_program_of_the_reader_in_markdown_is_left_alone(self):
        self.expect_clean("README.md", "```cpp\nauto f = [](const X& x) { return x; };  // gone.h\n```")
        self.expect("README.md", "```cmake\nadd_executable(a main.cpp)\n```\n\n`gone.h`", 5, "there is no gone.h")

    def test_folders_below_a_known_top_are_looked_for(self):
        self.expect_clean("README.md", "`engine/optics/`, tests/optics.", "`assets/scenes/cube.yaml`")
        self.expect("README.md", "in `engine/media` and", 1, "there is no engine/media")
        self.expect("engine/a.cpp", 'f("tests/gone/ has them");', 1, "there is no tests/gone")

    def test_links_lead_somewhere(self):
        self.expect_clean("README.md", "![w](assets/pictures/window.png)", "[a](https://a.org)", "[b](#b)",
                          "[c](engine/PHYSICS.md#4-degenerate-cases)")
        self.expect("README.md", "![w](assets/pictures/gone.png)", 1, "there is no assets/pictures/gone.png")

    def test_a_function_that_markdown_names_stands_in_the_sources(self):
        self.expect_clean("README.md", "`fresnel()` and `Optics::fresnel()`", "fresnel2()")
        self.expect("README.md", "`respond()`", 1, "there is no respond()")

    def test_a_test_that_markdown_names_stands_in_the_tests(self):
        self.expect_clean("README.md", "(Test: `Frame.IsRight...`.)", "(Tests: `Frame.*`,\n`Frame.IsRightHanded`.)", "`Gone.Name`")
        self.expect("README.md", "(Tests: `Frame.*`,\n`Gone.*`.)", 2, "there is no test Gone.")
        self.expect("README.md", "(Test: `Frame.IsWrong...`.)", 1, "there is no test Frame.IsWrong")

    def test_a_section_must_be_a_heading_of_its_chapter(self):
        self.expect_clean("engine/a.cpp", "// PHYSICS.md 2.1 to 2.1, and PHYSICS.md 4", 'f("x; PHYSICS.md 2.1: r_p = -r_s");',
                          "// `polarization/CONVENTIONS.md`, section 2", "// (CUTTING.md 3). 7 more.")
        self.expect("engine/a.cpp", 'f("PHYSICS.md 2.2");', 1, "PHYSICS.md has no section 2.2")
        self.expect("engine/a.cpp", "// PHYSICS.md 2.1, 2.7", 1, "PHYSICS.md has no section 2.7")
        self.expect("engine/a.cpp", "// PHYSICS.md 2.1 and 8", 1, "PHYSICS.md has no section 8")
        self.expect("engine/a.cpp", "// as CUTTING.md\n    /// 3.1 says", 1, "CUTTING.md has no section 3.1")
        self.expect("tests/a.cpp", 'f("CONVENTIONS.md 9");', 1, "CONVENTIONS.md has no section 9")
        self.expect("README.md", "`engine/polarization/CONVENTIONS.md`, section 6", 1, "CONVENTIONS.md has no section 6")

    def test_a_case_must_be_a_row_of_the_table(self):
        self.expect_clean("engine/a.cpp", "// PHYSICS.md 4, case 1", "// PHYSICS.md 4, cases 1 and 2", "// PHYSICS.md 4, case\n// 2")
        self.expect("engine/a.cpp", "// PHYSICS.md 4, cases 1 and 9", 1, "PHYSICS.md 4 has no case 9")

    def test_a_fact_must_be_a_row_of_its_table(self):
        self.expect_clean("engine/a.cpp", 'Fact fact{"T58", "Up."};  // T1 to T58', "template <class T1> T1 f(T2);", "// <T9>")
        self.expect("engine/a.cpp", 'Fact fact{"T59", "Down."};', 1, "PHYSICS.md 5 has no fact T59")
        self.expect("tests/a.cpp", "// beyond facts T1 and T7", 1, "PHYSICS.md 5 has no fact T7")

    def test_a_sweep_of_the_table_must_be_one_of_the_program(self):
        self.expect_clean("engine/verify/degenerate/axis_cases.cpp", 'Case a{"along-axis"};')
        self.assertEqual(self.findings("engine/verify/degenerate/axis_cases.cpp", ""),
                         ["engine/PHYSICS.md:11: there is no sweep along-axis"])

    def test_what_the_build_makes_and_what_was_are_no_findings(self):
        self.expect_clean("build/README.md", "gone.md")
        self.expect_clean("CHANGELOG.md", "`optics/gone.h` is gone")


if __name__ == "__main__":
    unittest.main()
