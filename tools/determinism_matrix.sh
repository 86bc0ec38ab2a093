#!/usr/bin/env bash
# Builds the core with many compilers, levels and processors, renders every shipped scene with each, and prints the
# hashes as Markdown: one a scene and number type, or the first stage (camera-ray, hit, normal, radiance) that differs.
set -euo pipefail

usage() {
    cat <<'TEXT'
Usage: tools/determinism_matrix.sh [--builds NAME,NAME...] [--jobs N] [--update]

Prints two tables: the hash of every scene, and what each configuration gives. Installs the cross compilers and
emulators that are missing. Builds stay in build/matrix; the whole matrix takes half an hour on two free cores.
--builds  only these (see --list), instead of all
--list    the names of all builds
--jobs    compilations at a time, default: the number of processors
--update  writes the tables into the section "Equal bits" of tests/README.md instead

Exit code 0: all configurations give the same hashes, and the build that breaks the float contract does not; 1: not so.
TEXT
}

cd "$(dirname "$0")/.."
for argument in "$@"; do
    case $argument in --help|-h) usage; exit 0 ;; esac
done
packages=(g++ clang-14 libclang-rt-14-dev cmake ninja-build python3 libxsimd-dev libtomlplusplus-dev
          libcli11-dev libbenchmark-dev libpng-dev
          g++-aarch64-linux-gnu g++-arm-linux-gnueabihf qemu-user)
tools/install_packages.sh "${packages[@]}"
exec python3 -B tools/determinism_matrix.py "$@"
