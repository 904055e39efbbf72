#!/bin/sh
# Measures how much of the ink of traced strokes is kept where the camera has turned around a scene, at the same points
# of the surface (programs/flicker.c): mean of four turns by 1 and by 5 degrees, while the light stays with the scene;
# and, for comparison, that of the strokes of another seed in the same view.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
meshes=$(dirname "$0")/../../../../shared/data/meshes
draw() { # draw STROKES OPTION ...
    strokes=$1
    shift
    render-gl -q "$work/$strokes" -t traced --finer 0 --lines none --size 960x720 --tone-range 0:.9 "$@"
}
printf 'scene\tafter_1_degree\tafter_5_degrees\tother_seed\n'
for shape in torus teapot superquadric; do
    meshgen $shape --faces 20000 | dirfield -q --smooth 1 -o "$work/$shape.glb"
done
for name in stanford-bunny.ply armadillo.obj rocker-arm.obj; do
    [ ! -e "$meshes/$name" ] || dirfield -q "$meshes/$name" -o "$work/${name%.*}.glb"
done
for file in "$work"/*.glb; do
    name=$(basename "$file" .glb)
    printf '%s' "$name"
    strokegen -q "$file" -o "$work/strokes.part"
    strokegen -q --seed 2 "$file" -o "$work/other.part"
    for step in 1 5; do
        draw strokes.part -n 5 --animate "from=30:20..$((30 + 4 * step)):20" \
            --animate "light=-40:40..$((-40 - 4 * step)):40" -o "$work/turn%d.exr"
        printf '\t%s' "$(flicker -q "$file" 30 $step 20 "$work"/turn[0-4].exr | cut -f 3)"
    done
    draw strokes.part --from 30:20 -o "$work/one.exr"
    draw other.part --from 30:20 -o "$work/two.exr"
    printf '\t%s\n' "$(flicker -q "$file" 30 0 20 "$work/one.exr" "$work/two.exr" | cut -f 3)"
done
