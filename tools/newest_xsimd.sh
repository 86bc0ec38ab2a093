#!/usr/bin/env bash
# Builds everything with the newest xsimd that Debian has, instead of Debian 12's 8.1, and runs the tests.
set -euo pipefail
cd "$(dirname "$0")/.."

usage() {
    cat <<'END'
Usage: tools/newest_xsimd.sh [--prefix FOLDER] [CTEST OPTION]...

Takes xsimd from FOLDER (one with include/xsimd), or unpacks the packages libxsimd-dev and xtl-dev of Debian's suite sid
into build/newest_xsimd_packages: nothing is installed, root is not needed. Then builds in build/newest_xsimd what the
preset release builds and runs its tests; options that follow go to ctest, e.g. -R '^(Lanes|EqualBytes)'.

Needs what tools/test.sh installs.
Exit code: 0 all tests pass, 1 something failed, 2 wrong command line.
END
}

prefix=
while [ $# -gt 0 ]; do
    case $1 in
        --help) usage; exit 0 ;;
        --prefix)
            [ -d "${2:-}/include/xsimd" ] || { echo "newest_xsimd.sh: --prefix needs a folder with include/xsimd" >&2; exit 2; }
            prefix=$(realpath "$2")
            shift 2 ;;
        *) break ;;
    esac
done

fail() { echo "newest_xsimd.sh: $1" >&2; exit 1; }

# apt with lists and packages of its own, beside those of the system.
packages=$PWD/build/newest_xsimd_packages
own_apt() {
    "$1" -q -o Dir::Etc::sourcelist="$packages/sources.list" -o Dir::Etc::sourceparts=- \
        -o Dir::State::lists="$packages/lists" -o Dir::Cache="$packages/cache" -o APT::Sandbox::User="$(id -un)" "${@:2}"
}

# Debian's archive as this system knows it: the suite sid is beside its own.
fetch() {
    local archive
    archive=$(apt-get indextargets --format '$(ORIGIN)/$(LABEL) $(REPO_URI)' 'Identifier: Packages' |
        sed -n 's|^Debian/Debian ||p' | head -n 1)
    [ -n "$archive" ] || fail "apt knows no archive of Debian; run apt-get update, or give --prefix"
    mkdir -p "$packages/lists/partial" "$packages/cache/archives/partial"
    echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $archive sid main" >"$packages/sources.list"
    rm -f "$packages"/*.deb
    { own_apt apt-get update && (cd "$packages" && own_apt apt-get download libxsimd-dev xtl-dev); } \
        >"$packages/apt.log" 2>&1 || { tail -n 5 "$packages/apt.log" >&2; fail "the packages could not be fetched"; }
    rm -rf "$packages/usr"
    for package in "$packages"/*.deb; do dpkg-deb -x "$package" "$packages"; done
    prefix=$packages/usr
}

[ -n "$prefix" ] || fetch
version=$(sed -nE 's/^#define XSIMD_VERSION_(MAJOR|MINOR|PATCH) ([0-9]+)$/\2/p' \
    "$prefix/include/xsimd/config/xsimd_config.hpp" | paste -s -d .)
echo "== xsimd $version: building"
log=build/newest_xsimd.log
{ cmake --preset release -B build/newest_xsimd -DCMAKE_PREFIX_PATH="$prefix" &&
    cmake --build build/newest_xsimd --parallel "$(nproc)"; } >"$log" 2>&1 ||
    { tail -n 40 "$log" >&2; fail "the build failed; its last lines are above, all of them in $log"; }
# A configuration that quietly takes the system's own would prove nothing.
grep -q -- "$prefix/include" build/newest_xsimd/compile_commands.json || fail "the build does not use $prefix/include"
echo "== xsimd $version: testing"
ctest --test-dir build/newest_xsimd --output-on-failure -j2 "$@" | grep -vE ' Passed |^ +Start ' || [ "${PIPESTATUS[0]}" -eq 0 ]
