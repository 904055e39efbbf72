# Every mode of every command on malformed, hostile and unusual inputs: limited processor time and memory for a file under
# 1 MB, and an exit status that the manuals name. The inputs are a few of those that make.pl makes. With LONG=1 they are
# all of them, and those of a folder shared/bad beside the source, and the limit is 2 seconds; without, 4 allow for slower
# processors. The last lines are the most expensive runs.
. "${TOP:-.}/tests/tap.sh"
[ -z "$SANITIZE" ] || { skip "modes" "sanitizers take memory and time of their own"; finish; }
LONG=${LONG:-}
seconds=4
[ -z "$LONG" ] || seconds=2
MEASURE=$PWD/measure
export MEASURE
ok "measure is built" ${CC:-cc} -O2 -std=c11 -D_POSIX_C_SOURCE=200809L -o "$MEASURE" "$TOP/tests/bench/programs/measure.c"
ok "inputs are generated" perl "$TOP/tests/bad/make.pl" own
ok "a map is made" tamgen --size 64 --tones 3 -o map.exr
meshgen plane --faces 2 -o plane.glb
printf 'x\ty\tz\tdx\tdy\tdz\tweight\n0\t0\t0\t1\t.6\t.3\t1\n1\t0\t0\t.2\t1\t.5\t10\n' >directions.tsv

# Inputs of the ordinary suite.
few="shape/comb-20000.ply shape/double-cone-20000.ply shape/moebius.obj shape/needles.obj
    shape/single-triangle.obj exr/pixels-nan.exr png/sound.png odd/nested-100k.json gltf/scale-0.glb"

mesh_modes() {
    for options in "" "--method hz" "--solver cholesky" "--smooth 0" "--direction min" "--coarse 500" "--degree 3" \
        "--constraints $PWD/directions.tsv" "--report OUT.tsv --arrows OUT.ply"; do
        echo "dirfield $options IN -o OUT.glb"
    done
    for options in "" "--atlas" "--size 0.01" "--size 1" "--curved 0" "--stretch 10 --turn 90"; do
        echo "lapped-param $options IN -o OUT.glb"
    done
    echo "strokegen --levels 2 IN -o OUT.glb"
    echo "hatchplan --techniques solid --size 64x48 --budget mb=.1 IN -o OUT.tsv"
    echo "hatchstat mesh IN -o OUT.tsv"
    echo "hatchstat field IN -o OUT.tsv"
    echo "hatchstat lapped IN -o OUT.tsv"
    draw="render-gl IN --size 64x64 -o OUT.png"
    echo "$draw --technique gouraud"
    echo "$draw --technique rptam --haloes 4"
    echo "$draw --technique solid --look watercolor"
    echo "$draw --technique gouraud --shadows .1 --ground 3 --pixel-light"
    echo "$draw --show field"
    echo "$draw --tam $PWD/map.exr"
    [ -n "$LONG" ] || return
    for technique in tam-flat tam-face tam-gouraud tam-triple tam-threshold; do
        echo "$draw --tam $PWD/map.exr --technique $technique"
    done
    for lines in none silhouettes creases boundaries; do
        echo "$draw --technique gouraud --lines $lines"
    done
    echo "strokegen --gap 0.02 --levels 1 --angles 45 IN -o OUT.glb"
    echo "strokegen --gap 1 --hard 180 IN -o OUT.glb"
    echo "$draw --technique gouraud --zoom 65536"
    echo "$draw --show patches"
    echo "render-gl IN --tam $PWD/map.exr --probe --size 64x64 -o OUT.tsv"
}
picture_modes() {
    echo "hatchstat diff IN IN -o OUT.tsv"
    echo "hatchstat frames IN IN -o OUT.tsv"
    echo "hatchstat ink --srgb IN -o OUT.tsv"
    echo "hatchstat tam IN -o OUT.tsv"
    echo "hatchstat tones --reference $PWD/map.exr IN -o OUT.tsv"
    echo "tamgen --size 64 --tones 1 --brush IN -o OUT.exr"
    for layout in rgb array dds png exr; do
        echo "tampack --layout $layout IN -o OUT"
    done
    echo "tamvol IN -o OUT.ktx2"
    echo "tamvol --layout array --compress IN -o OUT.ktx2"
    echo "tamthresh IN -o OUT.ktx2"
    echo "tamthresh --exact IN -o OUT.ktx2"
    echo "tamthresh --modulate IN $PWD/map.exr -o OUT.ktx2"
    echo "tamthresh --mask IN $PWD/map.exr -o OUT.ktx2"
    echo "render-gl $PWD/plane.glb --tam IN --size 64x64 -o OUT.png"
    echo "render-gl $PWD/plane.glb --technique gouraud --modulate IN --size 64x64 -o OUT.png"
    echo "render-gl $PWD/plane.glb --technique solid --solid IN --size 64x64 -o OUT.png"
    echo "solidgen --size 8 --exemplar IN --iterations 1 -o OUT.ktx2"
    echo "solidgen --size 8 --exemplar IN --method pyramid -o OUT.ktx2"
}
text_modes() {
    for option in style palette replay; do
        echo "tamgen --size 64 --tones 1 --$option IN -o OUT.exr"
    done
    echo "solidgen --size 8 --style IN -o OUT.ktx2"
    echo "hatchstat seeds IN -o OUT.tsv"
    echo "hatchstat tam $PWD/map.exr --strokes IN -o OUT.tsv"
    echo "dirfield $PWD/plane.glb --constraints IN -o OUT.glb"
    for option in seeds layers style; do
        echo "render-gl $PWD/plane.glb --technique rptam --$option IN --size 64x64 -o OUT.png"
    done
}
# runs FOLDER FILE ...: a line for each mode, with the arguments of mode.sh
runs() {
    folder=$1
    shift
    for file in "$@"; do
        [ -f "$folder/$file" ] && [ "$(wc -c <"$folder/$file")" -lt 1000000 ] || continue
        case $file in
        *.obj | *.ply | *.off | *.stl | *.glb | *.gltf) mesh_modes ;;
        *.json | *.svg | *.tsv | *.bin) mesh_modes && text_modes ;;
        *) picture_modes ;;
        esac | sed "s|^|$folder $file |"
    done
}
{
    if [ -z "$LONG" ]; then
        runs own $few
    else
        runs own $(tail -n +2 own/MANIFEST.tsv | cut -f 1)
        bad=$TOP/../shared/bad
        [ ! -e "$bad/MANIFEST.tsv" ] || runs "$bad" $(tail -n +2 "$bad/MANIFEST.tsv" | cut -f 1)
    fi
} >runs.list
xargs -P 2 -L 1 sh "$TOP/tests/bad/mode.sh" <runs.list | sort -rn >results
is "each run reported a result" "$(wc -l <results)" "$(wc -l <runs.list)"
awk -F '\t' -v seconds=$seconds '$1 > seconds || $2 > 256 {print $1 " s, " $2 " MiB: " $4 ": " $5}' results >over
is "$seconds seconds and 256 MiB are enough" "$(cat over)" ""
awk -F '\t' '$3 !~ /^[01345]$/ {print "exit " $3 ": " $4 ": " $5 ": " $6}' results >died
is "the exit statuses are those of the manuals" "$(cat died)" ""
awk -F '\t' '{total += $1} END {print "# processor time of all: " total " s"}' results
awk -F '\t' 'NR <= 12 {print "# " $1 " s\t" $2 " MiB\t" $4 "\t" $5}' results
sort -t "$(printf '\t')" -k 2,2rn results | awk -F '\t' 'NR <= 6 {print "# " $1 " s\t" $2 " MiB\t" $4 "\t" $5}'
finish
