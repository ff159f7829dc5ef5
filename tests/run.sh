#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Every check, from a bare Debian: installs what is missing, builds, tests. See --help.
set -uo pipefail
root=$(cd "$(dirname "$0")/.." && pwd -P)

usage() {
    cat <<'END'
Usage: tests/run.sh [STEP...]

Steps, all by default, in this order:
  release   build with warnings as errors; all tests: unit, physics, include rules, formatting
  deb       the Debian packages installed, used and removed (tests/packages.sh); needs the release build, skipped without root
  tidy      clang-tidy 14 (.clang-tidy) over engine/ and viewer/; needs the release build
  asan      AddressSanitizer and UndefinedBehaviorSanitizer over every test but those labelled slow (whole renders
            that take minutes there; they run in release)
  tsan      ThreadSanitizer over the tests labelled threads (render, film)
  fuzz      libFuzzer for 12 s on each kind of file or message that is read; longer: tests/fuzz/run.sh
Prints what each step took, then "N passed, N failed", and exits 1 if anything failed. A build that breaks, or a step that
does not end in time, counts as one failure. JOBS=N sets the number of jobs, 2 by default; BUILD=FOLDER builds there, not in
build/. On a system without apt, install what packages.txt lists for "test" first.
END
}

steps=("$@")
[ $# -gt 0 ] || steps=(release deb tidy asan tsan fuzz)
for step in "${steps[@]}"; do
    case $step in
    release | deb | tidy | asan | tsan | fuzz) ;;
    -h | --help) usage && exit 0 ;;
    *) usage >&2 && exit 2 ;;
    esac
done

# shellcheck source=tests/support/setup.sh
. "$root/tests/support/setup.sh"
jobs=${JOBS:-2}
passed=0
failed=0

# step NAME COMMAND...: runs one step, says how long it took and whether it held. A step that fails counts as one
# failure; ctest's own failures are counted by run_tests instead.
step() {
    local name=$1 begin=$SECONDS status=0
    shift
    say "== $name"
    "$@" || status=$?
    say "== $name: $([ $status -eq 0 ] && echo ok || echo FAILED), $((SECONDS - begin)) s"
    return $status
}

build() {
    local options=(-DPOL_TESTS=ON)
    [ "$1" != release ] || options+=(-DCMAKE_INSTALL_PREFIX=/usr) # where the packages of this build go
    if configure "$1" "${options[@]}"; then
        cmake --build "$build/$1" -j "$jobs" --target "${@:2}" -- --quiet && return 0
    else
        say "$(why_not_configured "$1" run test)"
    fi
    failed=$((failed + 1))
    return 1
}

# run_tests PRESET SECONDS [CTEST OPTION...]: counts what CTest counts. Skipped tests are neither passed nor failed.
run_tests() {
    local report=$build/$1/ctest.xml status=0 summary total bad skipped
    rm -f "$report"
    timeout --kill-after=30 "$2" "${wrap[@]}" ctest --test-dir "$build/$1" -j "$jobs" --output-on-failure --no-tests=error \
        --output-junit "$report" "${@:3}" </dev/null >"$build/$1/ctest.log" 2>&1 || status=$?
    if [ ! -f "$report" ]; then
        tail -n 40 "$build/$1/ctest.log"
        say "ctest did not finish (status $status; 124 means out of time)"
        failed=$((failed + 1))
        return 1
    fi
    summary=$(tr '\n\t' '  ' <"$report" | grep -o '<testsuite [^>]*>' | head -n 1)
    count() { sed -E "s/.* $1=\"([0-9]+)\".*/\1/" <<<"$summary"; }
    total=$(count tests) bad=$(count failures) skipped=$(($(count skipped) + $(count disabled)))
    [ $status -eq 0 ] || [ "$bad" -gt 0 ] || bad=1
    passed=$((passed + total - bad - skipped))
    failed=$((failed + bad))
    [ $status -eq 0 ] || grep -vE ' Passed  |^ *Start ' "$build/$1/ctest.log"
    say "$1: $((total - bad - skipped)) of $total tests passed, $bad failed, $skipped skipped"
    return $status
}

# Only what the build compiles, and as it does, the sources of a room together: clang-tidy would guess the flags of other
# files, and most of its time goes into what they include. Clang does not know all of GCC's warnings.
# Every version has checks of its own.
tidy() {
    command -v clang-tidy-14 >/dev/null || { say "clang-tidy 14 is not installed: skipped" && return; }
    local database=$build/release/compile_commands.json
    grep -o '"file": "[^"]*"' "$database" | cut -d '"' -f 4 | grep -E -e "^$root/(engine|viewer)/" \
        -e "^$build/release/(engine|viewer)/.*/Unity/" | sort -u |
        xargs -r -d '\n' -P "$jobs" -n 1 \
        clang-tidy-14 --quiet --extra-arg-before=-Wno-unknown-warning-option -p "$build/release" 2>/dev/null || {
        failed=$((failed + 1))
        return 1
    }
    passed=$((passed + 1))
}

# The packages are one test.
deb() {
    local bad=0
    "$root/tests/packages.sh" || bad=$?
    [ $bad -ne 77 ] || return 0
    passed=$((passed + (bad == 0)))
    failed=$((failed + (bad != 0)))
    return $bad
}

# Every target is one test.
fuzz() {
    local bad=0 sources=("$root"/tests/fuzz/fuzz_*.cpp)
    local targets=${#sources[@]}
    "$root/tests/fuzz/run.sh" 12 || bad=$?
    [ $bad -le "$targets" ] || bad=$targets
    passed=$((passed + targets - bad))
    failed=$((failed + bad))
    return $bad
}

begin=$SECONDS
packages() { (make_build_folder && install_packages run test); }
step "packages" packages || { say "0 passed, 1 failed" && exit 1; }

# Address space randomization wider than the sanitizers of GCC 12 expect makes them abort on some kernels.
unrandomized=()
setarch "$(uname -m)" -R true 2>/dev/null && unrandomized=(setarch "$(uname -m)" -R)
export UBSAN_OPTIONS=print_stacktrace=1
# Everything a test allocates is freed again, but for what leaks.txt names.
export ASAN_OPTIONS=detect_leaks=1:detect_stack_use_after_return=1
export LSAN_OPTIONS="suppressions='$root/tests/support/leaks.txt':print_suppressions=0"
export TSAN_OPTIONS="second_deadlock_stack=1:suppressions='$root/tests/support/races.txt':print_suppressions=0"

for name in "${steps[@]}"; do
    wrap=()
    case $name in
    release)
        step "build release" build release all && step "test release" run_tests release 1200
        ;;
    deb)
        step "deb" deb
        ;;
    tidy)
        step "clang-tidy" tidy
        ;;
    asan)
        wrap=("${unrandomized[@]}")
        step "build asan" build asan all && step "test asan" run_tests asan 1500 --label-exclude slow
        ;;
    tsan)
        wrap=("${unrandomized[@]}")
        step "build tsan" build tsan polariscope_thread_tests &&
            step "test tsan" run_tests tsan 600 --label-regex threads
        ;;
    fuzz)
        step "build fuzz" build asan polariscope_fuzz && step "fuzz" fuzz
        ;;
    esac
done

say "all steps: $((SECONDS - begin)) s"
say "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
