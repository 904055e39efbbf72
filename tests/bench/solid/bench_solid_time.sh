#!/bin/sh
# Measures the time of a frame at 1280x720 by pass: gouraud, tam, and each look and blend of solid, on the teapot and on
# two finer meshes. Runs of all are interleaved, three times; each also times gouraud, and rows
# are medians over the runs: of times, and of ratios to gouraud in the same run.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
tamgen --size 256 -o "$work/map.exr"
solidgen -q --size 64 -o "$work/solid.ktx2"
solidgen -q --style strokes --size 64 -o "$work/strokes.ktx2"
meshgen teapot -o "$work/teapot.glb"
meshgen teapot --faces 100000 -o "$work/teapot-100k.glb"
meshgen teapot --faces 538000 -o "$work/teapot-538k.glb"

# run MESH METHOD ARGUMENT ...: prints the times of passes beside that of gouraud in the same run
run() {
    mesh=$1 method=$2
    shift 2
    render-gl -q "$work/$mesh.glb" --size 1280x720 --lines none "$@" --time 2 >"$work/run"
    awk -F'\t' -v mesh="$mesh" -v method="$method" '
        FNR == NR {reference = $1 == "gouraud" && $2 == "frame" ? $4 : reference; next}
        FNR > 1 {print mesh "\t" ($1 == "gouraud" ? $1 : method) "\t" $2 "\t" $4 "\t" reference}' "$work/run" "$work/run"
}
for round in 1 2 3; do
    for mesh in teapot teapot-100k teapot-538k; do
        run $mesh tam --tam "$work/map.exr"
        for blend in linear contrast histogram; do
            run $mesh "plain, $blend" -t solid --solid "$work/solid.ktx2" --blend $blend
        done
        run $mesh binary -t solid --solid "$work/solid.ktx2" --look binary
        run $mesh watercolor -t solid --solid "$work/solid.ktx2" --look watercolor
        run $mesh collage -t solid --solid "$work/solid.ktx2,$work/strokes.ktx2" --look collage
    done
done >"$work/times"
printf 'mesh\tmethod\tpass\tms\tms_min\tms_max\tratio\n'
# middle COLUMN: sorts the rows of $row by a column and prints its smallest, middle and largest value
row=
middle() {
    awk -F'\t' -v row="$row" -v column="$1" '$1 "\t" $2 "\t" $3 == row {print column == 4 ? $4 : $4 / $5}' "$work/times" |
        sort -n | awk '{at[NR] = $1} END {printf "%.3f %.3f %.3f", at[1], at[int((NR + 1) / 2)], at[NR]}'
}
cut -f 1-3 "$work/times" | sort -u | while read -r row; do
    middle 4 >"$work/ms"
    read -r least ms most <"$work/ms" || true
    middle 5 >"$work/ratio"
    read -r _ ratio _ <"$work/ratio" || true
    printf '%s\t%s\t%s\t%s\t%s\n' "$row" "$ms" "$least" "$most" "$ratio"
done
