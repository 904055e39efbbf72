# lapped-param and hatchstat lapped: what they keep, change, refuse and report.
. "${TOP:-.}/tests/tap.sh"

meshgen torus --faces 800 -o torus.glb
dirfield torus.glb | lapped-param -o piped.glb
ok "a mesh without a field" lapped-param torus.glb -o alone.glb
ok "a mesh without a field gets the field of dirfield" cmp piped.glb alone.glb
printf 'OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n4 3 2 1 0\n4 4 5 6 7\n%s' \
    '4 0 1 5 4
4 1 2 6 5
4 2 3 7 6
4 3 0 4 7
' >cube.off
dirfield -q cube.off | lapped-param -q -o piped.cube.glb
lapped-param -q cube.off -o alone.cube.glb
ok "a mesh without normals gets them" cmp piped.cube.glb alone.cube.glb
awk 'NF == 3 && NR > 2 {print 3 * $1, 2 * $2, $3; next} {print}' cube.off >box.off
is "texture coordinates of a box follow the field of each face" "$(dirfield -q box.off |
    lapped-param -q | hatchstat lapped | awk -F'\t' '
        NR == 1 {for (i = 1; i <= NF; i++) at[$i] = i} NR == 2 {print $at["angle_max"] < 0.01}')" 1
cat >placed.gltf <<END
{"asset":{"version":"2.0"},"nodes":[{"mesh":0}],
"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],
"bufferViews":[{"buffer":0,"byteLength":36}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],
"images":[{"uri":"data:image/png;base64,AAAA"}],"textures":[{"source":0}],
"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0,
"extensions":{"KHR_texture_transform":{"scale":[5,5]}}}}}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}]}
END
lapped-param -q placed.gltf -o placed.glb
unpack placed.glb unplaced
is "the outline does not take over a texture's transform" "$(grep -c KHR_texture_transform unplaced.gltf)" 0
sed 's/"materials":\[{/&"name":"Oak","extensions":{"KHR_materials_unlit":{}},"emissiveFactor":[1,1,1],/' placed.gltf >plain.gltf
sed 's/"emissiveFactor"/"emissiveTexture":{"index":0},&/' plain.gltf >shining.gltf
for kind in plain shining; do
    lapped-param $kind.gltf -o lapped.glb 2>"$kind.err"
    unpack lapped.glb $kind.made
done
is "factors of a material are kept with its name, and left out with their textures" \
    "$(grep -c '"name":"Oak".*"emissiveFactor".*"KHR_materials_unlit":{}' plain.made.gltf) $(cat plain.err)
$(grep -c '"name":"Oak".*"KHR_materials_unlit":{}' shining.made.gltf) $(grep -c emissive shining.made.gltf) $(cat shining.err)" \
    "1 lapped-param: plain.gltf: warning: 1 texture left out: their texture coordinates have been replaced
1 0 lapped-param: shining.gltf: warning: 2 textures left out: their texture coordinates have been replaced"
# factors MEMBER METAL: the factors that are kept of a material with a member and one for metal
factors() {
    sed 's/"materials":\[{/&'"$1"'"emissiveFactor":[1,1,1],/
        s/"pbrMetallicRoughness":{/&'"$2"'"metallicFactor":0.25,"roughnessFactor":0.5,/' placed.gltf >factors.gltf
    lapped-param -q factors.gltf -o lapped.glb
    unpack lapped.glb factored
    grep -oE '"(metallic|roughness|emissive)Factor":[^],}]*' factored.gltf | tr '\n' ' '
}
is "factors of metal and light stay with a texture of another kind" "$(factors '"occlusionTexture":{"index":0},' '')" \
    '"metallicFactor":0.25 "roughnessFactor":0.5 "emissiveFactor":[1 '
is "factors of metal go with their texture" "$(factors '' '"metallicRoughnessTexture":{"index":0},')" \
    '"metallicFactor":0 "emissiveFactor":[1 '
is "that of light goes with its texture" "$(factors '"emissiveTexture":{"index":0},' '')" \
    '"metallicFactor":0.25 "roughnessFactor":0.5 '
# A sheet that is too clear to be drawn, before a wall: no view sees it, and it hides nothing from those that needs are of.
meshgen plane --faces 200 -o wall.glb
unpack wall.glb wall
perl -MJSON::PP -0777 -ne 'my $scene = decode_json($_);
    push @{$scene->{meshes}}, {primitives => [{%{$scene->{meshes}[0]{primitives}[0]}, material => 0}]};
    $scene->{materials} = [{alphaMode => "BLEND", pbrMetallicRoughness => {baseColorFactor => [1, 1, 1, .2]}}];
    push @{$scene->{nodes}}, {mesh => 1, translation => [0, 0, .5]};
    push @{$scene->{scenes}[0]{nodes}}, $#{$scene->{nodes}};
    print encode_json($scene)' wall.gltf >behind.gltf
render-gl -q behind.gltf --needs --size 96x72 -o behind.needs
for atlas in "" --atlas; do
    lapped-param -q $atlas --needs behind.needs behind.gltf -o behind.glb
    ok "what is invisible stays so: lapped-param $atlas" render-gl -q behind.glb -t rptam --size 96x72 -o behind.png
done
for command in lapped-param dirfield; do
    strokegen -q --levels 1 torus.glb | $command >without.glb 2>.err
    is "$command tells that strokes are left out" "$(cat .err)" \
        "$command: standard input: warning: its strokes are left out; strokegen traces them anew"
done
cat >coloured.gltf <<'END'
{"asset":{"version":"2.0"},"nodes":[{"mesh":0}],
"buffers":[{"byteLength":48,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA////Tf///03///9N"}],
"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":12}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
{"bufferView":1,"componentType":5121,"normalized":true,"count":3,"type":"VEC4"}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"COLOR_0":1}}]}]}
END
alphas() { # OPTION ...: the number of rows of the result with the alpha of the vertex colours, 77 / 255
    lapped-param -q "$@" coloured.gltf -o coloured.glb
    numbers coloured.glb | od -An -v -tf4 | grep -c '0\.30196'
}
is "vertex colours of patches are opaque, those of an atlas stay" "$(alphas) $(alphas --atlas)" "0 3"
# A tile far larger than the mesh: rounded texture coordinates would turn faces over.
render-gl -q torus.glb --size 96x72 --needs -o torus.needs
lapped-param -q --needs torus.needs --tile 4000 torus.glb -o tiny.glb
is "patches far smaller than a tile are not rounded" "$(hatchstat lapped tiny.glb | awk -F'\t' '
    NR == 1 {for (i = 1; i <= NF; i++) at[$i] = i} NR == 2 {print $at["flipped"], $at["stretch_max"] < 1.51}')" "0 1"
dirfield torus.glb -o field.glb
unpack field.glb field
sed 's/"NORMAL":[0-9]*,//' field.gltf >bare.gltf
is "a field without normals" "$(grep -c NORMAL bare.gltf)" 0
lapped-param bare.gltf -o bare.glb
unpack bare.glb bared
is "a mesh with a field and without normals gets them" "$(grep -c '"NORMAL"' bared.gltf)" 1
lapped-param <torus.glb >filter.glb
ok "from a pipe to a pipe" cmp filter.glb alone.glb
numbers alone.glb >a
lapped-param --seed 2 torus.glb -o other.glb
numbers other.glb >b
ok "another random seed gives other patches" test "$(cksum <a)" != "$(cksum <b)"
cp torus.glb "two words.glb"
lapped-param "two words.glb" -o "the result.glb"
ok "file names may have spaces" cmp "the result.glb" alone.glb

try lapped-param alone.glb
refused "a file that is lapped already" 3 1
ok "the message says that it is lapped already" grep -q 'alone.glb: is lapped already' .err
try lapped-param -v torus.glb -o /dev/null
is "-v counts patches" "$(grep -cE \
    '^lapped-param: [0-9]+ patches, overlap [0-9.]+; [0-9]+ end at face edges instead of at their outline, [0-9]+ enlarged' .err)" 1

unpack torus.glb uneven
is "a node that scales unevenly is named" "$(sed 's/"nodes":\[{/&"scale":[1,3,1],/' uneven.gltf >uneven3.gltf
    lapped-param uneven3.gltf 2>&1 >/dev/null)" "lapped-param: uneven3.gltf: warning: nodes scale a mesh by up to 3 times \
more along one direction than along another, and stretch strokes by as much: apply the scale to the mesh first"
is "an even scale is not" "$(sed 's/"nodes":\[{/&"scale":[3,3,3],/' uneven.gltf >even.gltf
    lapped-param even.gltf 2>&1 >/dev/null)" ""

# A texture whose image is the start of the mesh's buffer: images that are not drawn are not decoded.
unpack torus.glb textured
sed 's/"primitives":\[{/&"material":0,/
    s/,"accessors"/,"materials":[{"pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,1,1],"baseColorTexture":{"index":0}}}],"textures":[{"source":0}],"images":[{"bufferView":0,"mimeType":"image\/png"}]&/' \
    textured.gltf >t.gltf && mv t.gltf textured.gltf
try lapped-param textured.gltf -o textured.glb
is "textures are left out with a warning" "$(cat .err)" \
    "lapped-param: textured.gltf: warning: 1 texture left out: their texture coordinates have been replaced"
is "colours of materials are kept" "$(grep -ac '"baseColorFactor":\[0.5,0.25,1,1\]' textured.glb)" 1
numbers alone.glb >a
numbers textured.glb >b
ok "patches do not depend on textures" cmp a b

# Sizes are those of the scene: under a node that scales by 2 they are half as large in the mesh.
unpack torus.glb large
sed 's/"nodes":\[{/&"scale":[2,2,2],/' large.gltf >t.gltf && mv t.gltf large.gltf
is "the test's scene has a scaled node" "$(grep -c '"nodes":\[{"scale":\[2,2,2\],"name"' large.gltf)" 1
lapped-param large.gltf -o large.glb
numbers large.glb >b
ok "by default patches do not depend on the size of the model" cmp a b
lapped-param --tile 1 --size 0.3 large.gltf -o large.glb
lapped-param --tile 0.5 --size 0.3 torus.glb -o half.glb
numbers large.glb >a
numbers half.glb >b
ok "--tile is in units of the scene, --size a share of it" cmp a b
unpack torus.glb small
sed 's/"nodes":\[{/&"scale":[0.25,0.25,0.25],/' small.gltf >t.gltf && mv t.gltf small.gltf
lapped-param --tile 0.125 --size 0.3 small.gltf -o small.glb
numbers small.glb >b
ok "also under a node that makes it smaller" cmp a b
sed 's/"scale":\[0.25,0.25,0.25\]/"scale":[0,0,0]/' small.gltf >point.gltf
is "the test's scene has a node of no size" "$(grep -c '"scale":\[0,0,0\]' point.gltf)" 1
ok "a scene that a node shrinks to a point" lapped-param -q point.gltf -o point.glb
numbers point.glb >a
numbers alone.glb >b
ok "has the patches of its mesh" cmp a b
numbers small.glb >a
lapped-param --tile 1 --size 0.3 torus.glb -o whole.glb
numbers whole.glb >b
ok "--tile changes the texture coordinates" test "$(cksum <a)" != "$(cksum <b)"

lapped-param --atlas torus.glb -o atlas.glb
mesh_column() {
    hatchstat mesh "$2" | awk -F'\t' -v name="$1" \
        'NR == 1 {for (i = 1; i <= NF; i++) if ($i == name) at = i} NR == 2 {print $at}'
}
is "an atlas has every face, none of them mirrored or degenerate" \
    "$(for name in faces points uv uv_mirrored uv_degenerate; do mesh_column $name atlas.glb; done | xargs)" \
    "$(mesh_column faces torus.glb) $(mesh_column points torus.glb) 1 0 0"
try lapped-param atlas.glb -o /dev/null
is "an atlas can be lapped" $status 0
# atlas_side FILE: the side that -v tells
atlas_side() {
    lapped-param -v --atlas "$1" 2>&1 >/dev/null | sed -n 's/.*the side of its atlas is \(.*\) long in the scene$/\1/p'
}
is "the side of an atlas is that in the scene: twice as long under a node that scales by 2" \
    "$(echo "$(atlas_side large.gltf) $(atlas_side torus.glb)" | awk '{printf "%.4f", $1 / $2}')" 2.0000
# alpha NAME ALPHA MODE TEXTURE: makes NAME.glb, an atlas of a torus with this alpha, alpha mode and texture
alpha() {
    sed 's/"primitives":\[{/&"material":0,/
        s/,"accessors"/,"materials":[{"alphaMode":"'"$3"'","pbrMetallicRoughness":{"baseColorFactor":[1,1,1,'"$2"']'"$4"'}}],"textures":[{"source":0}],"images":[{"bufferView":0,"mimeType":"image\/png"}]&/' \
        torus_unpacked.gltf >$1.gltf
    lapped-param -q --atlas $1.gltf -o $1.glb
    grep -ao '"baseColorFactor":[^]]*]\|"alphaMode":"[A-Z]*"' $1.glb | cut -d: -f2 | sort | xargs
}
unpack torus.glb torus_unpacked
is "with an atlas a transparent material stays transparent" "$(alpha glass 0.25 BLEND '')" "BLEND [1,1,1,0.25]"
is "with an atlas an invisible material stays invisible" "$(alpha hidden 0.25 MASK '')" "MASK [1,1,1,0.25]"
is "a texture that is left out makes nothing visible" \
    "$(alpha covered 0.25 MASK ',"baseColorTexture":{"index":0}')" "MASK [1,1,1,0.25]"
is "the holes of a texture that is left out close" \
    "$(alpha leaf 0.75 MASK ',"baseColorTexture":{"index":0}')" "[1,1,1,0.75]"
try lapped-param --mask-size 63 torus.glb
refused "a mask too small to be 0 around its middle" 2 2
is "the smallest mask has no holes" "$(lapped-param -q --mask-size 64 --feather 0.01 torus.glb | hatchstat lapped |
    awk 'NR == 1 {for (i = 1; i <= NF; i++) column[$i] = i} NR == 2 {print $column["covered"], $column["opacity"]}')" "1 1"
try lapped-param --atlas --mask-size 64 torus.glb
refused "--mask-size with --atlas" 2 2
try lapped-param --atlas --tile 1 torus.glb
refused "--tile with --atlas" 2 2

ok "hatchstat lapped reads standard input" sh -c 'hatchstat lapped <alone.glb >figures.tsv'
column() {
    hatchstat lapped "$2" | awk -F'\t' -v name="$1" \
        'NR == 1 {for (i = 1; i <= NF; i++) if ($i == name) at = i} NR == 2 {print $at}'
}
is "the torus is covered" "$(column covered alone.glb)" 1
is "no face is flipped" "$(column flipped alone.glb)" 0
is "the number of faces is that of the mesh" "$(column faces alone.glb)" "$(hatchstat mesh torus.glb | tail -n 1 | cut -f2)"
unpack alone.glb second
sed 's/"materials":\[/&{"name":"other"},/; s/"material":0/"material":1/g' second.gltf >t.gltf && mv t.gltf second.gltf
is "a material before that of the patches changes no figure" "$(grep -c '"other"' second.gltf) $(hatchstat lapped second.gltf)" \
    "1 $(hatchstat lapped alone.glb)"
try hatchstat lapped torus.glb
refused "a file without patches" 3 1
try hatchstat lapped alone.glb --samples 0
refused "zero samples" 2 2

# One patch covers a plane of two faces and passes all limits; a coarse torus without limits on patches does not.
meshgen plane --faces 2 | lapped-param -o plane.glb
ok "--check passes good patches" hatchstat lapped plane.glb --check -o /dev/null
meshgen torus --faces 60 | lapped-param --turn 90 --stretch 10 -o rough.glb
try hatchstat lapped rough.glb --check -o /dev/null
is "--check fails bad patches" "$status" 1
ok "the message names the limit that was missed" grep -qE 'rough.glb: warning: (angle|stretch|overlap).* want .* at most' .err
finish
