#!/bin/sh
# Measures solidgen --exemplar: time, memory and both distances to the exemplar (hatchstat(1)) over sizes, methods,
# neighbourhoods and iterations, and the fast search against the exhaustive one. The exemplars have 128x128 pixels: cells
# with dark borders and bricks, in colours, and pen strokes that cross, in grey. Distances are of the last run; energy is
# what solidgen -v reports.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP

awk 'BEGIN {
    srand(1)
    for (i = 0; i < 110; i++) {x[i] = rand() * 160 - 16; y[i] = rand() * 160 - 16; c[i] = 0.5 + 0.4 * rand()}
    print "P3\n128 128\n255"
    for (v = 0; v < 128; v++) for (u = 0; u < 128; u++) {
        a = b = 1e9
        for (i = 0; i < 110; i++) {
            d = (u - x[i])^2 + (v - y[i])^2
            if (d < a) {b = a; a = d; n = i} else if (d < b) b = d
        }
        e = (sqrt(b) - sqrt(a)) / 3.5
        if (e > 1) e = 1
        print int(255 * e * c[n]), int(220 * e * c[n]), int(80 * e + 13)
    }}' >"$work/cells.ppm"
awk 'BEGIN {
    srand(2)
    print "P3\n128 128\n255"
    for (v = 0; v < 128; v++) for (u = 0; u < 128; u++) {
        row = int(v / 12); across = u + row % 2 * 12; n = int(across / 24) * 16 + row
        if (!(n in tint)) tint[n] = 0.7 + 0.3 * rand()
        grain = 0.9 + 0.1 * rand()
        if (v % 12 < 2 || across % 24 < 2) print int(225 * grain), int(222 * grain), int(212 * grain)
        else print int(170 * tint[n] * grain), int(85 * tint[n] * grain), int(55 * tint[n] * grain)
    }}' >"$work/bricks.ppm"
awk 'BEGIN {
    print "P2\n128 128\n255"
    for (v = 0; v < 128; v++) for (u = 0; u < 128; u++) {
        a = (0.57 * u + 0.82 * v) % 8; b = (0.57 * (128 - u) + 0.82 * v) % 8
        d = a < b ? a : b
        print int(255 * (d < 1 ? 0 : d < 2 ? d - 1 : 1))
    }}' >"$work/strokes.pgm"

printf 'method\texemplar\tsize\taxes\tneighborhood\titerations\tseconds\tseconds_min\tseconds_max\tcpu_seconds\tpeak_kib'
printf '\tenergy\thistogram\tneighborhood_distance\n'
# row RUNS METHOD EXEMPLAR SIZE AXES NEIGHBOURHOOD ITERATIONS [OPTION]: METHOD is kopf, pyramid or exhaustive
row() {
    runs=$1 method=$2 exemplar=$work/$3 size=$4 axes=$5 side=$6 iterations=$7
    printf '%s\t' "$method" "${3%.*}" "$size" "$axes" "$side" "$iterations"
    set -- solidgen --exemplar "$exemplar" --size "$size" --iterations "$iterations" -o "$work/solid.ktx2"
    case $method in
    kopf) set -- "$@" --neighborhood "$side" --axes "$axes" ;;
    exhaustive) set -- "$@" --neighborhood "$side" --axes "$axes" --exhaustive ;;
    pyramid) set -- "$@" --method pyramid ;;
    esac
    "$MEASURE" "$runs" "$@" --seed @ | tr '\n' '\t'
    for seed in $(seq "$runs"); do
        [ $method = pyramid ] && { echo nan; continue; }
        [ "$runs" -gt 1 ] || { "$@" -v 2>&1 | awk '/difference/ {print $NF}'; continue; }
        "$@" --seed "$seed" -v 2>&1 | awk '/difference/ {print $NF}'
    done | awk '{sum += $1} END {printf "%.5f\t", sum / NR}'
    hatchstat solid "$work/solid.ktx2" --reference "$exemplar" | awk -F'\t' 'NR == 2 {printf "%.5f\t%.5f\n", $14, $18}'
}
for size in 8 16 32 64 128; do
    runs=5
    [ $size -lt 64 ] || runs=1
    row $runs kopf cells.ppm $size xyz 8 8
    row $runs kopf strokes.pgm $size xyz 8 8
    row 5 pyramid cells.ppm $size xyz 0 8
    row 5 pyramid strokes.pgm $size xyz 0 8
done
for axes in xyz xy; do
    row 1 kopf bricks.ppm 64 $axes 8 8
done
row 5 pyramid bricks.ppm 64 xyz 0 8
for exemplar in cells.ppm bricks.ppm strokes.pgm; do
    for side in 4 6 8 10 12; do
        row 3 kopf $exemplar 32 xyz $side 8
    done
    for iterations in 1 2 4 16 32; do
        row 3 kopf $exemplar 32 xyz 8 $iterations
    done
    row 3 kopf $exemplar 16 xyz 8 3
    row 3 exhaustive $exemplar 16 xyz 8 3
done
