#!/bin/sh
# Measures how much of the ink of traced strokes is kept where the camera has turned around a scene, at the same points
# of the surface (programs/flicker.c): mean of four turns by 1 and by 5 degrees, while the light stays with the scene;
# and, for comparison, that of the strokes of another seed in the same view.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
. "$(dirname "$0")/scenes.sh"
draw() { # draw STROKES OPTION ...
    strokes=$1
    shift
    render-gl -q "$work/$strokes" -t traced --finer 0 --lines none --size 960x720 --tone-range 0:.9 "$@"
}
printf 'scene\tafter_1_degree\tafter_5_degrees\tother_seed\n'
make_fields "$work"
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
