#!/bin/sh
# Measures the time per frame of render-gl's technique strokes, with both values of --aggregate, as Table 1 of Szécsi et
# al., "Tonal Art Maps with Image Space Strokes": scenes of 27,000 to 193,000 triangles with about 1,000 to 16,000
# strokes, 1920x1200, four samples. rptam and both kinds of strokes are timed in turn, three times; each run also times
# gouraud. Then, for the growth of cost, one scene in three sizes, each with 1,000, 4,000 and 16,000 strokes, in turn,
# three times. Milliseconds are measured by the driver; of the three turns the fastest counts, because other work on the
# machine only adds. aggregate_ms is finding and collecting fragments, draw_ms drawing ribbons, rest_ms clearing the
# canvas, its paper and the mean of the samples: passes of frames whose passes are timed one by one. ms is a whole frame,
# low_ms and high_ms its quartiles; over_rptam is its ratio to ms of rptam, nan where that is not timed.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
printf 'method\ttriangles\tsize\tmegapixels\tstrokes\tfragments\taggregate_ms\tfit_ms\textrude_ms\tdraw_ms\trest_ms\t'
printf 'ms\tlow_ms\thigh_ms\tgouraud_ms\tover_rptam\tfit_share\tpeak_kib\n'
meshgen teapot --faces 27000 -o "$work/27000.glb"
meshgen torus --faces 90000 -o "$work/90000.glb"
meshgen teapot --faces 193000 -o "$work/193000.glb"

# run METHOD TURN: times $triangles.glb with strokes of $stroke; a file per method, size, stroke and turn
run() {
    case $1 in
    rptam) technique=rptam ;;
    *) technique="strokes --aggregate $1" ;;
    esac
    file=$work/$1.$size.$stroke.$2
    # shellcheck disable=SC2086 # the technique and its option are words
    "$MEASURE" 1 render-gl "$work/$triangles.glb" -t $technique --stroke "$stroke" --size "$size" --lines none \
        --time 3 -o "$work/times.tsv" | awk 'NR == 1 {print "peak\t\t\t" $5}' >"$file"
    cat "$work/times.tsv" >>"$file"
}

# row METHOD: prints what the turns have measured
row() {
    technique=strokes
    [ "$1" != rptam ] || technique=rptam
    method=$1
    counts=$(render-gl -v "$work/$triangles.glb" -t $technique --stroke "$stroke" --size "$size" --lines none \
        -o "$work/picture.png" 2>&1 | sed -n 's/.*: \([0-9]*\) strokes, \([0-9]*\) fragments.*/\1 \2/p')
    set -- "$work/$method.$size.$stroke".*
    [ "$method" = rptam ] || [ ! -e "$work/rptam.$size.$stroke.1" ] || set -- "$work/rptam.$size.$stroke".* "$@"
    awk -F'\t' -v method="$method" -v triangles="$triangles" -v size="$size" -v counts="$counts" '
        function part(name) {
            if (name == "paper" && !papers++ || name ~ /^(gather|route|sort|blend)$/) return "aggregate"
            return name ~ /^(fit|extrude)$/ ? name : name == "strokes" ? "draw" : "rest"
        }
        FNR == 1 {
            whose = FILENAME ~ /\/rptam[^\/]*$/ ? "rptam" : method
            papers = passes["aggregate"] = passes["fit"] = passes["extrude"] = passes["draw"] = passes["rest"] = 0
        }
        $1 == "peak" && whose == method && $4 > peak {peak = $4}
        $2 == "frame" && $1 != "gouraud" {ms = $4; low = $5; high = $6}
        $4 + 0 == 0 || $1 == "peak" || $2 == "frame" && $1 != "gouraud" {next}
        $1 != "gouraud" {
            passes[part($2)] += $4
            next
        }
        !(whose in best) || ms < best[whose] { # gouraud is the last row
            best[whose] = ms
            if (whose == method) {
                times = sum = ""
                split("aggregate fit extrude draw rest", names, " ")
                for (i = 1; i in names; i++) {
                    times = times sprintf("%.1f\t", passes[names[i]])
                    sum += passes[names[i]]
                }
                times = times sprintf("%.1f\t%.1f\t%.1f\t%.1f", ms, low, high, $4)
                share = passes["fit"] / sum
            }
        }
        END {
            split(size, side, "x")
            split(counts, count, " ")
            over = "rptam" in best ? sprintf("%.3f", best[method] / best["rptam"]) : "nan"
            printf "%s\t%d\t%s\t%.4g\t%d\t%d\t%s\t%s\t%.4f\t%s\n", method, triangles, size, side[1] * side[2] / 1e6,
                count[1], count[2], times, over, share, peak
        }' "$@"
}

# scene TRIANGLES STROKE: a row per method
scene() {
    triangles=$1 size=1920x1200 stroke=$2
    for turn in 1 2 3; do
        for method in rptam sort blend; do
            run $method $turn
        done
    done
    for method in rptam sort blend; do
        row $method
    done
    rm "$work"/*.[123]
}
scene 27000 220x8
scene 27000 96x3.5
scene 90000 96x3.5
scene 193000 96x3.5
scene 193000 40x1.5

# each COMMAND ...: runs it for every size and stroke of the second part
each() {
    triangles=27000
    while read -r size stroke; do
        "$@" </dev/null
    done <<'END'
1920x1200 220x8
1920x1200 96x3.5
1920x1200 40x1.5
1360x850 156x5.7
1360x850 68x2.5
1360x850 28x1.06
960x600 110x4
960x600 48x1.75
960x600 20x0.75
END
}
for turn in 1 2 3; do
    each run sort $turn
done
each row sort
