#!/bin/sh
# Compares drawings of fitted strokes with the picture: 512x512 pixels, strokes of 40x2, tones 0 to 0.65. The stroke script
# is drawn by tamgen --replay; the SVG file, without its outlines, by rsvg-convert.
#   strokes, paths  lines of the script, paths of the SVG file
#   bias            mean darkness of the script's drawing less that of the picture
#   box32, box64    largest difference of their means over squares of 32 and 64 pixels
#   picture_near    share of the picture's ink within two pixels of ink of the drawing;
#   drawing_near    and the reverse (programs/ink_near.c)
#   apart           mean difference per pixel between both drawings, in 2048x2048 pixels: librsvg mixes black and white in
#                   sRGB values where a line covers a part of a pixel
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
command -v rsvg-convert >/dev/null || { echo "bench_fit_drawing: rsvg-convert is missing (librsvg2-bin)" >&2 && exit 1; }
printf 'scene\tstrokes\tpaths\tbias\tbox32\tbox64\tpicture_near\tdrawing_near\tapart\n'

# diff A B FIGURE: prints a figure of hatchstat diff
diff() {
    hatchstat diff "$1" "$2" | awk -F'\t' -v name="$3" 'NR == 1 {for (i = 1; i <= NF; i++) at[$i] = i} NR == 2 {print $at[name]}'
}

for scene in teapot torus sphere ellipsoid; do
    meshgen $scene -o "$work/scene.glb"
    for file in picture.exr drawing.svg script.tsv; do
        render-gl -q "$work/scene.glb" -t strokes --lines none --stroke 40x2 --size 512x512 --tone-range 0:0.65 \
            -o "$work/$file"
    done
    sed '/<g id="outlines"/,/<\/g>/d' "$work/drawing.svg" >"$work/strokes.svg"
    for size in 512 2048; do
        tamgen -q --replay "$work/script.tsv" --tones 1 --levels 1 --size $size --set 'brush round' -o "$work/$size.exr"
    done
    rsvg-convert -b white -w 2048 -h 2048 "$work/strokes.svg" -o "$work/svg.png"
    printf '%s\t%d\t%d\t%.4f\t%.4f\t%.4f\t%s\t%.4f\n' $scene $(($(wc -l <"$work/script.tsv") - 1)) \
        "$(grep -c '<path' "$work/strokes.svg")" "$(diff "$work/picture.exr" "$work/512.exr" bias)" \
        "$(diff "$work/picture.exr" "$work/512.exr" max_box32)" "$(diff "$work/picture.exr" "$work/512.exr" max_box64)" \
        "$(ink_near 2 "$work/picture.exr" "$work/512.exr")" "$(diff "$work/2048.exr" "$work/svg.png" mean)"
done
