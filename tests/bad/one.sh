#!/bin/sh
# one.sh EXPECT SAYS FIGURES FOLDER FILE COMMAND ...: runs a command on FOLDER/FILE and prints one TAP line without a
# number. The word IN of the command stands for the input, OUT for an output file. make.pl documents EXPECT, SAYS and
# FIGURES.
set -u
expect=$1 says=$2 figures=$3 folder=$4 file=$5
shift 5
name="$file ($expect): $*"
. "$TOP/tests/bad/words.sh"

# A shell can limit the address space only; sanitizers and OpenGL drivers reserve more than they use. OpenImageIO, which
# reads formats other than PNG and EXR, reserves 400 MB when it is loaded.
if [ -z "${SANITIZE:-}" ] && [ "$1" != render-gl ]; then
    case $file in
    *.jpg | *.tif | *.bmp | *.gif | *.tga | *.hdr | *.ppm) ulimit -v $((1024 * 1024)) ;;
    *) ulimit -v $((512 * 1024)) ;;
    esac
fi
# Processor time does not depend on other load; the second limit ends commands that wait forever.
seconds=5
[ -z "${SANITIZE:-}" ] || seconds=30
(ulimit -t "$seconds" && exec timeout 600 "$@" --threads 2) >"$work/said" 2>"$work/words" </dev/null
status=$?

complaint() {
    # in one write, because another one.sh runs in parallel
    printf 'not ok - %s\n# %s (exit %s)\n%s\n' "$name" "$1" "$status" \
        "$(head -n 3 "$work/words" | cut -c 1-500 | sed 's/^/# /')"
    exit 0
}
refused() {
    [ "$(wc -l <"$work/words")" -eq 1 ] || complaint "not one line"
    grep -qF "${file##*/}" "$work/words" || complaint "the file is not named"
    for left in "$work"/* "$work"/.[!.]*; do
        case ${left##*/} in said | words | '*' | '.[!.]*') ;; *) complaint "an output was left: ${left##*/}" ;; esac
    done
    [ ! -s "$work/said" ] || complaint "something on standard output"
}
accepted() {
    [ -s "$work/said" ] || ls "$work"/out* >/dev/null 2>&1 || complaint "no output"
    # The PSNR of equal images is infinite, but nothing is NaN.
    if cat "$work"/out.tsv "$work/said" 2>/dev/null | LC_ALL=C grep -aqiw nan; then
        complaint "the output is NaN"
    fi
    # hatchstat refuses files with NaN or infinite values; a mesh that nodes make flat may stay so.
    if [ -e "$work/out.glb" ] && ! "$BIN/hatchstat" mesh "$work/out.glb" >"$work/read" 2>&1 &&
        ! grep -q ': no face has an area$' "$work/read"; then
        complaint "the output cannot be read: $(head -n 1 "$work/read")"
    fi
    [ "$figures" = - ] || compare
}
compare() {
    other=$(awk -F '\t' -v wanted="$figures" '
        NR == 1 {for (i = 1; i <= NF; i++) at[$i] = i}
        NR == 2 {
            count = split(wanted, figure, ",")
            for (i = 1; i <= count; i++) {
                split(figure[i], part, "=")
                if (!(part[1] in at) || $at[part[1]] + 0 != part[2] + 0) print figure[i] ": is " $at[part[1]] " "
            }
        }' "$work/out.tsv")
    [ -z "$other" ] || complaint "wrong figures: $(printf %s "$other" | tr '\n' ' ')"
}
case $expect.$status in
ERR.3 | ERR.5 | EITHER.3 | EITHER.5) refused ;;
OK.0 | EITHER.0) accepted ;;
WARN.0)
    accepted
    grep -q 'warning: ' "$work/words" || complaint "no warning"
    ;;
*) complaint "unexpected exit status" ;;
esac
# without the names of command and file, which may contain the same words
[ "$says" = - ] || sed 's/^[^:]*: [^:]*: //' "$work/words" | grep -qE -e "$says" || complaint "does not say: $says"
echo "ok - $name"
