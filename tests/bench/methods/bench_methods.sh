#!/bin/sh
# Measures every technique on five scenes at equal tones, 0 to 0.65, with strokes 2 pixels wide, in 960x720 pixels
# without lines: a torus, the teapot and a superquadric, whose texture coordinates are those of the shapes or, for the
# superquadric, those of patches; and the Stanford bunny and a rocker arm with patches, if ../shared has them.
#   ms, ratio   time of a frame; the same over gouraud's: the shortest in three runs in which all take turns, which other
#               work on the machine changes least
#   bytes       of the files that the technique reads, beyond the bare mesh
#   setup_s     processor time to make these
#   tone_rms, grey_strokes   of `hatchstat ink` against gouraud
#   spread      widest over narrowest mean width of strokes at zooms of 1, 2, 4 and 8, with one tone, 0.3, everywhere
#   flicker     mean difference between frames of a turn by a degree, at the same points of the surface, less gouraud's
#   continuity  of `hatchstat ink --patches` at the borders of patches
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
meshes=$(dirname "$0")/../../../../shared/data/meshes
techniques="gouraud tam-flat tam-face tam-gouraud tam-triple tam tam-threshold volume threshold threshold-soft rptam \
strokes solid traced"
printf 'method\tscene\tms\tratio\tbytes\tsetup_s\ttone_rms\tgrey_strokes\tspread\tflicker\tcontinuity\n'

# made FILE COMMAND: runs a command that makes FILE, and notes the processor time
made() {
    "$MEASURE" 1 sh -c "cd '$work' && $2" | cut -f 4 >"$work/$1.seconds"
}
made map.exr "tamgen -q --size 512 --set 'width 2' -o map.exr"
made volume.ktx2 "tamgen -q --size 512 --set 'width 2' --tones 64 | tamvol -q -o volume.ktx2"
made threshold.ktx2 "tamgen -q --size 512 --set 'width 2' --tones 64 | tamthresh -q -o threshold.ktx2"
made solid.ktx2 "solidgen -q --style strokes --size 64 -o solid.ktx2"
meshgen torus --faces 20000 -o "$work/torus.glb"
meshgen teapot --faces 20000 -o "$work/teapot.glb"
meshgen superquadric --faces 20000 -o "$work/superquadric.glb"
scenes="torus teapot superquadric"
for name in stanford-bunny.ply rocker-arm.obj; do
    [ -e "$meshes/$name" ] || continue
    cp "$meshes/$name" "$work"
    scenes="$scenes ${name%.*}"
done

# bare SCENE: its file without patches
bare() {
    case $1 in
    stanford-bunny) echo stanford-bunny.ply ;;
    rocker-arm) echo rocker-arm.obj ;;
    *) echo "$1.glb" ;;
    esac
}
for scene in $scenes; do
    case $scene in
    torus | teapot) ;;
    *) made "$scene.lapped.glb" "dirfield -q $(bare "$scene") | lapped-param -q -o $scene.lapped.glb" ;;
    esac
    made "$scene.strokes.glb" "dirfield -q $(bare "$scene") | strokegen -q --levels 7 -o $scene.strokes.glb"
done

# choose TECHNIQUE SCENE: sets `file`, the scene's; `asset`, what the technique reads, or nothing; and `options`
choose() {
    file=$(bare "$2") asset='' options=''
    case $1 in
    traced) file=$2.strokes.glb options='--stroke-width 2' ;;
    solid) asset=solid.ktx2 options="--solid $work/solid.ktx2 --look binary --solid-size 77" ;;
    gouraud) ;;
    *) [ ! -e "$work/$2.lapped.glb" ] || file=$2.lapped.glb ;;
    esac
    case $1 in
    tam*) asset=map.exr ;;
    volume) asset=volume.ktx2 ;;
    threshold*) asset=threshold.ktx2 ;;
    rptam | strokes) options='--stroke 40x2' ;;
    esac
    case $asset in
    '' | solid*) ;;
    *) options="$options --tam $work/$asset" ;;
    esac
}

# draw TECHNIQUE SCENE OPTION ...
draw() {
    choose "$1" "$2"
    technique=$1
    shift 2
    render-gl -q "$work/$file" -t "$technique" $options --lines none --size 960x720 "$@"
}

# figure NAME: prints a column of the report of hatchstat on standard input
figure() {
    awk -F'\t' -v name="$1" 'NR == 1 {for (i = 1; i <= NF; i++) at[$i] = i} NR == 2 {print $at[name]}'
}

# bytes_of and seconds_of: of all files that a technique reads for a scene, less the bare mesh
bytes_of() {
    choose "$1" "$2"
    total=0
    [ -z "$asset" ] || total=$(wc -c <"$work/$asset")
    [ "$file" = "$(bare "$2")" ] || total=$((total + $(wc -c <"$work/$file") - $(wc -c <"$work/$(bare "$2")")))
    echo $((total > 0 ? total : 0))
}
seconds_of() {
    choose "$1" "$2"
    cat "$work/$asset.seconds" "$work/$file.seconds" 2>/dev/null | awk '{sum += $1} END {printf "%.2f", sum}'
}

# spread_of TECHNIQUE SCENE
spread_of() {
    draw "$1" "$2" --tone-range 0.3:0.3 -n 4 --animate zoom=1..8 -o "$work/zoom%d.exr"
    for at in 0 1 2 3; do
        hatchstat ink "$work/zoom$at.exr" | figure width
    done | sort -g | awk '{at[NR] = $1} END {printf "%.3f", at[NR] / at[1]}'
}

# flicker_of TECHNIQUE SCENE: over three steps; the light turns with the scene
flicker_of() {
    draw "$1" "$2" --tone-range 0:0.65 -n 4 --animate from=30:10..33:10 --animate light=-40:40..-43:40 \
        -o "$work/turn%d.exr"
    flicker -q "$work/$(bare "$2")" 30 1 10 "$work"/turn[0-3].exr | cut -f 1
}

# continuity_of SCENE: of strokes.exr
continuity_of() {
    if [ -e "$work/$1.lapped.glb" ] && [ "$file" = "$1.lapped.glb" ]; then
        render-gl -q "$work/$file" --show patches --light 180:0 --lines none --samples 1 --size 960x720 \
            -o "$work/patches.png"
        hatchstat ink --patches "$work/patches.png" "$work/strokes.exr" | figure continuity
    else
        echo nan
    fi
}

# row TECHNIQUE SCENE
row() {
    draw "$1" "$2" --tone-range 0:0.65 -o "$work/strokes.exr"
    hatchstat ink --reference "$work/$2.tone.exr" "$work/strokes.exr" >"$work/ink"
    ms=$(cut -f 1 "$work/$2.$1.times" | sort -g | head -n 1)
    ratio=$(cat "$work/$2".*.times | awk -F'\t' -v ms="$ms" '!base || $2 < base {base = $2} END {print ms / base}')
    if [ "$1" = gouraud ]; then
        tail='0 nan nan 0'
    else
        moved=$(flicker_of "$1" "$2")
        tail="$(figure tone_rms <"$work/ink") $(figure grey_strokes <"$work/ink") $(spread_of "$1" "$2") \
$(awk -v a="$moved" -v b="$(cat "$work/$2.still")" 'BEGIN {printf "%.4f", a - b}')"
    fi
    choose "$1" "$2"
    printf '%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\n' "$1" "$2" "$ms" "$ratio" "$(bytes_of "$1" "$2")" \
        "$(seconds_of "$1" "$2")" $tail "$(continuity_of "$2")"
}
for scene in $scenes; do
    for turn in 1 2 3; do
        for technique in $techniques; do
            draw $technique "$scene" --tone-range 0:0.65 --time 5 -o "$work/times.tsv"
            awk -F'\t' -v technique=$technique '$2 != "frame" {next}
                $1 == technique {ms = $5} $1 == "gouraud" {base = $5} END {print ms "\t" base}' \
                "$work/times.tsv" >>"$work/$scene.$technique.times"
        done
    done
    draw gouraud "$scene" --tone-range 0:0.65 -o "$work/$scene.tone.exr"
    flicker_of gouraud "$scene" >"$work/$scene.still"
    for technique in $techniques; do
        row $technique "$scene"
    done
done
