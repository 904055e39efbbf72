#!/bin/sh
# Measures the trade-off of dirfield's --smooth on the scans in ../shared, if that folder exists: singularities against
# the angle to the unsmoothed principal direction at the most certain third of the points. One thread.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
models=$(dirname "$0")/../../../shared/data/meshes
printf 'model\tmethod\tsmooth\tfaces\tsingularities\tdeg_p50\tdeg_p95\tsmoothness\tenergy\t'
printf 'seconds\tseconds_min\tseconds_max\tcpu_seconds\tpeak_kib\n'

# column NAME <TABLE: the value of a column in the last row
column() {
    awk -F'\t' -v name="$1" 'NR == 1 {for (i = 1; i <= NF; i++) if ($i == name) c = i} END {print $c}'
}

# row FILE METHOD SMOOTH
row() {
    runs=3
    [ "$2" = linear ] || runs=1
    set -- "$(basename "${1%.*}")" "$2" "$3" dirfield -q -j 1 --method "$2" --smooth "$3" "$1"
    printf '%s\t%s\t%s\t' "$1" "$2" "$3"
    shift 3
    "$@" --report "$work/report.tsv" -o "$work/field.glb"
    hatchstat field -q "$work/field.glb" --reference "$work/raw.glb" --share 0.3333 >"$work/figures.tsv"
    for name in faces singularities deg_p50 deg_p95 smoothness; do
        printf '%s\t' "$(column $name <"$work/figures.tsv")"
    done
    printf '%s\t' "$(column energy <"$work/report.tsv")"
    "$MEASURE" "$runs" "$@" -o "$work/field.glb" | tr '\n' '\t' | sed 's/\t$//'
    echo
}
for model in stanford-bunny.ply horse.ply gargoyle.obj rocker-arm-80k.ply; do
    [ -e "$models/$model" ] || continue
    dirfield -q --smooth 0 "$models/$model" -o "$work/raw.glb"
    for smooth in 0.1 0.2 0.3 0.4 0.5 0.6 0.7 0.8 0.9; do
        row "$models/$model" linear $smooth
    done
    [ $model = stanford-bunny.ply ] || continue
    for smooth in 0.2 0.3 0.5 0.7; do
        row "$models/$model" hz $smooth
    done
done
