#!/bin/sh
# Measures meshfit beside the simplification of gltfpack, on built-in shapes and on the meshes of $MESHES, where they are.
# Both keep the error: the largest displacement that hatchstat coarse measures in pictures of $SIZE is at most half a
# pixel. gltfpack has no such option: its ratio is found by bisection, in 10 steps, and its time is that of one run with
# the ratio that was found. Rows of `gltfpack, 99.9 %` need to keep the error for 99.9 % of the places only.
# Without gltfpack there are rows of meshfit alone.
# MESHES: their folder (default: none). SIZE (default 960x720). STEPS of the bisection (default 10).
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
size=${SIZE:-960x720}
printf 'method\tmesh\tfaces_full\tfaces\tseconds\tseconds_min\tseconds_max\tpeak_kib\tdisplacement_px\tdisplacement_p999_px\t'
printf 'outline_px\toutline_p999_px\tnormal_deg\n'

# row METHOD MESH COMMAND ...: runs a command that writes $work/coarse.glb, and prints its row
row() {
    method=$1 mesh=$2
    shift 2
    times=$("$MEASURE" "${RUNS:-3}" "$@" | cut -f 1-3,5)
    hatchstat coarse -q --size "$size" "$work/full.glb" "$work/coarse.glb" >"$work/figures"
    awk -F'\t' -v method="$method" -v mesh="$mesh" -v times="$times" 'NR == 2 {
        printf "%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\n", method, mesh, $1, $2, times, $3, $4, $5, $6, $7}' "$work/figures"
}

# bisect COLUMN: sets $ratio to the smallest of gltfpack for which the figure is at most half a pixel
bisect() {
    low=0 ratio=1 step=0
    while [ "$step" -lt "${STEPS:-10}" ]; do
        step=$((step + 1))
        middle=$(echo "$low $ratio" | awk '{print ($1 + $2) / 2}')
        gltfpack -noq -si "$middle" -i "$work/full.glb" -o "$work/coarse.glb" >"$work/log"
        figure=$(hatchstat coarse -q --size "$size" "$work/full.glb" "$work/coarse.glb" | tail -n 1 | cut -f "$1")
        if echo "$figure" | awk '{exit !($1 <= 0.5)}'; then ratio=$middle; else low=$middle; fi
    done
}

# both MESH: the rows of $work/full.glb
both() {
    row meshfit "$1" meshfit -q --size "$size" "$work/full.glb" -o "$work/coarse.glb"
    command -v gltfpack >"$work/log" || return 0
    for method in 3:gltfpack '4:gltfpack, 99.9 %'; do
        bisect "${method%%:*}"
        row "${method#*:}" "$1" gltfpack -noq -si "$ratio" -i "$work/full.glb" -o "$work/coarse.glb"
    done
}

for shape in ${SHAPES-sphere torus teapot saddle}; do
    meshgen "$shape" --faces 40000 -o "$work/full.glb"
    both "$shape"
done
for file in ${MESHES:+${FILES-stanford-bunny.ply armadillo.obj horse.ply rocker-arm.obj igea.ply gargoyle.obj}}; do
    [ -e "$MESHES/$file" ] || continue
    meshfit -q --faces 4294967295 "$MESHES/$file" -o "$work/full.glb" || continue
    both "${file%.*}"
done
