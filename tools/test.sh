#!/usr/bin/env bash
# Every test, on a bare Debian 12 too: installs what is missing, then builds and tests for this machine (preset release),
# for 64-bit ARM under emulation (preset aarch64), and for this machine again with the address and undefined behaviour
# sanitizers (preset asan-ubsan: one lane and AVX2; without the proofs about objects and sources, which have builds of
# their own). Laws that average thousands of pictures, directions or rays are asked of the first build alone: that its
# bytes are those of ARM, and that its reads and writes are sound, others tell. CMakePresets.json names what is left out;
# tools/long_checks.sh asks it all. (The reference tracer, no part of zerkalo, has no tests of its own for ARM.)
# The last line is the total: "N passed, N failed".
# Exit code 0 only when something ran and nothing failed; a build that fails counts as one failed test.
set -euo pipefail
cd "$(dirname "$0")/.."

packages=(g++ clang-14 libclang-rt-14-dev cmake ninja-build binutils python3 libxsimd-dev libtomlplusplus-dev libcli11-dev libbenchmark-dev
          libpng-dev libgtest-dev qemu-system-x86 gnuplot-nox parallel)
arm_packages=(g++-aarch64-linux-gnu binutils-aarch64-linux-gnu qemu-user googletest)

total=0
failed=0
skipped=0
log=$(mktemp)
trap 'rm -f "$log"' EXIT

finish() {
    [ "$skipped" -eq 0 ] || echo "$skipped tests were skipped: this machine lacks what they need (named above)."
    echo "$((total - failed - skipped)) passed, $failed failed"
    [ "$failed" -eq 0 ] && [ "$total" -gt "$skipped" ]
}

build_fails() {
    tail -n 60 "$log"
    echo "The build of preset $1 failed; its last lines are above."
    total=$((total + 1))
    failed=$((failed + 1))
}

# run_preset NAME: configures, builds and tests it, and adds to the totals.
run_preset() {
    echo "== $1: building"
    if ! { cmake --preset "$1" && cmake --build --preset "$1" --parallel "$(nproc)"; } >"$log" 2>&1; then
        build_fails "$1"
        return
    fi
    echo "== $1: testing"
    # One more than there are processors: most tests are short, and starting one takes a while.
    ctest --preset "$1" --parallel "$(($(nproc) + 1))" >"$log" 2>&1 || true
    grep -vE '^ +Start +[0-9]+:|[0-9]+/[0-9]+ Test +#[0-9]+: .* Passed ' "$log" || true

    # CTest counts a skipped test among the passed ones, and one that could not start among the failed ones.
    local summary
    summary=$(sed -nE 's/^[0-9]+% tests passed, ([0-9]+) tests? failed out of ([0-9]+)$/\1 \2/p' "$log")
    if [ -z "$summary" ]; then
        echo "CTest ran nothing for preset $1."
        summary="1 1"
    fi
    failed=$((failed + ${summary% *}))
    total=$((total + ${summary#* }))
    skipped=$((skipped + $(grep -cE '^[[:space:]]+[0-9]+ - .* \(Skipped\)$' "$log" || true)))
}

if ! tools/install_packages.sh "${packages[@]}" "${arm_packages[@]}"; then
    failed=1
    total=1
    finish
    exit 1
fi
run_preset release
run_preset aarch64
run_preset asan-ubsan
finish
