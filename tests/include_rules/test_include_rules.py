#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Plants one violation at a time in an empty house and expects exactly that one to be named."""

import re
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
import include_rules  # noqa: E402: after the switch above, which keeps the source tree clean

TABLE = Path(__file__).resolve().parents[2] / "rooms.txt"
ROOMS = include_rules.read_rooms(TABLE)
LICENCE = "// SPDX-License-Identifier: Apache-2.0\n"


class IncludeRules(unittest.TestCase):
    def violations(self, path, text, *others):
        """Of a house with this file, and `others` as (path, text)."""
        with tempfile.TemporaryDirectory() as folder:
            for name, content in [(path, text), *others]:
                file = Path(folder) / name
                file.parent.mkdir(parents=True)
                file.write_text(content, encoding="utf-8")
            shutil.copy(TABLE, folder)
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

    def test_every_room_may_include_itself_and_only_the_window_sees_the_command_line(self):
        for name, room in ROOMS.items():
            self.assertIn(name, room.rooms)
            if name not in ("engine/cli", "viewer/app"):
                self.assertNotIn("engine/cli", room.rooms)
                self.expect_violation(f"{name}/a.cpp", '#include "cli/messages.h"\n', 2, "may not include")

    def test_no_two_rooms_include_each_other(self):
        for name, room in ROOMS.items():
            for other in room.rooms - {name}:
                self.assertNotIn(name, ROOMS[other].rooms, f"{name} and {other}")

    def test_every_folder_with_sources_has_a_row_and_every_row_has_sources(self):
        root = TABLE.parent
        folders = {str(f.parent.relative_to(root)) for top in ("engine", "viewer") for f in (root / top).rglob("*.h")}
        self.assertEqual(folders, set(ROOMS))

    def test_no_row_names_a_library_that_its_room_does_not_use(self):
        root = TABLE.parent
        for name, room in ROOMS.items():
            headers = {h for f in (root / name).glob("*.*") for h in re.findall(r"#\s*include <([^>]+)>", f.read_text())}
            used = {lib for h in headers for start, lib in include_rules.LIBRARIES.items() if h.startswith(start)}
            used |= {"threads"} if headers & include_rules.THREADS else set()
            used |= {"mutex"} & headers
            self.assertEqual(room.libraries - used, set(), name)

    def test_a_row_sees_only_what_stands_above_it(self):
        with tempfile.TemporaryDirectory() as folder:
            table = Path(folder) / "rooms.txt"
            table.write_text("engine/a | low | b |\nengine/b | high | |\n", encoding="utf-8")
            with self.assertRaisesRegex(SystemExit, "rooms.txt:1: 'b' is no room that stands above engine/a"):
                include_rules.read_rooms(table)

    def test_an_installed_header_stands_by_itself(self):
        self.expect_clean("engine/polariscope/a.h", '#pragma once\n#include <complex>\n#include "polariscope/result.h"\n')
        self.expect_clean("engine/polariscope/a.cpp", '#include <glm/vec3.hpp>\n#include "plan/plan.h"\n')
        for include in ("<glm/vec3.hpp>", '"plan/plan.h"', '"polariscope/inside.h"'):
            self.expect_violation("engine/polariscope/a.h", f"#pragma once\n#include {include}\n", 3, "installed header")

    def test_film_does_not_see_the_scene(self):
        self.expect_violation("engine/film/a.cpp", '#include "scene/scene.h"\n', 2, "film may not")

    def test_readers_see_no_plan(self):
        self.expect_violation("engine/io/scenes/a.cpp", '#include "plan/compile.h"\n', 2, "may not include")

    def test_widgets_see_no_session_and_no_document(self):
        for header in ("session/session.h", "document/document.h", "pages/pixel_page.h"):
            self.expect_violation("viewer/widgets/a.h", f'#pragma once\n#include "viewer/{header}"\n', 3, "may not include")

    def test_scene_does_not_see_the_ray_caster(self):
        self.expect_clean("engine/scene/a.h", '#pragma once\n#include "geometry/shape.h"\n')
        self.expect_violation("engine/scene/a.cpp", '#include "geometry/ray_caster.h"\n', 2, "ray_caster")

    def test_embree_is_hidden_in_one_file(self):
        self.expect_clean("engine/geometry/ray_caster.cpp", "#include <embree3/rtcore.h>\n")
        self.expect_violation("engine/geometry/ray_caster.h", "#pragma once\n#include <embree3/rtcore.h>\n", 3, "embree")
        self.expect_violation("engine/plan/a.cpp", "#include <embree3/rtcore.h>\n", 2, "embree")

    def test_file_formats_live_in_io(self):
        for room, header in (("pictures", "OpenEXR/ImfHeader.h"), ("pictures", "ImfHeader.h"), ("files", "yaml-cpp/yaml.h"),
                             ("pictures", "png.h"), ("meshes", "tiny_gltf.h")):
            self.expect_clean(f"engine/io/{room}/a.cpp", f"#include <{header}>\n")
            self.expect_violation("engine/maps/a.cpp", f"#include <{header}>\n", 2, header)

    def test_threads_live_in_render(self):
        for header in ("thread", "mutex", "atomic", "condition_variable"):
            self.expect_clean("engine/render/a.cpp", f"#include <{header}>\n")
            self.expect_violation("engine/tracer/a.cpp", f"#include <{header}>\n", 2, header)
        self.expect_clean("engine/film/a.h", "#pragma once\n#include <mutex>\n")
        self.expect_violation("engine/film/a.cpp", "#include <thread>\n", 2, "thread")

    def test_unknown_library_and_unknown_folder_are_violations(self):
        self.expect_violation("engine/core/a.cpp", "#include <Eigen/Dense>\n", 2, "does not know")
        self.expect_violation("engine/magic/a.cpp", '#include "core/vec.h"\n', 1, "no row")

    def test_engine_never_sees_viewer_or_window(self):
        self.expect_violation("engine/cli/a.cpp", '#include "viewer/session/session.h"\n', 2, "viewer")
        self.expect_violation("engine/render/a.cpp", "#include <GLFW/glfw3.h>\n", 2, "viewer/app")

    def test_matter_sheets_and_spectra_are_visited_not_picked_out(self):
        for kind in ("IsotropicMedium", "UniaxialMedium", "ConductorMedium", "CircularPolarizer", "TabulatedSpectrum"):
            for picked in (f"std::get_if<{kind}>(&m)", f"std::holds_alternative<{kind}>(m)", f"get_if<\n    pol::{kind}\n>(&m)"):
                for path in ("engine/io/scenes/a.cpp", "viewer/panels/a.cpp"):
                    self.expect_violation(path, f"\nbool f() {{ return {picked}; }}\n", 3, f"{kind} is picked out")
        self.expect_clean("engine/scene/a.cpp", "std::get<UniaxialMedium>(m);\n// std::get_if<UniaxialMedium>(&m)\n")
        self.expect_clean("engine/scene/a.cpp", "std::get_if<UniaxialMediumOfAnother>(&m);\n")

    def test_include_without_folder_is_a_violation(self):
        self.expect_violation("engine/core/a.cpp", '#include "vec.h"\n', 2, "name the folder")

    def test_viewer_session_knows_no_imgui_and_panels_know_no_gl(self):
        self.expect_violation("viewer/session/session.cpp", "#include <imgui.h>\n", 2, "imgui")
        self.expect_violation("viewer/panels/a.cpp", "#include <GL/glcorearb.h>\n", 2, "GL/")
        self.expect_clean("viewer/panels/a.cpp", "#include <imgui.h>\n")

    def test_a_panel_takes_nothing_that_it_could_change(self):
        for code in ("void draw(Session& session);", "void draw(const Plan& plan, Document &document);", "Session* session_;",
                     "auto& writable = const_cast<ViewSettings&>(view);", "fs::directory_iterator(folder);"):
            self.expect_violation("viewer/panels/a.h", f"#pragma once\n{code}\n", 3, "a panel reads")
            self.expect_violation("viewer/panels/a.cpp", code + "\n", 2, "a panel reads")
            self.expect_clean("viewer/commands/a.cpp", code + "\n")
        self.expect_clean("viewer/panels/a.h", "#pragma once\nvoid draw(const Session& session, const Document* of);\n")
        self.expect_clean("viewer/panels/a.cpp", "wishes.add([pin](Session& s) { s.pin(pin); });  // Session& is theirs\n")

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

    def test_a_name_is_one_type(self):
        text = LICENCE + "#pragma once\nnamespace pol {\n\nstruct Twice {\n    int x;\n};\n\n}\n"
        first, second = "engine/core/a.h", "viewer/session/a.h"
        self.assertEqual(self.violations(first, text, (second, text)), [f"{second}:5: pol::Twice is another type in {first}"])
        for other in (text.replace("pol {", "pol::test {"), text.replace(" {\n    int x;\n}", ""), text.replace("Twice", "Once")):
            self.assertEqual(self.violations(first, text, (second, other)), [])

    def test_header_needs_pragma_once(self):
        self.expect_violation("engine/core/a.h", "int x;\n", 1, "pragma once")


if __name__ == "__main__":
    unittest.main()
