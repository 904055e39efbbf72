#!/bin/sh
# Follows the ids of fitted strokes over 120 frames of a turn by 3 degrees a frame, of two shapes and of one that is covered
# with patches, and over 60 frames of a walking figure if ../shared has it; 640x360 pixels, a sample per pixel. The
# program bench_stroke_ids lists the strokes three times: as they are; with shaders that know no threshold, neither of tone
# nor of detail; and with those through all surfaces (stroke_ids.awk, which has the kinds of short sightings).
#   strokes     frames, strokes per frame; with --aggregate blend: strokes that wait for a slot in all frames but the first,
#               and most frames for which one does
#   other rows  a way to draw: sightings, share of the ink that is left out, and short sightings of each kind: those with at
#               least 4 pixels of ink in a frame, and those with less
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
here=$(cd "$(dirname "$0")" && pwd)
shaders=$here/../../../cmd/render-gl/shaders
man=$here/../../../../shared/data/gltf/CesiumMan.glb
style=$(dirname "$(command -v render-gl)")/../share/hatch/styles/ink.style
printf 'scene\tway\tsightings\tleft_out\ttwo_thresholds\ta_threshold\tpatch\thidden\taway\tcut_short\n'

# change FOLDER FILE FROM TO: replaces a line of a shader
change() {
    awk -v from="$3" -v to="$4" '{at = index($0, from)} at {$0 = substr($0, 1, at - 1) to; found = 1} {print} END {exit !found}' \
        "$shaders/$2" >"$work/$1/$2"
}
for folder in all through; do
    cp -r "$shaders" "$work/$folder"
    change $folder rptam/layers.glsl 'clamp(layer.tone.x * way + layer.tone.y, 0.0, 1.0);' '1.0;'
    change $folder rptam/seeds.glsl 'lives == uvec2(255u) ? 1.0 : clamp(weight, 0.0, 1.0);' '1.0;'
    change $folder strokes/gather.frag 'way_to(amount);' '1.0;'
done
change through traced/paper.frag 'o_color = ' 'discard;'
change through frame/vertex.glsl 'gl_Position = clip_from_unit * point;' 'gl_Position = clip_from_unit * point; gl_Position.z = 0.0;'

# follow NAME FILE OPTION ...
follow() {
    name=$1 file=$2
    shift 2
    for list in plain all through; do
        what=seen folder=$work/$list
        [ $list != plain ] || what=drawn folder=$shaders
        bench_stroke_ids $what -q -t strokes --style "$style" --lines none --size 640x360 --samples 1 "$@" --shader-dir "$folder" \
            -o "$work/frame%d.png" "$file" >"$work/$list.tsv"
    done
    awk -v name="$name" -f "$here/stroke_ids.awk" "$work/plain.tsv" "$work/all.tsv" "$work/through.tsv"
}
for shape in torus teapot superquadric; do
    meshgen $shape --faces 20000 -o "$work/$shape.glb"
done
follow torus "$work/torus.glb" -n 120 --animate from=0:10..357:10
follow teapot "$work/teapot.glb" -n 120 --animate from=0:10..357:10
dirfield -q "$work/superquadric.glb" | lapped-param -q -o "$work/patches.glb"
follow superquadric-patches "$work/patches.glb" -n 120 --animate from=0:10..357:10
[ ! -e "$man" ] || follow CesiumMan "$man" -n 60
