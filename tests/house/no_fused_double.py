#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Disassembles the program: no double is multiplied and added in one rounding. Where a compiler fuses for one instruction
set, the same scene has other last digits there (GCC 12 does so with complex products, in spite of -ffp-contract=off). Floats may:
they only choose which facet double decides about (engine/geometry/plane_scan.h).

Usage: no_fused_double.py PROGRAM      exit 77: nothing here disassembles
"""

import re
import shutil
import subprocess
import sys

FUSED = re.compile(r"\bvfn?m(?:add|sub|addsub|subadd)\d*[sp]d\b|\b(?:fn?madd|fn?msub)\s+d|\bfml[as]\s+v\d+\.2d")
FUNCTION = re.compile(r"^[0-9a-f]+ <(.*)>:$")


def fused_in(program):
    """Function -> how many fused operations on doubles it has."""
    found = {}
    function = "?"
    dump = subprocess.Popen(
        ["objdump", "-d", "-C", "--no-show-raw-insn", program], stdout=subprocess.PIPE, text=True, errors="replace"
    )
    for line in dump.stdout:
        heading = FUNCTION.match(line)
        if heading:
            function = heading[1]
        elif FUSED.search(line):
            found[function] = found.get(function, 0) + 1
    if dump.wait() != 0:
        sys.exit(f"objdump could not read {program}")
    return found


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    if shutil.which("objdump") is None:
        sys.exit(77)
    found = fused_in(sys.argv[1])
    for function, count in sorted(found.items()):
        print(f"{count} fused operations in {function}")
    sys.exit(bool(found))
