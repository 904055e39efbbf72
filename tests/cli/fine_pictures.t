# Grey strokes, tone and edges of pictures of a sphere with one map of 255 tones, for three techniques and a single
# threshold. bench_fine_frames.sh measures larger pictures, with times.
. "${TOP:-.}/tests/tap.sh"

tamgen --tones 255 --set 'darkest 1' -o map.exr
tamvol map.exr -o volume.ktx2
tamthresh map.exr -o thresholds.ktx2
tamthresh --exact map.exr -o exact.ktx2
meshgen sphere --faces 5000 -o ball.glb
# draw TECHNIQUE SAMPLES PICTURE [OPTION ...]
draw() {
    technique=$1 samples=$2 picture=$3
    shift 3
    render-gl ball.glb -q -t "$technique" --samples "$samples" --size 320x320 --lines none -o "$picture" \
        --tone-range 0:1 "$@"
}
draw gouraud 4 tone.exr
# figure NAME PICTURE REFERENCE
figure() {
    hatchstat ink "$2" --reference "$3" |
        awk -F'\t' -v name="$1" 'NR == 1 {for (i = 1; i <= NF; i++) at[$i] = i} NR == 2 {print $at[name]}'
}
# over NAME A FACTOR B: checks that A is larger than FACTOR times B
over() {
    is "$1 ($2 > $3 x $4)" "$(awk -v a="$2" -v f="$3" -v b="$4" 'BEGIN {print (a > f * b)}')" 1
}
for way in tam:map.exr volume:volume.ktx2 threshold:thresholds.ktx2 threshold-soft:thresholds.ktx2; do
    technique=${way%:*}
    for samples in 1 4 16; do
        draw "$technique" $samples "$technique.$samples.exr" -T "${way#*:}"
    done
    figure grey_strokes "$technique.4.exr" tone.exr >"$technique.grey"
    figure tone_error "$technique.4.exr" tone.exr >"$technique.tone"
    figure edge_error "$technique.1.exr" "$technique.16.exr" >"$technique.jagged"
    figure edge_error "$technique.4.exr" "$technique.16.exr" >"$technique.smooth"
done
draw threshold 4 exact.4.exr -T exact.ktx2

over "tam has more grey strokes than a volume" "$(cat tam.grey)" 1.3 "$(cat volume.grey)"
over "a volume more than thresholds" "$(cat volume.grey)" 1.12 "$(cat threshold.grey)"
over "a volume more than exact runs" "$(cat volume.grey)" 1.1 "$(figure grey_strokes exact.4.exr tone.exr)"
for technique in tam volume threshold; do
    over "tone of $technique" 0.02 1 "$(cat $technique.tone)"
done
over "tone of exact runs" 0.02 1 "$(figure tone_error exact.4.exr tone.exr)"
over "tone of a single threshold is worse" "$(cat threshold-soft.tone)" 2 "$(cat threshold.tone)"
over "edges of a single threshold are ragged" "$(cat threshold-soft.jagged)" 1.3 "$(cat threshold.jagged)"
over "with four samples a pixel far more so" "$(cat threshold-soft.smooth)" 2.5 "$(cat threshold.smooth)"
over "edges of thresholds with one sample" 0.25 1 "$(cat threshold.jagged)"
over "with four" 0.04 1 "$(cat threshold.smooth)"

# A checkerboard of half greys, whose figures are known, and its reference.
printf 'P2 4 4 255\n%s\n' '188 188 188 188 188 188 188 188 188 188 188 188 188 188 188 188' >grey.pgm
printf 'P2 4 4 255\n%s\n' '0 0 255 255 0 0 255 255 0 0 255 255 0 0 255 255' >black.pgm
is "ink of a grey checkerboard against a black one" "$(hatchstat ink grey.pgm black.pgm | cut -f 2-5 | paste -sd' ' | tr '\t' ' ')" \
    "inked grey grey_strokes tone_error 1 1 1 nan 0.5 0 0 nan"
try hatchstat ink grey.pgm --reference tone.exr
refused "a reference of another size" 3 1
try hatchstat ink grey.pgm --patches tone.exr
refused "patches of another size" 3 1
try hatchstat ink
refused "no picture" 2 2
finish
