#!/bin/sh
# Measures how well the outlines of drawings agree with the faces that they show, in eight views of shapes, and of scans
# and a skinned figure if ../shared has them (programs/bench_drawing.c): mean, and the largest of the views after a slash.
# all_missed: percentage of the outline and of steps deeper than 4 pixels without a path within 1.5 pixels;
# outside_px: largest distance of a path from the faces.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
shared=$(dirname "$0")/../../../../shared/data
printf 'scene\tpaths\tlength_px\toutline_missed\tall_missed\toutside_px\n'
draw() { # draw NAME SCENE OPTION ...
    name=$1
    shift
    [ -e "$1" ] || return 0
    for from in 30:20 75:10 120:35 165:-20 210:5 255:50 300:0 345:20; do
        set -- "$@" --from $from --size 960x720 -o "$work/drawing.svg"
        render-gl -q "$@"
        bench_drawing -q "$@" 2>/dev/null
    done | awk -v "name=$name" '{
        for (i = 1; i <= 5; i++) {
            sum[i] += $i
            most[i] = $i > most[i] ? $i : most[i]
        }
    }
    END {
        printf "%s\t%.1f/%d\t%.0f\t%.3f/%.3f\t%.3f/%.3f\t%.2f\n", name, sum[1] / NR, most[1], sum[2] / NR,
            sum[3] / NR, most[3], sum[4] / NR, most[4], most[5]
    }'
}
for shape in torus teapot; do
    meshgen $shape --faces 20000 -o "$work/$shape.glb"
    draw $shape "$work/$shape.glb"
done
for file in stanford-bunny.ply armadillo.obj rocker-arm.obj cow.obj teapot.obj; do
    draw "$file" "$shared/meshes/$file"
done
draw CesiumMan "$shared/gltf/CesiumMan.glb" --time-s 0.5
