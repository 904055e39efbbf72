#!/bin/sh
# Measures strokegen's time, and the number of its strokes: for 4, 5 and 6 levels on tori of 1000 to 1,000,000 faces with
# their true field, and for 3 to 8 levels on a torus of 10,000 faces; and for 6 levels on the scans in ../shared, if that
# folder exists. Seconds are those of the whole command with two threads, including reading and writing: median, minimum
# and maximum of five runs. bytes: those of the strokes in the file. SIZES: numbers of faces.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
models=$(dirname "$0")/../../../shared/data/meshes
printf 'method\tfaces\tlevels\tseconds\tseconds_min\tseconds_max\tpeak_kib\tstrokes\tpoints\tbytes\n'

# row METHOD FIELD.glb LEVELS
row() {
    time=$("$MEASURE" 5 strokegen --quiet --threads 2 --levels "$3" "$2" -o "$work/strokes.glb" | cut -f 1-3,5)
    strokegen --verbose --levels "$3" "$2" -o "$work/strokes.glb" 2>&1 >"$work/out" |
        awk -v method="$1" -v faces="$(hatchstat mesh "$2" | awk 'NR == 2 {print $2}')" -v levels="$3" -v time="$time" \
            -v bytes="$(($(wc -c <"$work/strokes.glb") - $(wc -c <"$2")))" \
            '/ strokes, / {printf "%s\t%s\t%s\t%s\t%s\t%s\t%s\n", method, faces, levels, time, $2, $4, bytes}'
}
for faces in ${SIZES:-1000 3000 10000 30000 100000 300000 1000000}; do
    meshgen torus --faces "$faces" --jitter 1 --seed 7 --field -o "$work/torus.glb"
    for levels in 4 5 6; do
        row torus "$work/torus.glb" $levels
    done
done
meshgen torus --faces 10000 --jitter 1 --seed 7 --field -o "$work/torus.glb"
for levels in 3 7 8; do
    row torus "$work/torus.glb" $levels
done
if [ -d "$models" ]; then
    for model in stanford-bunny.ply armadillo.obj rocker-arm.obj teapot.obj; do
        dirfield --quiet "$models/$model" -o "$work/model.glb"
        row "${model%.*}" "$work/model.glb" 6
    done
fi
