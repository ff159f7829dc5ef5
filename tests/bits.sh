#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Pictures, maps, explanations and reports of everything that is shipped, to see whether two programs, compilers or systems give
# the same bits: run it for both, then diff -r the folders. See --help.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd -P)

usage() {
    cat <<'END'
Usage: tests/bits.sh FOLDER [PROGRAM]

Renders every shipped scene, small, and a torus that only Embree can intersect, in glass and in calcite, into FOLDER: EXR, every
map, the explanation of a pixel, the plan, the facts and the stiff cases. PROGRAM: polariscope, by default build/release's.
SIZE=N renders N x N pixels instead of 96 x 96.

Two Debians:   KEEP=12 tests/distro.sh bookworm './run.sh --render && tests/bits.sh out'
               KEEP=13 tests/distro.sh trixie './run.sh --render && tests/bits.sh out'
               diff -r 12 13
END
}
case ${1-} in
-h | --help) usage && exit 0 ;;
-* | "") usage >&2 && exit 2 ;;
esac
size=${SIZE:-96}
folder=$(realpath -m -- "$1")
program=$(realpath -- "${2-${BUILD:-$root/build}/release/polariscope}")
mkdir -p "$folder"
cd "$folder"

# Not convex, so that Embree proposes its hits; 48 x 24 quads cut in two.
awk 'BEGIN {
    pi = atan2(0, -1)
    for (i = 0; i < 48; i++) for (j = 0; j < 24; j++) {
        u = 2 * pi * i / 48; v = 2 * pi * j / 24
        printf "v %.12f %.12f %.12f\n", (1 + 0.4 * cos(v)) * cos(u), (1 + 0.4 * cos(v)) * sin(u), 0.4 * sin(v)
    }
    for (i = 0; i < 48; i++) for (j = 0; j < 24; j++) {
        next_i = (i + 1) % 48; next_j = (j + 1) % 24
        a = 24 * i + j + 1; b = 24 * next_i + j + 1; c = 24 * next_i + next_j + 1; d = 24 * i + next_j + 1
        print "f", a, b, c
        print "f", a, c, d
    }
}' >torus.obj
for medium in glass calcite; do
    cat >"torus-$medium.yaml" <<END
render: {wavelengths: [450, 580, 650], spp: 4}
camera: {position: [0.4, -4, 2.5], target: [0, 0, 0], up: [0, 0, 1], fov: 40}
media: {glass: 1.5, calcite: {crystal: calcite, axis: [1, 0.3, 0.7]}}
objects:
  - {name: torus, shape: {mesh: {file: torus.obj}}, medium: $medium}
  - name: lamp
    shape: {rectangle: {size: 6}}
    transform: [{translate: [0, 0, -1]}]
    emission: {radiance: 1, polarization: {stokes: [0.5, 0.3, 0.4]}}
END
done

for scene in "$root"/assets/scenes/*.yaml "$root"/assets/scenes/bench/*.yaml torus-*.yaml; do
    name=$(basename "$scene" .yaml)
    "$program" render "$scene" -o "$name.exr" --size "${size}x$size" --node-budget 200 --quiet
    "$program" maps "$name.exr" --map all -o "$name-maps" >/dev/null
    "$program" explain "$scene" --size "${size}x$size" --pixel "$((size / 2)),$((size / 2))" --node-budget 300 >"$name-pixel.txt"
    "$program" plan "$scene" >"$name-plan.txt"
done
"$program" check facts --json >facts.json
"$program" check stiff | sed -E 's/ \(([0-9.]+ (h|min|s) ?)+\)//' >stiff.txt
printf '%s files in %s\n' "$(find . -type f | wc -l)" "$folder"
