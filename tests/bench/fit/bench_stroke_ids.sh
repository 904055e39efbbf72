#!/bin/sh
# Follows the ids of fitted strokes over 120 frames of a turn by 3 degrees a frame, and over 60 frames of a walking figure
# if ../shared has it; 640x360 pixels, a sample per pixel (programs/bench_stroke_ids.c, which has the columns).
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
man=$(dirname "$0")/../../../../shared/data/gltf/CesiumMan.glb
style=$(dirname "$(command -v render-gl)")/../share/hatch/styles/ink.style
printf 'scene\tframes\tstrokes\tsightings\tshort\tparts\tfaint\twaited\tlongest\n'

# follow NAME FILE OPTION ...
follow() {
    name=$1 file=$2
    shift 2
    bench_stroke_ids "$name" -q -t strokes --style "$style" --lines none --size 640x360 --samples 1 "$@" \
        -o "$work/frame%d.png" "$file"
}
for shape in torus teapot; do
    meshgen $shape --faces 20000 -o "$work/$shape.glb"
    follow $shape "$work/$shape.glb" -n 120 --animate from=0:10..357:10
done
[ ! -e "$man" ] || follow CesiumMan "$man" -n 60
