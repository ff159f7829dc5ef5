#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# How long do we take to a given error, and how long does Mitsuba 3 take? Installs Mitsuba's official package in a virtual environment
# in the build folder, renders the same scenes in both programs, checks that the pictures agree, and writes a table and a plot of
# error against CPU time. Asserts no speed. Half an hour; --quick: two minutes.
# Usage: tests/bench/peers.sh [--quick] [--only SCENE...] [...]     --help lists them; PROGRAM=FILE: this polariscope instead of building it
# Exit codes: 0 done, 1 a picture differs by more than noise, 77 Mitsuba cannot be had here
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd -P)
# shellcheck source=../support/setup.sh
. "$root/tests/support/setup.sh"
# shellcheck source=python_packages.sh
. "$root/tests/bench/python_packages.sh"

make_build_folder
if [ -z "${PROGRAM-}" ]; then
    install_packages run
    configure release || fail "$(why_not_configured release run)"
    cmake --build "$build/release" -j "${JOBS:-2}" --target polariscope -- --quiet
    PROGRAM=$build/release/polariscope
fi

# find_llvm: the newest LLVM that Dr.Jit, below Mitsuba, can use: with 15 it aborts.
find_llvm() {
    /sbin/ldconfig -p | sed -nE 's/.*=> (.*\/libLLVM(-|\.so\.)([0-9]+).*)$/\3 \1/p' | sort -rn | awk '$1 >= 16 { print $2; exit }'
}
DRJIT_LIBLLVM_PATH=${DRJIT_LIBLLVM_PATH-$(find_llvm)}
if [ -z "$DRJIT_LIBLLVM_PATH" ] && [ "$(this_system)" = debian ]; then
    (install_packages peers) || not_here "Mitsuba needs LLVM 16 or newer"
    DRJIT_LIBLLVM_PATH=$(find_llvm)
fi
[ -n "$DRJIT_LIBLLVM_PATH" ] || not_here "Mitsuba needs the library of LLVM 16 or newer; install $(how_to_install "$(this_system)" peers), or set DRJIT_LIBLLVM_PATH"
export DRJIT_LIBLLVM_PATH

python_with mitsuba matplotlib pyyaml
"$python" -c '
import mitsuba
mitsuba.set_variant("llvm_ad_mono_polarized")
mitsuba.render(mitsuba.load_dict(mitsuba.cornell_box()), spp=1).numpy()
' >"$build/peers/mitsuba.log" 2>&1 ||
    not_here "Mitsuba does not render with $DRJIT_LIBLLVM_PATH, see $build/peers/mitsuba.log: $(tail -n 1 "$build/peers/mitsuba.log")"
exec "$python" "$root/tests/bench/peers.py" "$PROGRAM" "$build/peers" "$@"
