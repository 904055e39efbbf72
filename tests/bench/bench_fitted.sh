#!/bin/sh
# Measures how few fitted strokes a scene needs, 960x720, tones 0 to 0.6: --most-strokes keeps the largest, and longer
# and wider strokes (--stroke) need fewer for the same tone. tone_rms is that of `hatchstat ink` against gouraud, over
# windows of 32 pixels; bias that of `hatchstat diff`. strokes: those that are drawn.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
printf 'method\tscene\tpart\tstrokes\ttone_rms\tbias\n'

draw() {
    render-gl --size 960x720 --lines none --tone-range 0:0.6 "$@"
}
# row METHOD SCENE PART OPTION ...
row() {
    method=$1 scene=$2 part=$3
    shift 3
    draw -v -t strokes "$work/$scene.glb" -o "$work/strokes.exr" "$@" 2>"$work/said"
    count=$(sed -n 's/.*: \([0-9]*\) strokes, [0-9]* fragments.*/\1/p' "$work/said")
    rms=$(hatchstat ink --reference "$work/$scene.exr" "$work/strokes.exr" | awk -F'\t' 'NR == 2 {print $7}')
    bias=$(hatchstat diff "$work/$scene.exr" "$work/strokes.exr" | awk -F'\t' 'NR == 2 {print $3}')
    printf '%s\t%s\t%s\t%s\t%s\t%s\n' "$method" "$scene" "$part" "$count" "$rms" "$bias"
}
for scene in teapot torus sphere; do
    meshgen $scene -o "$work/$scene.glb"
    draw -q -t gouraud "$work/$scene.glb" -o "$work/$scene.exr"
    for most in 125 250 500 1000 1500 2000 2500 3000 4000; do
        row largest $scene $most --most-strokes $most
    done
    for size in 20x1 30x1.4 40x2 60x3 80x4 110x5.5 160x8; do
        row size $scene $size --stroke $size
    done
done
