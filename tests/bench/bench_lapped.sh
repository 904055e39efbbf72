#!/bin/sh
# lapped-param's time, and how many patches of what quality it makes, for several sizes of patch on a torus of 1000
# to 1,000,000 faces that carries its true field: seconds of the whole command on one thread, reading and writing
# included: median, least and most of three runs; overlap: faces of all patches over those of the surface; stretch:
# 99th percentile; degrees to the field: median and 95th percentile. SIZES: which numbers of faces.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
printf 'method\tfaces\tseconds\tseconds_min\tseconds_max\tpeak_kib\tpatches\toverlap\tstretch_p99\tdeg_p50\tdeg_p95\n'
for faces in ${SIZES:-1000 3000 10000 30000 100000 300000 1000000}; do
    meshgen torus --faces "$faces" --jitter 1 --seed 7 --field -o "$work/torus.glb"
    for size in chosen 0.05 0.1 0.2 0.4; do
        [ $size = chosen ] && option= || option="--size $size"
        "$MEASURE" 3 lapped-param --quiet --threads 1 $option "$work/torus.glb" -o "$work/lapped.glb" |
            cut -f 1-3,5 >"$work/time"
        hatchstat lapped --samples 1000 "$work/lapped.glb" >"$work/figures"
        awk -F'\t' -v method="size $size" -v faces="$faces" -v time="$(cat "$work/time")" '
            NR == 1 {for (i = 1; i <= NF; i++) at[$i] = i}
            NR == 2 {
                printf "%s\t%d\t%s\t%d\t%.3f\t%.3f\t%.3f\t%.3f\n", method, faces, time, $at["patches"],
                    $at["overlap"], $at["stretch_p99"], $at["angle_p50"], $at["angle_p95"]
            }' "$work/figures"
    done
done
