#!/usr/bin/env bash
# Measures how fast the release build renders and prints the figures as Markdown, each table with its command.
set -euo pipefail

usage() {
    cat <<'TEXT'
Usage: tools/figures.sh [--quick] [--program FILE] [OUT.md]
       tools/figures.sh [--program FILE] --update

Prints the figures to standard output, or into OUT.md.
--update   writes them into tools/figures/README.md instead
--quick    fewer frames and rounds, to see that it works: half a minute instead of three
--program  the zerkalo to measure, default build/release/tools/zerkalo

Needs python3; counts instructions if valgrind is there. Other programs that run meanwhile disturb little:
the times are processor times.
TEXT
}

fail() {
    echo "figures.sh: $1" >&2
    exit "$2"
}

root=$(realpath "$(dirname "$0")/..")
program=$root/build/release/tools/zerkalo
out='' quick=() update=false
while [ $# -gt 0 ]; do
    case $1 in
        --help|-h) usage; exit 0 ;;
        --quick) quick=(--quick) ;;
        --update) update=true ;;
        --program) [ $# -ge 2 ] || fail "--program needs a value" 2; program=$(realpath -m "$2"); shift ;;
        -*) fail "unknown option '$1'; see --help" 2 ;;
        *) [ -z "$out" ] || fail "one output file at most; see --help" 2; out=$1 ;;
    esac
    shift
done
if $update; then
    [ "${#quick[@]}$out" = 0 ] || fail "--update wants the whole run and writes tools/figures/README.md alone" 2
    out=$root/tools/figures/README.md
fi
begin='<!-- figures: begin -->'
end='<!-- figures: end -->'

# marker TEXT: how often tools/figures/README.md has this line.
marker() { grep -cxF -- "$1" "$out" || true; }

if $update && [ "$(marker "$begin") $(marker "$end")" != "1 1" ]; then
    fail "$out has not one line '$begin' and one '$end'" 1
fi
if [ -n "$out" ] && { [ -d "$out" ] || [ ! -w "$(dirname "$out")" ]; }; then
    fail "$out cannot be written" 1
fi
[ -x "$program" ] || fail "$program is not there; build it: cmake --workflow --preset release" 1
command -v python3 >/dev/null || fail "python3 is not installed (Debian: apt-get install python3)" 1
newer=$(find "$root/core" "$root/platform" "$root/tools" -name '*.[ch]pp' -newer "$program" -print -quit)
[ -z "$newer" ] || echo "figures.sh: warning: $program is older than its sources, e.g. $newer" >&2

# Other programs slow this one down only through the caches that they share: the load is told, not avoided.
load=$(cut -d ' ' -f 1 /proc/loadavg)
work=$(mktemp -d)
new=
trap 'rm -rf "$work" ${new:+"$new"}' EXIT
trap 'exit 130' INT TERM

# The shipped scene with its mirror polished; its highlight stays.
sed '/^lobe/d' "$root/firmware/scenes/gold-mirror-5.toml" >"$work/sharp.toml"
case $("$program" render "$work/sharp.toml" -o "$work/picture.png" --json) in
    *'"glossy"'*) fail "gold-mirror-5.toml names its lobe in a way that this script does not know" 1 ;;
esac

# from_lscpu NAME: the value of that line.
from_lscpu() { LC_ALL=C lscpu | sed -n "s/^$1: *//p" | head -n 1; }

head_of_figures() {
    local virtual compiler
    virtual=$(from_lscpu 'Hypervisor vendor')
    compiler=$("$program" doctor --json | sed -n 's/.*"compiler": "\([^"]*\)".*/\1/p')
    cat <<TEXT
$(date -u +%Y-%m-%d), $(from_lscpu 'Model name') (family $(from_lscpu 'CPU family'), model $(from_lscpu Model)), \
$(from_lscpu 'CPU(s)') CPUs${virtual:+ under $virtual}, $compiler, load average $load at the start.
\`zerkalo\` is \`build/release/tools/zerkalo\`; \`sharp.toml\` is the shipped scene with its mirror polished:

    sed '/^lobe/d' firmware/scenes/gold-mirror-5.toml > sharp.toml
TEXT
}

head_of_figures >"$work/figures.md"
for table in instructions lanes process pixels solids kernels; do
    echo "figures.sh: $table ..." >&2
    echo >>"$work/figures.md"
    python3 -B "$root/tools/figures.py" "$table" "$program" "$work" "${quick[@]}" >>"$work/figures.md"
done

if [ -z "$out" ]; then
    cat "$work/figures.md"
    exit 0
fi
new=$(mktemp "$out.XXXXXX")
if $update; then
    { sed "/^$begin\$/q" "$out"; cat "$work/figures.md"; sed -n "/^$end\$/,\$p" "$out"; } >"$new"
else
    cat "$work/figures.md" >"$new"
fi
chmod 644 "$new"
mv "$new" "$out"
new=
