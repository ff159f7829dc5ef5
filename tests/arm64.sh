#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds for arm64 with a cross compiler and runs the tests there in an emulator. See --help.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd -P)

usage() {
    cat <<'END'
Usage: tests/arm64.sh [bookworm|trixie] [COMMAND]

In a bare Debian of its own (tests/distro.sh), builds the engine, its tests and the command line for arm64 with Debian's cross
compiler and runs COMMAND, a line for bash; by default every test but those labelled slow and those of the sources and of the
installation, in QEMU's emulation of the user mode of an arm64 processor. There build/arm64/polariscope runs like any program.
Takes an hour or two on 2 cores.
JOBS=N sets the number of jobs, 2 by default; KEEP=FOLDER takes what COMMAND leaves in out/.

The same bits:   SIZE=16 tests/bits.sh x86
                 KEEP=arm tests/arm64.sh bookworm 'SIZE=16 tests/bits.sh out build/arm64/polariscope'
                 diff -r x86 arm
END
}

suite=bookworm
case ${1-} in
-h | --help) usage && exit 0 ;;
bookworm | trixie) suite=$1 && shift ;;
inside) ;; # this script, in the bare system
-*) usage >&2 && exit 2 ;;
esac
if [ "${1-}" != inside ]; then
    exec "$root/tests/distro.sh" "$suite" tests/arm64.sh inside "$@"
fi

# shellcheck source=support/setup.sh
. "$root/tests/support/setup.sh"
make_build_folder
install_packages arm64
dpkg --add-architecture arm64
apt-get -qq update
# Libraries of the other architecture; those of headers alone are of every one. None that only the window needs.
libraries=()
for package in $(packages_of debian run test | grep '^lib.*-dev$' | grep -vE '^lib(clang|egl|fontconfig|gl|glfw3|imgui|opengl)-'); do
    if [ -n "$(apt-cache show --no-all-versions "$package:arm64" 2>/dev/null)" ]; then package+=:arm64; fi
    libraries+=("$package")
done
DEBIAN_FRONTEND=noninteractive apt-get -qq install -y --no-install-recommends "${libraries[@]}" nlohmann-json3-dev >"$build/apt.log" ||
    fail "apt-get could not install: ${libraries[*]}"

export PKG_CONFIG_LIBDIR=/usr/lib/aarch64-linux-gnu/pkgconfig:/usr/share/pkgconfig
folder=$build/arm64
cmake --preset release -S "$root" -B "$folder" -DPOL_VIEWER=OFF -DPOL_TESTS=ON -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64 \
    -DCMAKE_CXX_COMPILER=aarch64-linux-gnu-g++ -DCMAKE_CROSSCOMPILING_EMULATOR=qemu-aarch64-static >"$build/configure-arm64.log" ||
    fail "CMake could not configure, see above"
program=$folder/polariscope
rm -f "$program"
cmake --build "$folder" -j "${JOBS:-2}" -- --quiet || fail "the build failed"
# The tests of the command line run it by its name.
mv "$program" "$program.arm64"
printf '#!/bin/sh\nexec qemu-aarch64-static %q "$@"\n' "$program.arm64" >"$program"
chmod +x "$program"

cd "$root"
if [ $# -gt 1 ]; then
    bash -c "${*:2}"
else
    ctest --test-dir "$folder" -j "${JOBS:-2}" --output-on-failure --label-exclude slow --exclude-regex '^(house|install)[.]'
fi
