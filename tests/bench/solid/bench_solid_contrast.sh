#!/bin/sh
# Measures the contrast of blended solid textures, eight styles of solidgen and a checkerboard, with
# programs/bench_solid_contrast.c; and the time of a frame of the teapot, 640x360, over that of gouraud in the same run.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
for style in perlin turbulence worley stipple strokes crosshatch marble wood; do
    solidgen -q --style $style --size 64 -o "$work/$style.ktx2"
done
perl "$(dirname "$0")/../../support/solid/make.pl" 64 checker:8 >"$work/checkers.ktx2"
meshgen teapot --faces 20000 -o "$work/scene.glb"
for blend in linear contrast histogram; do
    render-gl "$work/scene.glb" -t solid --solid "$work/perlin.ktx2" --blend $blend --size 640x360 --lines none --time 15 |
        awk -F'\t' -v blend=$blend '$2 == "frame" {ms[$1] = $4}
            END {printf "%s\t%.3f\n", blend, ms["solid"] / ms["gouraud"]}'
done >"$work/ratios"
cd "$work"
bench_solid_contrast perlin=perlin.ktx2 turbulence=turbulence.ktx2 worley=worley.ktx2 stipple=stipple.ktx2 \
    strokes=strokes.ktx2 crosshatch=crosshatch.ktx2 marble=marble.ktx2 wood=wood.ktx2 checkers=checkers.ktx2 |
    awk -F'\t' -v OFS='\t' 'FILENAME == "ratios" {ratio[$1] = $2; next} {print $0, FNR == 1 ? "time_ratio" : ratio[$2]}' \
        ratios -
