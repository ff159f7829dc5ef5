#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Copies engine/ with every fault of faults.py behind a switch: the environment variable POLARISCOPE_FAULT=N plants the
Nth at run time, 0 or nothing none. CMake does this for POL_FAULTS=ON; the real sources never hold a switch.

Usage: plant.py ENGINE COPY
"""

import re
import shutil
import sys
from pathlib import Path

from faults import FAULTS

HEADER = """// Made by tests/faults/plant.py.
#pragma once
#include <cstdlib>
namespace pol {
inline int planted_fault() {
    static const int number = std::getenv("POLARISCOPE_FAULT") ? std::atoi(std::getenv("POLARISCOPE_FAULT")) : 0;
    return number;
}
}  // namespace pol
"""


def switched(text, number):
    """`text` with FAULT(right, wrong) as the choice that fault `number` makes."""
    begin = text.index("FAULT(")
    depth, comma, end = 0, None, None
    for i in range(begin + len("FAULT"), len(text)):
        if text[i] in "([{":
            depth += 1
        elif text[i] in ")]}":
            depth -= 1
            if depth == 0:
                end = i
                break
        elif text[i] == "," and depth == 1:
            comma = i
    right, wrong = text[begin + len("FAULT(") : comma], text[comma + 1 : end]
    done = f"{text[:begin]}(::pol::planted_fault() == {number} ? ({wrong.strip()}) : ({right.strip()})){text[end + 1:]}"
    return switched(done, number) if "FAULT(" in done else done


def plant(engine, copy):
    sources = {}
    for number, (name, file, right, wrong) in enumerate(FAULTS, 1):
        text = sources.setdefault(file, (engine / file).read_text(encoding="utf-8"))
        if text.count(right) != 1:
            sys.exit(f"faults.py: '{name}': the text to change stands {text.count(right)} times in {file}")
        sources[file] = text.replace(right, switched(wrong, number))
    shutil.copytree(engine, copy, dirs_exist_ok=True)
    (copy / "core" / "planted_fault.h").write_text(HEADER, encoding="utf-8")
    for file, text in sources.items():
        text = re.sub(r"^#include", '#include "core/planted_fault.h"\n#include', text, count=1, flags=re.MULTILINE)
        (copy / file).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    plant(Path(sys.argv[1]), Path(sys.argv[2]))
    print(len(FAULTS), "faults planted")
