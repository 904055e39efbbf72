#!/bin/sh
# Measures tamgen's time and the evenness of its strokes: both methods with several numbers of candidates at the size of
# the paper, and larger maps on one and two threads. Each row: five runs with the random seeds 1 to 5; evenness (1:
# random; lower is better) for boxes of N/32, N/16, N/8 and N/4, means over seeds and tones.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
printf 'method\tsize\ttones\tlevels\tthreads\tcandidates\tseconds\tseconds_min\tseconds_max\tcpu_seconds\tpeak_kib'
printf '\teven32\teven16\teven8\teven4\n'

# row METHOD SIZE TONES LEVELS THREADS CANDIDATES EVENNESS
row() {
    printf '%s\t' "$1" "$2" "$3" "$4" "$5" "$6"
    set -- "$7" tamgen --method "$1" --size "$2" --tones "$3" --levels "$4" --threads "$5" --candidates "$6"
    evenness=$1
    shift
    "$MEASURE" 5 "$@" --seed @ -o "$work/map.exr" | tr '\n' '\t'
    if [ "$evenness" = no ]; then
        printf 'nan\tnan\tnan\tnan\n'
        return
    fi
    for seed in 1 2 3 4 5; do
        "$@" --seed $seed --strokes "$work/map.tsv" -o "$work/map.exr"
        hatchstat tam "$work/map.exr" --strokes "$work/map.tsv" --throws 4 | sed -n '1p;$p'
    done | awk -F'\t' '
        $1 == "tone" {for (i = 1; i <= NF; i++) if ($i == "even32") first = i; next}
        {seeds++; for (i = 0; i < 4; i++) sum[i] += $(first + i)}
        END {printf "%.4f\t%.4f\t%.4f\t%.4f\n", sum[0] / seeds, sum[1] / seeds, sum[2] / seeds, sum[3] / seeds}'
}
for method in field exhaustive; do
    for candidates in 30:3 100:10 300:30 1000:100 4000:400; do
        row $method 256 6 4 1 $candidates yes
    done
done
for threads in 1 2; do
    row field 1024 64 6 $threads 1000:100 no
done
