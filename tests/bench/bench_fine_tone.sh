#!/bin/sh
# Measures the textures made from one map of 255 tones, 256 pixels and four levels: error, tone error and grey strokes
# against memory, for several numbers of bins and tones, plain and block-compressed, grey and coloured (an array of 8
# tones equals a map of 8 columns). Each row: five runs on two threads, including reading and writing; figures of
# hatchstat tones are means over levels of detail.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
printf 'method\tstyle\tvariant\tsize\tseconds\tseconds_min\tseconds_max\tcpu_seconds\tpeak_kib\tbytes\ttone_error\terror\terror_max\tgrey\n'

# row METHOD STYLE VARIANT COMMAND ...: makes $work/made
row() {
    printf '%s\t' "$1" "$2" "$3" 256
    style=$2
    shift 3
    "$MEASURE" 5 "$@" | tr '\n' '\t'
    hatchstat tones "$work/made" --reference "$work/$style.exr" --samples 40000 | awk -F'\t' -v OFS='\t' '
        NR > 1 {n++; bytes = $2; tone += $3; error += $5; if ($6 > most) most = $6; grey += $7}
        END {print bytes, tone / n, error / n, most, grey / n}'
}
for style in ink pencil; do
    map=$work/$style.exr
    tamgen --style $style --set 'darkest 1' --candidates 300:100 --tones 255 -o "$map"
    for bins in 1 2 3 4 5 6 7; do
        row bins $style $bins tamthresh -q -j 2 --bins $bins "$map" -o "$work/made"
    done
    row exact $style all tamthresh -j 2 --exact "$map" -o "$work/made"
    for tones in 8 16 32 64 128; do
        row volume $style $tones tamvol -q -j 2 --tones $tones "$map" -o "$work/made"
        row array $style $tones tamvol -q -j 2 --layout array --tones $tones "$map" -o "$work/made"
        row blocks $style $tones tamvol -q -j 2 --compress --tones $tones "$map" -o "$work/made"
    done
done
style=colour
tamgen --palette dusk --set 'darkest 1' --candidates 300:100 --tones 255 -o "$work/$style.exr"
for tones in 8 16 32 64 128; do
    row volume $style $tones tamvol -q -j 2 --tones $tones "$work/$style.exr" -o "$work/made"
    row bc7 $style $tones tamvol -q -j 2 --compress --layout volume --tones $tones "$work/$style.exr" -o "$work/made"
    row bc1 $style $tones tamvol -q -j 2 --compress --tones $tones "$work/$style.exr" -o "$work/made"
done
