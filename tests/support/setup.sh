# SPDX-License-Identifier: Apache-2.0
# Sourced by run.sh and the scripts of tests/: brings a machine to the point where CMake can configure.
# Expects: `root`, the top of the working tree. Sets: `build`, the folder of all builds: BUILD, or build/ in the tree.

say() { printf '%s\n' "$*"; }
fail() {
    printf '%s: %s\n' "$(basename "$0")" "$*" >&2
    exit 1
}

# packages_of SYSTEM GROUP...: the packages of these groups in a system's column of packages.txt.
packages_of() {
    awk -v name="$1" -v groups=" ${*:2} " '
        $1 == "#who" { for (i = 1; i <= NF; ++i) if ($i == name) column = i }
        !/^#/ && column && index(groups, " " $1 " ") && $column != "" && $column != "-" { print $column }
    ' "$root/tests/support/packages.txt" | sort -u
}

# this_system: "debian" (and what descends from it), "fedora", "arch", "homebrew", or nothing if it is none of them.
this_system() {
    if command -v dpkg-query >/dev/null && command -v apt-get >/dev/null; then
        say debian
        return
    fi
    local kin=""
    # shellcheck source=/dev/null
    kin=$(. "${OS_RELEASE:-/etc/os-release}" 2>/dev/null && say "${ID-} ${ID_LIKE-}")
    case " $kin $(uname -s) " in
    *" fedora "*) say fedora ;;
    *" arch "*) say arch ;;
    *" Darwin "*) say homebrew ;;
    esac
}

# how_to_install SYSTEM GROUP...: the command that installs them, and what has to be had elsewhere.
how_to_install() {
    local name here=() elsewhere=""
    for name in $(packages_of "${1:-debian}" "${@:2}"); do
        case $name in
        none:*) elsewhere+=", ${name#none:}" ;;
        aur:*) elsewhere+=", ${name#aur:} (in the AUR)" ;;
        *) here+=("$name") ;;
        esac
    done
    elsewhere=${elsewhere:+; not packaged there: ${elsewhere#, }}
    case $1 in
    fedora) say "sudo dnf install ${here[*]}$elsewhere" ;;
    arch) say "sudo pacman -S --needed ${here[*]}$elsewhere" ;;
    homebrew) say "brew install ${here[*]}$elsewhere" ;;
    *) say "what Debian calls ${here[*]}" ;;
    esac
}

if [ "$(this_system)" = homebrew ]; then
    fail "this has not been ported to macOS yet; its libraries there: $(how_to_install homebrew run)"
fi

build=$(realpath -m -- "${BUILD:-$root/build}")
# make_build_folder: and says what another user has left in it, as after a call with sudo.
make_build_folder() {
    local path hint="choose another folder with BUILD=FOLDER"
    mkdir -p "$build" 2>/dev/null || fail "cannot write to $build; $hint"
    for path in "$build" "$build"/*; do
        [ -w "$path" ] || [ ! -e "$path" ] || fail "cannot write to $path; $hint"
    done
}

# Compiled objects are shared between clones, whatever folder they lie in; without a place for them, they are not kept.
export CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=1
ccache_folder=${CCACHE_DIR:-${XDG_CACHE_HOME:-${HOME-/dev/null}/.cache}/ccache}
mkdir -p "$ccache_folder" 2>/dev/null && [ -w "$ccache_folder" ] || export CCACHE_DISABLE=1

# missing_packages GROUP...: the Debian packages of these groups that are not installed.
missing_packages() {
    local package
    for package in $(packages_of debian "$@"); do
        dpkg-query -W -f '${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed || say "$package"
    done
}

# install_packages GROUP...: asks apt for what is missing, and does nothing if nothing is. Where there is no apt, CMake
# will see what is missing.
install_packages() {
    [ "$(this_system)" = debian ] || return 0
    local missing
    missing=$(missing_packages "$@" | paste -sd ' ' -)
    [ -n "$missing" ] || return 0

    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || fail "needs root, or sudo, to install: $missing"
        as_root=(sudo)
        [ -t 0 ] || as_root=(sudo -n)
        "${as_root[@]}" true 2>/dev/null || fail "sudo refused; as root, run: apt-get install --no-install-recommends $missing"
    fi
    say "installing: $missing"
    local log waited=0 apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=600)
    log=$(mktemp)
    # A machine that has just started may be busy with updates of its own; that lock has no timeout. A repository out of
    # reach does not matter if what is needed comes from another one.
    until "${apt[@]}" -q update </dev/null >"$log" 2>&1 || [ $waited -ge 600 ] || ! grep -q 'Could not get lock' "$log"; do
        [ $waited -gt 0 ] || say "waiting for another package manager to end"
        sleep 5
        waited=$((waited + 5))
    done
    # shellcheck disable=SC2086 # a list of package names
    if ! "${apt[@]}" -qq install -y --no-install-recommends $missing </dev/null >>"$log" 2>&1; then
        fail "apt-get could not install: $missing ($(grep -m 1 '^[EW]: ' "$log" || tail -n 1 "$log"))"
    fi
    rm -f "$log"
}

# configure PRESET [-DNAME=VALUE...]: once; after that the build itself sees when a CMake file changed. Again if an option has
# another value; anew if the tree or the build was moved, or if it never came to an end.
configure() {
    local folder=$build/$1 log=$build/configure-$1.log cache=$build/$1/CMakeCache.txt option fresh=() same=yes
    if [ ! -f "$folder/build.ninja" ]; then
        fresh=(--fresh) same=no
    else
        grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache" && grep -qxF "CMAKE_CACHEFILE_DIR:INTERNAL=$folder" "$cache" ||
            fresh=(--fresh) same=no
        for option in "${@:2}"; do
            [[ $option =~ ^-D(.*)=(.*)$ ]]
            grep -qE "^${BASH_REMATCH[1]}:[A-Z]+=${BASH_REMATCH[2]}\$" "$cache" || same=no
        done
    fi
    [ $same = no ] || return 0
    (cd "$root" && cmake --preset "$1" -B "$folder" "${fresh[@]}" "${@:2}") >"$log" 2>&1 || {
        [ "$(this_system)" != debian ] || tail -n 30 "$log" >&2
        return 1
    }
}

# why_not_configured PRESET GROUP...: what CMake missed first, and how to get it.
why_not_configured() {
    local log=$build/configure-$1.log missed system
    missed=$(sed -n '/^CMake Error/,$p' "$log" | grep -m 1 -oE 'Could NOT find [^ ]+|not providing "Find[^".]+|file provided by "[^"]+"|Could not find [A-Z_]+|build program corresponding to "[^"]+"|No CMAKE_[A-Z_]+ could be found|Embree [0-9].* is needed' ||
        sed '/^CMake Error/,$d' "$log" | grep -oE "(Package|No package) '[^']+'.* (not )?found" | tail -n 1 | grep . || tail -n 1 "$log")
    missed=$(sed -E 's/^(not providing "Find|file provided by )"?([^"]+)"?/no package \2/' <<<"$missed")
    system=$(this_system)
    [ "$system" = debian ] || missed="$missed; install: $(how_to_install "$system" "${@:2}")"
    say "CMake could not configure, see $log: $missed"
}
