#!/bin/sh
# times.sh OLD NEW [ROUNDS]: the time of a frame with the render-gl of two builds, by technique: columns technique,
# old_ms, new_ms and ratio. Builds draw in turns, so that a busy machine slows both; times are medians of the rounds'
# medians, of frames in software on one thread.
set -eu
old=$(cd "$1" && pwd) new=$(cd "$2" && pwd) rounds=${3:-9}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
trap 'exit 1' INT TERM HUP
cd "$folder"
LP_NUM_THREADS=0
export LP_NUM_THREADS
"$new/bin/meshgen" teapot --faces 20000 -o teapot.glb
"$new/bin/tamgen" -q --size 128 --levels 3 -o six.exr
"$new/bin/tamgen" -q --size 128 --levels 3 --tones 32 -o many.exr
"$new/bin/tamvol" -q many.exr -o volume.ktx2
"$new/bin/tamthresh" -q many.exr -o thresholds.ktx2
frame() { # frame BUILD TECHNIQUE [ASSET]
    build=$1 technique=$2
    shift 2
    "$build/bin/render-gl" -q teapot.glb -t "$technique" ${1:+-T "$1"} --size 320x240 --time 7 | awk -F'\t' '
        NR == 1 {for (i = 1; i <= NF; i++) column[$i] = i; next}
        $column["span"] == "frame" {print $column["wall_ms"]; exit}'
}
median() {
    sort -n "$1" | awk '{value[NR] = $1} END {print value[int((NR + 1) / 2)]}'
}
printf 'technique\told_ms\tnew_ms\tratio\n'
for technique in $("$new/bin/render-gl" --options-table | awk -F'\t' '$2 == "technique" {gsub(",", " ", $7); print $7}'); do
    for asset in "" six.exr volume.ktx2 thresholds.ktx2 none; do
        frame "$new" "$technique" "$asset" >found 2>said && [ -s found ] && break
    done
    [ "$asset" != none ] || { echo "$technique: no asset fits" >&2; exit 1; }
    : >old_ms
    : >new_ms
    for _ in $(seq "$rounds"); do
        frame "$old" "$technique" "$asset" >>old_ms
        frame "$new" "$technique" "$asset" >>new_ms
    done
    echo "$technique $(median old_ms) $(median new_ms)" | awk '{printf "%s\t%.2f\t%.2f\t%.3f\n", $1, $2, $3, $3 / $2}'
done
