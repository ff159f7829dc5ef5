#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Names every C++ file that clang-format 14 would change. Usage: format_check.sh ROOT
# To mend: clang-format-14 -i FILE. Other versions format differently: exit code 77, skipped, where 14 is not installed.
set -euo pipefail
command -v clang-format-14 >/dev/null || { echo "clang-format 14 is not installed" && exit 77; }
cd "$1"
folders=()
for folder in engine viewer tests; do [ -d "$folder" ] && folders+=("$folder"); done
find "${folders[@]}" \( -name '*.h' -o -name '*.cpp' \) -print0 | {
    status=0
    while IFS= read -r -d '' file; do
        clang-format-14 "$file" | cmp -s - "$file" || {
            echo "$file: not formatted; run clang-format-14 -i $file"
            status=1
        }
    done
    exit $status
}
