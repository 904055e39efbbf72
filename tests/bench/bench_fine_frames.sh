#!/bin/sh
# Measures all ways to draw one map of 255 tones on a sphere (Webb et al. 2002, Figure 4): time per frame, grey
# strokes, tone and jagged edges. Milliseconds are measured by the driver for the surfaces alone; each run also times
# gouraud as the reference, so that `ratio` compares times of one run. hatchstat ink measures the rest: grey_strokes is
# a share of the inked pixels, the tone error is relative to gouraud's picture, jagged is the edge error relative to
# the same technique with 16 samples per pixel. bytes is the size of the file. Strokes have the width of the style, and
# four pixels.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
printf 'method\tstyle\tsamples\tsize\tms\tms_min\tms_max\tgouraud_ms\tratio\tbytes'
printf '\tinked\tgrey\tgrey_strokes\ttone_error\ttone_worst\tjagged\n'
size=480x480
meshgen sphere --faces 20000 -o "$work/ball.glb"

# draw TECHNIQUE FILE SAMPLES OUTPUT ARGUMENT ...
draw() {
    technique=$1 file=$2 samples=$3 output=$4
    shift 4
    render-gl "$work/ball.glb" -q -t "$technique" ${file:+-T "$file"} --samples "$samples" --size $size --lines none \
        -o "$output" "$@"
}

# row METHOD STYLE TECHNIQUE FILE: one row for each number of samples
row() {
    draw "$3" "$4" 16 "$work/many.exr"
    for samples in 1 4; do
        printf '%s\t%s\t%s\t%s\t' "$1" "$2" $samples $size
        draw "$3" "$4" $samples "$work/times.tsv" --time 15
        draw "$3" "$4" $samples "$work/strokes.exr"
        hatchstat ink --reference "$work/tone.exr" "$work/strokes.exr" >"$work/tone.tsv"
        hatchstat ink --reference "$work/many.exr" "$work/strokes.exr" >"$work/edges.tsv"
        awk -F'\t' -v OFS='\t' -v technique="$3" -v bytes="$(wc -c <"$4")" '
            $2 == "frame" && $1 == technique {ms = $4; low = $5; high = $6}
            $2 == "frame" && $1 == "gouraud" {reference = $4}
            FILENAME ~ /tone/ && FNR == 2 {figures = $1 OFS $2 OFS $3 OFS $4 OFS $5}
            FILENAME ~ /edges/ && FNR == 2 {jagged = $6}
            END {printf "%.3f\t%.3f\t%.3f\t%.3f\t%.3f\t%s\t%s\t%s\n", ms, low, high, reference,
                ms / reference, bytes, figures, jagged}' "$work/times.tsv" "$work/tone.tsv" "$work/edges.tsv"
    done
}
for width in 1.8 4; do
    style=$(awk -v width=$width 'BEGIN {print (width > 2 ? "bold" : "ink")}')
    tamgen --tones 255 --set "darkest 1
width $width" -o "$work/map.exr"
    tamvol "$work/map.exr" -o "$work/volume.ktx2"
    tamvol --layout array "$work/map.exr" -o "$work/array.ktx2"
    tamvol --compress "$work/map.exr" -o "$work/blocks.ktx2"
    tamthresh -q "$work/map.exr" -o "$work/thresholds.ktx2"
    tamthresh --exact "$work/map.exr" -o "$work/exact.ktx2"
    draw gouraud "" 4 "$work/tone.exr" --tone-range 0:1
    row tam $style tam "$work/map.exr"
    row volume $style volume "$work/volume.ktx2"
    row array $style volume "$work/array.ktx2"
    row blocks $style volume "$work/blocks.ktx2"
    row threshold $style threshold "$work/thresholds.ktx2"
    row exact $style threshold "$work/exact.ktx2"
    row threshold-soft $style threshold-soft "$work/thresholds.ktx2"
done
