# --needs: known scenes have known needs, tamgen and strokegen make no more, and a view that needs more is refused.
. "${TOP:-.}/tests/tap.sh"

meshgen plane --faces 200 --uv whole -o plane.glb
meshgen torus --faces 3000 -o torus.glb
unpack plane.glb plane

# row FILE THING INDEX: prints a value
row() {
    awk -F"\t" -v thing="$2" -v at="$3" '$1 == thing && $2 == at {print $3}' "$1"
}
# near NAME GOT WANT OFF: checks that GOT is within OFF of WANT
near() {
    is "$1: $2 for $3" "$(awk -v got="$2" -v want="$3" -v off="$4" \
        'BEGIN {print (got != "" && got >= want - off && got <= want + off)}')" 1
}
# The square of side 2 fills a square picture from this distance.
front='--camera 0,0,3.7320508:0,0,0 --fov 30'

# shellcheck disable=SC2086 # options are words
render-gl plane.glb $front --size 300x300 --tone-range .5:.5 --needs -o tone.needs
near "a plane of tone .5 needs .5 less half the tolerance" "$(row tone.needs darkest 0)" .495 1e-6
near "its lightest tone is not over the darkest" "$(row tone.needs lightest 0)" .495 1e-6
near "all pixels show it" "$(row tone.needs drawn 0)" 1 0
near "all of one tone" "$(row tone.needs tone 32)" 1 0
near "in which a unit of length has 150 pixels" "$(row tone.needs unit-px 32)" 150 .01
near "and a unit of texture coordinates, 300, over 2^8" "$(row tone.needs texels 8)" 1 0
is "tones that are given are no shares" "$(row tone.needs relative 0)" 0
# shellcheck disable=SC2086
render-gl plane.glb $front --size 300x300 --tone-range .5:.5 --needs --tolerance .1 |
    awk -F'\t' '$1 == "darkest" {print $3}' >darkest
near "with ten times the tolerance" "$(cat darkest)" .45 1e-6
# shellcheck disable=SC2086
render-gl plane.glb $front --size 300x300 --tone-range .25:.25 --ink black,white --paper gray --needs -o two.needs
near "of two inks the first" "$(row two.needs darkest 0)" .245 1e-6
near "and the second" "$(row two.needs darkest 1)" .245 1e-6

# A second plane behind the first, and one that is half out of the picture.
sed 's/"nodes":\[0\]/"nodes":[0,1]/; s/"nodes":\[{/&"mesh":0,"translation":[0,0,-1]},{/' plane.gltf >behind.gltf
# shellcheck disable=SC2086
render-gl behind.gltf $front --size 250x250 --needs -o behind.needs
is "faces of the hidden plane are not seen" "$(row behind.needs faces-seen 0) of $(row behind.needs faces 0)" "0 of 200"
is "faces of the other are" "$(row behind.needs faces-seen 1) of $(row behind.needs faces 1)" "200 of 200"
is "and it has all pixels" "$(row behind.needs item 0) $(row behind.needs item 1)" "0 1"
render-gl plane.glb --camera 1,0,3.7320508:1,0,0 --fov 30 --size 250x250 --needs -o half.needs
is "half of the faces are in the picture" "$(row half.needs faces-seen 0)" 100
near "which has the plane on one half" "$(row half.needs drawn 0)" .5 .005
# shellcheck disable=SC2086
render-gl plane.glb $front --size 300x300 --tone-range .5:.5 --frames 2 --animate zoom=1..2 --needs -o zoom.needs
is "both views count" "$(row zoom.needs views 0)" 2
near "the nearer one needs twice the pixels" "$(row zoom.needs unit-px 32)" 300 .05

# The plane grows from nothing to twice its size in a second, and in half of one is as large as above. Lengths are those
# at rest, or where they are 0 there, those of the largest scale that is set.
for scale in 0 0.5 2; do
    perl -MJSON::PP -MMIME::Base64 -0e '
        my ($rest, $scene) = (shift, decode_json <>);
        my $data = encode_base64(pack("f<8", 0, 1, 0, 0, 0, 2, 2, 2), "");
        my ($buffer, $view, $at) = map { scalar @{$scene->{$_}} } qw(buffers bufferViews accessors);
        push @{$scene->{buffers}}, {byteLength => 32, uri => "data:application/octet-stream;base64,$data"};
        push @{$scene->{bufferViews}}, {buffer => $buffer, byteLength => 32};
        push @{$scene->{accessors}},
            {bufferView => $view, componentType => 5126, count => 2, type => "SCALAR", min => [0], max => [1]},
            {bufferView => $view, byteOffset => 8, componentType => 5126, count => 2, type => "VEC3"};
        $scene->{animations} = [{channels => [{sampler => 0, target => {node => 0, path => "scale"}}],
            samplers => [{input => $at, output => $at + 1}]}];
        $scene->{nodes}[0]{scale} = [map { 0 + $rest } 1 .. 3];
        print encode_json $scene' $scale plane.gltf >growing.gltf
    # shellcheck disable=SC2086
    render-gl -q growing.gltf $front --animation 0 --time-s 0.5 --size 300x300 --tone-range .5:.5 --needs \
        -o growing.needs
    near "grown from $scale" "$(row growing.needs unit-px 32)" "$(awk "BEGIN {print $scale ? 150 / $scale : 75}")" .01
done

# In tiles; with more threads; as JSON.
render-gl plane.glb --camera 0,0,3.7320508:0,0,0 --fov 30 --size 8192x32 --needs -o wide.needs
near "a plane on both of two tiles of a picture is seen on both" "$(row wide.needs drawn 0)" "$(awk 'BEGIN {print 32 / 8192}')" .0001
render-gl torus.glb --size 320x240 --needs -j 1 -o one.needs
render-gl torus.glb --size 320x240 --needs -j 3 -o three.needs
ok "the same bytes with any number of threads" cmp one.needs three.needs
render-gl torus.glb --size 320x240 --needs --json -o one.json.needs
is "the same table as JSON" "$(perl -MJSON::PP -0e 'print join "", map {"$_->{thing}\t$_->{index}\t$_->{value}\n"} @{decode_json <>}' one.json.needs | md5sum)" \
    "$(tail -n +2 one.needs | cut -f1-3 | md5sum)"

# Nothing in sight; one triangle.
render-gl -q plane.glb --camera 0,0,4:0,0,8 --size 64x64 --needs -o none.needs
is "paper alone needs no tone" "$(row none.needs darkest 0) $(row none.needs drawn 0) $(grep -c unit-px none.needs)" "0 0 0"
tamgen -q --size 64 --needs none.needs -o none.exr
is "and one column" "$(hatchstat tam none.exr | awk '$1 ~ /^[0-9]/ {print $1}' | sort -u)" 0
ok "which draws the paper" render-gl -q plane.glb -T none.exr --camera 0,0,4:0,0,8 --size 64x64 -o none.png
is "no patch, and no figure that is not a number" \
    "$(lapped-param -v --needs none.needs plane.glb 2>&1 >none.glb | grep -cE '(^|: )0 patches, overlap 0.00|computed 0.0 times')" 2
is "one level of strokes" "$(strokegen -v --needs none.needs plane.glb 2>&1 >none.glb | grep -o '^.* levels')" \
    "strokegen: 1 of 6 levels"
meshgen plane --faces 2 -o two.glb
for x in -.9 .9; do
    render-gl two.glb --camera $x,0,.1:$x,0,0 --size 64x64 --needs -o triangle.needs
    is "a view of one triangle sees one" "$(row triangle.needs faces-seen 0) of $(row triangle.needs faces 0)" "1 of 2"
    is "the cells of its box, which is that of both, are the regions seen" "$(row triangle.needs region-cells 0)" 1024
done
echo '{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"name":"x"}]}' >empty.gltf
try render-gl -q empty.gltf --needs -o x.needs
refused "an empty scene is refused" 3 1
ok "and leaves no file of needs" test ! -e x.needs

# A map that was cut: its columns are those of the whole map.
light='--light 0:20 --size 320x240 --lines none'
render-gl torus.glb --light 0:20 --size 320x240 --turntable --frames 4 --needs -o turn.needs
tamgen -q --size 128 --tones 32 -o whole.exr
tamgen -v --size 128 --tones 32 --needs turn.needs -o cut.exr 2>said
columns=$(hatchstat tam cut.exr | awk '$1 ~ /^[0-9]/ {print $1}' | sort -u | wc -l)
is "some columns are left out" "$(awk -v n="$columns" 'BEGIN {print (n > 8 && n < 32)}')" 1
ok "-v says how many" grep -q "^tamgen: $((32 - columns)) of 32 columns left out: tones over" said
is "and what that saves" "$(sed -n 's/^tamgen: \(.*\) % of the texels are made/\1/p' said)" \
    "$(awk -v n="$columns" 'BEGIN {printf "%.3g", 100 * n / 32}')"
# rounded A B: prints whether two maps have the same columns and levels, and their pixels differ by rounding to 8ths, which
# changes means over 8 x 8 pixels by little
rounded() {
    rm -f ./*_[ab].*.png
    tampack -q --layout png "$1.exr" -o "$1_a"
    tampack -q --layout png "$2.exr" -o "$2_b"
    for file in "$1"_a.*.png; do
        hatchstat diff "$file" "$2_b.${file#"$1_a."}" | awk 'NR == 2 {print $1, $7}'
    done | awk '{pixel = $1 > pixel ? $1 : pixel; mean = $2 > mean ? $2 : mean}
        END {print (NR > 3 && pixel > .04 && pixel < .08 && mean < .025) ? "rounded" : NR " " pixel " " mean}'
}
is "all columns that are made have the pixels of the whole map, rounded" "$(rounded cut whole)" rounded
is "of each column and level" "$(find . -name 'cut_a.*.png' | wc -l)" "$((8 * columns))"
ok "fewer bytes" test "$(wc -c <cut.exr)" -lt "$(wc -c <whole.exr)"
# darkness MAP FRAME: draws a frame of a turn of 12, and prints the mean darkness over the scene's pixels
drawn=$(row turn.needs drawn 0)
for map in whole cut; do
    # shellcheck disable=SC2086
    render-gl -q torus.glb -t tam-triple $light -T $map.exr --turntable --frames 9 -o $map.%d.exr
done
hatchstat frames whole.?.exr | awk 'NR > 1 {print $2}' >whole.light
hatchstat frames cut.?.exr | awk 'NR > 1 {print $2}' >cut.light
is "views between differ by at most the tolerance, and do differ" "$(paste whole.light cut.light |
    awk -v drawn="$drawn" '{off = ($2 - $1) / drawn; sum += off; most = off > most ? off : most}
        END {print (NR > 4 && most < .015 && sum > 0)}')" 1
# shellcheck disable=SC2086
try render-gl -q torus.glb -T cut.exr --light 180:-30 --size 320x240 -o x.png
refused "a view that needs darker tones is refused" 3 1
is "with what to do" "$(sed 's/[0-9.]* *, this/T, this/; s/needs [0-9.]*:/needs T:/' "$WORK/.err")" \
    "render-gl: cut.exr: was made for tones up to T, this view needs T: make it again with the needs of this view"
ok "and leaves no file" test ! -e x.png
ok "a range of tones that the map has is drawn" \
    render-gl -q torus.glb -T cut.exr --light 180:-30 --tone-range 0:.5 --size 64x48 -o x.png
tamgen -q --size 64 --needs tone.needs --tones 4 -o four.exr
try render-gl -q torus.glb -T four.exr --window
refused "a window, which shows any view, refuses a map that is not whole" 3 1
is "before it opens" "$(cat "$WORK/.err")" \
    "render-gl: four.exr: was made for the needs of some views; make the map without --needs"
tamgen -q --size 64 --tones 4 -o four.exr
tamgen -q --size 64 --tones 4 --set 'darkest .4' -o whole4.exr
tamgen -q --size 64 --tones 4 --set 'darkest .4' --needs tone.needs -o same4.exr
is "a map of which everything is needed is that of tamgen without --needs, rounded" "$(rounded same4 whole4)" rounded

# A map whose finest level no view reads: the smaller one looks alike, with the same tiles.
view='--size 160x120 --lines none'
render-gl torus.glb --size 160x120 --turntable --frames 4 --needs -o small.needs
tamgen -q --tones 4 -o large.exr
tamgen -v --tones 4 --needs small.needs -o small.exr 2>said
is "finer levels are left out" "$(grep -c 'levels finer than 128 pixels left out' said)" 1
columns=$(hatchstat tam small.exr | awk '$1 ~ /^[0-9]/ {print $1}' | sort -u | wc -l)
is "which leaves a quarter of the texels" "$(sed -n 's/^tamgen: \(.*\) % of the texels are made/\1/p' said)" \
    "$(awk -v n="$columns" 'BEGIN {printf "%.3g", 100 * n / 4 / 4}')"
tamgen -q --tones 4 --size 128 -o smaller.exr
is "as if --size were smaller" "$(rounded small smaller)" rounded
tamgen -q --tones 4 --levels 4 --needs small.needs -o levels.exr
is "not if --levels is given" "$(rounded levels large)" rounded
sed 's/^tolerance	0	0.01/tolerance	0	0.009/' small.needs >exact.needs
tamgen -q --tones 4 --needs exact.needs -o exact.exr
is "nor for a tolerance that levels exceed" "$(rounded exact large)" rounded
for map in large small; do
    # shellcheck disable=SC2086
    render-gl -q torus.glb $view -T $map.exr -o $map.png
done
is "pictures have the same tone, and at 64 pixels, too" "$(hatchstat diff small.png large.png |
    awk 'NR == 2 {print ($3 > -.005 && $3 < .005 && $10 < .04)}')" 1
# shellcheck disable=SC2086
try render-gl -q torus.glb $view --zoom 2 -T small.exr -o near.png
refused "a nearer view is refused" 3 1
is "since it needs finer levels" "$(sed 's/: [0-9.]* % of/: X of/' "$WORK/.err")" \
    "render-gl: small.exr: was made for surfaces seen from farther away: X of this view needs finer levels; make it again with the needs of this view"

# Strokes: as many levels as the picture's size asks for.
for width in 80 160 320; do
    render-gl torus.glb --size ${width}x$((width * 3 / 4)) --needs -o s.needs
    strokegen -v --needs s.needs torus.glb -o strokes.$width.glb 2>&1 | sed -n 's/^strokegen: \([0-9]\) of 6 levels.*/\1/p'
done >levels
is "each doubling of the size asks for a level" "$(tr '\n' ' ' <levels)" "3 4 5 "
dirfield torus.glb -o field.glb
strokegen -v --gap .08 --needs s.needs field.glb 2>&1 >five.glb | grep strokes | sed 's/.*: //' >few
strokegen -v --needs s.needs field.glb 2>&1 >wide.glb | grep strokes | sed 's/.*: //' >>few
strokegen -v --levels 5 field.glb 2>&1 >five.glb | grep strokes | sed 's/.*: //' >>few
is "gaps are wider than those of --gap, whose strokes are no more than those of --levels" "$(sed 's/ .*//' few |
    tr '\n' ' ' | awk '{print ($2 < .95 * $1 && $1 <= $3)}')" 1

# Of two meshes, one far behind the other and one out of sight.
meshgen sphere --faces 600 -o ball.glb
unpack ball.glb ball
perl -MJSON::PP -0e '
    my $scene = decode_json <>;
    push @{$scene->{meshes}}, $scene->{meshes}[0], $scene->{meshes}[0];
    push @{$scene->{nodes}}, {mesh => 1, translation => [0, 0, -9]}, {mesh => 2, translation => [0, 9, 0]};
    $scene->{scenes}[0]{nodes} = [0, 1, 2];
    print encode_json $scene' ball.gltf >balls.gltf
render-gl balls.gltf --camera 3,0,3:0,0,-4 --size 160x120 --needs -o balls.needs
is "items that are seen have an extent" "$(awk -F'\t' '$1 == "item-px" {print $2}' balls.needs | tr '\n' ' ')" "0 1 "
is "nearer regions have more pixels" "$(awk -F'\t' '$1 == "region-unit-px" {
        near = int($2 / 1024) > 15; n[near]++; most[near] = $3 > most[near] ? $3 : most[near]}
    END {print (n[0] > 0 && n[1] > 0 && most[1] > 2 * most[0])}' balls.needs)" 1
strokegen -v --needs balls.needs balls.gltf -o balls.glb 2>said
is "it gets more levels" "$(sed -n 's/^strokegen: \([1-6]\) to \([1-6]\) of 6 levels are needed/\1 \2/p' said |
    awk '{print ($1 < $2)}')" 1
is "what the picture does not show of the three meshes is marked" "$(grep -ao '"unseen":' balls.glb | wc -l)" 3
strokegen -q --levels "$(sed -n 's/^strokegen: . to \(.\) of .*/\1/p' said)" balls.gltf -o more.glb
ok "fewer bytes" test "$(wc -c <balls.glb)" -lt "$(wc -c <more.glb)"

is "lapped-param -v says how large the atlas of each mesh is, after parts without one, too" \
    "$(lapped-param -v --atlas --needs balls.needs balls.gltf 2>&1 >atlas.glb | grep -c 'the side of its atlas')" 2

# Meshes: as coarse as the picture allows, and divided into what it shows and the rest.
try dirfield --needs balls.needs torus.glb -o x.glb
refused "needs of another scene" 3 1
is "are refused with what to do" "$(cat "$WORK/.err")" \
    "dirfield: balls.needs: the needs are those of another scene than torus.glb: render-gl --needs of this file alone makes them"
meshgen ellipsoid --faces 20000 -o egg.glb
side='--from 0:0 --size 240x180'
# shellcheck disable=SC2086
render-gl egg.glb $side --needs -o egg.needs
dirfield egg.glb -o egg.full.glb
dirfield -v --needs egg.needs egg.glb -o egg.field.glb 2>said
cp said once
is "-v says how many faces are left out" "$(grep -c '^dirfield: [0-9]* of 20[0-9]* faces left out' said)" 1
is "and how many are not seen" "$(grep -c '^dirfield: no view shows [1-9][0-9]* of' said)" 1
ok "a quarter of the bytes, or less" test "$(wc -c <egg.field.glb)" -lt $(($(wc -c <egg.full.glb) / 4))
for mesh in full field; do
    # shellcheck disable=SC2086
    render-gl -q egg.$mesh.glb -t gouraud $side --lines none -o egg.$mesh.png
done
is "the picture is the same, but for the tolerance" "$(hatchstat diff egg.full.png egg.field.png |
    awk 'NR == 2 {print ($3 > -.01 && $3 < .01 && $7 < .15)}')" 1
lapped-param -q egg.full.glb -o egg.all.glb
lapped-param -v --needs egg.needs egg.field.glb -o egg.patches.glb 2>said
is "the mask is smaller" "$(grep -c 'the mask is [1-9][0-9]* of 1024 pixels wide' said)" 1
# A texel may cover four pixels: small pictures need the smallest mask, whose soft border has 11 pixels.
render-gl egg.glb --from 0:0 --size 8x6 --needs -o tiny.needs
lapped-param -v --needs tiny.needs egg.glb -o tiny.glb 2>said
is "a mask for small pictures keeps the soft border" "$(grep -c 'the mask is 256 of 1024 pixels wide' said)" 1
lapped-param -v --needs tiny.needs --feather 0.3 egg.glb -o tiny.glb 2>said
is "no mask is smaller than 64 pixels" "$(grep -c 'the mask is 64 of 1024 pixels wide' said)" 1
ok "patches, too, have a quarter of the bytes" test "$(wc -c <egg.patches.glb)" -lt $(($(wc -c <egg.all.glb) / 4))
strokegen -q --needs egg.needs egg.field.glb -o egg.strokes.glb
strokegen -q --needs egg.needs egg.glb -o egg.anew.glb
for file in egg.patches egg.strokes egg.anew; do
    options='-t traced' again='it again with the needs of this view'
    [ $file != egg.patches ] || options='-t rptam'
    # shellcheck disable=SC2086
    ok "$file: the view is drawn" render-gl -q $file.glb $options $side -o x.png
    # shellcheck disable=SC2086
    try render-gl -q $file.glb $options --from 180:0 --size 240x180 -o back.png
    refused "$file: the other side is refused" 3 1
    is "with what to do" "$(sed 's/: [0-9.]* % of/: X of/' "$WORK/.err")" \
        "render-gl: $file.glb: was made for other views: X of this one shows what they do not see; make $again"
done
try render-gl -q egg.strokes.glb -t traced --window
refused "a window, which shows all sides" 3 1
# Faces that a second run makes at the border may lie out of sight altogether: they are one more part that is unseen.
dirfield -v --needs egg.needs egg.field.glb -o egg.twice.glb 2>twice
is "dirfield takes what it has made" "$(grep -ao '"unseen":' egg.twice.glb | wc -l | grep -c '^ *[12]$')" 1
is "of which it sees the same share" "$(cat once twice | awk '/no view shows/ {share[n++] = $5 / $7}
    END {print (n == 2 && share[1] > share[0] - .01 && share[1] < share[0] + .01)}')" 1
# shellcheck disable=SC2086
try render-gl -q egg.field.glb --needs --from 180:0 --size 240x180 -o x.needs
refused "needs of the other side, of the mesh that lacks it" 3 1
render-gl -q torus.glb --up z --size 320x240 --from 20:30 --needs -o up.needs
dirfield -v --needs up.needs torus.glb 2>said >up.glb
ok "a scene that is turned by --up has the same regions" grep -q "no view shows [1-9]" said
ok "what it sees is there" render-gl -q up.glb --up z --size 320x240 --from 20:30 -t gouraud --lines none -o x.png

ok "its normals are integers" grep -aq '"extensionsRequired":\["KHR_mesh_quantization"\]' egg.field.glb
ok "as are those of patches" sh -c 'lapped-param -q --needs egg.needs egg.glb | grep -aq KHR_mesh_quantization'
ok "and of strokes" sh -c 'strokegen -q --needs egg.needs egg.glb | grep -aq KHR_mesh_quantization'

# Volumes and thresholds of maps that were cut, and cut by themselves.
tamgen -q --size 128 --tones 32 --needs turn.needs | tamvol -q -o cut.ktx2
tamvol -v --needs turn.needs whole.exr -o fit.ktx2 2>said
is "tamvol says that it makes fewer slices" "$(grep -c '32 slices, not 64' said)" 1
tamvol -q whole.exr -o all.ktx2
# shape FILE: prints VkFormat, depth and layers
shape() {
    for offset in 12 28 32; do
        od -An -tu4 -j $offset -N 4 "$1"
    done | tr -d ' ' | paste -sd' '
}
tamgen -q --size 128 --tones 16 --palette dusk -o colour.exr
tamvol -q --needs turn.needs colour.exr -o colour.ktx2
is "of a coloured map it makes BC1 blocks, too, in an array" "$(shape colour.ktx2 | sed 's/ [12][0-9]$/ N/')" "131 0 N"
tamvol -q --alpha --needs turn.needs colour.exr -o alpha.ktx2
is "with --alpha, an array of RGBA8" "$(shape alpha.ktx2 | sed 's/ [12][0-9]$/ N/')" "37 0 N"
tamvol -q --layout volume --needs turn.needs colour.exr -o deep.ktx2
is "a volume keeps slices for its coarser levels" "$(shape deep.ktx2 | awk '{print $1, ($2 > 32)}')" "23 1"

# A plane of 40 pixels shows the level of 32 texels, on which a volume of 4 slices has 2: they are grey strokes.
# shellcheck disable=SC2086
render-gl -q plane.glb $front --size 40x40 --tone-range .5:.5 --needs -o far.needs
for layout in array volume; do
    tamvol -q --needs far.needs --layout $layout --tones 4 whole.exr -o four.ktx2
    # shellcheck disable=SC2086
    try render-gl -q plane.glb $front --size 40x40 --tone-range .5:.5 -t volume -T four.ktx2 -o x.png
    echo "$status $(cat "$WORK/.err")"
done >four
is "all slices of an array are on all levels" "$(head -n 1 four)" "0 "
is "levels of few slices are refused where a view shows them" "$(tail -n 1 four)" "3 render-gl: four.ktx2: 100 % of \
this view shows levels with fewer than 4 slices of tone; want tamvol --layout array"
tamthresh -q --exact --needs turn.needs whole.exr -o exact.ktx2
tamthresh -q whole.exr -o bins.ktx2
tamthresh -v --needs turn.needs whole.exr -o few.ktx2 2>said
is "tamthresh, that it makes fewer bins" "$(grep -c '4 bins of 7, in 2 layers' said)" 1
tamthresh -v --bins 7 --needs turn.needs whole.exr -o seven.ktx2 2>asked
is "bins that are asked for stay" "$(grep -c ' in 2 layers' asked) $(grep -c '^tamthresh: bins 0 [0-9. ]* 1; ' asked)" "0 1"
is "which need a quarter of the bytes, compressed" \
    "$(($(wc -c <bins.ktx2) * 10 / $(wc -c <few.ktx2))) $(grep -c 'compression error: 0.0' said)" "39 1"
tamthresh -q --needs turn.needs whole.exr -o few.exr
ok "in EXR they are not" grep -aq "dy.0" few.exr
ok "fewer slices of a cut map" test "$(wc -c <cut.ktx2)" -lt "$(wc -c <all.ktx2)"
# mean FILE TECHNIQUE: prints the mean light of a view
mean() {
    # shellcheck disable=SC2086
    render-gl -q torus.glb -t $2 $light --turntable --frames 2 -T $1 -o m%d.exr || echo failed
    hatchstat frames m?.exr | awk 'NR == 2 {print $2}'
}
for pair in "cut.ktx2 all.ktx2 volume" "fit.ktx2 all.ktx2 volume" "exact.ktx2 bins.ktx2 threshold" \
    "few.ktx2 bins.ktx2 threshold"; do
    # shellcheck disable=SC2086
    set -- $pair
    is "$1 differs by no more than the tolerance" "$(echo "$(mean $1 $3) $(mean $2 $3)" |
        awk -v drawn="$drawn" '{off = ($1 - $2) / drawn; print (off > -.015 && off < .015)}')" 1
    # shellcheck disable=SC2086
    try render-gl -q torus.glb -t $3 -T $1 --light 180:-30 --size 320x240 -o x.png
    refused "$1: a view that needs darker tones" 3 1
    is "is told so" "$(sed 's/[0-9.]* *, this/T, this/; s/needs [0-9.]*:/needs T:/' "$WORK/.err")" \
        "render-gl: $1: was made for tones up to T, this view needs T: make it again with the needs of this view"
done
tamthresh -q --bins 3 --needs turn.needs whole.exr -o three.ktx2
ok "thresholds in two layers are read" render-gl -q torus.glb -t threshold-soft $light -T three.ktx2 -o x.png

# Solid textures.
render-gl torus.glb --solid-size 64 --size 160x120 --needs -o solid.needs
is "a period that is asked for has a row" "$(row solid.needs solid-px 0)" 64
is "which needs half of the texels along a side" "$(solidgen -v --needs solid.needs 2>&1 >solid.ktx2 |
    grep -c '32 texels along a side, not 64: a period covers 64 pixels; 12.5 % of')" 1
ok "the same as --size" cmp solid.ktx2 "$(solidgen -q --size 32 -o half.ktx2 && echo half.ktx2)"
# With fewer texels, features have the same size: paper has 24 cells, in two texels each; a picture is reduced.
solidgen -q --needs solid.needs --style paper -o paper.ktx2
ok "a style keeps its features" cmp paper.ktx2 "$(solidgen -q --style paper -o whole.ktx2 && echo whole.ktx2)"
for side in 48 24; do
    awk -v side=$side 'BEGIN {
        printf "P2\n%d %d\n255\n", side, side
        for (i = 0; i < side * side; i++)
            print int((i % side) / side * 8) * 29 % 256 }' >ramps$side.pgm
done
solidgen -q --needs solid.needs --exemplar ramps48.pgm --method pyramid -o reduced.ktx2
ok "a picture keeps its size" cmp reduced.ktx2 "$(solidgen -q --size 32 --exemplar ramps24.pgm --method pyramid -o small.ktx2 &&
    echo small.ktx2)"
is "without one, all are made" "$(solidgen -q --needs s.needs | wc -c)" "$(solidgen -q | wc -c)"

# Usage
try render-gl torus.glb --needs --technique gouraud
refused "--needs with a technique" 2 2
try render-gl torus.glb --tolerance .1 -o x.png
refused "--tolerance without --needs" 2 2
try render-gl torus.glb --needs --samples 4
refused "--needs with samples" 2 2
try strokegen --needs s.needs --levels 3 torus.glb
refused "strokegen: --needs with --levels" 2 2

# A drawing that is replayed.
tamgen -q --size 128 --tones 12 -r drawing.tsv -o drawn.exr
tamgen -q --replay drawing.tsv --size 128 --tones 12 -o drawing.exr
tamgen -v --replay drawing.tsv --size 128 --tones 12 --needs turn.needs -o some.exr 2>said
columns=$(hatchstat tam some.exr | awk '$1 ~ /^[0-9]/ {print $1}' | sort -u | wc -l)
is "some of its columns are left out" "$(grep -c "^tamgen: $((12 - columns)) of 12 columns left out" said)" 1
is "the others are the same, rounded" "$(rounded some drawing)" rounded
# shellcheck disable=SC2086
ok "they draw the views" render-gl -q torus.glb -t tam-triple $light --turntable --frames 4 -T some.exr -o r%d.png
try tamgen --needs s.needs --replay drawing.tsv --ids -o x.exr
refused "tamgen: --ids of a drawing by needs" 2 2
try tamgen --needs torus.glb
refused "tamgen: a file that is none of needs" 3 1

# No view showed the back of a ball, which is coarse: it stays so by the same needs, and is refused by needs that show it.
meshgen sphere --faces 500 -o ball.glb
render-gl --size 64x64 --from 0:0 --needs -o front.needs ball.glb
render-gl --size 64x64 --turntable --frames 4 --needs -o around.needs ball.glb
dirfield -q --needs front.needs ball.glb -o front.glb
ok "the same needs again" sh -c 'dirfield -q --needs front.needs front.glb | strokegen -q --needs front.needs -o again.glb'
try dirfield --needs around.needs front.glb -o around.glb
refused "needs that show what is coarse" 3 1
is "which says where to begin" "$(grep -c 'faces that these views show are as coarse as .*: begin with the full scene$' .err)" 1

# A map that is cut already is not cut again by the same needs, which may be shares of its darkest tone.
meshgen torus --faces 400 -o ring.glb
render-gl ring.glb --size 64x48 --light 60:0 --needs -o lit.needs
tamgen -q -t 24 --size 64 --needs lit.needs -o once.exr
tamvol -q --needs lit.needs once.exr -o twice.ktx2
ok "needs of a cut map" render-gl -q ring.glb --size 64x48 --light 60:0 -t volume -T twice.ktx2 -o twice.png
# Strokes are listed by the columns and levels of the map that is written.
render-gl ring.glb --size 64x48 --light 0:60 --needs -o dim.needs
tamgen -q --size 64 --tones 256 --needs dim.needs --strokes few.tsv -o few.exr
ok "the strokes of each second column" hatchstat tam few.exr --strokes few.tsv
tamgen -q --size 256 --tones 12 --strokes whole.tsv -o /dev/null
tamgen -q --replay whole.tsv --size 256 --tones 12 --needs dim.needs --strokes cut.tsv -o cut.exr
ok "the strokes of a drawing whose columns and levels are cut" hatchstat tam cut.exr --strokes cut.tsv
is "which are fewer" "$(awk 'END {print NR < whole}' whole="$(wc -l <whole.tsv)" cut.tsv)" 1
# Of each stroke, the part has the columns in which it enters the coarser levels, as far as it has these columns.
drawing="--replay $TOP/pipelines/hatching.svg --keep .5 --size 256 --tones 12"
# shellcheck disable=SC2086 # options are words
tamgen -q $drawing --strokes whole.tsv -o whole.exr
# shellcheck disable=SC2086
tamgen -v $drawing --needs small.needs --strokes cut.tsv -o cut.exr 2>said
is "the finest level is left out, and some columns" "$(grep -c 'levels finer than 128 pixels\|of 12 columns left out' said)" 2
awk -F'\t' -v tones="$(sed -n 's/^tamgen: \(.*\) of 12 columns left out.*/\1/p' said)" 'NR > 1 {
    split($14, column, ",")
    for (level = 0; column[level + 2] != "" && column[level + 2] < 12 - tones; level++)
        enters = enters (level ? "," : "\t") column[level + 2]
    if (enters) print $10, column[2], level - 1 enters
    enters = ""}' whole.tsv >want
awk -F'\t' 'NR > 1 {print $10, $11, $12 "\t" $14}' cut.tsv >got
ok "strokes enter the levels of the part where they enter those of the whole" cmp got want
ok "of which many enter one later than the next" test "$(awk -F'[\t,]' '$2 < $3' want | wc -l)" -gt 20
tamgen -q --size 64 --tones 24 --ids --needs dim.needs -o ids.exr
is "a map with ids has its strokes" "$(strings ids.exr | grep -c hatch:strokes)" 1
printf 'vertex\tdx\tdy\tdz\n1\t1\t0\t0\n' >vertex.tsv
try dirfield --needs dim.needs --constraints vertex.tsv ring.glb -o constrained.glb
refused "constraints by vertices, which --needs renumbers" 3 1
finish
