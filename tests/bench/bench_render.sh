#!/bin/sh
# Measures the time per frame and the tone error of render-gl's techniques, on the teapot at three distances, 1280x720.
# Milliseconds are measured by the driver for the surfaces alone; each run also times gouraud as the reference, so that
# `ratio` compares times of one run. The error is the largest difference from gouraud in linear light over windows of
# 64 pixels, which average strokes out; mean over the distances.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
printf 'method\tsize\tms\tms_min\tms_max\tgouraud_ms\tratio\tpeak_kib\ttone_error_box64\tbias\n'
tamgen --size 512 -o "$work/map.exr"
meshgen teapot --faces 20000 -o "$work/scene.glb"

# with TECHNIQUE ANISOTROPY ARGUMENT ...: draws with the map; gouraud, which reads none, with the tones of the map
with() {
    technique=$1 anisotropy=$2
    shift 2
    case $technique in
    gouraud) set -- --tone-range 0:0.9 "$@" ;;
    *) set -- --tam "$work/map.exr" --anisotropy "$anisotropy" "$@" ;;
    esac
    ${measure:-} render-gl "$work/scene.glb" --technique "$technique" "$@"
}

# picture NAME TECHNIQUE DISTANCE ANISOTROPY
picture() {
    with "$2" "$4" --camera "$3" --lines none -o "$work/$1.exr"
}

# row NAME TECHNIQUE ANISOTROPY SIZE: SIZE fits in one tile, since only one tile is timed
row() {
    measure="$MEASURE 1" with "$2" "$3" --size "$4" --lines none --time 9 -o "$work/times.tsv" | tr '\n' '\t' >"$work/whole.tsv"
    for camera in 2,1.6,4:0,0,0 4,3.2,8:0,0,0 8,6.4,16:0,0,0; do
        picture tone gouraud $camera 1
        picture strokes "$2" $camera "$3"
        hatchstat diff "$work/strokes.exr" "$work/tone.exr" | tail -n 1
    done >"$work/errors.tsv"
    awk -F'\t' -v name="$1" -v technique="$2" -v size="$4" '
        FILENAME ~ /times/ && $2 == "frame" && $1 == technique {ms = $4; low = $5; high = $6}
        FILENAME ~ /times/ && $2 == "frame" && $1 == "gouraud" {reference = $4}
        FILENAME ~ /whole/ {peak = $5}
        FILENAME ~ /errors/ {error += $10; bias += $3; n++}
        END {printf "%s\t%s\t%.3f\t%.3f\t%.3f\t%.3f\t%.3f\t%s\t%.5f\t%.5f\n", name, size, ms, low, high,
            reference, ms / reference, peak, error / n, bias / n}
    ' "$work/times.tsv" "$work/whole.tsv" "$work/errors.tsv"
}
for method in gouraud tam tam-flat tam-face tam-gouraud tam-triple; do
    row $method $method 1 1280x720
done
row tam-threshold tam-threshold 1 1024x720
row "tam anisotropy 8" tam 8 1280x720
