#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks the house rules that no compiler sees: who may include whom and which room may use which library (rooms.txt),
licence lines, file lengths, what is visited in full, that panels only read. Prints one `file:line: rule` per violation;
exits 1 if there is any.

Usage: include_rules.py ROOT        (the top of a working tree)

A header or library that no row knows is a violation too: using a new one is a decision, and it is taken there.
"""

import re
import sys
from pathlib import Path

# Headers of a library by how their names begin -> its name in rooms.txt. What no row here knows is a violation.
LIBRARIES = {
    "boost/multiprecision/": None,  # None: for every room
    "glm/": None,
    "hwy/": "highway",
    "embree3/": "embree",
    "embree4/": "embree",
    "OpenEXR/": "openexr",
    "Imath/": "openexr",
    "Imf": "openexr",
    "openexr.h": "openexr",
    "Iex": "openexr",
    "xxhash.h": "xxhash",
    "yaml-cpp/": "yaml-cpp",
    "png.h": "png",
    "zlib.h": "zlib",
    "tiny_gltf": "tinygltf",
    "cairo": "cairo",
    "nlohmann/": "json",
    "fmt/": "fmt",
    "CLI/": "cli11",
    "imgui": "imgui",
    "fontconfig/": "fontconfig",
    "GL/": "opengl",
    "EGL/": "opengl",
    "GLFW/": "glfw",
    "arpa/": "posix",
    "fcntl.h": "posix",
    "netdb.h": "posix",
    "netinet/": "posix",
    "poll.h": "posix",
    "signal.h": "posix",
    "unistd.h": "posix",
    "sys/": "posix",
}
THREADS = {"thread", "shared_mutex", "atomic", "condition_variable", "future", "semaphore", "latch", "barrier", "stop_token"}
# The room whose headers are installed. They stand by themselves: the standard library and each other.
FRONT_DOOR = "engine/polariscope"
NOT_INSTALLED = {"engine/polariscope/inside.h"}
# A library that one file of its room hides from all others.
ONLY_IN = {"embree": "engine/geometry/ray_caster.cpp"}
# A single header that some rooms may not include although the table opens its room to them.
NOT_FOR = {"engine/geometry/ray_caster.h": ["engine/scene", "engine/io/meshes", "engine/io/scenes"]}


class Room:
    """A row of rooms.txt: which rooms it may include (itself, too) and which libraries it may use."""

    def __init__(self, about, rooms, libraries):
        self.about, self.rooms, self.libraries = about, rooms, libraries


def read_rooms(file):
    """The table as {name: Room}. Rows see only rows above them."""
    rooms = {}
    for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
        if not line.strip() or line.startswith("#"):
            continue
        cells = [cell.strip() for cell in line.split("|")]
        if len(cells) != 4 or not cells[0] or not cells[1]:
            sys.exit(f"{file}:{number}: a row is: room | what it is about | rooms | libraries")
        name, about, may_include, libraries = cells
        seen = {name}
        for word in may_include.split():
            room = word.rstrip("+")
            if room.split("/")[0] not in ("engine", "viewer"):
                room = f"{name.split('/')[0]}/{room}"
            if room not in rooms:
                sys.exit(f"{file}:{number}: '{word}' is no room that stands above {name}")
            seen |= rooms[room].rooms if word.endswith("+") else {room}
        rooms[name] = Room(about, seen, set(libraries.split()))
    return rooms


SOURCES = {".h", ".cpp", ".vert", ".frag", ".glsl"}
SCRIPTS = {".py", ".sh"}
MAX_LINES = 600
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def without_comments(text):
    """The text with comments and string literals blanked, line breaks kept."""
    pattern = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.DOTALL)
    return pattern.sub(lambda m: re.sub(r"[^\n]", " ", m.group()), text)


def is_installed(path):
    return str(Path(path).parent) == FRONT_DOOR and path.endswith(".h") and path not in NOT_INSTALLED


def library_rule(rooms, path, header):
    """Why the file `path` may not include the library header, or None."""
    name = str(Path(path).parent)
    if "." not in header and "/" not in header:  # the standard library
        library = "mutex" if header == "mutex" else "threads" if header in THREADS else None
        if library and library not in rooms[name].libraries:
            return f"<{header}>: {name} has no {library}"
        if header == "complex" and path.startswith("engine/") and name != FRONT_DOOR:
            return "<complex>: the engine has its own, core/complex.h"
        return None
    if is_installed(path):
        return f"<{header}>: an installed header needs nothing but the standard library"
    for beginning, library in LIBRARIES.items():
        if header.startswith(beginning):
            if library is None or (library in rooms[name].libraries and ONLY_IN.get(library, path) == path):
                return None
            where = ONLY_IN.get(library) or ", ".join(r for r in rooms if library in rooms[r].libraries) or "no room"
            return f"<{header}> is for {where} only"
    return f"<{header}>: a library that the table of include_rules.py does not know"


def room_rule(rooms, path, header):
    """Why the file `path` may not include the header of a room, as in "core/vec.h" or "viewer/shown/glyphs.h", or None."""
    name = str(Path(path).parent)
    full = header if header.startswith("viewer/") else "engine/" + header
    target = str(Path(full).parent)
    if "/" not in header:
        return f'"{header}": name the folder, as in "{name.removeprefix("engine/")}/{header}"'
    if name in NOT_FOR.get(full, []):
        return f'{name} may not include "{header}"'
    if is_installed(path) and not is_installed(full):
        return f'an installed header may not include "{header}"'
    if target in rooms[name].rooms:
        return None
    allowed = ", ".join(sorted(rooms[name].rooms - {name})) or "the standard library and glm"
    return f'{name} may not include "{header}" (it may include {allowed})'


# Kinds that are visited in full, so that a new one does not compile before everything has been told of it.
VISITED = ("IsotropicMedium", "UniaxialMedium", "ConductorMedium", "LinearPolarizer", "Retarder", "CircularPolarizer",
           "ConstantSpectrum", "D65Spectrum", "TabulatedSpectrum")
PICKED = re.compile(r"\b(?:get_if|holds_alternative)\s*<\s*(?:const\s+)?(?:pol::)?(" + "|".join(VISITED) + r")\b")

# Panels read (viewer/panels/README.md). Only what is done later, a lambda that is wished, may take these to change them.
CHANGED_BY_PANEL = re.compile(r"(?<!const )(?<!\]\()\b(Session|Document)\s*[&*]|\bconst_cast\b")
# The folder that the user types is looked into while he does.
LOOKS_INTO_FOLDERS = "viewer/panels/open_dialog.cpp"


def panel_rule(path, code):
    """Why a panel may not have this line of code, or None."""
    if match := CHANGED_BY_PANEL.search(code):
        return f"{match.group()}: a panel reads, and wishes for what is to change (viewer/session/wishes.h)"
    if "directory_iterator" in code and path != LOOKS_INTO_FOLDERS:
        return "a panel reads no folder while it draws"
    return None


def check_includes(rooms, path, lines):
    if str(Path(path).parent) not in rooms:
        yield 1, f"folder {Path(path).parent} has no row in rooms.txt"
        return
    for number, line in enumerate(lines, 1):
        match = INCLUDE.match(line)
        if match:
            rule = room_rule if match.group(1) == '"' else library_rule
            if why := rule(rooms, path, match.group(2)):
                yield number, why


def check_file(root, rooms, file):
    """Yields (line, rule) for every violation in one file."""
    lines = file.read_text(encoding="utf-8").splitlines()
    path = file.relative_to(root).as_posix()
    top = path.split("/")[0]

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
        yield from check_includes(rooms, path, lines)
    code = without_comments("\n".join(lines))
    if top in ("engine", "viewer"):
        for match in PICKED.finditer(code):
            number = code.count("\n", 0, match.start()) + 1
            yield number, f"{match.group(1)} is picked out: std::visit all kinds, which a new one then cannot miss"
    for number, line in enumerate(code.split("\n"), 1):
        if top == "engine" and not is_installed(path) and re.search(r"\bstd::complex\b", line):
            yield number, "std::complex: the engine has its own, core/complex.h"
        if path.startswith("viewer/panels/") and (why := panel_rule(path, line)):
            yield number, why


NAMESPACE = re.compile(r"^namespace ([\w:]+) \{")
TYPE = re.compile(r"^(?:struct|class|enum class) (?:alignas\(\w+\) )?(\w+)\b(?! *<)[^;]*\{")


def types_of(file):
    """Yields (line, type with its namespace) for every type that a header defines for all."""
    namespace = ""
    for number, line in enumerate(without_comments(file.read_text(encoding="utf-8")).split("\n"), 1):
        if match := NAMESPACE.match(line):
            namespace = match.group(1)
        elif match := TYPE.match(line):
            yield number, f"{namespace}::{match.group(1)}"


def one_definition(root):
    """Yields a line of text for every type that two headers define: the linker keeps one of their functions."""
    seen = {}
    for top in ("engine", "viewer"):
        for file in sorted((root / top).rglob("*.h")):
            path = file.relative_to(root)
            for line, name in types_of(file):
                if name in seen:
                    yield f"{path}:{line}: {name} is another type in {seen[name]}"
                seen.setdefault(name, path)


def violations(root):
    """All violations below `root` as sorted lines of text."""
    rooms = read_rooms(root / "rooms.txt")
    found = []
    for top in ("engine", "viewer", "shaders", "tests"):
        for file in sorted((root / top).rglob("*")):
            if file.suffix in SOURCES | SCRIPTS and file.is_file():
                found += [f"{file.relative_to(root)}:{line}: {rule}" for line, rule in check_file(root, rooms, file)]
    return found + list(one_definition(root))


def main():
    if len(sys.argv) != 2 or not (Path(sys.argv[1]) / "engine").is_dir():
        sys.exit("usage: include_rules.py ROOT, the top of a working tree")
    found = violations(Path(sys.argv[1]).resolve())
    print("\n".join(found) if found else "no violations")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
