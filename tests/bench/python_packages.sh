# SPDX-License-Identifier: Apache-2.0
# Sourced by scripts of tests/bench after tests/support/setup.sh: a Python with packages that are not the system's.

# not_here WORDS...: what is asked for cannot be had on this machine, which is no failure.
not_here() {
    printf '%s: left out: %s\n' "$(basename "$0")" "$*" >&2
    exit 77
}

# python_with PACKAGE...: makes a virtual environment in the build folder and sets `python` to its interpreter.
python_with() {
    local folder=$build/peers/python log=$build/peers/pip.log
    python=$folder/bin/python
    mkdir -p "$build/peers"
    [ -x "$folder/bin/pip" ] || python3 -m venv --clear "$folder" >"$log" 2>&1 ||
        not_here "python3 cannot make a virtual environment, see $log (on Debian: python3-venv)"
    # Installed ones are not looked for again, so that a second call needs no network.
    "$folder/bin/pip" install --quiet --disable-pip-version-check "$@" >"$log" 2>&1 ||
        not_here "pip could not install $*, see $log: $(tail -n 1 "$log")"
}
