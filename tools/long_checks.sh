#!/usr/bin/env bash
# The checks that take too long for every build: many more rays than the tests have, the mutants, and every test by every
# compiler, with sanitizers and under emulation, where tools/test.sh asks what depends on these alone.
set -euo pipefail
cd "$(dirname "$0")/.."

usage() {
    cat <<'END'
Usage: tools/long_checks.sh [--rays N] [--leak-rays N] [--only CHECK]...

  oracle      every primitive against its closed form, N rays each (default 100000000; the tests have a million)
  leaks       N rays at edges and vertices of prisms and pyramids (default 1000000000; the tests have a million)
  mutants     tools/mutants/run.py: every formula made wrong must be caught by a law
  gcc         every test of the build by GCC (preset gcc)
  arm         every test of the build for 64-bit ARM, under emulation (preset aarch64)
  sanitizers  every test of every kernel with the address and undefined behaviour sanitizers (preset asan-ubsan)

Needs what tools/test.sh installs. One after the other, with all processors. On two: a quarter of an hour for oracle, ten
minutes for leaks, two hours for mutants, ten to thirty minutes for each of the others. Logs: build/long_checks/.
Exit code: 0 all hold, 1 something does not, 2 wrong command line.
END
}

rays=100000000
leak_rays=1000000000
only=()
while [ $# -gt 0 ]; do
    case $1 in
        --help) usage; exit 0 ;;
        --rays | --leak-rays)
            [[ ${2:-} =~ ^[1-9][0-9]*$ ]] || { echo "long_checks.sh: $1 needs a number of rays" >&2; exit 2; }
            if [ "$1" = --rays ]; then rays=$2; else leak_rays=$2; fi
            shift 2 ;;
        --only)
            [[ ${2:-} =~ ^(oracle|leaks|mutants|gcc|arm|sanitizers)$ ]] ||
                { echo "long_checks.sh: --only oracle, leaks, mutants, gcc, arm or sanitizers" >&2; exit 2; }
            only+=("$2")
            shift 2 ;;
        *) echo "long_checks.sh: unknown argument \"$1\"; see --help" >&2; exit 2 ;;
    esac
done
[ ${#only[@]} -gt 0 ] || only=(oracle leaks mutants gcc arm sanitizers)

logs=build/long_checks
program=build/release/tests/oracle/oracle_test
summary=()
failed=0
mkdir -p "$logs"

build_oracle() {
    echo "== building $program"
    { cmake --preset release && cmake --build --preset release --target oracle_test; } >"$logs/build.log" 2>&1 ||
        { tail -n 40 "$logs/build.log"; echo "long_checks.sh: the build failed; its last lines are above" >&2; exit 1; }
}

# Each primitive is a test of its own, so all processors are busy.
run_oracle() {
    "$program" --gtest_list_tests --gtest_filter='*PrimitiveOracle*' | sed -nE 's/^ +[^/]*\/([a-z_]+) .*/\1/p' |
        ZERKALO_ORACLE_RAYS=$rays xargs -P "$(nproc)" -I{} \
            "$program" --gtest_brief=1 --gtest_filter='*PrimitiveOracle*/{}'
}

run_leaks() { ZERKALO_LEAK_RAYS=$leak_rays "$program" --gtest_brief=1 --gtest_filter='Leaks.*'; }

run_mutants() { tools/mutants/run.py --jobs "$(nproc)" --markdown "$logs/mutants.md"; }

# every_test PRESET OPTION...: builds the preset in a folder of its own and runs all of its tests, whatever it leaves out.
every_test() {
    local folder=build/long_checks/$1
    cmake --preset "$1" -B "$folder" "${@:2}" >"$logs/build.log" && cmake --build "$folder" --parallel >>"$logs/build.log" ||
        { tail -n 40 "$logs/build.log"; return 1; }
    ctest --test-dir "$folder" --parallel "$(nproc)" --output-on-failure |
        grep -vE '^ +Start +[0-9]+:|[0-9]+/[0-9]+ Test +#[0-9]+: .* Passed '
}
run_gcc() { every_test gcc; }
run_arm() { every_test aarch64; }
run_sanitizers() { every_test asan-ubsan -D ZERKALO_FEW_KERNELS=OFF; }

# check NAME WHAT: runs it, shows and keeps its output, and notes how it ended and how long it took.
check() {
    echo "== $1: $2"
    local start=$SECONDS outcome=holds
    "run_$1" 2>&1 | tee "$logs/$1.log" || { outcome="DOES NOT HOLD"; failed=1; }
    summary+=("$1: $outcome, $((SECONDS - start)) s ($2)")
}

[[ " ${only[*]} " =~ \ (oracle|leaks)\  ]] && build_oracle
for name in "${only[@]}"; do
    case $name in
        oracle) check oracle "$rays rays a primitive" ;;
        leaks) check leaks "$leak_rays rays at edges and vertices" ;;
        mutants) check mutants "$(tools/mutants/run.py --check)" ;;
        gcc) check gcc "every test, built by GCC" ;;
        arm) check arm "every test for 64-bit ARM" ;;
        sanitizers) check sanitizers "every test of every kernel, sanitized" ;;
    esac
done
echo "== summary"
printf '%s\n' "${summary[@]}"
exit "$failed"
