#!/bin/sh
# run.sh FOLDER: measures. Each bench_SUBJECT.sh prints a TSV with a header line, which goes to
# FOLDER/SUBJECT.tsv: method, size of the work, median, minimum and maximum seconds of five runs or
# more, peak memory, error with its name and unit. $MEASURE runs and times a command: measure.c. SUBJECT, a
# name or a pattern, measures that alone: make bench SUBJECT=fine_frames.
set -eu
mkdir -p "$1"
MEASURE=$(cd "$1" && pwd)/measure
export MEASURE
${CC:-cc} -O2 -std=c11 -D_POSIX_C_SOURCE=200809L -o "$MEASURE" "$(dirname "$0")/measure.c"
for script in "$(dirname "$0")"/bench_${SUBJECT:-*}.sh; do
    [ -e "$script" ] || continue
    subject=$(basename "$script" .sh | sed 's/^bench_//')
    echo "$subject"
    sh "$script" >"$1/$subject.part"
    mv "$1/$subject.part" "$1/$subject.tsv"
done
