# strokegen: what it reads, keeps and replaces, and the strokes that it writes.
. "${TOP:-.}/tests/tap.sh"

coarse="--gap 0.15 --levels 2"
# sets FILE.glb: prints the sets of strokes, a line each: family, level, angle and gap
sets() {
    tail -c +21 "$1" | head -c "$(od -An -tu4 -j12 -N4 "$1" | tr -d ' ')" | grep -o '"mode":1,"extras":{"hatch":{[^}]*}' |
        sed 's/.*{//; s/}.*//; s/"[a-z]*"://g; s/,/ /g'
}

meshgen torus --faces 800 -o torus.glb
ok "a mesh without a field" strokegen $coarse torus.glb -o alone.glb
dirfield torus.glb | strokegen $coarse -o piped.glb
ok "a mesh without a field gets the field of dirfield" cmp piped.glb alone.glb
dirfield --direction min torus.glb | strokegen $coarse -o across.glb
numbers alone.glb >a
numbers across.glb >b
ok "a field in the file is followed" test "$(cksum <a)" != "$(cksum <b)"
strokegen $coarse <torus.glb >filter.glb
ok "from a pipe to a pipe" cmp filter.glb alone.glb
ok "a mesh with strokes" strokegen $coarse alone.glb -o again.glb
ok "strokes are replaced" cmp again.glb alone.glb
strokegen $coarse --seed 2 torus.glb -o other.glb
numbers other.glb >b
ok "another random seed gives other strokes" test "$(cksum <a)" != "$(cksum <b)"
cp torus.glb "two words.glb"
strokegen $coarse "two words.glb" -o "the result.glb"
ok "file names may have spaces" cmp "the result.glb" alone.glb
is "the options are in the file" "$(grep -ac '"strokegen --gap 0.15 --levels 2 --angles 0,60 --length 40 --hard 40 --seed 1"' \
    alone.glb)" 1

try strokegen -v $coarse torus.glb -o /dev/null
is "-v counts strokes and points" "$(grep -cE '^strokegen: [1-9][0-9]* strokes, [1-9][0-9]* points$' .err)" 1
try strokegen $coarse torus.glb -o /dev/null
is "without it, nothing is said" "$(cat .err)" ""

# The diagonal of the torus is 4.03321.
is "each family has a set for each level, with half the gap" "$(sets alone.glb)" "0 0 0 0.604981601 40 0.69813168
0 1 0 0.302490801 40 0.69813168
1 0 1.04719758 0.604981601 40 0.69813168
1 1 1.04719758 0.302490801 40 0.69813168"
strokegen --gap 0.3 --levels 3 --angles=-45,0.5,360 torus.glb -o three.glb
is "as many families as angles" "$(sets three.glb | cut -d' ' -f1,3 | uniq -c | xargs)" \
    "3 0 -0.785398185 3 1 0.00872664619 3 2 6.28318548"
strokegen --gap 0.3 --levels 1 --angles 1,2,3,4,5,6,7,8 torus.glb -o eight.glb
is "eight families" "$(sets eight.glb | wc -l)" 8

for angles in '' x 1,,2 ,1 1, '1, 2' 0x10 nan inf 360.5 -361 1e999; do
    try strokegen "--angles=$angles" torus.glb
    refused "--angles '$angles'" 2 2
done
try strokegen --angles 1,2,3,4,5,6,7,8,9 torus.glb
refused "nine angles" 2 2

# Strokes on one line meet on a plane.
meshgen plane --faces 2 | strokegen --gap 0.09 --levels 4 --angles 30 -o plane.glb
ok "strokes on a plane can be read again" strokegen $coarse plane.glb -o /dev/null

# Faces that are replaced lose their strokes; all else is as without them.
strokegen $coarse torus.glb | dirfield -o strokes.field.glb
dirfield torus.glb -o field.glb
ok "dirfield leaves strokes out" cmp strokes.field.glb field.glb
strokegen $coarse torus.glb | lapped-param -o strokes.lapped.glb
lapped-param field.glb -o lapped.glb
ok "lapped-param leaves strokes out" cmp strokes.lapped.glb lapped.glb
try strokegen $coarse lapped.glb
refused "patches, which overlap, get no strokes" 3 1
is "the message tells the remedy" "$(cat .err)" \
    "strokegen: lapped.glb: is lapped already: use the file that it was made from"
try hatchstat mesh alone.glb
is "other readers do not mind strokes" "$status $(cat .err)" "0 "
hatchstat mesh torus.glb >figures
ok "the surface is the same" cmp figures .out

# Gaps are shares of the scene's diagonal, whatever places the meshes in it.
unpack torus.glb large
sed 's/"nodes":\[{/&"scale":[2,2,2],/' large.gltf >t.gltf && mv t.gltf large.gltf
strokegen $coarse large.gltf -o large.glb
numbers large.glb >b
ok "strokes do not depend on the size of the model" cmp a b
sed 's/"scenes":\[{"nodes":\[0\]}\],"nodes":\[{/"scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":1},{/
    s/"meshes":\[\({.*}\]}\),*\],"accessors"/"meshes":[\1,\1],"accessors"/' large.gltf >pair.gltf
strokegen --gap 0.1 --levels 1 --angles 0 pair.gltf -o pair.glb
is "two nodes, of which one is twice as large" "$(sets pair.glb | cut -d' ' -f4 | sort -n | awk '
    {gap[NR] = $1} END {print NR, gap[2] / gap[1], (gap[2] > 0.8 && gap[2] < 0.81)}')" "2 2 1"

sed 's/\[2,2,2\]/[0,0,0]/' large.gltf >flat.gltf
try strokegen flat.gltf
refused "a scene without size" 3 1
# A scale of 0 is not one of 1, with which a mesh in small units would take hours.
sed 's/\[2,2,2\]/[0,0,0]/; s/\[{"mesh":1}/[{"mesh":1,"scale":[0.5,0.5,0.5]}/' pair.gltf >hidden.gltf
strokegen --gap 0.1 --levels 1 --angles 0 hidden.gltf -o hidden.glb 2>.err
is "a node of scale 0: its mesh is as large as the scene" "$(sets hidden.glb | cut -d' ' -f4 | uniq -c | xargs)" \
    "2 0.403321087"
# A mesh that is much smaller than the gaps has one level, so that near views can add finer ones, of every family.
sed 's/\[{"mesh":1}/[{"mesh":1,"scale":[0.001,0.001,0.001]}/' pair.gltf >small.gltf
try strokegen $coarse small.gltf -o small.glb
is "a small mesh: sets that have strokes" "$(sets small.glb | cut -d' ' -f1,2 | xargs)" "0 0 0 1 1 0 1 1 0 0 1 0"
is "nothing is said of it" "$(cat .err)" ""
try strokegen --gap 1 --levels 1 torus.glb -o wide.glb
is "gaps that are too wide for the scene" "$status $(sets wide.glb | cut -d' ' -f1,2 | xargs)" "0 0 0 1 0"
echo '{"asset":{"version":"2.0"}}' >empty.gltf
try strokegen empty.gltf
refused "a scene without faces" 3 1
ok "a scene without faces: the message" grep -q 'empty.gltf: no face has an area' .err

# Damaged strokes are refused by every reader.
unpack alone.glb damaged
sed 's/"family":1,"level":1/"family":9,"level":1/' damaged.gltf >t.gltf && mv t.gltf damaged.gltf
for command in "strokegen" "dirfield" "hatchstat mesh"; do
    try $command damaged.gltf
    refused "$command refuses damaged strokes" 3 1
    ok "$command: the message names the place" grep -q 'damaged.gltf: mesh 0, primitive 4: strokes: family' .err
done
# A strip a million times as long as wide has few strokes, or none, but is done soon.
printf 'v 0 0 0\nv 1 0 0\nv 1 1e-6 0\nv 0 1e-6 0\nf 1 2 3\nf 1 3 4\n' >narrow.obj
ok "a strip that is narrower than any gap" timeout 20 strokegen -q narrow.obj -o narrow.glb
ok "has a small file" test "$(wc -c <narrow.glb)" -lt 100000
# Facets of zeros, which scanners write for missing ones, have no place.
{
    echo solid body
    awk 'function facet(a, b, c) {print "facet normal 0 0 0 outer loop vertex " a " vertex " b " vertex " c " endloop endfacet"}
        function at(i, j) {return 100 + i / 10 " " 100 + j / 10 " " 100 + sin(i / 3) / 4}
        BEGIN {for (i = 0; i < 10; i++) for (j = 0; j < 10; j++) {
            facet(at(i, j), at(i + 1, j), at(i + 1, j + 1)); facet(at(i, j), at(i + 1, j + 1), at(i, j + 1))}}'
} >body.stl
{
    cat body.stl
    echo facet normal 0 0 0 outer loop vertex 0 0 0 vertex 0 0 0 vertex 0 0 0 endloop endfacet endsolid
} >padded.stl
echo endsolid >>body.stl
strokegen -q body.stl -o body.glb
strokegen -q padded.stl -o padded.glb
ok "strokes of a scan with facets of zeros" cmp body.glb padded.glb
# The mesh that is written is the repaired one, with a direction field, too.
meshgen torus --faces 400 | dirfield -q -o field.glb
unpack field.glb field
perl -MJSON::PP -0777 -e '
    my $scene = decode_json(<>);
    my $view = $scene->{bufferViews}[$scene->{accessors}[$scene->{meshes}[0]{primitives}[0]{indices}]{bufferView}];
    open my $file, "+<:raw", "field.bin" or die;
    seek $file, $view->{byteOffset}, 0;
    read $file, my $face, 6;
    seek $file, $view->{byteOffset} + 6, 0;
    print $file $face;' field.gltf
strokegen field.gltf -o mended.glb 2>said
is "a face that is given twice" "$(grep -c '1 face given twice left out' said) $(hatchstat mesh mended.glb |
    awk -F'\t' 'NR == 1 {for (i = 1; i <= NF; i++) c[$i] = i} NR == 2 {print $c["duplicates"]}')" "1 0"
finish
