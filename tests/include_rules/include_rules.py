#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks the house rules that no compiler sees: who may include whom, which folder may use which library, licence lines,
file lengths. Prints one `file:line: rule` per violation; exits 1 if there is any.

Usage: include_rules.py ROOT        (the top of a working tree)

The table is the one of engine/README.md. A header or library that no rule knows is a violation too: using a new one is a
decision, and it is taken here.
"""

import re
import sys
from pathlib import Path

# Folder of engine/ -> folders it may include. Every folder may include itself.
MAY_INCLUDE = {
    "core": [],
    "spectrum": ["core"],
    "polarization": ["core"],
    "optics": ["core", "spectrum", "polarization"],
    "media": ["core", "spectrum", "polarization"],
    "geometry": ["core"],
    "scene": ["core", "spectrum", "optics", "media", "geometry"],
    "plan": ["core", "spectrum", "polarization", "optics", "media", "geometry", "scene"],
    "tracer": ["core", "spectrum", "polarization", "optics", "media", "geometry", "scene", "plan"],
    "film": ["core", "spectrum", "polarization"],
    "maps": ["core", "spectrum", "polarization", "film"],
    "render": ["core", "spectrum", "polarization", "optics", "media", "geometry", "scene", "plan", "tracer", "film"],
    "io": ["core", "spectrum", "polarization", "optics", "media", "geometry", "scene", "plan/settings.h", "film", "maps"],
}
MAY_INCLUDE["verify"] = list(MAY_INCLUDE) + ["plan"]
MAY_INCLUDE["cli"] = list(MAY_INCLUDE) + ["plan"]

# A single header that some folders may not include although the table opens its folder to them.
NOT_FOR = {"geometry/ray_caster.h": ["scene", "io"]}

# Library headers by how their name begins -> where in engine/ they may be used ("" means everywhere).
LIBRARIES = {
    "glm/": [""],
    "boost/multiprecision/": [""],
    "hwy/": ["geometry/"],
    "embree3/": ["geometry/ray_caster.cpp"],
    "embree4/": ["geometry/ray_caster.cpp"],
    "OpenEXR/": ["io/"],
    "Imath/": ["io/"],
    "Imf": ["io/"],
    "openexr.h": ["io/"],
    "Iex": ["io/"],
    "yaml-cpp/": ["io/"],
    "png.h": ["io/"],
    "zlib.h": ["io/"],
    "tiny": ["io/"],
    "stb": ["io/"],
    "cairo": ["io/", "maps/"],
    "nlohmann/": ["io/", "verify/", "cli/"],
    "fmt/": ["io/", "verify/", "cli/"],
    "CLI/": ["cli/"],
    "fcntl.h": ["io/", "cli/"],
    "signal.h": ["io/", "cli/"],
    "unistd.h": ["io/", "cli/"],
    "sys/": ["io/", "cli/"],
}
# Threads live in render; the film guards itself with one mutex.
THREADS = {"thread", "mutex", "shared_mutex", "atomic", "condition_variable", "future", "semaphore", "latch", "barrier"}
THREAD_USERS = {"render": THREADS, "film": {"mutex"}}

# Part of viewer/ -> beginnings of library headers it may not include. The first part that a path begins with counts;
# what is not named is the session: no window, no GL, no ImGui.
IMGUI, GL, WINDOW = ("imgui",), ("GL/", "EGL/"), ("GLFW/",)
VIEWER_NOT = {
    "panels/": GL + WINDOW,
    "widgets/": GL + WINDOW,
    "interface": GL + WINDOW,
    "gl/": IMGUI + WINDOW,
    "picture_renderer": IMGUI + WINDOW,
    "app": (),
    "": IMGUI + GL + WINDOW,
}

SOURCES = {".h", ".cpp", ".vert", ".frag", ".glsl"}
SCRIPTS = {".py", ".sh"}
MAX_LINES = 600
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def without_comments(text):
    """The text with comments and string literals blanked, line breaks kept."""
    pattern = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.DOTALL)
    return pattern.sub(lambda m: re.sub(r"[^\n]", " ", m.group()), text)


def library_rule(path, header):
    """Why `path` (below engine/) may not include the library header, or None."""
    if "." not in header and "/" not in header:  # the standard library
        folder = path.split("/")[0]
        if header in THREADS and header not in THREAD_USERS.get(folder, set()):
            return f"<{header}>: threads live in render only (film: its mutex)"
        if header == "complex":
            return "<complex>: the engine has its own, core/complex.h"
        return None
    for beginning, users in LIBRARIES.items():
        if header.startswith(beginning):
            if any(path.startswith(user) for user in users):
                return None
            return f"<{header}> is for {', '.join(users)} only"
    return f"<{header}>: a library that the table of include_rules.py does not know"


def engine_rule(path, header):
    """Why `path` (below engine/) may not include the engine header "folder/name.h", or None."""
    folder, target = path.split("/")[0], header.split("/")[0]
    if folder not in MAY_INCLUDE:
        return f"folder {folder} is not in the include table"
    if "/" not in header:
        return f'"{header}": name the folder, as in "{folder}/{header}"'
    if folder in NOT_FOR.get(header, []):
        return f'{folder} may not include "{header}"'
    if target == folder or target in MAY_INCLUDE[folder] or header in MAY_INCLUDE[folder]:
        return None
    allowed = ", ".join(MAY_INCLUDE[folder]) or "the standard library and glm"
    return f'{folder} may not include "{header}" (it may include {allowed})'


def viewer_rule(path, header):
    """Why `path` (below viewer/) may not include the library header, or None."""
    part, beginnings = next(item for item in VIEWER_NOT.items() if path.startswith(item[0]))
    return f"viewer/{part or path} may not include <{header}>" if header.startswith(beginnings) else None


def check_includes(top, path, lines):
    for number, line in enumerate(lines, 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        quoted, header = match.group(1) == '"', match.group(2)
        if top == "engine":
            rule = engine_rule(path, header) if quoted else library_rule(path, header)
        else:
            rule = None if quoted else viewer_rule(path, header)
        if rule:
            yield number, rule


def check_file(root, file):
    """Yields (line, rule) for every violation in one file."""
    lines = file.read_text(encoding="utf-8").splitlines()
    top, path = file.relative_to(root).as_posix().split("/", 1)

    licence_line = 1 if lines and lines[0].startswith("#!") else 0
    if len(lines) <= licence_line or "SPDX-License-Identifier: Apache-2.0" not in lines[licence_line]:
        yield licence_line + 1, "the first line is the SPDX licence identifier"
    if len(lines) > MAX_LINES and not any("Long because" in line for line in lines):
        yield MAX_LINES + 1, f"{len(lines)} lines: split it, or say 'Long because ...' in a comment"
    if file.suffix not in {".h", ".cpp"}:
        return
    if file.suffix == ".h" and "#pragma once" not in lines:
        yield 1, "a header needs #pragma once"
    if top in ("engine", "viewer"):
        yield from check_includes(top, path, lines)
    if top == "engine":
        for number, line in enumerate(without_comments("\n".join(lines)).split("\n"), 1):
            if re.search(r"\bstd::complex\b", line):
                yield number, "std::complex: the engine has its own, core/complex.h"


def violations(root):
    """All violations below `root` as sorted lines of text."""
    found = []
    for top in ("engine", "viewer", "shaders", "tests"):
        for file in sorted((root / top).rglob("*")):
            if file.suffix in SOURCES | SCRIPTS and file.is_file():
                found += [f"{file.relative_to(root)}:{line}: {rule}" for line, rule in check_file(root, file)]
    return found


def main():
    if len(sys.argv) != 2 or not (Path(sys.argv[1]) / "engine").is_dir():
        sys.exit("usage: include_rules.py ROOT, the top of a working tree")
    found = violations(Path(sys.argv[1]).resolve())
    print("\n".join(found) if found else "no violations")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
