#!/usr/bin/env bash
# The study of error against run time over every shipped scene, and of single solids before a mirror of exponent 1000.
set -euo pipefail

usage() {
    cat <<'TEXT'
Usage: tools/study.sh [--short | --quick] [--program FILE] [--update] [DIR]

Runs `zerkalo study` into DIR, default build/study; a run that was stopped goes on there.
--short    120x90 pixels, every second number of samples, smaller references: ten minutes instead of thirty
--quick    to see that it works: a minute
--update   afterwards writes goals and tables into tools/README.md and the diagrams into tools/pictures/study
--program  the zerkalo to study, default build/release/tools/zerkalo

Times are of one thread; run nothing else meanwhile. Diagrams need gnuplot (Debian package gnuplot-nox).
TEXT
}

fail() {
    echo "study.sh: $1" >&2
    exit "$2"
}

root=$(realpath "$(dirname "$0")/..")
program=$root/build/release/tools/zerkalo
folder='' update=false mode=() command=tools/study.sh
while [ $# -gt 0 ]; do
    case $1 in
        --help|-h) usage; exit 0 ;;
        --short) mode=(--size 120x90 --samples 1,4,16,64,256 --reference-samples 16384); command+=" --short" ;;
        --quick) mode=(--quick); command+=" --quick" ;;
        --update) update=true; command+=" --update" ;;
        --program) [ $# -ge 2 ] || fail "--program needs a value" 2; program=$(realpath -m "$2"); shift ;;
        -*) fail "unknown option '$1'; see --help" 2 ;;
        *) [ -z "$folder" ] || fail "one folder at most; see --help" 2; folder=$(realpath -m "$1") ;;
    esac
    shift
done
folder=${folder:-$root/build/study}
[ -x "$program" ] || fail "$program is not there; build it: cmake --workflow --preset release" 1
readme=$root/tools/README.md
begin='<!-- study: begin -->'
end='<!-- study: end -->'
for marker in "$begin" "$end"; do
    [ "$(grep -cxF -- "$marker" "$readme")" = 1 ] || fail "$readme has not one line '$marker'" 1
done

load=$(cut -d ' ' -f 1 /proc/loadavg)
scenes=("$root"/firmware/scenes/*.toml)
for solid in sphere prism pyramid; do
    scenes+=("$root/firmware/scenes/$solid.toml@1000")
done
"$program" study "${scenes[@]}" -o "$folder" "${mode[@]}" --threads 1
echo "$folder/study.md"
$update || exit 0

# from_lscpu NAME: the value of that line.
from_lscpu() { LC_ALL=C lscpu | sed -n "s/^$1: *//p" | head -n 1; }
# part NAME: a section of study.md, one heading deeper.
part() { sed -n "/^## $1/,/^## /{/^## $1/{s/^/#/;p;d};/^## /d;p}" "$folder/study.md"; }

pictures=$root/tools/pictures/study
mkdir -p "$pictures"
new=$(mktemp "$readme.XXXXXX")
trap 'rm -f "$new"' EXIT
{
    sed "/^$begin\$/q" "$readme"
    virtual=$(from_lscpu 'Hypervisor vendor')
    cat <<TEXT
$(date -u +%Y-%m-%d), $(from_lscpu 'Model name'), $(from_lscpu 'CPU(s)') CPUs${virtual:+ under $virtual}, load average \
$load at the start: \`$command\`.
TEXT
    sed -n '3,/^$/p' "$folder/study.md"
    part Goals
    part Cheapest
    echo "### Time against error"
    echo
    echo "Below the grey zone no error can be told. Rings: what no other setting beats."
    echo
    for picture in "$folder"/diagrams/*-time.png; do
        name=$(basename "$picture")
        cp "$picture" "$pictures/$name"
        printf '<img src="pictures/study/%s" width="400" alt="%s: time against error"> ' "$name" "${name%-time.png}"
    done
    echo
    sed -n "/^$end\$/,\$p" "$readme"
} >"$new"
chmod 644 "$new"
mv "$new" "$readme"
trap - EXIT
