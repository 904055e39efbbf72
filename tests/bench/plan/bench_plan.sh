#!/bin/sh
# Measures how good the choice of hatchplan is, and how long it takes: on ten scenes, for three kinds of bounds each, against
# a search of all candidates (hatchplan --exhaustive), in 480x360 pixels or those of $SIZE, and 5 rounds or $ROUNDS. It
# takes an hour. Five scenes
# are of meshgen or of a formula: with and without texture coordinates, several objects on the ground, a film once around,
# and a choice of samples, too; the others are those of ../shared, if it is there. The bounds of a scene follow from the
# table of all its candidates:
#   tolerance   1.5 times the least tone error: the fastest is wanted
#   budget      of the time of a frame, 1.5 times the median of the candidates; of the bytes, half their median; of the
#               set-up time, 3 seconds: the most exact is wanted
#   both        1.5 times the least tone error, and that budget of bytes: the fastest is wanted
# Columns:
#   chosen, best   techniques and parameters
#   objective      ms or tone_rms
#   ratio          of the objective of the choice to that of the best one, both as the exhaustive search has measured them
#   over           the worst figure of the choice over its limit, as the exhaustive search has measured it: 1 is the limit.
#                  Limits of time count in plain frames, of which each run knows the shortest: other work on the machine
#                  makes them longer in a short run than in a long one
#   plan_s, all_s  processor time of the choice, and of the exhaustive search with the files that it makes
#   share          plan_s / all_s
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
shared=$(cd "$(dirname "$0")/../../../.." && pwd)/shared/data
size="--size ${SIZE:-480x360}"
printf 'scene\tbounds\tchosen\tbest\tobjective\tratio\tover\tplan_s\tall_s\tshare\n'

meshgen teapot --faces 20000 -o "$work/teapot.glb"
meshgen torus --faces 5000 -o "$work/torus.glb"
meshgen cone --faces 2000 -o "$work/cone.glb"
# A torus with bumps and without texture coordinates.
awk 'BEGIN {
    m = 160; n = 64; turn = 6.2831853
    print "OFF\n" m * n, 2 * m * n, 0
    for (i = 0; i < m; i++) for (j = 0; j < n; j++) {
        u = turn * i / m; v = turn * j / n; r = 0.4 + 0.05 * sin(7 * u) * cos(5 * v)
        print (1 + r * cos(v)) * cos(u), r * sin(v), (1 + r * cos(v)) * sin(u)
    }
    for (i = 0; i < m; i++) for (j = 0; j < n; j++) {
        a = i * n + j; b = (i + 1) % m * n + j; c = i * n + (j + 1) % n; d = (i + 1) % m * n + (j + 1) % n
        print 3, a, c, b "\n" 3, b, c, d
    }
}' >"$work/bumps.off"
meshgen sphere --faces 3000 -o "$work/sphere.glb"

# options SCENE: the words of hatchplan for it
options() {
    case $1 in
    teapot) echo "$work/teapot.glb" ;;
    row) echo "--ground 3 $work/teapot.glb $work/torus.glb $work/cone.glb" ;;
    bumps) echo "$work/bumps.off" ;;
    turn) echo "--frames 3 --turntable $work/torus.glb" ;;
    samples) echo "--samples 1,4 --techniques tam,solid,rptam,traced $work/sphere.glb" ;;
    bunny) echo "$shared/meshes/stanford-bunny.ply" ;;
    rocker-arm) echo "$shared/meshes/rocker-arm.obj" ;;
    skinned) echo "--frames 3 --rate 2 $shared/gltf/CesiumMan.glb" ;;
    engine) echo "$shared/gltf/2CylinderEngine.glb" ;;
    dragon) echo "$shared/meshes/dragon-res2.ply" ;;
    esac
}

# limits KIND: the options of the bounds, from the table of all candidates
limits() {
    awk -F'\t' -v kind="$1" '
        function median(values, count,   i, j, swap) {
            for (i = 2; i <= count; i++)
                for (j = i; j > 1 && values[j] < values[j - 1]; j--) {
                    swap = values[j]
                    values[j] = values[j - 1]
                    values[j - 1] = swap
                }
            return values[int((count + 1) / 2)]
        }
        NR > 1 {ms[++n] = $3; bytes[n] = $4; error = !error || $6 < error ? $6 : error}
        END {
            mb = sprintf("mb=%.4g", median(bytes, n) / 2e6)
            if (kind == "budget") printf "--budget ms=%.4g,%s,s=3", 1.5 * median(ms, n), mb
            else if (kind == "tolerance") printf "--tolerance %.4g", 1.5 * error
            else printf "--tolerance %.4g --budget %s", 1.5 * error, mb
        }' "$work/all.tsv"
}

# read_words: sets `seconds`, the processor time of a run of hatchplan, and `plain`, the time of a plain frame
read_words() {
    seconds=$(sed -n 's/^hatchplan: \([0-9.]*\) s of processor time$/\1/p' "$work/words")
    plain=$(sed -n 's/^hatchplan: a plain frame takes \([0-9.]*\) ms$/\1/p' "$work/words")
}

# row SCENE KIND: plans, and compares with the table of all candidates
row() {
    bounds=$(limits "$2")
    status=0
    hatchplan -v $size $bounds $(options "$1") >"$work/plan.tsv" 2>"$work/words" || status=$?
    [ "$status" -le 1 ] || exit "$status"
    read_words
    awk -F'\t' -v OFS='\t' -v scene="$1" -v kind="$2" -v bounds="$bounds" -v plan_s="$seconds" -v all_s="$all_s" \
        -v clock="$(awk -v all="$all_plain" -v own="$plain" 'BEGIN {print all / own}')" '
        function limit(name, factor,   word) {
            if (!match(bounds, name "[0-9.e+-]+")) return 0
            word = substr(bounds, RSTART, RLENGTH)
            sub(/.*[= ]/, "", word)
            return factor * word
        }
        function over(row,   worst, i) {
            for (i = 3; i <= 6; i++)
                if (most[i] && figure[row, i] / most[i] > worst) worst = figure[row, i] / most[i]
            return worst + 0
        }
        BEGIN {most[3] = limit("ms=", clock); most[4] = limit("mb=", 1e6); most[5] = limit("[, ]s=", 1)
            most[6] = limit("tolerance ", 1); objective = most[6] ? 3 : 6}
        NR == FNR && FNR > 1 {
            name = $1 " " $2
            for (i = 3; i <= 6; i++) figure[name, i] = $i
            if (over(name) <= 1 && (!best || $objective < figure[best, objective])) best = name
        }
        NR > FNR && $8 == "yes" {chosen = $1 " " $2}
        END {
            ratio = chosen == best ? 1 : "nan"
            if (chosen && best) ratio = figure[chosen, objective] / figure[best, objective]
            print scene, kind, chosen ? chosen : "nothing", best ? best : "nothing", most[6] ? "ms" : "tone_rms",
                ratio, chosen ? over(chosen) : "nan", plan_s, all_s, plan_s / all_s
        }' "$work/all.tsv" "$work/plan.tsv"
}
for scene in ${SCENES:-teapot row bumps turn samples bunny rocker-arm skinned engine dragon}; do
    for file in $(options $scene); do
        case $file in "$shared"*) [ -e "$file" ] || continue 2 ;; esac
    done
    hatchplan -v $size --exhaustive --rounds ${ROUNDS:-5} --all $(options $scene) >"$work/all.tsv" 2>"$work/words"
    read_words
    all_s=$seconds all_plain=$plain
    for kind in tolerance budget both; do
        row $scene $kind
    done
done
