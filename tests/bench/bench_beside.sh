#!/bin/sh
# Measures traced strokes beside tam, volume and rptam at equal tones, 0 to 0.65, the darkest of rptam, with strokes 2
# pixels wide, 960x720 with 4 samples, without lines, on the torus, the teapot, and the bunny if ../shared has it,
# which is covered with patches for all but traced. Milliseconds are those of the driver for a frame: medians of five
# runs, in which the techniques take turns; ratio: to gouraud in the same run. black, inked and tone_rms are those of
# `hatchstat ink` against gouraud. flicker is the mean difference between successive frames of a turntable of 1
# degree, at the same points of the surface (programs/flicker.c), and still the same for steps of 0.05 degrees, in
# which hardly a stroke changes; the light turns with the scene. flicker_tone and still_tone: those of gouraud.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
bunny=$(dirname "$0")/../../../shared/data/meshes/stanford-bunny.ply
printf 'method\tscene\tms\tms_min\tms_max\tratio\tinked\tblack\ttone_rms\tflicker\tstill\tflicker_tone\tstill_tone\n'
tamgen -q --size 512 --set 'width 2' -o "$work/map.exr"
tamgen -q --size 512 --set 'width 2' --tones 64 | tamvol -q -o "$work/volume.ktx2"

# with TECHNIQUE SCENE ARGUMENT ...
with() {
    technique=$1 scene=$2 file=$2
    shift 2
    case $technique in
    traced) file=$scene.strokes && set -- --stroke-width 2 "$@" ;;
    tam) set -- --tam "$work/map.exr" "$@" ;;
    volume) set -- --tam "$work/volume.ktx2" "$@" ;;
    rptam) set -- --stroke 40x2 "$@" ;;
    esac
    case $technique$scene in
    tambunny | volumebunny | rptambunny) file=lapped ;;
    esac
    render-gl -q "$work/$file.glb" -t "$technique" --lines none --size 960x720 --tone-range 0:0.65 "$@"
}

# flicker_of TECHNIQUE SCENE STEP: the mean over four steps
flicker_of() {
    azimuth=$(awk -v step="$3" 'BEGIN {print 30 + 4 * step}')
    light=$(awk -v step="$3" 'BEGIN {print -40 - 4 * step}')
    with "$1" "$2" -n 5 --animate "from=30:0..$azimuth:0" --animate "light=-40:40..$light:40" -o "$work/turn%d.exr"
    flicker "$work/$2.glb" 30 "$3" 0 "$work"/turn[0-4].exr | cut -f 1
}

# row TECHNIQUE SCENE
row() {
    with "$1" "$2" -o "$work/strokes.exr"
    hatchstat ink --reference "$work/tone.exr" "$work/strokes.exr" |
        awk -F'\t' 'NR == 2 {print $1, $9, $7}' >"$work/ink"
    awk -F'\t' -v technique="$1" '$1 == technique && $2 == "frame" {ms = $4}
        $1 == "gouraud" && $2 == "frame" {printf "%s\t%s\n", ms, ms / $4}' "$work/$1".[1-5].tsv | sort -n |
        awk -v method="$1" -v scene="$2" -v ink="$(cat "$work/ink")" -v moved="$(flicker_of "$1" "$2" 1)" \
            -v still="$(flicker_of "$1" "$2" 0.05)" -v tone="$(cat "$work/tone")" '
            {ms[NR] = $1; ratio[NR] = $2}
            END {
                split(ink, part, " ")
                printf "%s\t%s\t%s\t%s\t%s\t%.2f\t%.4f\t%.4f\t%.4f\t%s\t%s\t%s\n", method, scene, ms[3],
                    ms[1], ms[5], ratio[3], part[1], part[2], part[3], moved, still, tone
            }'
}
meshgen torus --faces 20000 -o "$work/torus.glb"
meshgen teapot --faces 20000 -o "$work/teapot.glb"
scenes="torus teapot"
if [ -e "$bunny" ]; then
    scenes="$scenes bunny"
    dirfield -q "$bunny" -o "$work/bunny.glb"
    lapped-param -q "$work/bunny.glb" -o "$work/lapped.glb"
fi
for scene in $scenes; do
    strokegen -q --levels 7 "$work/$scene.glb" -o "$work/$scene.strokes.glb"
    with gouraud "$scene" -o "$work/tone.exr"
    printf '%s\t%s\n' "$(flicker_of gouraud "$scene" 1)" "$(flicker_of gouraud "$scene" 0.05)" >"$work/tone"
    for turn in 1 2 3 4 5; do
        for technique in traced tam volume rptam; do
            with $technique "$scene" --time 3 -o "$work/$technique.$turn.tsv"
        done
    done
    for technique in traced tam volume rptam; do
        row $technique "$scene"
    done
done
