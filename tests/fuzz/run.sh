#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds the fuzz targets and runs them. See --help.
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd -P)
every_kind=(scene mesh index texture exr array live)

usage() {
    cat <<END
Usage: tests/fuzz/run.sh [SECONDS [KIND...]]

Builds the libFuzzer targets (preset asan: clang, address and undefined sanitizers) and runs each for SECONDS, 12 by
default, JOBS of them at a time, 2 by default. KIND: ${every_kind[*]}; all by default.
A target starts with tests/fuzz/corpus/KIND, the shipped assets of its kind and what earlier runs found worth keeping
(build/fuzz/corpus/KIND). An input that crashes, leaks, takes more than 60 s or 4 GiB is kept in build/fuzz/findings; the
exit code is the number of targets with such an input, 100 if the build breaks, or 101 for wrong arguments.
END
}

case ${1:-} in
-h | --help) usage && exit 0 ;;
0* | *[!0-9]*) usage >&2 && exit 101 ;;
esac
seconds=${1:-12}
kinds=("${@:2}")
[ $# -ge 2 ] || kinds=("${every_kind[@]}")
for kind in "${kinds[@]}"; do
    [ -f "$root/tests/fuzz/fuzz_$kind.cpp" ] || { usage >&2 && exit 101; }
done

# shellcheck source=tests/support/setup.sh
. "$root/tests/support/setup.sh"
make_build_folder
configure asan || { why_not_configured asan run test >&2 && exit 100; }
built=$build/asan
build=$build/fuzz
mkdir -p "$build"
cmake --build "$built" -j "${JOBS:-2}" --target polariscope_fuzz -- --quiet || exit 100

# Every input becomes a file, most of the work if that lies on a disk.
scratch=$(mktemp -d -p /dev/shm 2>/dev/null || mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export TMPDIR=$scratch # where the targets write the files that they read
# Recording who allocated takes a third of the time; a finding that is run alone says it in full.
export ASAN_OPTIONS=malloc_context_size=2
# Scenes name textures, which are another target's business: here all are small.
mkdir -p "$scratch/assets/textures"
ln -s "$root/assets/refractive_index" "$root/assets/scenes" "$scratch/assets"
for texture in "$root"/assets/textures/*.png; do
    cp "$root/tests/fuzz/corpus/texture/gray1.png" "$scratch/assets/textures/$(basename "$texture")"
done
export POLARISCOPE_ASSETS=$scratch/assets
# Address space randomization wider than the sanitizers expect makes them abort on some kernels.
unrandomized=()
setarch "$(uname -m)" -R true 2>/dev/null && unrandomized=(setarch "$(uname -m)" -R)

# fuzz KIND: says what was run and how far it got; the log stays in build/fuzz.
fuzz() {
    local kind=$1 corpus=$build/corpus/$1 log=$build/$1.log verdict=ok edges inputs
    mkdir -p "$corpus" "$build/findings"
    [ -d "$root/tests/fuzz/corpus/$kind" ] && cp "$root/tests/fuzz/corpus/$kind"/* "$corpus"
    case $kind in
    scene) cp "$root"/assets/scenes/*.yaml "$corpus" ;;
    index) cp "$root"/assets/refractive_index/*.yml "$corpus" ;;
    texture) cp "$root"/assets/textures/*.png "$corpus" ;;
    array) cp "$root"/tests/data/pictures/stokes_dialects/*.{npy,npz,png,fits} "$corpus" ;;
    esac
    "${unrandomized[@]}" "$built/tests/fuzz/polariscope_fuzz_$kind" -max_total_time="$seconds" -timeout=60 -report_slow_units=60 \
        -rss_limit_mb=4096 -print_final_stats=1 -artifact_prefix="$build/findings/$kind-" "$corpus" </dev/null >"$log" 2>&1 || {
        verdict="FAILED, see build/fuzz/findings"
        touch "$scratch/$kind.failed"
        tail -n 40 "$log"
    }
    edges=$(sed -nE 's/^#[0-9]+.* cov: ([0-9]+) .*/\1/p' "$log" | sed -n '1p;$p' | paste -sd ' ' | sed 's/ / to /')
    inputs=$(sed -nE 's/^stat::number_of_executed_units: //p' "$log")
    say "fuzz $kind: ${inputs:-?} inputs, ${edges:-?} edges, $verdict"
}

running=0
for kind in "${kinds[@]}"; do
    if [ $running -eq "${JOBS:-2}" ]; then
        wait -n
        running=$((running - 1))
    fi
    fuzz "$kind" &
    running=$((running + 1))
done
wait
exit "$(find "$scratch" -name '*.failed' | wc -l)"
