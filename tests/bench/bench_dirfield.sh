#!/bin/sh
# Measures dirfield and other methods against the true principal directions of twelve irregular shapes, clean and noisy.
# `five` are the first five shapes, on which dirfield's constants were chosen; `twelve` are all.
# Angles in degrees, over all points where the shape has a first principal direction: means over shapes and random seeds
# of the median and of the 95th percentile of the angle to the nearer principal axis (axis_deg) and to the axis of
# larger absolute curvature (deg).
# Singularities: means over shapes and seeds of the number that hatchstat counts on the mesh; then those of the torus (0
# is right) and of the ellipsoid (4).
# Seconds: median, minimum and maximum over shapes and seeds, one thread, without reading, repairing and writing.
# Peers (programs/peers.c): the quadric over some rings; its tensor smoothed to second order; the smoothest field of Knöppel et
# al. Their constants are the same for all meshes, or ("told") chosen by hand for the number of faces and the noise.
# SIZES: numbers of faces. SEEDS: random seeds of the meshes. SEEDS_LARGE: those of meshes of more than 10,000 faces
# (default: the first of SEEDS). Further options of dirfield are measured at 10,000 faces, with the first seed.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
shapes='torus ellipsoid cylinder saddle wave frustum monge eggbox superquadric bump helicoid catenoid'
seeds=${SEEDS:-7 8 9}
printf 'method\tshapes\tseeds\tfaces\tnoise\tseconds\tseconds_min\tseconds_max\tpeak_kib\taxis_deg_p50\taxis_deg_p95\t'
printf 'deg_p50\tdeg_p95\tsingularities\ttorus\tellipsoid\n'

# columns FILE NAME ...: the values of columns in the first row, with spaces between them
columns() {
    file=$1
    shift
    awk -F'\t' -v names="$*" '
        NR == 1 {for (i = 1; i <= NF; i++) at[$i] = i}
        NR == 2 {
            n = split(names, name, " ")
            for (i = 1; i <= n; i++) {
                if (!(name[i] in at)) {print "no column " name[i] >"/dev/stderr"; exit 1}
                printf "%s%s", $at[name[i]], i < n ? " " : "\n"
            }
        }' "$file"
}

# once MESH COMMAND ...: seconds, peak and figures of one run
once() {
    mesh=$1
    shift
    rm -f "$work/field.glb"
    if [ "$1" = dirfield ]; then
        "$MEASURE" 1 "$@" --quiet --threads 1 "$mesh" --report "$work/report" -o "$work/field.glb" |
            cut -f 5 >"$work/peak"
        columns "$work/report" frames_ms curvature_ms field_ms | awk '{print ($1 + $2 + $3) / 1000}' >"$work/seconds"
    else
        "$MEASURE" 1 sh -c 'out=$1; shift; exec "$@" >"$out"' sh "$work/seconds" "$@" "$mesh" "$work/field.glb" |
            cut -f 5 >"$work/peak"
    fi
    hatchstat field "$work/field.glb" --reference "$mesh" >"$work/figures"
    cat "$work/seconds" "$work/peak" | tr '\n' ' '
    columns "$work/figures" axis_deg_p50 axis_deg_p95 deg_p50 deg_p95 singularities
}

# rows METHOD SEEDS COMMAND ...: two rows, of five shapes and of twelve
rows() {
    method=$1 used=$2
    shift 2
    for shape in $shapes; do
        for seed in $used; do
            printf '%s ' $shape
            once "$work/$shape.$seed.glb" "$@"
        done
    done >"$work/runs"
    for set in five twelve; do
        awk -v method="$method" -v set=$set -v seeds="$(echo "$used" | wc -w)" -v faces="$faces" -v noise="$noise" '
            !($1 in seen) {seen[$1] = ++kinds}
            set == "five" && kinds > 5 {exit}
            {
                s[++n] = $2
                peak = $3 > peak ? $3 : peak
                for (i = 4; i <= 8; i++) sum[i] += $i
                alone[kinds] += $8
                each[kinds]++
            }
            END {
                for (i = 1; i <= n; i++)
                    for (k = i; k > 1 && s[k] < s[k - 1]; k--) {t = s[k]; s[k] = s[k - 1]; s[k - 1] = t}
                printf "%s\t%s\t%d\t%s\t%s\t%.4f\t%.4f\t%.4f\t%d", method, set, seeds, faces, noise,
                    s[int((n + 1) / 2)], s[1], s[n], peak
                for (i = 4; i <= 7; i++) printf "\t%.4f", sum[i] / n
                printf "\t%.1f\t%.1f\t%.1f\n", sum[8] / n, alone[1] / each[1], alone[2] / each[2]
            }' "$work/runs"
    done
}

# told: constants of peers chosen by hand for $faces and $noise: rings and mu of tensor, strength of smoothest
told() {
    size=$((faces > 30000 ? 3 : faces > 5000 ? 2 : 1))
    case $size:$noise in
    1:0) echo 2 30 300 ;;
    1:0.05) echo 5 300 30 ;;
    1:*) echo 5 300 30 ;;
    2:0) echo 2 100 1000 ;;
    2:0.05) echo 5 1000 100 ;;
    2:*) echo 5 3000 30 ;;
    3:0) echo 3 1000 1000 ;;
    3:0.05) echo 5 30000 300 ;;
    *) echo 5 30000 30 ;;
    esac
}

for faces in ${SIZES:-2000 10000 100000}; do
    here=$seeds
    [ "$faces" -le 10000 ] || here=${SEEDS_LARGE:-${seeds%% *}}
    for noise in 0 0.05 0.2; do
        for shape in $shapes; do
            for seed in $here; do
                meshgen $shape --faces "$faces" --jitter 1 --noise $noise --seed "$seed" --field \
                    -o "$work/$shape.$seed.glb"
            done
        done
        rows dirfield "$here" dirfield
        rows "dirfield, smooth 0.3" "$here" dirfield --smooth 0.3
        rows "dirfield, smooth 0" "$here" dirfield --smooth 0
        set -- $(told)
        rows "quadric, 2 rings" "$here" peers quadric 2
        rows "quadric, 5 rings" "$here" peers quadric 5
        rows "tensor, 5 rings, mu 1000" "$here" peers tensor 5 1000
        rows "tensor, told" "$here" peers tensor "$1" "$2"
        rows "smoothest, 100" "$here" peers smoothest 100
        rows "smoothest, told" "$here" peers smoothest "$3"
        if [ "$faces" = 10000 ]; then
            first=${seeds%% *}
            for support in '2.6 4' '4 2' '6 3' '10 3'; do
                rows "radius ${support% *}, degree ${support#* }" "$first" \
                    dirfield --smooth 0 --radius "${support% *}" --degree "${support#* }"
            done
            rows "hz" "$first" dirfield --method hz
            rows "simplified" "$first" dirfield --coarse $((faces / 8))
        fi
        rm "$work"/*.*.glb
    done
done
