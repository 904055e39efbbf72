#!/bin/sh
# Measures seedgen's time against the number of seed points for its three methods, up to the size at which backtracking
# gives up (`found`: the share of twenty runs that find a cycle within a million digits), and the distances between seed
# points against the number of candidates: means over five files of four layers, compared with random points and the
# Bayer order. Distances are divided by the hexagonal bound.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
printf 'method\tseeds\tlayers\tcandidates\tfound\tseconds\tseconds_min\tseconds_max\tcpu_seconds\tpeak_kib'
printf '\tdistance\tdistance_random\tdistance_bayer\n'

# row METHOD SEEDS LAYERS CANDIDATES FILES: five runs; distances are measured in the first FILES of them
row() {
    set -- "$5" "$1" "$2" "$3" "$4" seedgen --method "$1" -n "$2" --layers "$3" --candidates "$4" --max-nodes 1000000
    files=$1
    shift
    method=$1
    printf '%s\t' "$1" "$2" "$3" "$4"
    shift 4
    if [ "$method" = backtrack ]; then
        for seed in $(seq 20); do
            "$@" --seed "$seed" 2>/dev/null >"$work/seeds" && echo 1 || { [ $? = 5 ] && echo 0; }
        done | awk '{n += $1} END {printf "%g\t", n / NR}'
        "$MEASURE" 20 sh -c '"$@" 2>/dev/null || [ $? = 5 ]' sh "$@" --seed @ | tr '\n' '\t'
    else
        printf '1\t'
        "$MEASURE" 5 "$@" --seed @ -o "$work/seeds" | tr '\n' '\t'
    fi
    [ "$files" -gt 0 ] || { printf 'nan\tnan\tnan\n'; return; }
    for seed in $(seq "$files"); do
        "$@" --seed "$seed" | hatchstat seeds --throws 100 | tail -n +2
    done | awk -F'\t' '{d += $5; r += $7; b += $8} END {printf "%.4f\t%.4f\t%.4f\n", d / NR, r / NR, b / NR}'
}
for seeds in 4 16 64 256 1024; do
    row backtrack $seeds 1 1 0
done
for seeds in 16 64 256 1024 4096 16384 65536 262144 1048576; do
    row euler $seeds 1 1 0
done
for seeds in 10 100 1000 10000 100000 1000003; do
    row any $seeds 1 1 0
done
for candidates in 1 3 10 30 100 300 1000 3000; do
    row any 64 4 $candidates 5
done
