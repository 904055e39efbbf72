#!/bin/sh
# Measures the ink of fitted strokes beside that of the texture's own strokes, with --technique rptam: 960x720 pixels,
# strokes of 40x2, tones 0 to 0.65, without lines. Scenes of whole charts, and scenes that are covered with patches
# (lapped): shapes, and files of ../shared if it is there.
#   ink          mean darkness of the picture
#   texture_near share of the texture's ink within a stroke's width, two pixels, of the fitted strokes' ink;
#   strokes_near and of theirs of the texture's (programs/ink_near.c)
#   black        share of black among the inked pixels, tone_rms: error of tone; across: share of the ink near borders of
#                patches that goes on, continuity: that divided by the same away from borders; of `hatchstat ink`
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
data=$(dirname "$0")/../../../../shared/data
printf 'method\tscene\tink\ttexture_near\tstrokes_near\tblack\ttone_rms\tacross\tcontinuity\n'

# draw SCENE TECHNIQUE OPTION ...: draws into TECHNIQUE.exr
draw() {
    file=$1 technique=$2
    shift 2
    render-gl -q "$work/$file.glb" -t "$technique" --lines none --size 960x720 --tone-range 0:0.65 "$@" \
        -o "$work/$technique.exr"
}

# row TECHNIQUE SCENE NEAR OPTION ...: NEAR: both shares
row() {
    technique=$1 scene=$2 shares=$3
    shift 3
    hatchstat ink --reference "$work/gouraud.exr" "$@" "$work/$technique.exr" | awk -F'\t' -v head="$technique	$scene" \
        -v near="$shares" -v ink="$(hatchstat frames "$work/$technique.exr" "$work/$technique.exr" | awk 'NR == 2 {print 1 - $2}')" '
        NR == 1 {for (i = 1; i <= NF; i++) at[$i] = i}
        NR == 2 {printf "%s\t%.4f\t%s\t%.3f\t%.4f\t%.3f\t%.3f\n", head, ink, near, $at["black"], $at["tone_rms"],
            $at["across"], $at["continuity"]}'
}

# measure SCENE
measure() {
    scene=$1
    draw "$scene" gouraud
    draw "$scene" rptam --stroke 40x2
    draw "$scene" strokes --stroke 40x2
    set --
    case $scene in
    *-lapped)
        render-gl -q "$work/$scene.glb" --show patches --light 180:0 --lines none --samples 1 --size 960x720 \
            -o "$work/patches.png"
        set -- --patches "$work/patches.png"
        ;;
    esac
    near=$(ink_near 2 "$work/rptam.exr" "$work/strokes.exr")
    row rptam "$scene" "nan	nan" "$@"
    row strokes "$scene" "$near" "$@"
}
for shape in teapot torus sphere ellipsoid superquadric; do
    meshgen $shape -o "$work/$shape.glb"
done
scenes="teapot torus sphere"
lapped="ellipsoid superquadric torus"
for file in gltf/Duck.glb gltf/CesiumMan.glb meshes/stanford-bunny.ply meshes/rocker-arm.obj; do
    [ -e "$data/$file" ] || continue
    name=$(basename "$file")
    cp "$data/$file" "$work"
    case $name in
    Duck.glb) scenes="$scenes Duck" ;;
    CesiumMan.glb) scenes="$scenes CesiumMan" lapped="$lapped CesiumMan" ;;
    *)
        dirfield -q "$work/$name" -o "$work/${name%.*}.glb"
        lapped="$lapped ${name%.*}"
        ;;
    esac
done
for scene in $scenes; do
    measure "$scene"
done
for scene in $lapped; do
    dirfield -q "$work/$scene.glb" | lapped-param -q -o "$work/$scene-lapped.glb"
    measure "$scene-lapped"
done
