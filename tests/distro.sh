#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs a command in a bare Debian, where nothing is installed that nobody asked for. See --help.
set -uo pipefail
root=$(cd "$(dirname "$0")/.." && pwd -P)

usage() {
    cat <<'END'
Usage: tests/distro.sh [--user] [bookworm|trixie] [COMMAND...]

Makes a bare Debian system (debootstrap, variant minbase; bookworm, that is 12, if none is named), copies the working tree
into it without what git ignores, and runs COMMAND in the top of that tree; by default the README's two, ./run.sh and then
tests/run.sh. A COMMAND of one word is a line for bash. It runs as root in root's home folder, with --user as an ordinary
user with sudo. Needs root here, for chroot and mounts.

The base system is kept for the next call in ~/.cache/polariscope/distro; what is installed on top of it is not. Mirror, proxy
and other download settings of apt are those of this machine; what ccache has is shared, but not with --user.
MIRROR=URL    another Debian mirror
KEEP=FOLDER   takes what the command leaves in the tree's out/

Exit code: the command's own; 77 if no bare system can be made here. What failed is said on one line.
END
}

as_user=no suite=bookworm
while :; do
    case ${1-} in
    -h | --help) usage && exit 0 ;;
    --user) as_user=yes && shift ;;
    bookworm | trixie) suite=$1 && shift && break ;;
    -*) usage >&2 && exit 2 ;;
    *) break ;;
    esac
done

complain() { printf 'tests/distro.sh: %s: %s\n' "$suite" "$*" >&2; }
cannot() {
    complain "no bare system: $*"
    exit 77
}

# Mounts and processes live in namespaces of their own, which end with this script, however it ends.
namespaces=(setpriv --pdeathsig KILL unshare --mount --propagation private --pid --fork --kill-child)
[ "$(id -u)" -eq 0 ] || cannot "this needs root"
"${namespaces[@]}" mount -t tmpfs tmpfs /mnt 2>/dev/null || cannot "this machine lets root mount nothing"
# shellcheck source=support/setup.sh
. "$root/tests/support/setup.sh"
for tool in debootstrap git; do
    command -v "$tool" >/dev/null || (install_packages distro) || cannot "$tool cannot be installed"
done

store=${XDG_CACHE_HOME:-${HOME-/root}/.cache}/polariscope/distro
if ! { mkdir -p "$store" && exec 7>"$store/lock" && flock 7; } then cannot "$store cannot be written"; fi
# What a killed call left behind: nobody holds its lock any more.
for work in "$store"/*.work; do
    [ ! -d "$work" ] || (flock -n 8 && rm -rf --one-file-system "$work") 8<"$work"
done
if ! { work=$(mktemp -d "$store/$suite.XXXXXX.work") && exec 8<"$work" && flock 8; } then cannot "$store cannot be written"; fi
system=$work/system
# shellcheck disable=SC2317 # called by the trap
clean_up() {
    [ -z "${inside-}" ] || { kill -KILL "$inside" && wait "$inside"; } 2>/dev/null
    rm -rf --one-file-system "$work"
}
trap clean_up EXIT
for signal in HUP INT TERM; do
    # shellcheck disable=SC2064 # the number of this signal
    trap "complain 'stopped by SIG$signal'; exit $((128 + $(kill -l $signal)))" $signal
done

# apart COMMAND...: in namespaces of its own, and such that a signal need not wait for its end.
apart() {
    "${namespaces[@]}" "$@" <&0 &
    inside=$!
    wait "$inside"
    local status=$?
    inside=
    return $status
}

# The Debian mirror of this machine, as apt knows it.
mirror() {
    local known
    for _ in once again; do
        known=$(apt-get indextargets --format '$(ORIGIN) $(LABEL) $(REPO_URI)' 'Created-By: Packages' 2>/dev/null |
            awk '$1 == "Debian" && $2 == "Debian" { print $3; exit }')
        [ -z "$known" ] || { say "$known" && return; }
        apt-get -q update >/dev/null 2>&1
    done
}

base=$store/$suite.tar
mirror=${MIRROR:-$(mirror)}
if [ ! -f "$base" ]; then
    [ -n "$mirror" ] || cannot "apt knows no Debian mirror here; name one with MIRROR=URL"
    # debootstrap does not read apt's settings.
    eval "$(apt-config shell http Acquire::http::Proxy https Acquire::https::Proxy)"
    apart env ${http:+http_proxy="$http"} ${https:+https_proxy="$https"} \
        debootstrap --variant=minbase "$suite" "$system" "$mirror" >"$work/log" 2>&1 ||
        cannot "debootstrap from $mirror: $(grep -m 1 '^E: ' "$work/log" || tail -n 1 "$work/log")"
    rm -f "$system"/var/cache/apt/archives/*.deb
    if ! { tar -C "$system" --numeric-owner -cf "$work/base" . && mv "$work/base" "$base"; } then cannot "$base cannot be written"; fi
else
    if ! { mkdir "$system" && tar -C "$system" --numeric-owner -xpf "$base"; } then cannot "$base cannot be unpacked"; fi
fi
exec 7>&-
[ -z "$mirror" ] || say "deb $mirror $suite main" >"$system/etc/apt/sources.list"

# Download settings of this machine: what is about the way to the mirror, not about what apt keeps or shows.
apt-config dump | grep '^Acquire::' | grep -vE '^Acquire::(IndexTargets|CompressionTypes|Languages|Changelogs|cdrom)' \
    >"$system/etc/apt/apt.conf.d/99machine"
for file in /etc/apt/auth.conf /etc/apt/auth.conf.d /etc/resolv.conf /etc/hosts; do
    [ ! -e "$file" ] || cp -RL --preserve=mode -T "$file" "$system$file"
done

# The working tree, without what git ignores.
home=/root
[ $as_user = no ] || home=/home/user
tree=$system$home/polariscope
mkdir -p "$tree" "$system$home/.cache/ccache"
(cd "$root" && git -c safe.directory="$root" ls-files -z --cached --others --exclude-standard |
    while IFS= read -r -d '' file; do [ ! -e "$file" ] || printf '%s\0' "$file"; done |
    tar --null --no-recursion -T - -c) | tar -C "$tree" --no-same-owner -x || cannot "the working tree cannot be copied"

# mount_and_run COMMAND...: inside the namespaces.
mount_and_run() {
    mount -t proc proc "$system/proc" &&
        mount --bind /dev "$system/dev" &&
        mount -t devpts -o newinstance,ptmxmode=0666,gid=5,mode=620 devpts "$system/dev/pts" &&
        mount -t tmpfs -o mode=1777 tmpfs "$system/dev/shm" || exit 77
    if [ -d "$ccache_folder" ] && [ $as_user = no ]; then
        mount --bind "$ccache_folder" "$system$home/.cache/ccache" || exit 77
    fi
    # Nothing of this machine's environment but the way to the network, and no signal ignored because a shell here does.
    local clean=(env -i --default-signal HOME="$home" PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin
        TERM="${TERM-dumb}" "${given[@]}")
    local enter=(chroot "$system" "${clean[@]}")
    if [ $as_user = yes ]; then
        # shellcheck disable=SC2016 # for the shell inside
        "${enter[@]}" sh -c 'id -u user && exit; apt-get -qq update && DEBIAN_FRONTEND=noninteractive apt-get -qq install -y --no-install-recommends sudo &&
            useradd --shell /bin/bash --no-create-home user && echo "user ALL=(ALL) NOPASSWD: ALL" >/etc/sudoers.d/user &&
            chown -R user:user /home/user' >"$work/log" 2>&1 || { tail -n 3 "$work/log" >&2 && exit 77; }
        enter=(chroot --userspec=user:user --groups=user "$system" "${clean[@]}")
    fi
    # shellcheck disable=SC2016 # for the shell inside
    "${enter[@]}" bash -c 'cd "$HOME/polariscope" && exec "$@"' bash "$@"
}

# run COMMAND...
run() {
    [ $# -ne 1 ] || set -- bash -c "$1"
    mount_and_run=$(declare -f mount_and_run)
    export as_user ccache_folder home system work
    apart bash -c "given=(${given[*]@Q}); $mount_and_run; mount_and_run \"\$@\"" bash "$@"
}

given=()
for name in CI JOBS {http,https,ftp,no}_proxy {HTTP,HTTPS,FTP,NO}_PROXY; do
    [ -z "${!name-}" ] || given+=("$name=${!name}")
done
status=0
if [ $# -gt 0 ]; then
    run "$@" || { status=$? && complain "ended with status $status: $*"; }
else
    for command in ./run.sh tests/run.sh; do
        run "$command" || { status=$? && complain "ended with status $status: $command" && break; }
    done
fi
if [ -n "${KEEP-}" ] && [ -d "$tree/out" ]; then
    mkdir -p "$KEEP" && cp -R "$tree/out/." "$KEEP" || complain "cannot write to $KEEP"
fi
exit $status
