# Extreme scenes, cameras, lights and sizes: each gives a plausible picture.
. "${TOP:-.}/tests/tap.sh"

tamgen --size 64 --levels 2 -o map.exr
meshgen teapot --faces 3000 -o teapot.glb

# draws NAME ARGUMENT ...: checks that a picture is drawn without messages, other than those that match $expected
expected=
draws() {
    name=$1
    shift
    case " $* " in
    *" gouraud "*) try render-gl "$@" -o picture.png ;;
    *) try render-gl "$@" --tam map.exr -o picture.png ;;
    esac
    is "$name" "$status $(grep -v "${expected:-^$}" .err)" "0 "
}

# tone [FILE]: the mean of a picture, linear
tone() {
    hatchstat frames "${1:-picture.png}" "${1:-picture.png}" | awk 'NR == 2 {print $2}'
}

# between LOW HIGH: whether the mean of the picture is in this range
between() {
    tone | awk -v low="$1" -v high="$2" '{exit !($1 > low && $1 < high)}'
}

# size FILE: width and height of a PNG
size() {
    perl -e 'open my $f, "<:raw", shift; read $f, my $b, 24; print join "x", unpack("x16NN", $b)' "$1"
}

# scene LIGHT NODE [POSITIONS [TEXCOORDS]]: prints a glTF scene of a square from -1 to 1, a light and its node
scene() {
    perl -e '
        use MIME::Base64;
        my ($lights, $nodes, $positions, $texcoords) = @ARGV;
        my @positions = split " ", $positions || "-1 -1 0 1 -1 0 1 1 0 -1 1 0";
        my @texcoords = split " ", $texcoords || "0 1 1 1 1 0 0 0";
        my $data = encode_base64(pack("f<12f<8S<6", @positions, @texcoords, 0,1,2, 0,2,3), "");
        my $extent = sub { my $k = shift; my @all = sort { $a <=> $b } @positions[map { 3 * $_ + $k } 0..3];
            ($all[0], $all[3]) };
        my @box = map { [$extent->($_)] } 0..2;
        my $list = sub { my $end = shift; join ",", map { unpack("f", pack("f", $_->[$end])) } @box };
        print qq({"asset":{"version":"2.0"},"scene":0,
            "extensionsUsed":["KHR_lights_punctual"],
            "extensions":{"KHR_lights_punctual":{"lights":[$lights]}},
            "scenes":[{"nodes":[0), $nodes ? ",1" : "", qq(]}],
            "nodes":[{"mesh":0}), $nodes ? ",$nodes" : "", qq(],
            "meshes":[{"primitives":[{"indices":2,"attributes":{"POSITION":0,"TEXCOORD_0":1}}]}],
            "buffers":[{"byteLength":92,"uri":"data:application/octet-stream;base64,$data"}],
            "bufferViews":[{"buffer":0,"byteLength":92}],
            "accessors":[
                {"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[), $list->(0),
                    q(],"max":[), $list->(1), q(]},
                {"bufferView":0,"byteOffset":48,"componentType":5126,"count":4,"type":"VEC2"},
                {"bufferView":0,"byteOffset":80,"componentType":5123,"count":6,"type":"SCALAR"}]});
    ' "$@"
}
point='{"type":"point","intensity":100}'
at() {
    printf '{"translation":[%s],"extensions":{"KHR_lights_punctual":{"light":0}}}' "$1"
}

draws "a picture of one pixel" teapot.glb --size 1x1
is "the picture of one pixel has one pixel" "$(size picture.png)" 1x1
draws "a column of pixels" teapot.glb --size 1x500
draws "a picture 16384 pixels wide" teapot.glb --size 16384x32 --samples 1
is "the picture has the given size" "$(size picture.png)" 16384x32
ok "the wide picture shows the teapot" between 0.5 0.9999
draws "a picture wider than the driver's limit" teapot.glb --size 20000x16 --samples 1
is "the picture has the given size" "$(size picture.png)" 20000x16

# With normals smoothed over its edges a box would be shaded like a sphere.
awk 'BEGIN {
    for (i = 0; i < 8; i++) print "v", i % 2, int(i / 2) % 2, int(i / 4)
    n = split("1 3 4 2 5 6 8 7 1 2 6 5 3 7 8 4 1 5 7 3 2 4 8 6", v)
    for (i = 1; i <= n; i += 4) print "f", v[i], v[i + 1], v[i + 2], v[i + 3] }' >box.obj
awk '/^v/ {print} /^f/ {n++; print "vn", (n == 6) - (n == 5), (n == 4) - (n == 3), (n == 2) - (n == 1)
    printf "f"; for (i = 2; i <= 5; i++) printf " %d//%d", $i, n; print ""}' box.obj >flat.obj
render-gl box.obj --technique gouraud --size 160x120 -o box.exr
render-gl flat.obj --technique gouraud --size 160x120 -o flat.exr
ok "a box without normals has flat sides" hatchstat diff box.exr flat.exr --max-difference 1e-3

draws "a camera inside" teapot.glb --camera 0,0.4,0:1,0.4,0.2 --size 160x120
ok "a camera inside sees the inner wall with strokes" between 0.05 0.98
draws "a camera straight above" teapot.glb --camera 0,5,0 --size 160x120
scene "$point" "$(at 0,0,2)" >square.gltf
expected='the picture is blank'
draws "a camera very far away" teapot.glb --camera 1e30,0,0 --size 160x120
draws "a camera on a vertex" square.gltf --camera 1,1,0:0,0,-1 --size 160x120
expected=
draws "a camera in the plane of a face" square.gltf --camera 3,0,0:0,0,0 --size 160x120

meshgen teapot --faces 500000 -o large.glb
draws "500,000 triangles" large.glb --size 320x240 --lines none
ok "500,000 triangles show the teapot" between 0.5 0.99

# With automatic exposure near lamps light the square like distant ones. The square covers 0.879 of the picture; lit,
# its tone is 0.25 and the mean 0.783, unlit 0.96 and 0.154.
square="--technique gouraud --camera 0,0,4 --size 64x64 --tone-range .25:1"
lit="0.77 0.79"
unlit="0.14 0.16"
for place in 1,1,0 0,0,0; do
    scene "$point" "$(at $place)" >light.gltf
    draws "a lamp at $place, in the plane of the square" light.gltf $square
    ok "a lamp in the plane does not light the square" between $unlit
done
for place in 0,0,1e-20 0,0,1 0,0,1e30; do
    scene "$point" "$(at $place)" >light.gltf
    draws "a lamp at $place" light.gltf $square
    ok "the lamp lights the square" between $lit
done
scene "$point" "$(at 0,0,1e30)" >far.gltf
render-gl far.gltf $square -o far.png
scene '{"type":"directional","intensity":1e30}' '{"extensions":{"KHR_lights_punctual":{"light":0}}}' \
    >sun.gltf
draws "a sun of 1e30 lux" sun.gltf $square
is "a lamp infinitely far away is a sun" "$(tone far.png)" "$(tone picture.png)"
ok "a distant lamp lights the square" between $lit
scene '{"type":"spot","intensity":9,"spot":{"innerConeAngle":0,"outerConeAngle":0.0001}}' "$(at 0,0,2)" \
    >spot.gltf
draws "a spot of no width" spot.gltf $square
ok "a spot of no width lights nothing" between $unlit
scene '{"type":"point","intensity":0}' "$(at 0,0,2)" >dark.gltf
draws "a lamp that is off" dark.gltf $square
ok "a lamp that is off lights nothing" between $unlit

# Texture coordinates that coincide, where all pixels read one texel; and collinear, huge and tiny ones, which lose the
# strokes but keep their tone, 0.5 on 0.879 of the picture.
corners="-1 -1 0 1 -1 0 1 1 0 -1 1 0"
expected='the same texture coordinates everywhere\|the picture is blank'
for uv in "0 0 0 0 0 0 0 0" "0 0 1 1 2 2 3 3" "0 1e30 1e30 1e30 1e30 0 0 0" "0 1e-30 1e-30 1e-30 1e-30 0 0 0"; do
    scene "$point" "$(at 0,0,2)" "$corners" "$uv" >uv.gltf
    draws "texture coordinates $uv" uv.gltf --camera 0,0,4 --size 64x64 --lines none --tone-range .5:.5
    [ "$uv" = "0 0 0 0 0 0 0 0" ] || ok "degenerate texture coordinates keep the tone" between 0.53 0.59
done
expected=

# Tiny, huge and distant positions: the picture is that of the plain square.
scene "$point" "" >plain.gltf
draws "a square" plain.gltf --size 64x64 --technique gouraud
plain=$(tone)
for scale in 1e-15 1e15; do
    scene "$point" "" "$(echo "$corners" | sed "s/1/$scale/g")" >scaled.gltf
    draws "a square of $scale" scaled.gltf --size 64x64 --technique gouraud
    is "the square looks like the plain one" "$(tone)" "$plain"
done
moved=$(echo "$corners" | awk '{for (i = 1; i <= NF; i++) printf "%d ", $i + 1000000}')
scene "$point" "" "$moved" >moved.gltf
draws "a square a million units away" moved.gltf --size 64x64 --technique gouraud
is "the square looks like the plain one" "$(tone)" "$plain"

printf '{"asset":{"version":"2.0"}}' >empty.gltf
try render-gl empty.gltf --tam map.exr --size 64x64 -o picture.png
refused "an empty scene" 3 1

lamps=$(for i in $(seq 66); do printf ',%s' "$(at 0,0,3)"; done)
scene "$point" "{\"children\":[$(seq -s, 2 67)]}$lamps" >lamps.gltf
try render-gl lamps.gltf --tam map.exr --size 32x24 -o picture.png
is "lights beyond the sixty-fourth are left out with a warning" "$status $(cat .err)" \
    "0 render-gl: lamps.gltf: warning: 2 lights are left out: at most 64 are used"
# Coordinates of a survey in metres and in millimetres; floats hold the latter to 32 mm.
for far in 0 4000000 4000000000; do
    awk -v far="$far" 'BEGIN {for (i = 0; i <= 24; i++) for (j = 0; j <= 12; j++) {
        a = i * 0.2617993877991494; b = j * 0.5235987755982989; r = 1 + 0.4 * cos(b)
        printf "v %.9f %.9f %.9f\nvt %g %g\n", far + r * cos(a), 0.4 * sin(b), r * sin(a) - far, i / 8, j / 12
        p = (i - 1) * 13 + j;
        if (i && j) printf "f %d/%d %d/%d %d/%d %d/%d\n", p, p, p+1, p+1, p+14, p+14, p+13, p+13}}' \
        >far.obj
    render-gl far.obj --tam map.exr --size 64x48 -o "far-$far.png"
    [ "$far" = 0 ] || ok "a mesh $far units away is drawn like one at the origin" hatchstat diff --max-difference 0.05 far-0.png "far-$far.png"
    hatchstat mesh --quiet far.obj | awk -F'\t' 'NR == 2 {printf "%s %.2f %.3g\n", $3, $14, $15}' >"far-$far.txt"
done
is "hatchstat mesh reports the true position" "$(cat far-4000000000.txt)" "$(awk '{print $1, $2, "4e+09"}' far-0.txt)"
finish
