#!/bin/sh
# Measures lapped-param's time and the number and quality of its patches: for several patch sizes on a torus with its
# true field; for the default size on tori of 1000 to 1,000,000 faces and on ellipsoids with noise of a tenth of an
# edge, whose poles are crumpled; and on the scans in ../shared, if that folder exists, the armadillo decimated to
# 346,000 faces. Seconds are those of the whole command on one thread, including reading and writing: median, minimum
# and maximum of five runs, of three above 200,000 faces. overlap: faces of all patches divided by faces of the
# surface; stretch: 99th percentile; degrees to the field: median and 95th percentile, by faces and by area. SIZES:
# numbers of faces; FEW: those for which all patch sizes are measured.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
here=$(dirname "$0")
models=$here/../../../shared/data/meshes
columns="patches overlap stretch_p99 angle_p50 angle_p95 angle_area_p50 angle_area_p95"
printf 'method\tfaces\tseconds\tseconds_min\tseconds_max\tpeak_kib\t%s\n' "$(echo $columns | tr ' ' '\t')"

# row METHOD FIELD.glb OPTION ...
row() {
    method=$1 field=$2
    shift 2
    runs=5
    [ "$(wc -c <"$field")" -lt 8000000 ] || runs=3
    "$MEASURE" $runs lapped-param --quiet --threads 1 "$@" "$field" -o "$work/lapped.glb" | cut -f 1-3,5 >"$work/time"
    hatchstat lapped --samples 1000 "$work/lapped.glb" | awk -F'\t' -v method="$method" \
        -v time="$(cat "$work/time")" -v columns="$columns" '
        NR == 1 {for (i = 1; i <= NF; i++) at[$i] = i}
        NR == 2 {
            printf "%s\t%d\t%s\t%d", method, $at["faces"], time, $at["patches"]
            count = split(columns, name, " ")
            for (i = 2; i <= count; i++) printf "\t%.3f", $at[name[i]]
            printf "\n"
        }'
}
for faces in ${SIZES:-1000 3000 10000 30000 100000 300000 1000000}; do
    meshgen torus --faces "$faces" --jitter 1 --seed 7 --field -o "$work/torus.glb"
    row chosen "$work/torus.glb"
    meshgen ellipsoid --faces "$faces" --jitter 1 --noise 0.1 --seed 7 | dirfield --quiet -o "$work/noisy.glb"
    row noisy "$work/noisy.glb"
done
for faces in ${FEW:-1000 10000 100000}; do
    meshgen torus --faces "$faces" --jitter 1 --seed 7 --field -o "$work/torus.glb"
    for size in 0.05 0.1 0.2 0.4; do
        row "size $size" "$work/torus.glb" --size $size
    done
done
if [ -d "$models" ]; then
    dirfield --quiet "$models/stanford-bunny.ply" -o "$work/bunny.glb"
    row bunny "$work/bunny.glb"
    awk -f "$here/subdivide.awk" "$models/armadillo.obj" >"$work/armadillo.obj"
    dirfield --quiet "$work/armadillo.obj" -o "$work/armadillo.glb"
    row armadillo "$work/armadillo.glb"
fi
