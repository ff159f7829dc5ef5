# SPDX-License-Identifier: Apache-2.0
# Sourced by run.sh and tests/run.sh: brings a Debian 12 machine to the point where CMake can configure.
# Expects: `root`, the top of the working tree.

say() { printf '%s\n' "$*"; }
fail() {
    printf '%s: %s\n' "$(basename "$0")" "$*" >&2
    exit 1
}

# wanted_packages GROUP...: the packages of these groups of packages.txt.
wanted_packages() {
    awk -v groups=" $* " '!/^#/ && NF == 2 && index(groups, " " $2 " ") { print $1 }' "$root/tests/support/packages.txt"
}

# missing_packages GROUP...: those of them that are not installed.
missing_packages() {
    local package
    for package in $(wanted_packages "$@"); do
        dpkg-query -W -f '${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed || say "$package"
    done
}

# install_packages GROUP...: asks apt for what is missing, and does nothing if nothing is.
install_packages() {
    command -v dpkg-query >/dev/null && command -v apt-get >/dev/null ||
        fail "this is no Debian system (no apt-get). Install what tests/support/packages.txt lists, then build with:
    cmake --preset release && cmake --build --preset release"
    local missing
    missing=$(missing_packages "$@" | tr '\n' ' ')
    [ -n "$missing" ] || return 0

    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || fail "needs root, or sudo, to install: $missing"
        as_root=(sudo)
        [ -t 0 ] || as_root=(sudo -n)
        "${as_root[@]}" true || fail "sudo refused; as root, run: apt-get install --no-install-recommends $missing"
    fi
    say "installing: $missing"
    "${as_root[@]}" apt-get -q update </dev/null >/dev/null ||
        fail "apt-get update failed: is there a network, and is /etc/apt/sources.list right?"
    # shellcheck disable=SC2086 # a list of package names
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq install -y --no-install-recommends $missing </dev/null \
        >/dev/null || fail "apt-get could not install: $missing"
}

# Compiled objects are shared between clones, whatever folder they lie in.
export CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=1

# configure PRESET: once; after that the build itself sees when a CMake file changed.
configure() {
    [ -f "$root/build/$1/build.ninja" ] && return 0
    (cd "$root" && cmake --preset "$1" >"$root/build/configure-$1.log" 2>&1) || {
        tail -n 30 "$root/build/configure-$1.log" >&2
        return 1
    }
}
