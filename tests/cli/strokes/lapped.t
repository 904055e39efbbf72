# --technique strokes on lapped patches: each stroke belongs to the patch that lies on top at its middle.
. "${TOP:-.}/tests/tap.sh"

tamgen -q --ids -o ids.exr
meshgen torus --faces 4000 | dirfield -q | lapped-param -q -o lapped.glb
draw="render-gl -q --lines none --size 480x360 lapped.glb"

mean() {
    hatchstat frames "$1" "$1" | awk 'NR == 2 {print 1 - $2}'
}

# Strokes reach beyond their patches, over others. With those of the patches below, tone .4 would become .47.
$draw -t gouraud --tone-range 1:1 -o whole.exr
whole=$(mean whole.exr)
check_tone() {
    name=$1 of=$2 tone=$3
    shift 3
    $draw -t $of "$@" --tone-range $tone:$tone -o texture.exr
    $draw -t strokes "$@" --tone-range $tone:$tone --overdraw 0 -o strokes.exr
    want=$(mean texture.exr) got=$(mean strokes.exr)
    ok "$name: tone $tone is about that of $of: $got, $want, of $whole" awk -v want="$want" -v got="$got" \
        -v whole="$whole" 'BEGIN {d = (got - want) / whole; exit !(want > 0 && d > -.045 && d < .02)}'
}
check_tone "seed points" rptam .2
check_tone "seed points" rptam .5
check_tone "a map" tam .2 --tam ids.exr
check_tone "a map" tam .5 --tam ids.exr

$draw -t strokes -o all.exr
for n in 1 2; do
    LP_NUM_THREADS=$n $draw -t strokes -o again$n.exr
done
ok "the same bytes again" cmp all.exr again1.exr
ok "the same bytes with another number of threads" cmp again1.exr again2.exr

render-gl -q -t strokes --tam ids.exr --lines none --size 320x240 lapped.glb lapped.glb -o row.exr
meshgen torus -o torus.glb
render-gl -q -t strokes --tam ids.exr --lines none --size 320x240 lapped.glb torus.glb -o mixed.exr
ok "patches beside a surface without them" awk -v a="$(mean row.exr)" -v b="$(mean mixed.exr)" \
    'BEGIN {exit !(a > .02 && b > .7 * a && b < 1.4 * a)}'
finish
