# --technique strokes with --tam: the strokes of a tonal art map, found in the picture and drawn anew.
. "${TOP:-.}/tests/tap.sh"

tamgen -q --ids -o ids.exr
tamgen -q -o plain.exr
meshgen plane --faces 200 -o plane.glb
meshgen torus -o torus.glb
draw="render-gl -q --lines none --size 320x240"

mean() {
    hatchstat frames "$1" "$1" | awk 'NR == 2 {print 1 - $2}'
}

# Widths follow from the map, so that the tone stays, whatever share of the picture the plane covers.
$draw plane.glb -t gouraud --tone-range 1:1 -o whole.exr
whole=$(mean whole.exr)
for tone in .1 .3 .5 .7; do
    $draw plane.glb -t tam --tam ids.exr --tone-range $tone:$tone -o tam.exr
    $draw plane.glb -t strokes --tam ids.exr --tone-range $tone:$tone --overdraw 0 -o strokes.exr
    want=$(mean tam.exr) got=$(mean strokes.exr)
    ok "tone $tone is that of tam: $got, $want, of $whole" awk -v want="$want" -v got="$got" -v whole="$whole" \
        'BEGIN {d = (got - want) / whole; exit !(want > 0 && d > -.02 && d < .02)}'
done

# Strokes grow with the texels of a map that is magnified.
for zoom in 16 32; do
    near="--uv-scale 4 --zoom $zoom --tone-range .3:.3"
    # shellcheck disable=SC2086 # options
    $draw plane.glb -t tam --tam ids.exr $near -o tam.exr
    for how in sort blend; do
        # shellcheck disable=SC2086
        $draw plane.glb -t strokes --aggregate $how --tam ids.exr $near -o strokes.exr
        want=$(mean tam.exr) got=$(mean strokes.exr)
        ok "near strokes by $how have the tone of tam, zoom $zoom: $got, $want" awk -v want="$want" -v got="$got" \
            'BEGIN {d = got - want; exit !(want > 0 && d > -.03 && d < .03)}'
    done
done

# Strokes that lie wholly over others, of which soft dark styles have many, are known from the list in the map. A map
# without it is read, too.
tamgen -q --ids --style pencil -o pencil.exr
sed 's/hatch:strokes/hatch:strokez/' pencil.exr >unlisted.exr
for tone in .5 .8; do
    for map in pencil unlisted; do
        $draw plane.glb -t strokes --tam $map.exr --tone-range $tone:$tone --overdraw 0 -o $map$tone.exr
    done
done
$draw plane.glb -t tam --tam pencil.exr --tone-range .8:.8 -o tam.exr
want=$(mean tam.exr) got=$(mean pencil.8.exr) less=$(mean unlisted.8.exr)
ok "pencil strokes get as dark as their map: $got, $want" awk -v want="$want" -v got="$got" -v whole="$whole" \
    'BEGIN {d = (got - want) / whole; exit !(want > 0 && d > -.04 && d < .04)}'
ok "without the list they do not: $less" awk -v less="$less" -v got="$got" 'BEGIN {exit !(less > 0 && less < .85 * got)}'

# Strokes of maps whose strokes do not darken each other where they cross.
for style in marker charcoal; do
    tamgen -q --ids --style $style --set 'overlap flat' -o $style.exr
    for tone in $([ $style = charcoal ] && echo .5 || echo .3 .5 .8); do
        $draw plane.glb -t tam --tam $style.exr --tone-range $tone:$tone -o tam.exr
        $draw plane.glb -t strokes --tam $style.exr --style $style --tone-range $tone:$tone --overdraw 0 -o strokes.exr
        want=$(mean tam.exr) got=$(mean strokes.exr)
        ok "flat strokes of $style are no darker than their map, $tone: $got, $want" \
            awk -v want="$want" -v got="$got" -v whole="$whole" \
            'BEGIN {d = (got - want) / whole; exit !(want > 0 && d > -.03 && d < .03)}'
    done
done
sed 's/x\ty\tlength\tangle/x\tz\tlength\tangle/' pencil.exr >bad.exr
try $draw plane.glb -t strokes --tam bad.exr -o none.exr
refused "a damaged list" 3 1
is "says where it is" "$(cat .err)" "render-gl: bad.exr: hatch:strokes: header: no column 'y'"

# So many small strokes that the first table of strokes does not hold them, each hardly a pixel long, are grey together.
$draw plane.glb -t tam --tam ids.exr --uv-scale 60 --tone-range .3:.3 -o tam.exr
$draw plane.glb -t strokes --tam ids.exr --uv-scale 60 --most-strokes 300000 --tone-range .3:.3 -o strokes.exr
want=$(mean tam.exr) got=$(mean strokes.exr)
ok "small strokes have their tone: $got, $want" awk -v want="$want" -v got="$got" \
    'BEGIN {exit !(want > 0 && got > .9 * want && got < 1.1 * want)}'

# The strokes are those of the map, at their places.
$draw plane.glb -t tam --tam ids.exr --tone-range .3:.3 -o tam.exr
$draw plane.glb -t strokes --tam ids.exr --tone-range .3:.3 -o strokes.exr
$draw plane.glb -t strokes --tone-range .3:.3 -o seeds.exr
apart() {
    hatchstat diff tam.exr "$1" | awk 'NR == 2 {print $4}'
}
near=$(apart strokes.exr) far=$(apart seeds.exr)
ok "fitted strokes lie where the map's strokes do: $near, others $far" awk -v near="$near" -v far="$far" \
    'BEGIN {exit !(near > 0 && near < .6 * far)}'

# A stroke across the border of the tile is one stroke. In two parts it would taper at the border, as strokes do where
# they are cut off, and lose ink with this pen.
printf 'x\ty\tlength\tangle\twidth\ttone\tr\tg\tb\tid\tcolumn\tlevel\tgrain\n0\t.5\t.5\t0\t.04\t1\t0\t0\t0\t1\t0\t0\t1\n' >one.tsv
tamgen -q --replay one.tsv --tones 1 --levels 1 --ids --set 'brush round; darkest .02' -o one.exr
printf 'brush round\ntaper 1000\nvary 0\nwobble 0\npressure 0\n' >taper.style
$draw plane.glb -t strokes --tam one.exr --style ./taper.style --uv-scale 2 --tone-range 1:1 --overdraw 0 -o one-strokes.exr
$draw plane.glb -t tam --tam one.exr --uv-scale 2 --tone-range 1:1 -o one-tam.exr
want=$(mean one-tam.exr) got=$(mean one-strokes.exr)
ok "a stroke across the tile's border is whole: $got, $want" awk -v want="$want" -v got="$got" \
    'BEGIN {exit !(want > .001 && got > .9 * want && got < 1.1 * want)}'

$draw torus.glb -t strokes --tam ids.exr -o all.exr
for n in 1 2; do
    LP_NUM_THREADS=$n $draw torus.glb -t strokes --tam ids.exr -o again$n.exr
done
ok "the same bytes again" cmp all.exr again1.exr
ok "the same bytes with another number of threads" cmp again1.exr again2.exr

# says NAME STATUS LINES TEXT OPTION ...
says() {
    name=$1 want=$2 lines=$3 text=$4
    shift 4
    try $draw plane.glb -t strokes "$@" -o none.exr
    refused "$name" "$want" "$lines"
    grep -qF -e "$text" .err
    is "$name: the message contains '$text'" $? 0
}
says "a map without ids" 3 1 "plain.exr: technique strokes needs a tonal art map with ids (tamgen --ids makes one)" \
    --tam plain.exr
says "seed points beside a map" 2 2 "--seed-tile cannot be combined with --tam" --tam ids.exr --seed-tile 64
says "repeats of no map" 2 2 "--uv-scale needs --tam" --uv-scale 2
says "a filter of integers" 2 2 "--anisotropy needs --technique tam" --tam ids.exr --anisotropy 2
finish
