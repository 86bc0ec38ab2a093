#!/usr/bin/env bash
# From a bare Debian 12 to a picture: installs what the render needs, builds the program, renders the shipped scene.
# Usage: demo.sh [SCENE]        The picture appears in build/, named after the scene.
set -euo pipefail

scene=$(realpath -m "${1:-$(dirname "$0")/../firmware/scenes/gold-mirror-5.toml}")
cd "$(dirname "$0")/.."
root=$PWD
[ -r "$scene" ] || { echo "error: there is no scene $scene to read; try one of $root/firmware/scenes/" >&2; exit 1; }

tools/install_packages.sh clang-14 cmake ninja-build libxsimd-dev libtomlplusplus-dev libcli11-dev libbenchmark-dev libpng-dev

# A directory that was configured with its tests keeps them; a new one does not need GoogleTest.
tests=OFF
grep -qs '^ZERKALO_TESTS:[A-Z]*=ON' build/release/CMakeCache.txt && tests=ON

log=$(mktemp)
trap 'rm -f "$log"' EXIT
run_quietly() {
    "$@" >"$log" 2>&1 && return
    cat "$log" >&2
    echo "error: this failed: $*" >&2
    exit 1
}
echo "Building zerkalo (a minute or two the first time) ..." >&2
run_quietly cmake --preset release -DZERKALO_TESTS=$tests
run_quietly cmake --build --preset release --target zerkalo

picture=$root/build/$(basename "$scene" .toml).png
build/release/tools/zerkalo render "$scene" -o "$picture" >&2
echo "$picture"
echo "To look at it: xdg-open $picture" >&2
echo "Without a desktop: $root/build/release/tools/zerkalo show $scene --display terminal --once" >&2
