#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The Debian packages: built, installed on this system, used, removed. See --help.
set -uo pipefail
root=$(cd "$(dirname "$0")/.." && pwd -P)

usage() {
    cat <<'END'
Usage: tests/packages.sh [FOLDER]

Builds the packages from build/release, leaves them in FOLDER (build/release/packages), installs them here with apt, uses what
they bring by its installed name, removes them and looks for what is left. Needs root, and no polariscope installed before;
for a system of their own:  tests/distro.sh bookworm './run.sh --render && tests/packages.sh'

Prints a line for each thing that does not hold. Exit code: how many; 77 if this system is not for it.
END
}
case ${1-} in
-h | --help) usage && exit 0 ;;
-*) usage >&2 && exit 2 ;;
esac

# shellcheck source=support/setup.sh
. "$root/tests/support/setup.sh"
packages=$(realpath -m -- "${1-$build/release/packages}")
skip() {
    say "tests/packages.sh: skipped: $*"
    exit 77
}
[ "$(this_system)" = debian ] || skip "this is no Debian"
[ "$(id -u)" -eq 0 ] || skip "installing needs root"
for package in polariscope libpolariscope-dev; do
    ! dpkg-query -W "$package" >/dev/null 2>&1 || skip "$package is known to dpkg here already"
done
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

failures=0
# holds WHAT COMMAND...: says WHAT, and what was printed, if COMMAND fails.
holds() {
    "${@:2}" >"$scratch/said" 2>&1 && return
    say "does not hold: $1"
    tail -n 20 "$scratch/said" | sed 's/^/    /'
    failures=$((failures + 1))
    return 1
}
apt() { DEBIAN_FRONTEND=noninteractive apt-get -qq -y "$@" </dev/null; }
# user COMMAND...: as one who has only what is installed, and works somewhere else.
user() { (cd "$scratch/user" && env -i PATH=/usr/bin:/bin HOME="$scratch/user" LC_ALL=C.UTF-8 "$@"); }
mkdir "$scratch/user"

build_packages() {
    configure release -DCMAKE_INSTALL_PREFIX=/usr && cmake --build "$build/release" ${JOBS:+-j "$JOBS"} -- --quiet &&
        rm -rf "$packages" && (umask 022 && cpack --config "$build/release/CPackConfig.cmake" -B "$packages")
}
holds "the packages are built" build_packages || exit 1
rm -rf "$packages/_CPack_Packages"
version=$(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' "$build/release/CMakeCache.txt")-1
machine=$(dpkg --print-architecture)
program=$packages/polariscope_${version}_$machine.deb
development=$packages/libpolariscope-dev_${version}_$machine.deb
holds "there are two of them, with Debian's names" test -f "$program" -a -f "$development" || exit 1
if command -v lintian >/dev/null; then
    holds "lintian finds no error" lintian --fail-on error "$program" "$development"
fi

holds "apt installs them" apt install --no-install-recommends "$program" "$development" || exit 1
dpkg -L polariscope libpolariscope-dev | sort -u >"$scratch/brought"

scene=/usr/share/polariscope/scenes/crossed-polarizers.yaml
render=(render "$scene" --size 16x16 --wavelengths 580 -o)
holds "a shipped scene is rendered" user polariscope "${render[@]}" installed.exr
# shellcheck disable=SC2016 # for the shell inside
holds "in the bits of the build tree" bash -c '"$1" "${@:3}" "$2/built.exr" && cmp "$2/built.exr" "$2/user/installed.exr"' bash \
    "$build/release/polariscope" "$scratch" "${render[@]}"
holds "a record is found" user polariscope interface --from air --to calcite --axis 0,0,1
holds "every fact holds" user polariscope check facts
# shellcheck disable=SC2016 # for the shell inside
holds "a program of one's own works with the library" user sh -c \
    'cmake -S "$1" -B consumer && cmake --build consumer && consumer/consumer' sh "$root/tests/consumer"
# shellcheck disable=SC2016
holds "nothing of the tree's place is in the program" sh -c '! grep -aF "$1" /usr/bin/polariscope' sh "$root"
# shellcheck disable=SC2016
holds "the manual page is there" user sh -c 'man polariscope | grep -q -e --node-budget'
# shellcheck disable=SC2016
holds "bash completes commands and shipped scenes" user bash -c '
    . /usr/share/bash-completion/completions/polariscope
    COMP_WORDS=(polariscope ren) COMP_CWORD=1 && _polariscope && [ "${COMPREPLY[*]}" = render ] &&
        COMP_WORDS=(polariscope render wolla) COMP_CWORD=2 && _polariscope &&
        [ "${COMPREPLY[*]}" = /usr/share/polariscope/scenes/wollaston.yaml ]'
holds "zsh has a completion" grep -q '^#compdef polariscope' /usr/share/zsh/vendor-completions/_polariscope
id=io.github.polariscope.Polariscope
holds "the desktop entry is valid" desktop-file-validate /usr/share/applications/$id.desktop
holds "it names the program and an icon that are there" sh -c \
    "grep -qx 'Exec=polariscope view %F' /usr/share/applications/$id.desktop && test -f /usr/share/icons/hicolor/scalable/apps/$id.svg"
holds "the type of a scene is known by its name" grep -q 'application/x-polariscope-scene+yaml:\*.pol.yaml' /usr/share/mime/globs2
if command -v appstreamcli >/dev/null; then
    holds "the description for software centers is valid" appstreamcli validate --no-net /usr/share/metainfo/$id.metainfo.xml
fi
holds "the window works" python3 "$root/tests/viewer/test_end_to_end.py" /usr/bin/polariscope \
    EndToEnd.test_a_session_of_a_user

holds "they are removed" apt purge polariscope libpolariscope-dev
left() {
    local path bad=0
    while read -r path; do
        if [ -e "$path" ] && { [ ! -d "$path" ] || [[ $path == *polariscope* ]]; }; then say "$path" && bad=1; fi
    done <"$scratch/brought"
    return $bad
}
holds "nothing is left" left
holds "the desktop knows the type no longer" sh -c '! grep -q polariscope /usr/share/mime/globs2'

dpkg-deb -x "$program" "$scratch/moved"
holds "the same files work in another place" user "$scratch/moved/usr/bin/polariscope" interface --from air --to calcite --axis 0,0,1
rm -r "$scratch/moved/usr/share/polariscope"
# shellcheck disable=SC2016
holds "without the assets it says where it looked" user sh -c '"$1" interface --from air --to calcite --axis 0,0,1 2>&1 |
    grep "looked for in $2/share/polariscope, .*/usr/share/polariscope, "' sh "$scratch/moved/usr/bin/polariscope" "$scratch/moved/usr"

[ $failures -ne 0 ] || say "the packages are sound: $(du -h "$program" "$development" | awk '{ print $1 }' | paste -sd ' ' -)"
exit $failures
