#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# How fast is it here? Builds the release preset, runs every Google Benchmark program (medians of 5), times whole renders and the
# window.
# against.sh compares the program with an older one at equal error, peers.sh with Mitsuba: minutes each, so they are not called here.
# Asserts nothing: a shared machine is not a stopwatch. Compare only figures of one run.
# Usage: tests/bench/run.sh [FILTER]     FILTER: a regular expression on benchmark names; with it no renders are timed
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd -P)
# shellcheck source=../support/setup.sh
. "$root/tests/support/setup.sh"

make_build_folder
install_packages run test
configure release -DPOL_TESTS=ON || fail "$(why_not_configured release run test)"
mapfile -t benches < <(ninja -C "$build/release" -t targets all | grep -oE '^polariscope_bench_[a-z0-9_]+' | sort -u)
cmake --build "$build/release" -j "${JOBS:-2}" --target polariscope ${benches[@]+"${benches[@]}"} -- --quiet

for bench in ${benches[@]+"${benches[@]}"}; do
    say "== $bench"
    program=$(find "$build/release" -name "$bench" -type f -perm -u+x -print -quit)
    "$program" --benchmark_filter="${1-.}" --benchmark_repetitions=5 --benchmark_report_aggregates_only=true 2>/dev/null |
        grep -E '^(Benchmark|-)|_median' || say "(nothing matches)"
done
[ $# -gt 0 ] && exit
python3 "$root/tests/bench/time_renders.py" "$build/release/polariscope" "$root/assets/scenes/bench"
exec python3 "$root/tests/bench/time_window.py" "$build/release/polariscope"
