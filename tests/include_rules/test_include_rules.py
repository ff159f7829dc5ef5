#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Plants one violation at a time in an empty house and expects exactly that one to be named."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
import include_rules  # noqa: E402: after the switch above, which keeps the source tree clean

LICENCE = "// SPDX-License-Identifier: Apache-2.0\n"


class IncludeRules(unittest.TestCase):
    def violations(self, path, text):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / path
            file.parent.mkdir(parents=True)
            file.write_text(text, encoding="utf-8")
            return include_rules.violations(Path(folder))

    def expect_clean(self, path, code):
        self.assertEqual(self.violations(path, LICENCE + code), [])

    def expect_violation(self, path, code, line, word):
        found = self.violations(path, LICENCE + code)
        self.assertEqual(len(found), 1, found)
        self.assertTrue(found[0].startswith(f"{path}:{line}: "), found[0])
        self.assertIn(word, found[0])

    def test_downward_include_is_fine(self):
        self.expect_clean("engine/tracer/a.cpp", '#include "plan/plan.h"\n#include "core/vec.h"\n')

    def test_upward_include_is_named_with_its_line(self):
        self.expect_violation("engine/core/a.cpp", '\n#include "optics/fresnel.h"\n', 3, "core may not include")

    def test_every_folder_may_include_itself_and_core_and_no_folder_the_command_line(self):
        for folder in include_rules.MAY_INCLUDE:
            self.expect_clean(f"engine/{folder}/a.cpp", f'#include "{folder}/a.h"\n#include "core/vec.h"\n')
            if folder != "cli":
                self.expect_violation(f"engine/{folder}/a.cpp", '#include "cli/commands.h"\n', 2, "may not include")

    def test_no_two_folders_include_each_other(self):
        table = include_rules.MAY_INCLUDE
        for folder, below in table.items():
            for other in below:
                self.assertNotIn(folder, [] if folder == other else table.get(other, []), f"{folder} and {other}")

    def test_film_does_not_see_the_scene(self):
        self.expect_violation("engine/film/a.cpp", '#include "scene/scene.h"\n', 2, "film may not")

    def test_io_sees_the_settings_of_the_plan_only(self):
        self.expect_clean("engine/io/a.cpp", '#include "plan/settings.h"\n')
        self.expect_violation("engine/io/a.cpp", '#include "plan/compile.h"\n', 2, "io may not")

    def test_scene_does_not_see_the_ray_caster(self):
        self.expect_clean("engine/scene/a.h", '#pragma once\n#include "geometry/shape.h"\n')
        self.expect_violation("engine/scene/a.cpp", '#include "geometry/ray_caster.h"\n', 2, "ray_caster")

    def test_embree_is_hidden_in_one_file(self):
        self.expect_clean("engine/geometry/ray_caster.cpp", "#include <embree3/rtcore.h>\n")
        self.expect_violation("engine/geometry/ray_caster.h", "#pragma once\n#include <embree3/rtcore.h>\n", 3, "embree")
        self.expect_violation("engine/plan/a.cpp", "#include <embree3/rtcore.h>\n", 2, "embree")

    def test_file_formats_live_in_io(self):
        for header in ("OpenEXR/ImfHeader.h", "ImfHeader.h", "yaml-cpp/yaml.h", "png.h", "tiny_gltf.h", "stb_image.h"):
            self.expect_clean("engine/io/a.cpp", f"#include <{header}>\n")
            self.expect_violation("engine/maps/a.cpp", f"#include <{header}>\n", 2, header)

    def test_threads_live_in_render(self):
        for header in ("thread", "mutex", "atomic", "condition_variable"):
            self.expect_clean("engine/render/a.cpp", f"#include <{header}>\n")
            self.expect_violation("engine/tracer/a.cpp", f"#include <{header}>\n", 2, header)
        self.expect_clean("engine/film/a.h", "#pragma once\n#include <mutex>\n")
        self.expect_violation("engine/film/a.cpp", "#include <thread>\n", 2, "thread")

    def test_unknown_library_and_unknown_folder_are_violations(self):
        self.expect_violation("engine/core/a.cpp", "#include <Eigen/Dense>\n", 2, "does not know")
        self.expect_violation("engine/magic/a.cpp", '#include "core/vec.h"\n', 2, "not in the include table")

    def test_engine_never_sees_viewer_or_window(self):
        self.expect_violation("engine/cli/a.cpp", '#include "viewer/session.h"\n', 2, "viewer")
        self.expect_violation("engine/render/a.cpp", "#include <GLFW/glfw3.h>\n", 2, "does not know")

    def test_include_without_folder_is_a_violation(self):
        self.expect_violation("engine/core/a.cpp", '#include "vec.h"\n', 2, "name the folder")

    def test_viewer_session_knows_no_imgui_and_panels_know_no_gl(self):
        self.expect_violation("viewer/session.cpp", "#include <imgui.h>\n", 2, "imgui")
        self.expect_violation("viewer/panels/a.cpp", "#include <GL/glcorearb.h>\n", 2, "GL/")
        self.expect_clean("viewer/panels/a.cpp", "#include <imgui.h>\n")

    def test_std_complex_is_a_violation_in_code_and_not_in_a_comment(self):
        self.expect_clean("engine/core/a.cpp", "// not std::complex, see README\n")
        self.expect_violation("engine/core/a.cpp", "std::complex<double> z;\n", 2, "std::complex")

    def test_first_line_is_the_licence(self):
        found = self.violations("engine/core/a.cpp", "int x;\n")
        self.assertEqual(found, ["engine/core/a.cpp:1: the first line is the SPDX licence identifier"])
        self.assertEqual(self.violations("tests/x/a.sh", "#!/bin/sh\n# SPDX-License-Identifier: Apache-2.0\n"), [])
        self.assertEqual(len(self.violations("tests/x/a.cpp", "")), 1)

    def test_long_file_needs_a_reason(self):
        self.expect_clean("tests/x/a.cpp", "\n" * (include_rules.MAX_LINES - 1))
        self.expect_violation("tests/x/a.cpp", "\n" * include_rules.MAX_LINES, include_rules.MAX_LINES + 1, "split")
        self.expect_clean("tests/x/a.cpp", "// Long because of a table.\n" + "\n" * include_rules.MAX_LINES)

    def test_header_needs_pragma_once(self):
        self.expect_violation("engine/core/a.h", "int x;\n", 1, "pragma once")


if __name__ == "__main__":
    unittest.main()
