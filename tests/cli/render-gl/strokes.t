# --technique strokes: strokes that are found in the picture and drawn anew.
. "${TOP:-.}/tests/tap.sh"

meshgen plane --faces 200 -o plane.glb
meshgen torus -o torus.glb

# draw FILE OPTION ...: draws without feature lines into $file
file=picture.exr
draw() {
    render-gl -q -t strokes --lines none -o $file "$@"
}

# The texture's own strokes cover the same pixels.
draw plane.glb --size 320x240 --tone-range .3:.3 --overdraw 0
render-gl -q plane.glb -t rptam --lines none --size 320x240 --tone-range .3:.3 -o texture.exr
rms=$(hatchstat diff texture.exr picture.exr | awk 'NR == 2 {print $4}')
ok "fitted strokes lie where the texture's strokes do: $rms" awk -v rms="$rms" 'BEGIN {exit !(rms != "" && rms < .12)}'

# What is random about a stroke follows from its number, not from the order of threads.
draw torus.glb --size 320x240
for n in 1 2; do
    LP_NUM_THREADS=$n render-gl -q -t strokes --lines none -o again$n.exr torus.glb --size 320x240
done
ok "the same bytes again" cmp picture.exr again1.exr
ok "the same bytes with another number of threads" cmp again1.exr again2.exr

file=none.exr
draw torus.glb --size 320x240 --tone-range 0:0
is "no ink, no strokes" "$(hatchstat frames none.exr none.exr | awk 'NR == 2 {print 1 - $2}')" 0

# Strokes run over outlines by --overdraw, and by no more.
beyond() {
    file=over.exr
    draw torus.glb --size 320x240 --samples 1 --overdraw "$1"
    hatchstat frames over.exr over.exr | awk 'NR == 2 {print 1 - $2}'
}
none=$(beyond 0) some=$(beyond 12)
ok "overdraw adds ink: $none, $some" awk -v a="$none" -v b="$some" 'BEGIN {exit !(a > 0 && b > 1.005 * a && b < 1.3 * a)}'

# Options of rptam belong to this technique, too, and --animate moves them.
file=films%d.exr
draw plane.glb --size 64x64 --frames 2 --animate stroke=20x1..40x2
ok "its options may change" test -s films0.exr -a -s films1.exr
finish
