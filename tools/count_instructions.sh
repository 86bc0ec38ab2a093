#!/bin/sh
# Exact instruction counts of rendering alone: callgrind counts only while the program is in render_frame(), which hands
# out the tiles; one thread.
set -eu

usage() {
    cat <<'END'
Usage: tools/count_instructions.sh [--program FILE] [--size WxH] SCENE [ISAS [SAMPLES]]

Prints the instructions of one frame for every instruction set and sample count, e.g.
    tools/count_instructions.sh firmware/scenes/gold-mirror-5.toml sse4.2,avx2 1,16,64

ISAS      comma-separated, default scalar,sse2,sse4.2,avx2
SAMPLES   comma-separated lobe rays per mirror hit, default 1,16,64
--program the zerkalo to measure, default build/release/tools/zerkalo
--size    size of the picture, default 640x480

Needs valgrind. Valgrind (3.19 in Debian 12) cannot run AVX-512: avx512 is refused.
A scene with a polished mirror has the same count for every sample count.
END
}

fail() {
    echo "count_instructions.sh: $1" >&2
    exit "$2"
}

program=$(dirname "$0")/../build/release/tools/zerkalo
size=640x480
while [ $# -gt 0 ]; do
    case $1 in
        --help|-h) usage; exit 0 ;;
        --program|--size) [ $# -ge 2 ] || fail "$1 needs a value" 2 ;;
        -*) fail "unknown option '$1'; see --help" 2 ;;
        *) break ;;
    esac
    case $1 in
        --program) program=$2 ;;
        --size) size=$2 ;;
    esac
    shift 2
done
case $# in 1|2|3) ;; *) fail "expected SCENE [ISAS [SAMPLES]]; see --help" 2 ;; esac
scene=$1
isas=${2:-scalar,sse2,sse4.2,avx2}
samples=${3:-1,16,64}
command -v valgrind >/dev/null || fail "valgrind is not installed (Debian: apt-get install valgrind)" 1
[ -x "$program" ] || fail "$program is not there; build it or name another by --program" 1
case ,$isas, in *,avx512,*) fail "valgrind cannot run avx512; take avx2 or a narrower one" 2 ;; esac

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM

# count ISA SAMPLES: instructions of one frame.
count() {
    if ! valgrind --tool=callgrind --callgrind-out-file="$work/out" --toggle-collect='zerkalo::render_frame(*' \
        "$program" render "$scene" -o "$work/picture.png" --size "$size" --threads 1 --isa "$1" --samples "$2" \
        >"$work/log" 2>&1; then
        grep -v '^==' "$work/log" >&2 || true
        fail "the run failed: $program render $scene --isa $1 --samples $2" 1
    fi
    sed -n 's/^totals: \([0-9]*\)$/\1/p' "$work/out"
}

printf 'scene %s, %s, one thread, instructions per frame\n\n' "$scene" "$size"
printf '%-8s %8s %15s\n' isa samples instructions
for isa in $(echo "$isas" | tr ',' ' '); do
    for n in $(echo "$samples" | tr ',' ' '); do
        instructions=$(count "$isa" "$n")
        [ "${instructions:-0}" -gt 0 ] || fail "$program has no symbol render_frame; is it stripped?" 1
        printf '%-8s %8s %15s\n' "$isa" "$n" "$instructions"
    done
done
