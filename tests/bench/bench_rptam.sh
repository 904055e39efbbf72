#!/bin/sh
# Measures the time per frame of render-gl's technique rptam against the number of seed points for both values of
# --seed-loop, on the teapot, 640x360, four layers, with the default samples and strokes. The tile grows with the number
# of seed points, so that the number of strokes is constant. Milliseconds are measured by the driver for the surfaces alone;
# each run also times gouraud as the reference, and one row times tam. The error is the largest difference from the
# picture of the other loop, 0..1.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
printf 'method\tseeds\tlayers\tsize\tms\tms_min\tms_max\tgouraud_ms\tratio\tpeak_kib\tdifference\n'
tamgen --size 256 -o "$work/map.exr"
meshgen teapot --faces 20000 -o "$work/scene.glb"

# row METHOD SEEDS FRAMES DIFFERENCE ARGUMENT ...
row() {
    method=$1 seeds=$2 frames=$3 difference=$4
    shift 4
    "$MEASURE" 1 render-gl "$work/scene.glb" --size 640x360 --lines none "$@" --time "$frames" \
        -o "$work/times.tsv" | tr '\n' '\t' >"$work/whole.tsv"
    awk -F'\t' -v method="$method" -v seeds="$seeds" -v difference="$difference" '
        FILENAME ~ /times/ && $2 == "frame" && $1 != "gouraud" {ms = $4; low = $5; high = $6}
        FILENAME ~ /times/ && $2 == "frame" && $1 == "gouraud" {reference = $4}
        FILENAME ~ /whole/ {peak = $5}
        END {printf "%s\t%s\t4\t640x360\t%.3f\t%.3f\t%.3f\t%.3f\t%.3f\t%s\t%s\n", method, seeds, ms, low, high,
            reference, ms / reference, peak, difference}
    ' "$work/times.tsv" "$work/whole.tsv"
}
row tam 0 9 0 --tam "$work/map.exr"
for seeds in 4 16 64 256 1024; do
    seedgen -n $seeds --layers 4 --candidates 10 -o "$work/sets"
    tile=$(awk -v n=$seeds 'BEGIN {printf "%.3f", 32 * sqrt(n)}')
    for loop in coverage brute; do
        render-gl "$work/scene.glb" -t rptam --size 320x180 --lines none --seeds "$work/sets" --seed-tile "$tile" \
            --seed-loop $loop -o "$work/$loop.exr"
    done
    difference=$(hatchstat diff "$work/coverage.exr" "$work/brute.exr" | awk -F'\t' 'NR == 2 {print $1}')
    for loop in coverage brute; do
        frames=7
        [ $loop$seeds != brute1024 ] || frames=2
        row $loop $seeds $frames "$difference" -t rptam --seeds "$work/sets" --seed-tile "$tile" \
            --seed-loop $loop
    done
done
