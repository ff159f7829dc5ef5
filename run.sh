#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# From a bare Debian to the window: installs what is missing, builds, opens. See --help.
set -euo pipefail
root=$(cd "$(dirname "$0")" && pwd -P)

usage() {
    cat <<'END'
Usage: ./run.sh [--render] [FILE]

Installs the Debian packages that are missing (needs root or sudo only for that), builds build/release/polariscope and
opens FILE in the window: a scene, by default assets/scenes/paper-calcite-unpolarized.yaml, or an EXR picture. F1 shows the
keys. With --render, or where there is no display, it renders the scene into out/ beside build/ instead:
  NAME.exr              Stokes vectors at 580 nm with the residual, for any EXR viewer
  NAME-intensity.png    and -dop, -ellipticity, -azimuth, -residual: maps at 580 nm
  NAME-color.exr, .png  21 wavelengths, 380:780:20 nm, and the color that the CIE 1931 observer sees
For color, one random path stands for what is left past 100 branches of a sample, so that crystals take a minute, not an
hour; "polariscope render" without that limit is more exact.
A second call installs, builds and renders only what is new, and needs neither root nor a network.
On other Linux systems it says what to install, and builds once that is there.

JOBS=N        number of compile jobs
BUILD=FOLDER  builds there and renders into FOLDER/out, for a tree that cannot be written to

Examples:
  ./run.sh
  ./run.sh assets/scenes/fresnel-rhomb.yaml
  ./run.sh --render assets/scenes/fresnel-rhomb.yaml
END
}

render=no
case ${1-} in
-h | --help) usage && exit 0 ;;
--render) render=yes && shift ;;
esac
case ${1-} in
-*) usage >&2 && exit 2 ;;
esac
[ $# -le 1 ] || { usage >&2 && exit 2; }

# shellcheck source=tests/support/setup.sh
. "$root/tests/support/setup.sh"
file=$(realpath -m -- "${1-$root/assets/scenes/paper-calcite-unpolarized.yaml}")
[ -f "$file" ] || { say "run.sh: no such file: $file" >&2 && exit 3; }

make_build_folder
install_packages run
configure release || fail "$(why_not_configured release run)"
quiet=(-- --quiet)
if [ -t 1 ]; then
    quiet=()
    export NINJA_STATUS='building, %p after %e s: '
fi
cmake --build "$build/release" --target polariscope ${JOBS:+-j "$JOBS"} "${quiet[@]}" || fail "the build failed"

out=$root/out
[ -z "${BUILD-}" ] || out=$build/out
program=$build/release/polariscope
if [ $render = no ]; then
    [ -z "${DISPLAY-}" ] || exec "$program" view "$file"
    say "there is no display to open a window on (DISPLAY is not set); rendering into $out instead"
fi
case $file in
*.exr) say "run.sh: $file is a picture already; draw its maps with: $program maps $file --map all -o FOLDER" >&2 && exit 2 ;;
esac

mkdir -p "$out" 2>/dev/null && [ -w "$out" ] || fail "cannot write to $out; choose another folder with BUILD=FOLDER"
name=$(basename "$file")
name=$out/${name%.*}

# A picture is new enough if it is younger than the program, the scene's folder and all that is shipped in assets/.
out_of_date() {
    [ ! -f "$1" ] || [ -n "$(find "$program" "$(dirname "$file")" "$root/assets" -newer "$1" -print -quit)" ]
}

# render PICTURE OPTION...
render() {
    if out_of_date "$1"; then
        "$program" render "$file" -o "$1" "${@:2}"
    fi
}
# draw EXR MAP
draw() {
    if out_of_date "$name-$2.png"; then
        "$program" maps "$1" --map "$2" -o "$name-$2.png"
    fi
    say "$name-$2.png"
}
render "$name.exr" --wavelengths 580
say "$name.exr"
for map in intensity dop ellipticity azimuth residual; do
    draw "$name.exr" "$map"
done
render "$name-color.exr" --wavelengths 380:780:20 --node-budget 100
say "$name-color.exr"
draw "$name-color.exr" color
