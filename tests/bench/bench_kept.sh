#!/bin/sh
# Measures the error of tone against the number of strokes of a scene, 960x720, engraving: strokegen makes 7 levels,
# and programs/keep_strokes.c keeps the first 3 to 7 of them, or the points up to a threshold. Tones are 0 to 0.9.
# tone_rms and bias (mean of the picture minus that of the tone) are those of `hatchstat ink` and `diff` against
# gouraud; tone_rms takes means over windows of 32 pixels, which are about as wide as a blur of 10 pixels' standard
# deviation. kept: strokes; share: of the strokes of all levels. The bunny is measured if ../shared has it.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
bunny=$(dirname "$0")/../../../shared/data/meshes/stanford-bunny.ply
printf 'method\tscene\tpart\tkept\tshare\ttone_rms\tbias\n'

draw() {
    render-gl -q --size 960x720 --lines none --tone-range 0:0.9 "$@"
}
# row SCENE levels|share NUMBER
row() {
    keep_strokes "$2" "$3" "$work/$1.glb" "$work/part.glb" >"$work/counts"
    draw "$work/part.glb" -t traced -o "$work/strokes.exr"
    rms=$(hatchstat ink --reference "$work/$1.exr" "$work/strokes.exr" | awk -F'\t' 'NR == 2 {print $7}')
    bias=$(hatchstat diff "$work/$1.exr" "$work/strokes.exr" | awk -F'\t' 'NR == 2 {print $3}')
    awk -v method="$2" -v scene="$1" -v part="$3" -v rms="$rms" -v bias="$bias" \
        '{printf "%s\t%s\t%s\t%s\t%.4f\t%.5f\t%.5f\n", method, scene, part, $2, $2 / $1, rms, bias}' "$work/counts"
}
meshgen torus --faces 20000 | strokegen -q --levels 7 -o "$work/torus.glb"
meshgen teapot --faces 20000 | strokegen -q --levels 7 -o "$work/teapot.glb"
if [ -e "$bunny" ]; then
    strokegen -q --levels 7 "$bunny" -o "$work/bunny.glb"
fi
for file in "$work"/*.glb; do
    scene=$(basename "$file" .glb)
    draw "$file" -t gouraud -o "$work/$scene.exr"
    for levels in 3 4 5 6 7; do
        row "$scene" levels $levels
    done
    for share in .015 .022 .031 .044 .0625 .088 .125 .177 .25 .35 .5 .7 1; do
        row "$scene" share $share
    done
done
