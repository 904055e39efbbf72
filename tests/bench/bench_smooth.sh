#!/bin/sh
# Measures the trade-off of dirfield's --smooth on the scans in ../shared, if that folder exists: singularities against
# the angle to principal directions. Points and directions are not dirfield's choice: they are those of the quadric over
# three rings (programs/peers.c), at the 30 % of the points where it is most anisotropic, (|k1| - |k2|) / (|k1| + |k2|). Degrees:
# median and 95th percentile of the angle to the nearer principal axis (axis_deg) and to the axis of larger absolute
# curvature (deg). Method smoothest is that of peers.c, with its strength in the column smooth. One thread.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
models=$(dirname "$0")/../../../shared/data/meshes
printf 'model\tmethod\tsmooth\tfaces\tsingularities\tdeg_p50\tdeg_p95\taxis_deg_p50\taxis_deg_p95\tsmoothness\tenergy\t'
printf 'seconds\tseconds_min\tseconds_max\tcpu_seconds\tpeak_kib\n'

# column NAME <TABLE: the value of a column in the last row
column() {
    awk -F'\t' -v name="$1" '
        NR == 1 {for (i = 1; i <= NF; i++) if ($i == name) c = i}
        NR == 1 && !c {print "no column " name >"/dev/stderr"; exit 1}
        END {if (c) print $c}'
}

# figures COMMAND ...: runs a command that writes $work/field.glb, and prints the columns from faces to peak_kib
figures() {
    "$@" >"$work/said"
    hatchstat field -q "$work/field.glb" --reference "$work/peer.glb" --share 0.3 >"$work/figures.tsv"
    for name in faces singularities deg_p50 deg_p95 axis_deg_p50 axis_deg_p95 smoothness; do
        value=$(column $name <"$work/figures.tsv")
        printf '%s\t' "$value"
    done
    value=nan
    [ "$1" != dirfield ] || value=$(column energy <"$work/report.tsv")
    printf '%s\t' "$value"
    "$MEASURE" "$runs" "$@" | tr '\n' '\t' | sed 's/\t$//'
    echo
}

# row FILE METHOD SMOOTH
row() {
    runs=3
    [ "$2" = linear ] || runs=1
    printf '%s\t%s\t%s\t' "$(basename "${1%.*}")" "$2" "$3"
    if [ "$2" = smoothest ]; then
        figures peers -q smoothest "$3" "$1" "$work/field.glb"
    else
        figures dirfield -q -j 1 --method "$2" --smooth "$3" "$1" --report "$work/report.tsv" -o "$work/field.glb"
    fi
}
for model in stanford-bunny.ply horse.ply gargoyle.obj rocker-arm-80k.ply; do
    [ -e "$models/$model" ] || continue
    peers -q quadric 3 "$models/$model" "$work/peer.glb" >"$work/said"
    for smooth in 0 0.1 0.2 0.3 0.4 0.5 0.6 0.7 0.8 0.9; do
        row "$models/$model" linear $smooth
    done
    [ $model = stanford-bunny.ply ] || continue
    for smooth in 0.2 0.3 0.5 0.7; do
        row "$models/$model" hz $smooth
    done
    for strength in 10 30 100 300 1000 3000 10000; do
        row "$models/$model" smoothest $strength
    done
done
