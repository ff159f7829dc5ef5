#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# How much faster has the program become? A table of CPU seconds, errors and ratios at equal error, of another polariscope and the one
# in the build folder, rendering the same scenes in turns. Asserts nothing.
# Usage: tests/bench/against.sh OLD_PROGRAM [--quick] [--only ROW...] [...]     --help lists them; PROGRAM=FILE: the new program
# Exit codes: 0 done, 77 numpy cannot be had here
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd -P)
# shellcheck source=../support/setup.sh
. "$root/tests/support/setup.sh"
# shellcheck source=python_packages.sh
. "$root/tests/bench/python_packages.sh"

make_build_folder
python_with numpy
[ $# -gt 0 ] || set -- --help
case $1 in
-h | --help) exec "$python" "$root/tests/bench/against.py" --help ;;
esac
old=$1
shift
exec "$python" "$root/tests/bench/against.py" "$old" "${PROGRAM-$build/release/polariscope}" "$build/peers" "$@"
