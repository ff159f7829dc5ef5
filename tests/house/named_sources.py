#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that what comments, docstrings, texts for users and Markdown name is there: files and folders of this tree, sections of
PHYSICS.md, CUTTING.md and CONVENTIONS.md, cases and sweeps of PHYSICS.md 4, facts (T1, T2, ...), and the `functions()` and (Tests: `Suite.Name...`) of
Markdown. Prints one `file:line: what is missing` per finding; exits 1 if there is any.

Usage: named_sources.py ROOT        (the top of a working tree)

A file is looked for at the top, in engine/, viewer/, tests/ and shaders/, and beside the file that names it; the three chapters are
found by name alone. NAME.md, FILE.md and patterns (*.cpp) are placeholders; a scene is a user's unless its name begins at the top. In texts of the program only what has a folder, or ends in .md, is taken for a file; texts in tests name files of their own.
"""

import os
import re
import sys
from pathlib import Path

SLASHES = {".h", ".cpp", ".frag", ".vert", ".glsl"}
HASHES = {".py", ".sh", ".cmake", ".yaml"}
NOT_OURS = {"build", "out", "shared", "__pycache__"}
TOPS = ("engine", "viewer", "tests", "shaders", "assets")
PLACES = ("", "engine", "viewer", "tests", "shaders")
# A change log names what was.
PAST = {"CHANGELOG.md"}
# What is named and is no file of this tree: headers of others, files that the build makes, a placeholder.
ELSEWHERE = ("GL/", "linux/", "embree3/", "embree4/", "tables.cpp", "shader_sources.cpp", "folder/name.h")
CHAPTERS = {"PHYSICS": "engine/PHYSICS.md", "CUTTING": "engine/CUTTING.md",
            "CONVENTIONS": "engine/polarization/CONVENTIONS.md"}

PLACEHOLDER = re.compile(r"(?<![A-Z])(?:NAME|FILE|FOLDER)(?![A-Z])")
BEFORE = r"(?<![\w./<*{}$~-])"
FILE = re.compile(BEFORE + r"(?:\.\.?/)*\w[\w./-]*\.(?:md|h|cpp|py|sh|yaml|frag|vert|glsl|cmake)\b(?![\w*{/]|\.\w)")
FOLDER = re.compile(BEFORE + rf"(?:{'|'.join(TOPS)})/[\w/-]*\w(?![\w*{{<$-]|\.\w)")
FENCED = re.compile(r"^```(?:cpp|cmake)\n.*?^```$", re.DOTALL | re.MULTILINE)  # a program of the reader's
LINK = re.compile(r"\]\(([^)#\s]+)[^)]*\)")
GAP = r"(?: |\s*\n\s*(?:///?<?|#)?\s*)"  # a blank, or a line break in a comment
NUMBER = r"\d+(?:\.\d+)*(?![\w.]*\w)"
CASES = rf",{GAP}cases?{GAP}\d+(?:(?:,|{GAP}and|{GAP}to){GAP}\d+)*"
CITED = re.compile(rf"\b({'|'.join(CHAPTERS)})\.md`?,?(?:{GAP}sections?)?"
                   rf"((?:(?:,|{GAP}and|{GAP}to)?{GAP}{NUMBER}(?:{CASES})?)+)")
FUNCTION = re.compile(r"`(?:\w+::)*(\w+)\(\)`")
TESTS = re.compile(r"\b[Tt]ests?: `[A-Z]\w+\.[^)]*")
TEST = re.compile(r"`([A-Z]\w+\.\w*)(?:\.\.\.|\*)?`")
FACT = re.compile(r"(?<![\w.-])T([1-9]\d?)(?![\w(<>{:]|\.\w)")


def parts_of_slashes(text):
    """(offset, text, is a comment) of every comment and string of C++ or GLSL; the strings of #include are none."""
    pattern = r'^\s*#\s*include[^\n]*|//[^\n]*(?:\n\s*//[^\n]*)*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\''
    for match in re.finditer(pattern, text, re.DOTALL | re.MULTILINE):
        if match.group()[0] in '/"':
            yield match.start(), match.group(), match.group()[0] == "/"


def parts_of_hashes(text, is_python):
    """The same of comments with #, and of the docstrings of Python."""
    comment = r"(?<!\S)#[^\n]*(?:\n\s*#[^\n]*)*"
    pattern = rf'(""").*?"""|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|{comment}' if is_python else comment
    for match in re.finditer(pattern, text, re.DOTALL):
        if match.group().startswith(("#", '"""')):
            yield match.start(), match.group(), True


def parts(file, text):
    if file.suffix in SLASHES:
        return parts_of_slashes(text)
    if file.suffix in HASHES or file.name == "CMakeLists.txt":
        return parts_of_hashes(text, file.suffix == ".py")
    blank = lambda match: re.sub(r"[^\n]", " ", match.group())
    return [(0, FENCED.sub(blank, text), True)] if file.suffix == ".md" else []


class House:
    """What can be named in a tree."""

    def __init__(self, root):
        self.root = root
        texts = {name: self.text_of(path) for name, path in CHAPTERS.items()}
        self.sections = {name: set(re.findall(r"^#+ (\d+(?:\.\d+)*)\.? ", text, re.MULTILINE)) for name, text in texts.items()}
        self.tests = set()
        for file in (root / "tests").rglob("*.cpp"):
            found = re.findall(r"^TEST(?:_[FP])?\((\w+), *(\w+)\)", file.read_text(encoding="utf-8"), re.MULTILINE)
            self.tests.update(".".join(names) for names in found)
        self.words = set()
        for file in (file for top in ("engine", "viewer", "shaders") for file in (root / top).rglob("*")):
            if file.suffix in SLASHES:
                self.words.update(re.findall(r"\w+", file.read_text(encoding="utf-8")))
        self.facts = set(re.findall(r"^\| T(\d+) \|", texts["PHYSICS"], re.MULTILINE))
        self.cases = set(re.findall(r"^\| (\d+) \|", texts["PHYSICS"], re.MULTILINE))

    def text_of(self, path):
        file = self.root / path
        return file.read_text(encoding="utf-8") if file.is_file() else ""

    def has(self, name, beside):
        if name.startswith(ELSEWHERE) or name in map(os.path.basename, CHAPTERS.values()):
            return True
        return any((folder / name).exists() for folder in [*(self.root / place for place in PLACES), beside])

    def missing_sweeps(self):
        code = "".join(file.read_text(encoding="utf-8") for file in (self.root / "engine/verify").rglob("*.cpp"))
        for number, line in enumerate(self.text_of(CHAPTERS["PHYSICS"]).split("\n"), 1):
            cells = re.split(r"(?<!\\)\|", line)
            if re.match(r"\| \d+ \|", line) and len(cells) == 6:
                for name in re.findall(r"`([^`]+)`", cells[4]):
                    if f'"{name}"' not in code:
                        yield f"{CHAPTERS['PHYSICS']}:{number}: there is no sweep {name}"


def missing_files(house, file, text, is_comment):
    """(offset, complaint) for every file or folder that the text names and the tree does not have."""
    for match in [*FILE.finditer(text), *FOLDER.finditer(text)]:
        name = match.group()
        is_users = (not name.startswith(tuple(f"{top}/" for top in TOPS)) if name.endswith(".yaml") else
                    not is_comment and "/" not in name and not name.endswith(".md"))
        if not PLACEHOLDER.search(name) and not is_users and not house.has(name, file.parent):
            yield match.start(), f"there is no {name}"
    if file.suffix == ".md":
        for match in FUNCTION.finditer(text):
            if match.group(1) not in house.words:
                yield match.start(), f"there is no {match.group().strip('`')}"
        for group in TESTS.finditer(text):
            for match in TEST.finditer(group.group()):
                if not any(test.startswith(match.group(1)) for test in house.tests):
                    yield group.start() + match.start(), f"there is no test {match.group(1)}"
        for match in LINK.finditer(text):
            if "://" not in match.group(1) and not house.has(match.group(1), file.parent):
                yield match.start(1), f"there is no {match.group(1)}"


def missing_sections(house, text):
    """(offset, complaint) for every section, case or fact that the text names and its chapter does not have."""
    for match in CITED.finditer(text):
        chapter, places = match.groups()
        for cases in re.findall(CASES, places):
            for case in sorted(set(re.findall(r"\d+", cases)) - house.cases):
                yield match.start(), f"PHYSICS.md 4 has no case {case}"
        for section in sorted(set(re.findall(r"\d+(?:\.\d+)*", re.sub(CASES, "", places))) - house.sections[chapter]):
            yield match.start(), f"{chapter}.md has no section {section}"
    for match in FACT.finditer(text):
        if match.group(1) not in house.facts:
            yield match.start(), f"PHYSICS.md 5 has no fact {match.group()}"


def findings_in(house, file):
    text = file.read_text(encoding="utf-8")
    is_test = file.relative_to(house.root).parts[0] == "tests"
    for offset, part, is_comment in parts(file, text):
        names = missing_files(house, file, part, is_comment) if is_comment or not is_test else []
        for at, complaint in [*names, *missing_sections(house, part)]:
            yield text.count("\n", 0, offset + at) + 1, complaint


def findings(root):
    """All findings below `root` as lines of text."""
    house = House(root)
    found = []
    for folder, folders, names in os.walk(root):
        folders[:] = sorted(name for name in folders if name not in NOT_OURS and not name.startswith("."))
        for file in (Path(folder) / name for name in sorted(names) if name not in PAST):
            if file.suffix in SLASHES | HASHES | {".md"} or file.name == "CMakeLists.txt":
                found += [f"{file.relative_to(root)}:{line}: {text}" for line, text in sorted(set(findings_in(house, file)))]
    return found + list(house.missing_sweeps())


def main():
    if len(sys.argv) != 2 or not (Path(sys.argv[1]) / "engine").is_dir():
        sys.exit("usage: named_sources.py ROOT, the top of a working tree")
    found = findings(Path(sys.argv[1]).resolve())
    print("\n".join(found) if found else "everything that is named is there")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
