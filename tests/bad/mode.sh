#!/bin/sh
# mode.sh FOLDER FILE COMMAND ...: runs a command on FOLDER/FILE, where the word IN stands for the input and OUT for an
# output file, and prints a line: processor seconds, peak MiB, exit status (over 128: a signal), command, file and the
# first line of its messages, separated by tabs. $MEASURE is the program made of tests/bench/programs/measure.c.
set -u
folder=$1 file=$2
shift 2
words=$*
. "$TOP/tests/bad/words.sh"
# The limit only ends what would run for ever.
spent=$("$MEASURE" 1 sh -c '
    work=$1
    shift
    (ulimit -t 20; ulimit -c 0; exec timeout 600 "$@" --threads 2) >"$work/said" 2>"$work/words" </dev/null
    echo $? >"$work/status"' sh "$work" "$@" 2>/dev/null) || exit 1
printf '%s\n' "$spent" | awk -F '\t' -v status="$(cat "$work/status")" -v words="$words" -v file="$file" \
    -v said="$(head -n 1 "$work/words" | cut -c 1-160 | tr '\t\\' '  ')" '
    {printf "%.2f\t%.0f\t%s\t%s\t%s\t%s\n", $4, $5 / 1024, status, words, file, said}'
