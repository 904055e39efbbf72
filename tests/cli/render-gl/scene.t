# Morph targets and opacity of glTF files are drawn, also after dirfield and lapped-param.
. "${TOP:-.}/tests/tap.sh"

# Positions of a square, its normals, positions with one corner half as high, a morph target that moves that corner
# twice as far, times, weights.
perl -e 'print pack "f<*", 0,0,0, 1,0,0, 0,1,0, 1,1,0,  (0,0,1) x 4,  0,0,0, 1,0,0, 0,1,0, 1,.5,0,  0,0,0, 0,0,0, 0,0,0, 0,-1,0,
    0,1, 0,1;' >square.bin
# square NAME POSITIONS MATERIAL MORE: writes a glTF of the square
square() {
    cat >"$1.gltf" <<END
{"asset":{"version":"2.0"},"buffers":[{"uri":"square.bin","byteLength":208}],"bufferViews":[
{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":48},{"buffer":0,"byteOffset":96,"byteLength":48},
{"buffer":0,"byteOffset":144,"byteLength":48},{"buffer":0,"byteOffset":192,"byteLength":16}],"accessors":[
{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
{"bufferView":1,"componentType":5126,"count":4,"type":"VEC3"},
{"bufferView":2,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
{"bufferView":3,"componentType":5126,"count":4,"type":"VEC3","min":[0,-1,0],"max":[0,0,0]},
{"bufferView":4,"componentType":5126,"count":2,"type":"SCALAR","min":[0],"max":[1]},
{"bufferView":4,"byteOffset":8,"componentType":5126,"count":2,"type":"SCALAR"}],
"materials":[{"doubleSided":true$3}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"mode":5,"attributes":{"POSITION":$2,"NORMAL":1},"material":0$4]}
END
}
# draw SCENE PICTURE [OPTION ...]
draw() {
    scene=$1 picture=$2
    shift 2
    render-gl -q "$scene" -t gouraud --lines all --size 96x72 --camera 0.5,0.5,4 -o "$picture" "$@"
}
# apart A B: prints 1 if the pictures differ, else 0
apart() {
    hatchstat diff "$1" "$2" | awk 'NR == 2 {print ($2 > 0.003)}'
}
square still 0 '' '}]}'
square half 2 '' '}]}'
weights='"animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"weights"}}],"samplers":[{"input":4,"output":5}]}'
square morph 0 '' ',"targets":[{"POSITION":3}]}]}],'"$weights"
for scene in still half; do
    draw $scene.gltf $scene.png
done
draw morph.gltf begin.png --time-s 0
draw morph.gltf middle.png --time-s 0.5
is "morph targets are animated" \
    "$(apart begin.png still.png)$(apart middle.png half.png)$(apart begin.png middle.png)" 001
dirfield -q morph.gltf | lapped-param -q -o lapped.glb
draw lapped.glb lapped.png --time-s 0.5
is "morph targets survive dirfield and lapped-param" "$(apart lapped.png half.png)" 0
draw morph.gltf turn%d.png --frames 3 --rate 2
is "frames follow the animation of morph targets" "$(apart turn0.png still.png)$(apart turn1.png half.png)" 00

# Films whose pictures keep step with the animation: within a second the square goes ten to the right and back.
perl -e 'print pack "f<*", 0,.5,1, 0,0,0, 10,0,0, 0,0,0' >swing.bin
perl -MJSON::PP -0777 -ne '
    my $scene = decode_json($_);
    push @{$scene->{buffers}}, {uri => "swing.bin", byteLength => 48};
    push @{$scene->{bufferViews}}, {buffer => 1, byteLength => 12}, {buffer => 1, byteOffset => 12, byteLength => 36};
    push @{$scene->{accessors}}, {bufferView => 5, componentType => 5126, count => 3, type => "SCALAR", min => [0], max => [1]},
        {bufferView => 6, componentType => 5126, count => 3, type => "VEC3"};
    $scene->{animations} = [{channels => [{sampler => 0, target => {node => 0, path => "translation"}}],
        samplers => [{input => 6, output => 7}]}];
    print encode_json($scene);' still.gltf >swing.gltf
for film in 193 "17 --rate 2"; do
    try render-gl swing.gltf -t gouraud --size 32x24 --samples 1 -o swing%d.png --frames $film
    is "a repeating animation stays in the picture, --frames $film" "$status $(cat .err)" "0 "
done

# The square passes in front of the middle of a wall, whose outline stays where it is in the picture.
perl -MJSON::PP -0777 -ne '
    my $scene = decode_json($_);
    push @{$scene->{nodes}}, {mesh => 0, scale => [20, 20, 1], translation => [-4.5, -9.5, -3]};
    print encode_json($scene);' swing.gltf >wall.gltf
render-gl wall.gltf --size 64x48 --from 0:0 --zoom 0.5 --frames 5 --rate 8 -o wall%d.svg
is "--zoom of a film is steady, whatever passes" \
    "$(cat wall?.svg | grep -o ' d="[^"]*"' | sort | uniq -c | awk '$1 == 5' | wc -l)" 1

# Cameras that see up to 7 or everything, before a square at 6 and one at 26.
perl -MJSON::PP -0777 -ne '
    my $scene = decode_json($_);
    my %lens = (perspective => {yfov => .8, znear => .1}, orthographic => {xmag => 12, ymag => 9, znear => .1, zfar => 99});
    push @{$scene->{nodes}}, {mesh => 0, translation => [3.5, .5, -20], scale => [4, 4, 1]}, {camera => 0, translation => [.5, .5, 6]};
    for my $type (keys %lens) {
        for my $file ("$type.gltf", "$type-near.gltf") {
            $scene->{cameras} = [{type => $type, $type => $lens{$type}}];
            open my $out, ">", $file;
            print $out encode_json($scene);
            $lens{$type}{zfar} = 7;
        }
    }' still.gltf
for type in perspective orthographic; do
    for scene in $type $type-near; do
        render-gl -q $scene.gltf --size 96x72 -o $scene.svg
        render-gl -q $scene.gltf --size 96x72 -t gouraud --lines all --haloes 4 -o $scene.png
        hatchstat ink $scene.png | awk -F'\t' 'NR == 2 {printf "%.4f", $1}' >$scene.ink
        grep -c '<path' $scene.svg >$scene.paths
    done
    is "a $type camera sees up to zfar" "$(cat $type.paths $type-near.paths | tr '\n' ' ')" "2 1 "
    ok "a $type picture ends at zfar" awk "BEGIN {exit !($(cat $type-near.ink) > 0 && $(cat $type.ink) > $(cat $type-near.ink))}"
done

square glass 0 ',"alphaMode":"BLEND","pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.49]}' '}]}'
square solid 0 ',"alphaMode":"BLEND","pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.5]}' '}]}'
draw glass.gltf glass.png
draw solid.gltf solid.png
# inked FILE: prints 1 if anything is drawn, else 0
inked() {
    hatchstat ink "$1" | awk -F'\t' 'NR == 2 {print ($1 > 0)}'
}
is "meshes less than half opaque are not drawn" "$(inked glass.png)$(inked solid.png)" 01
is "meshes at least half opaque are drawn as opaque" "$(apart solid.png still.png)" 0
dirfield -q glass.gltf | lapped-param -q -o glass.glb
dirfield -q solid.gltf | lapped-param -q -o solid.glb
draw glass.glb glass.png
draw solid.glb solid.png
is "opacity survives dirfield and lapped-param" "$(inked glass.png)$(apart solid.png still.png)" 00
try render-gl glass.gltf -t gouraud --size 32x24 -o glass.png
is "transparent meshes that are left out are warned of" "$(grep -c '1 transparent mesh is left out' .err)" 1
try render-gl solid.gltf glass.gltf glass.gltf -t gouraud --size 32x24 -o row.png
is "those of a row, too, whichever its place" "$(grep -c '2 transparent meshes are left out' .err)" 1

# holes NAME INDEX: a square that is all hole behind a smaller one without holes, whose textures are 0 and INDEX
clear=data:image/png\;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAAC0lEQVR42mNgAAIAAAUAAen63NgAAAAASUVORK5CYII=
holes() {
    texture='"pbrMetallicRoughness":{"baseColorTexture":{"index":'
    square "$1" '2,"TEXCOORD_0":6' ",${texture}0}}},{\"doubleSided\":true,\"alphaMode\":\"MASK\",$texture$2}}" \
        '},{"mode":5,"attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":6},"material":1}]}],"textures":[{"source":0},
{"source":1}],"images":[{"uri":"'"$clear"'"},{"uri":"'"$clear"'"}'
    sed 's/"type":"SCALAR"}\],/"type":"SCALAR"},{"bufferView":1,"componentType":5126,"count":4,"type":"VEC2"}],/' \
        "$1.gltf" >with.gltf && mv with.gltf "$1.gltf"
    draw "$1.gltf" "$1.png" --lines none
}
holes same 0
holes other 1
draw half.gltf half.png --lines none
is "a texture has holes in one mesh and none in another" "$(apart same.png other.png)$(apart same.png half.png)" 00

# parts_at X: two spheres that touch, of which one is a child of a node at X
meshgen sphere --faces 200 -o ball.glb
unpack ball.glb ball
parts_at() {
    nodes="{\"children\":[1],\"translation\":[$1.1,0,0]},{\"mesh\":0,\"translation\":[0.07,0,0]}"
    nodes="$nodes,{\"mesh\":0,\"rotation\":[0,0,0.6,0.8],\"translation\":[$1.32,2.01,0]}"
    sed "s/\"nodes\":\[0\]}\],\"nodes\":\[{[^}]*}\]/\"nodes\":[0,2]}],\"nodes\":[$nodes]/" ball.gltf
}
parts_at 0 >near.gltf
parts_at 4500000 >far.gltf
strokegen -q --levels 2 far.gltf -o far.glb
for file in near.gltf far.gltf far.glb; do
    render-gl -q $file -t gouraud --size 96x72 -o $file.png
done
is "nodes far from the origin keep their places" "$(apart near.gltf.png far.gltf.png)$(apart near.gltf.png far.glb.png)" 00
finish
