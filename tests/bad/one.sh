#!/bin/sh
# one.sh EXPECT FOLDER FILE COMMAND ...: gives FILE to a command and prints one TAP line without a
# number. OUT among the words is an output file, IN the input. EXPECT: as in the manifest's README.
set -u
expect=$1 folder=$2 file=$3
shift 3
name="$1 $2: $file: $expect"
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
count=$#
while [ $count -gt 0 ]; do
    word=$1
    shift
    case $word in
    IN) word=$folder/$file ;;
    OUT) word=$work/out ;;
    OUT.*) word=$work/out.${word#OUT.} ;;
    esac
    set -- "$@" "$word"
    count=$((count - 1))
done

# Address space is what a shell can bound; sanitizers and OpenGL drivers reserve more than they use.
if [ -z "${SANITIZE:-}" ] && [ "$1" != render-gl ]; then
    ulimit -v $((512 * 1024))
fi
# Of a processor, which a busy machine does not change; the other limit ends what waits for ever.
seconds=5
[ -z "${SANITIZE:-}" ] || seconds=30
(ulimit -t "$seconds" && exec timeout 600 "$@") >"$work/said" 2>"$work/words" </dev/null
status=$?

complaint() {
    # in one write: another runs beside this one
    printf 'not ok - %s\n# %s (exit %s)\n%s\n' "$name" "$1" "$status" \
        "$(head -n 3 "$work/words" | sed 's/^/# /')"
    exit 0
}
refused() {
    [ "$(wc -l <"$work/words")" -eq 1 ] || complaint "more or less than one line"
    grep -qF "$(basename "$file")" "$work/words" || complaint "the file is not named"
    [ -z "$(ls "$work" | grep -v -e said -e words)" ] || complaint "an output was left"
    [ ! -s "$work/said" ] || complaint "something on standard output"
}
accepted() {
    [ -s "$work/said" ] || ls "$work"/out* >/dev/null 2>&1 || complaint "no output"
    # an infinite ratio of two equal pictures is right, a NaN never is
    if cat "$work"/out.tsv "$work/said" 2>/dev/null | LC_ALL=C grep -aqiw nan; then
        complaint "the output is NaN"
    fi
    # which refuses numbers that are none
    if [ -e "$work/out.glb" ] && ! "$BIN/hatchstat" mesh "$work/out.glb" >"$work/read" 2>&1; then
        complaint "the output cannot be read again: $(head -n 1 "$work/read")"
    fi
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
echo "ok - $name"
