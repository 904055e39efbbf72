# --animate: each frame equals the picture drawn with its values.
. "${TOP:-.}/tests/tap.sh"

tamgen --size 64 --levels 2 -o map.exr
meshgen teapot --faces 1000 -o teapot.glb

# same_as_still NAME OPTION A B C ARGUMENT ...: checks three frames from A to C, with B half-way
same_as_still() {
    name=$1 option=$2 first=$3 middle=$4 last=$5
    shift 5
    case "$*" in
    *rptam* | *gouraud* | *solid*) map= ;;
    *) map="--tam map.exr" ;;
    esac
    draw="render-gl teapot.glb --size 64x48 --samples 1 $map $*"
    $draw --frames 3 --animate "$option=$first..$last" -o way%d.png || fail "$name" "$option"
    for frame in 0 1 2; do
        eval "value=\$$(echo first middle last | cut -d ' ' -f $((frame + 1)))"
        $draw "--$option=$value" -o still$frame.png
        cmp -s way$frame.png still$frame.png || echo "frame $frame"
    done >differing
    is "$name: frames equal the pictures of their values" "$(cat differing)" ""
    is "$name: the frames differ" "$(cat still?.png | cksum)" \
        "$(cmp -s still0.png still1.png || cmp -s still1.png still2.png || cat still?.png | cksum)"
}
same_as_still stroke stroke 10x1 20x2 40x4 -t rptam
same_as_still stroke-ink stroke-ink 1 0.75 0.5 -t rptam
same_as_still stroke-turn stroke-turn 0 20 40 -t rptam
same_as_still seed-tile seed-tile 64 128 256 -t rptam
same_as_still seed-layers seed-layers 1 2 3 -t rptam --tone-range 0:1
same_as_still overlap overlap 0 0.25 0.5 -t rptam
same_as_still hatch-turn hatch-turn -30 0 30 -t tam
same_as_still hatch-scale hatch-scale 0.8 1.2 1.8 -t rptam
same_as_still tone-range tone-range 0:0.2 0.1:0.3 0.2:0.4 -t rptam
same_as_still tone-gamma tone-gamma 0.5 1 2 -t tam
same_as_still light light -80:0 0:20 80:40 -t gouraud
same_as_still line-width line-width 1 2 4 -t tam
same_as_still from from -20:0 10:20 40:40 -t tam --uv-scale 8
same_as_still fov fov 10 30 50 -t tam --uv-scale 8 --camera 1,2,6:0,0,0
same_as_still zoom zoom 0.5 1 2 -t rptam
perl "$TOP/tests/support/solid/make.pl" 16 waves:4 >waves.ktx2
for look in plain binary watercolor collage; do
    same_as_still "solid-size, $look" solid-size 16 128 1024 -t solid --solid waves.ktx2 --look $look
done
same_as_still border border 6 3 0 -t solid --solid waves.ktx2 --look collage
same_as_still "deep zoom" zoom 1 256 65536 -t rptam

# All frames have the repeats of the map that the first view asks for; that of the last asks for larger tiles.
near="render-gl teapot.glb --size 64x48 --samples 1 -t tam --tam map.exr --camera 1,2,6:0,0,0"
$near --frames 2 --animate fov=20..60 -o map%d.png
$near --fov 20 -o first.png
$near --fov 60 -o last.png
ok "the map repeats over the first frame as over its picture" cmp map0.png first.png
ok "and over the last one more often" sh -c '! cmp -s map1.png last.png'

# Two options at once, on a turntable.
render-gl teapot.glb -t rptam --size 64x48 --frames 2 --turntable --animate zoom=1..4 --animate overlap=0..1 -o both%d.png
render-gl teapot.glb -t rptam --size 64x48 --frames 2 --turntable --zoom 4 --overlap 1 -o turn%d.png
ok "several --animate work together and with --turntable" cmp both1.png turn1.png

is "parameters are applied once per frame" "$(render-gl -v teapot.glb -t rptam --size 32x24 --frames 5 \
    --animate overlap=0..1 -o five%d.png 2>&1 | grep -o 'applied [0-9]* times')" "applied 4 times"
try render-gl -v teapot.glb -t rptam --size 32x24 --frames 5 --animate zoom=1..9 -o five%d.png
is "a zoom does not apply parameters again" "$status $(grep -c 'times' .err)" "0 0"

# A scene's camera gives way to --from and --fov, moved or not.
perl -MJSON::PP -0777 -ne '
    my $json = substr $_, 20, unpack "x12V", $_;
    my $scene = decode_json($json);
    $scene->{cameras} = [{type => "perspective", perspective => {yfov => .5, znear => .1}}];
    push @{$scene->{nodes}}, {camera => 0, translation => [0, 0, 9]};
    push @{$scene->{scenes}[0]{nodes}}, $#{$scene->{nodes}};
    $json = encode_json($scene);
    $json .= " " x (-length($json) % 4);
    my $rest = substr $_, 20 + unpack "x12V", $_;
    print "glTF", pack("V4", 2, 20 + length($json) + length($rest), length $json, 0x4e4f534a), $json, $rest;
' teapot.glb >camera.glb
for option in from=0:20..80:20 fov=20..50; do
    name=${option%%=*} last=${option##*.}
    render-gl -q camera.glb -t gouraud --size 32x24 --frames 2 --animate $option -o moved%d.png
    render-gl -q camera.glb -t gouraud --size 32x24 --$name "$last" -o still.png
    ok "--animate $name of a scene with a camera" cmp moved1.png still.png
done
try render-gl camera.glb -t gouraud --size 32x24 --frames 2 --camera 0 --animate fov=20..50 -o moved%d.png
refused "--animate fov with the scene's camera" 2 2

# A square without normals that a target tilts by 60 degrees is lit as one that is tilted at rest.
# square TILTED_AT_REST: prints it
square() {
    perl -MMIME::Base64 -e '
        my @flat = (0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0);
        my @up = map { $_ % 3 == 1 ? $flat[$_] * -0.5 : $_ % 3 == 2 ? $flat[$_ - 1] * -0.75 ** 0.5 : 0 } 0 .. 17;
        my @rest = map { $flat[$_] + $ARGV[0] * $up[$_] } 0 .. 17;
        my $data = encode_base64(pack("f<*", @rest, @up, 0, 1, 0, 1 - $ARGV[0]), "");
        my $n = 0;
        my $views = join ",", map { my $at = $n; $n += $_; "{\"buffer\":0,\"byteOffset\":$at,\"byteLength\":$_}" } 72, 72, 8, 8;
        my $places = "\"componentType\":5126,\"count\":6,\"type\":\"VEC3\"";
        my $numbers = "\"componentType\":5126,\"count\":2,\"type\":\"SCALAR\"";
        print "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],",
            "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"targets\":[{\"POSITION\":1}]}]}],",
            "\"accessors\":[{\"bufferView\":0,$places},{\"bufferView\":1,$places},{\"bufferView\":2,$numbers},",
            "{\"bufferView\":3,$numbers}],\"bufferViews\":[$views],\"buffers\":[{\"byteLength\":$n,",
            "\"uri\":\"data:application/octet-stream;base64,$data\"}],\"animations\":[{\"channels\":[{\"sampler\":0,",
            "\"target\":{\"node\":0,\"path\":\"weights\"}}],\"samplers\":[{\"input\":2,\"output\":3}]}]}"
    ' "$1"
}
square 0 >tilts.gltf
square 1 >tilted.gltf
for scene in tilts tilted; do
    render-gl -q $scene.gltf -t gouraud --lines none --light 0:60 --camera 0.5,0.2,3:0.5,0.2,0 --size 48x48 --frames 2 \
        --rate 1 -o $scene%d.png
done
differ() { hatchstat diff "$1" "$2" | awk 'NR == 2 {print ($2 > 0.004)}'; }
is "flat faces turn as a target moves them" "$(differ tilts1.png tilted1.png) $(differ tilts0.png tilted0.png)" "0 1"
finish
