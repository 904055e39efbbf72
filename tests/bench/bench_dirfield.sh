#!/bin/sh
# Measures dirfield's time and the angle to the true principal direction, for fixed supports of several sizes and
# degrees, the adaptive support, both smoothing methods and the simplified mesh of the paper, on clean and noisy
# irregular shapes of three sizes; a million faces with one method only. Each row: one run on each of five shapes
# (torus, ellipsoid, cylinder, saddle, wave). Seconds are those of frames, curvature and field on one thread, without
# reading and writing: median, minimum and maximum of the five. Angles in degrees are means over the shapes of the
# median and of the 95th percentile. Singularities are those of the torus (0 is right) and the ellipsoid (4). SIZES:
# numbers of faces (default "1000 10000 100000 1000000").
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
printf 'method\tfaces\tnoise\tseconds\tseconds_min\tseconds_max\tpeak_kib\tdeg_p50\tdeg_p95\ttorus\tellipsoid\n'

# column FILE NAME: the value of a column in the first row
column() {
    awk -F'\t' -v name="$2" 'NR == 1 {for (i = 1; i <= NF; i++) if ($i == name) at = i} NR == 2 {print $at}' "$1"
}

# row METHOD FACES NOISE OPTION ...
row() {
    method=$1 faces=$2 noise=$3
    shift 3
    for shape in torus ellipsoid cylinder saddle wave; do
        "$MEASURE" 1 dirfield --quiet --threads 1 "$work/$shape.glb" "$@" --report "$work/report" -o "$work/field.glb" |
            cut -f 5 >"$work/peak"
        hatchstat field "$work/field.glb" --reference "$work/$shape.glb" >"$work/angles"
        for name in frames_ms curvature_ms field_ms singularities; do
            column "$work/report" $name
        done | tr '\n' ' '
        echo "$(cat "$work/peak") $(column "$work/angles" deg_p50) $(column "$work/angles" deg_p95)"
    done | awk -v method="$method" -v faces="$faces" -v noise="$noise" '
        {s[NR] = ($1 + $2 + $3) / 1000; found[NR] = $4; peak = $5 > peak ? $5 : peak; middle += $6; high += $7}
        END {
            for (i = 1; i <= NR; i++)
                for (k = i; k > 1 && s[k] < s[k - 1]; k--) {t = s[k]; s[k] = s[k - 1]; s[k - 1] = t}
            printf "%s\t%s\t%s\t%.4f\t%.4f\t%.4f\t%d\t%.4f\t%.4f\t%d\t%d\n", method, faces, noise, s[3], s[1], s[NR],
                peak, middle / NR, high / NR, found[1], found[2]
        }'
}
for faces in ${SIZES:-1000 10000 100000 1000000}; do
    for noise in 0 0.05 0.2; do
        [ "$faces" -lt 1000000 ] || [ $noise = 0.05 ] || continue
        for shape in torus ellipsoid cylinder saddle wave; do
            meshgen $shape --faces "$faces" --jitter 1 --noise $noise --seed 7 --field -o "$work/$shape.glb"
        done
        row "adaptive, linear" "$faces" $noise
        [ "$faces" -lt 1000000 ] || continue
        row adaptive "$faces" $noise --smooth 0
        [ "$faces" = 10000 ] || continue
        for support in '2 2' '2.6 4' '4 2' '4 3' '6 3' '8 3' '10 3' '14 4'; do
            row "radius ${support% *}, degree ${support#* }" "$faces" $noise --smooth 0 --radius "${support% *}" \
                --degree "${support#* }"
        done
        row "adaptive, hz" "$faces" $noise --method hz
        row "adaptive, Cholesky" "$faces" $noise --solver cholesky
        row "simplified" "$faces" $noise --smooth 0 --coarse $((faces / 8))
        row "simplified, linear" "$faces" $noise --coarse $((faces / 8))
    done
done
