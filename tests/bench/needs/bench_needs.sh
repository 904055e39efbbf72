#!/bin/sh
# Measures what assets by needs save on ten scenes, beside the default ones: bytes and processor seconds (the mean of
# RUNS, 3) of all files of a technique that are made for a scene: the map, volume or thresholds; seeds; the mesh with
# patches where the scene's own texture coordinates are not used; strokes with their mesh.
#   difference  the largest, over 24 views in and between those that the needs were measured of (6 at other tolerances
#               than .01), of the mean tone of the scene's pixels, to the default assets
#   ms          time of a frame: the shortest of RUNS in which both take turns; of two techniques at the tolerance .01
# Rows "needs" have the seconds of --needs, and of drawing the views once with gouraud, as the default ones.
# SCENES: some of them; TOLERANCES.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
here=$(cd "$(dirname "$0")" && pwd)
data=$here/../../../../shared/data
printf 'scene\ttechnique\ttolerance\tbytes\tbytes_default\tseconds\tseconds_default\tdifference\tms\tms_default\n'

# scene NAME: sets `file`, whose texture coordinates are used if `own` is yes; the options `size`, `look` and `view` that
# needs are measured with; and `between`, the options in place of `view` that are compared
scene() {
    own=no look='' view='' between="--animate zoom=1..1.01 --frames $count"
    case $1 in
    scan) file=$data/meshes/stanford-bunny.ply size=960x720 view='--turntable --frames 12' between=turn ;;
    figure)
        file=$data/gltf/CesiumMan.glb own=yes size=480x360 view='--frames 12 --rate 6'
        between="--frames $count --rate $((count / 2))"
        ;;
    engine) file=$data/gltf/2CylinderEngine.glb size=960x720 ;;
    textured) file=$data/gltf/sphere_lights/sphere_lights.gltf own=yes size=640x480 look=--texture-tone ;;
    far) file=$data/gltf/Duck.glb own=yes size=960x720 ;;
    zoom)
        file=teapot.glb own=yes size=640x480 view='--animate zoom=1..3 --frames 6'
        between="--animate zoom=1..3 --frames $count"
        ;;
    rock) file=rock.glb size=960x720 ;;
    crowd) file=crowd.gltf size=640x480 view='--turntable --frames 12' between=turn ;;
    shade) file=torus.glb own=yes size=320x240 look='--light 0:60' view='--turntable --frames 8' between=turn ;;
    icon) file=superquadric.glb size=320x240 view='--turntable --frames 8' between=turn ;;
    esac
    [ "$between" != turn ] || between="--turntable --frames $count"
}

# made FILE COMMAND: runs a command that makes FILE, and notes its mean processor seconds
made() {
    "$MEASURE" "$runs" sh -c "$2" | cut -f 4 >"$1.seconds"
}
sum() {
    for made in "$@"; do cat "$made.seconds"; done | awk '{s += $1} END {printf "%.4f", s}'
}
bytes() {
    cat "$@" | wc -c
}

# assets KIND SCENE NEEDS: makes all assets of a scene, KIND.*; NEEDS: nothing, or --needs and its file
assets() {
    made "$1.map.exr" "tamgen -q $3 -o $1.map.exr"
    made "$1.volume.ktx2" "tamgen -q --tones 128 $3 | tamvol -q $3 -o $1.volume.ktx2"
    made "$1.thresholds.ktx2" "tamgen -q --tones 128 $3 | tamthresh -q $3 -o $1.thresholds.ktx2"
    made "$1.strokes.glb" "strokegen -q $3 $file -o $1.strokes.glb"
    made "$1.seeds" "seedgen -q --layers 4 -o $1.seeds"
    [ $own = yes ] || made "$1.patches.glb" "dirfield -q $3 $file | lapped-param -q $3 -o $1.patches.glb"
}

# files TECHNIQUE KIND: the files that are made for it; sets `drawn`, the options that draw with them
files() {
    mesh=$file made=''
    [ $own = yes ] || mesh=$2.patches.glb made=$2.patches.glb
    case $1 in
    tam) echo "$2.map.exr $made" && drawn="$mesh -t tam-triple -T $2.map.exr" ;;
    volume) echo "$2.volume.ktx2 $made" && drawn="$mesh -t volume -T $2.volume.ktx2" ;;
    threshold) echo "$2.thresholds.ktx2 $made" && drawn="$mesh -t threshold -T $2.thresholds.ktx2" ;;
    rptam) echo "$2.seeds $made" && drawn="$mesh -t rptam --seeds $2.seeds" ;;
    traced) echo "$2.strokes.glb" && drawn="$2.strokes.glb -t traced" ;;
    esac
}

# views: prints how many views are compared
views() {
    [ "$tolerance" = .01 ] && echo 24 || echo 6
}

# light NAME COUNT FILE OPTION ...: draws COUNT views, and writes the mean light of each to NAME.COUNT
light() {
    light=$1 count=$2
    shift 2
    scene "$name"
    # shellcheck disable=SC2086
    render-gl -q "$@" --size $size $look $between --lines none --samples 1 --tone-range 0:.8 \
        -o "frame.%02d.exr"
    hatchstat frames frame.*.exr | awk 'NR > 1 {print $2}' >"$light.$count"
    rm -f frame.*.exr
}

# frame_ms OPTION ...: prints the time of a frame
frame_ms() {
    # shellcheck disable=SC2086
    render-gl -q "$@" --size $size $look --lines none --tone-range 0:.8 --time 4 | awk -F'\t' '$2 == "frame" {print $4; exit}'
}
least() {
    awk 'NR == 1 || $1 < least {least = $1} END {printf "%.3f", least}' "$1"
}

cd "$work"
count=24
meshgen teapot --faces 10000 -o teapot.glb
meshgen torus --faces 10000 -o torus.glb
meshgen superquadric --faces 20000 -o superquadric.glb
meshgen ellipsoid --faces 100000 --noise 0.3 -o rock.glb
meshgen torus --faces 6000 -o ring.glb
perl "$here/crowd.pl" ring.glb >crowd.gltf
runs=${RUNS:-3} tolerances=${TOLERANCES:-.003 .01 .03 .1}
for name in ${SCENES:-scan figure engine textured far zoom rock crowd shade icon}; do
    scene "$name"
    [ -e "$file" ] || continue
    rm -f default.* fit.*
    assets default "$name" ''
    for technique in tam volume threshold traced $([ $own = yes ] || echo rptam); do
        files $technique default >files
        for tolerance in $tolerances; do
            # shellcheck disable=SC2086
            [ -e "default.$technique.$(views)" ] || light "default.$technique" "$(views)" $drawn
        done
    done
    for tolerance in $tolerances; do
        # shellcheck disable=SC2086
        "$MEASURE" "$runs" sh -c "render-gl -q $file --size $size --tone-range 0:.8 $look $view --tolerance $tolerance \
            --needs -o x.needs" | cut -f 4 >needs.seconds
        "$MEASURE" "$runs" sh -c "render-gl -q $file --size $size $look $view --lines none -t gouraud -o '$(
            [ "$view" ] && echo "drawn.%02d.png" || echo drawn.png)'" | cut -f 4 >drawn.seconds
        share=$(awk -F'\t' '$1 == "drawn" {print $3}' x.needs)
        printf '%s\tneeds\t%s\t%d\t0\t%s\t%s\t0\t0\t0\n' "$name" "$tolerance" "$(wc -c <x.needs)" \
            "$(sum needs)" "$(sum drawn)"
        assets fit "$name" '--needs x.needs'
        for technique in tam volume threshold traced $([ $own = yes ] || echo rptam); do
            files $technique fit >files.fit
            # shellcheck disable=SC2086
            light fit "$(views)" $drawn
            off=$(paste "default.$technique.$(views)" "fit.$(views)" | awk -v share="$share" '
                {off = ($1 - $2) / share; off = off < 0 ? -off : off; most = off > most ? off : most}
                END {printf "%.4f", most}')
            rm -f ms.*
            fit=$drawn
            files $technique default >files
            if [ "$tolerance" = .01 ] && { [ $technique = tam ] || [ $technique = traced ]; }; then
                for run in $(seq "$runs"); do
                    # shellcheck disable=SC2086
                    frame_ms $fit >>ms.fit && frame_ms $drawn >>ms.default
                done
            else
                echo 0 | tee ms.fit >ms.default
            fi
            # shellcheck disable=SC2046
            printf '%s\t%s\t%s\t%d\t%d\t%s\t%s\t%s\t%s\t%s\n' "$name" $technique "$tolerance" \
                "$(bytes $(cat files.fit))" "$(bytes $(cat files))" "$(sum $(cat files.fit))" "$(sum $(cat files))" \
                "$off" "$(least ms.fit)" "$(least ms.default)"
        done
    done
done
