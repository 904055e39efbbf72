#!/bin/sh
# run.sh FOLDER: runs the benchmarks. Each bench_SUBJECT.sh prints a table with a header line, which is written to
# FOLDER/SUBJECT.tsv: method, size of the work; median, minimum and maximum seconds of five or more runs; peak memory;
# errors, with name and unit. $MEASURE runs and times a command (programs/measure.c). The environment variable SUBJECT, a name
# or a pattern, selects benchmarks: make bench SUBJECT=fine_frames.
set -eu
mkdir -p "$1"
MEASURE=$(cd "$1" && pwd)/measure
export MEASURE
${CC:-cc} -O2 -std=c11 -D_POSIX_C_SOURCE=200809L -o "$MEASURE" "$(dirname "$0")/programs/measure.c"
for script in "$(dirname "$0")"/bench_${SUBJECT:-*}.sh "$(dirname "$0")"/*/bench_${SUBJECT:-*}.sh; do
    [ -e "$script" ] || continue
    subject=$(basename "$script" .sh | sed 's/^bench_//')
    echo "$subject"
    sh "$script" >"$1/$subject.part"
    mv "$1/$subject.part" "$1/$subject.tsv"
done
