# Meshes of formats that do not define which axis points up: --up, and the warning for those that seem to stand along z.
. "${TOP:-.}/tests/tap.sh"

# cone NAME ORDER: writes an OBJ of a cone with a base, the coordinates in that order, with a mark on one side; the order
# keeps the orientation
cone() {
    awk -v order="$2" 'function put(x, y, z) {
            if (order == "xyz") print "v", x, y, z; else if (order == "z up") print "v", x, -z, y; else print "v", y, -x, z }
        BEGIN {
            n = 48; put(0, 2, 0); put(0, 0, 0); put(1.5, 0.5, 0)
            for (i = 0; i < n; i++) put(cos(i * 6.283185307179586 / n), 0, sin(i * 6.283185307179586 / n))
            for (i = 0; i < n; i++) { a = i + 4; b = (i + 1) % n + 4; print "f", 1, b, a; print "f", 2, a, b }
            print "f", 1, 4, 3; print "f", 3, 4, 1
        }' >"$1"
}
cone y.obj xyz
cone z.obj "z up"
cone x.obj "x up"
# drawn PICTURE ARGUMENTS: draws without strokes; messages in .err
drawn() {
    picture=$1
    shift
    try render-gl "$@" --technique gouraud --lines none --size 160x120 -o "$picture"
}
hint='render-gl: z.obj: warning: the mesh seems to stand along z, but y points up: to turn it, draw it with render-gl --up z'
drawn y.png y.obj
is "a mesh that stands along y is drawn without a hint" "$status $(grep -c 'stand along' .err)" "0 0"
drawn lying.png z.obj
is "a mesh that stands along z is drawn with a hint" "$status $(grep 'stand along' .err)" "0 $hint"
try hatchstat diff --max-difference 0.01 y.png lying.png
is "without --up it lies" $status 1
for axis in x y z; do
    drawn $axis.up.png $axis.obj --up $axis
    is "--up $axis needs no hint" "$status $(grep -c 'stand along' .err)" "0 0"
    ok "--up $axis draws the mesh upright" hatchstat diff --max-difference 0.004 y.png $axis.up.png
done
drawn two.png z.obj z.obj --ground 2
is "each of several meshes has its hint" "$(grep -c 'stand along' .err)" 2
drawn quiet.png -q z.obj
is "--quiet leaves the hint out" "$(cat .err)" ""
try sh -c 'dirfield z.obj -o z.glb'
is "dirfield gives the hint, since a GLB has y up" "$status $(grep -c 'stand along.*render-gl --up z$' .err)" "0 1"
try lapped-param --size 0.5 z.obj -o patches.glb
is "lapped-param gives it, too" "$status $(grep -c 'stand along.*render-gl --up z$' .err)" "0 1"
drawn glb.png z.glb
is "a GLB gets none" "$status $(grep -c 'stand along' .err)" "0 0"
drawn glb.up.png z.glb --up z
ok "--up z turns a GLB, too" hatchstat diff --max-difference 0.004 y.png glb.up.png
try render-gl z.obj --technique gouraud --up w -o w.png
refused "--up w" 2 2
finish
