#!/bin/sh
# Measures the time of a frame at 1280x720 by pass: gouraud, tam, and each look and blend of solid, on the teapot and on
# two finer meshes. Runs of all are interleaved, three times; each also times gouraud, and rows are medians over the runs.
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

# run MESH METHOD ARGUMENT ...
run() {
    mesh=$1 method=$2
    shift 2
    render-gl -q "$work/$mesh.glb" --size 1280x720 --lines none "$@" --time 2 |
        awk -F'\t' -v mesh="$mesh" -v method="$method" 'NR > 1 {
            print mesh "\t" ($1 == "gouraud" && $2 == "frame" && method != "gouraud" ? "reference" : method) "\t" $2 "\t" $4}'
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
printf 'mesh\tmethod\tpass\tms\tms_min\tms_max\tgouraud_ms\tratio\n'
cut -f 1-3 "$work/times" | sort -u | while IFS="$(printf '\t')" read -r mesh method pass; do
    reference=$(awk -F'\t' -v mesh="$mesh" '$1 == mesh && $2 == "reference" && $3 == "frame" {print $4}' "$work/times" |
        sort -n | awk '{at[NR] = $1} END {print at[int((NR + 1) / 2)]}')
    awk -F'\t' -v mesh="$mesh" -v method="$method" -v pass="$pass" '$1 == mesh && $2 == method && $3 == pass {print $4}' \
        "$work/times" | sort -n | awk -v mesh="$mesh" -v method="$method" -v pass="$pass" -v reference="$reference" '
            {at[NR] = $1}
            END {ms = at[int((NR + 1) / 2)]
                printf "%s\t%s\t%s\t%.3f\t%.3f\t%.3f\t%.3f\t%.3f\n", mesh, method == "reference" ? "gouraud" : method,
                    pass, ms, at[1], at[NR], reference, ms / reference}'
done
