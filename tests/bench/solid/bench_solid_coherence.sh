#!/bin/sh
# Measures what changes between the frames of a film besides the motion itself (programs/flicker.c), for solid textures
# and, beside them, a tonal art map: on the teapot, which the camera turns around by one degree a frame, and on the
# animations of a figure with a skin and of a box of moving parts, if ../shared has them. 960x720, 5 frames, no
# lines, one tone everywhere. change: mean difference of luminance from frame to frame at the same points of the surface;
# screen: the same for a picture of a plane by the same method that stays with the screen; ratio: screen / change.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
gltf=$(dirname "$0")/../../../../shared/data/gltf
printf 'scene\tmethod\tchange\tscreen\tratio\tcompared\n'
meshgen teapot --faces 20000 -o "$work/teapot.glb"
meshgen plane -o "$work/plane.glb"
tamgen -q --size 256 -o "$work/map.exr"
solidgen -q --style perlin --size 64 -o "$work/perlin.ktx2"

# draw SCENE METHOD ARGUMENT ...
draw() {
    scene=$1 method=$2
    shift 2
    case $method in
    tam) set -- --tam "$work/map.exr" --tone-range 0.5:0.5 "$@" ;;
    binary) set -- -t solid --solid "$work/perlin.ktx2" --look binary --tone-range 0.5:0.5 "$@" ;;
    binary-linear) set -- -t solid --solid "$work/perlin.ktx2" --look binary --blend linear --tone-range 0.5:0.5 "$@" ;;
    *) set -- -t solid --solid "$work/perlin.ktx2" --blend "$method" --tone-range 0:0 "$@" ;;
    esac
    render-gl -q "$scene" --lines none --size 960x720 "$@"
}

# row NAME SCENE METHOD FLICKER RENDER: FLICKER and RENDER are arguments of the two programs
row() {
    draw "$work/plane.glb" "$3" --from 0:0 --zoom 4 -o "$work/screen.exr"
    draw "$2" "$3" --frames 5 $5 -o "$work/frame%d.exr"
    # Of the columns of flicker: the change, and the share of points that are compared.
    moved=$(flicker -q ${4%%|*} "$2" ${4#*|} "$work"/frame[0-4].exr | cut -f 1,2)
    screen=$(flicker -q ${4%%|*} --paper "$work/screen.exr" "$2" ${4#*|} "$work"/frame[0-4].exr)
    printf '%s\t%s\t%s\t%s\n' "$1" "$3" "$moved" "$screen" |
        awk -F'\t' -v OFS='\t' '{print $1, $2, $3, $5, $5 / $3, $4}'
}
for method in linear contrast histogram binary binary-linear tam; do
    row teapot "$work/teapot.glb" $method '|30 1 20' '--animate from=30:20..34:20'
    for name in CesiumMan BoxAnimated; do
        [ -e "$gltf/$name.glb" ] || continue
        [ $method$name != tamBoxAnimated ] || continue # it has no texture coordinates
        row $name "$gltf/$name.glb" $method '--rate 24|60 0 10' '--from 60:10'
    done
done
