# --technique solid: files that are no solid textures, and options of looks that do not go together, each refused with
# one line that says what to do.
. "${TOP:-.}/tests/tap.sh"

# solid NAME SIZE PATTERN [FORMAT]: writes NAME.ktx2
solid() {
    name=$1
    shift
    perl "$TOP/tests/support/solid/make.pl" "$@" >"$name.ktx2"
}
solid waves 16 waves:4
meshgen torus --faces 200 -o torus.glb
tamgen --size 64 --levels 1 --tones 8 -o map.exr
draw="render-gl --size 32x24 -o picture.png torus.glb -t solid"

# refuses NAME STATUS LINES WORDS OPTION ...: checks that a picture with these options is refused with STATUS and LINES of
# messages, the first of which ends in WORDS
refuses() {
    name=$1 want=$2 lines=$3 words=$4
    shift 4
    try $draw "$@"
    refused "$name" "$want" "$lines"
    is "$name: message" "$(head -n 1 .err)" "render-gl: $words"
    [ ! -e picture.png ] || fail "$name: no picture is left"
}

# Textures that are none.
solid box 16x16x8 waves:4
refuses "a texture that is no cube" 3 1 "box.ktx2: 16x16x8 texels, want a cube or a square" --solid box.ktx2
tamvol -q --tones 8 map.exr -o volume.ktx2
refuses "a volume of tamvol" 3 1 "volume.ktx2: 64x64x8 texels, want a cube or a square" --solid volume.ktx2
solid odd 24 waves:4
refuses "a side that is no power of two" 3 1 \
    "odd.ktx2: 24 texels along a side, want a power of two from 8 to 512" --solid odd.ktx2
solid small 4 grey:90
refuses "a texture that is too small" 3 1 \
    "small.ktx2: 4 texels along a side, want a power of two from 8 to 512" --solid small.ktx2
solid two 16 waves:4 rg8
solid words 16 grey:90 r32ui
for format in two words; do
    refuses "texels of another format, $format" 3 1 \
        "$format.ktx2: texels of a format other than R8, RGB8 and RGBA8" --solid $format.ktx2
done
refuses "a file that is no picture" 3 1 \
    "torus.glb: the picture cannot be read: not an image of a known format, neither by content nor by extension" \
    --solid torus.glb
refuses "a file that does not exist" 4 1 "none.ktx2: cannot open: no such file or directory" --solid none.ktx2
refuses "a second file that does not exist" 4 1 "none.ktx2: cannot open: no such file or directory" \
    --solid waves.ktx2,none.ktx2
refuses "a texture larger than --max-memory" 5 1 \
    "out of memory: 2097152 items of 1 bytes needed, 0 bytes in use, limit 1048576" \
    --solid "$(solid large 64 grey:90 && echo large.ktx2)" --max-memory 1M

# Files that are cut off or damaged: all of the header and of the level index, a few places behind them.
size=$(wc -c <waves.ktx2)
said=$(for end in 0 11 12 47 79 80 103 104 140 200 2000 $((size - 1)); do
    head -c $end waves.ktx2 >cut.ktx2
    try $draw --solid cut.ktx2
    echo "$end: $status $(wc -l <.err) $(grep -c '^render-gl: cut.ktx2: .' .err) $(ls picture.png 2>/dev/null)"
done | grep -v ': 3 1 1 $')
is "files that are cut off" "$said" ""
said=$(for at in 0 5 12 15 16 19 20 23 24 27 28 31 32 35 36 39 40 43 44 47 80 87 88 95 96 103; do
    { head -c $at waves.ktx2 && printf '\377' && tail -c +$((at + 2)) waves.ktx2; } >bad.ktx2
    try $draw --solid bad.ktx2
    echo "$at: $status $(wc -l <.err) $(grep -c '^render-gl: bad.ktx2: .' .err) $(ls picture.png 2>/dev/null)"
done | grep -vE ': [35] 1 1 $')
is "files with a wrong byte in the header or the level index" "$said" ""

# 2D textures.
solid flat 16x16x0 waves:4
refuses "a flat texture and a solid one" 2 2 "--solid: waves.ktx2 is a solid texture, the others are not" \
    --solid flat.ktx2,waves.ktx2
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >bare.obj
refuses "a 2D texture on a mesh without texture coordinates" 3 1 \
    "bare.obj: primitive 0 has no texture coordinates, which 2D textures need; 3D textures, which solidgen makes, need none" \
    --solid flat.ktx2 bare.obj
ok "a 2D texture" $draw --solid flat.ktx2
rm -f picture.png

# Surfaces so near that they are drawn in pieces.
for texture in waves flat; do
    ok "$texture, from very near" $draw --solid $texture.ktx2 --zoom 1e9
    rm -f picture.png
done

# Textures that are unusual, but are some.
solid grey 8 grey:0
solid alpha 16 waves:4 rgba8
tamvol -q --tones 64 map.exr -o cube.ktx2
for texture in grey alpha cube; do
    ok "an unusual texture, $texture" $draw --solid $texture.ktx2
    rm -f picture.png
done
many=waves.ktx2,waves.ktx2,waves.ktx2,waves.ktx2
ok "eight files" $draw --solid $many,$many
rm -f picture.png
cp waves.ktx2 'in a folder.ktx2'
ok "a name with blanks" $draw --solid 'in a folder.ktx2,./waves.ktx2'
ok "standard input" $draw --solid - <waves.ktx2
rm -f picture.png
{
    printf 'Pf\n2 1\n-1.0\n'
    printf '\0\0\300\177\0\0\0\0' # NaN and 0
} >nan.pfm
try $draw --solid nan.pfm
is "numbers that are not finite" "$status $(cat .err)" \
    "0 render-gl: nan.pfm: warning: 1 number is not finite: replaced by 1"
rm -f picture.png

# Options.
ok "no texture: that of a style" $draw
rm -f picture.png
ok "textures of two styles" $draw --solid wood,canvas
rm -f picture.png
refuses "a style that does not exist" 2 2 "solid: 'wod' is not one of canvas, crosshatch, marble, paper, perlin, stipple, strokes, \
turbulence, wood, worley, and not a file; perhaps wood" --solid wod
refuses "nine files" 2 2 "--solid: more than 8 files" --solid $many,$many,waves.ktx2
for names in , waves.ktx2, ,waves.ktx2 waves.ktx2,,grey.ktx2; do
    refuses "an empty name in $names" 2 2 "--solid $names: an empty name" --solid $names
done
refuses "standard input twice" 2 2 "two inputs come from standard input" --solid -,- <waves.ktx2
refuses "a look that does not exist" 2 2 "--look: 'oil' is not one of plain, binary, watercolor, collage" --look oil
refuses "a blend that is none" 2 2 "--blend: 'rank' is not one of linear, contrast, histogram, union" --blend rank
for range in solid-size:3:4:4096 grain:1.5:0:1 wobble:33:0:32 dry:-1:0:1 edge-darkening:2:0:1 paper-grain:2:0:1 \
    border:17:0:16; do
    IFS=: read -r option value low high <<END
$range
END
    refuses "--$option out of range" 2 2 "--$option: '$value' is not a number from $low to $high" --$option $value
done
for turn in 1,2 10,20,361 1:2:3 nan,0,0; do
    refuses "--solid-turn $turn" 2 2 "--solid-turn $turn: want X,Y,Z, angles from -360 to 360 degrees" \
        --solid waves.ktx2 --solid-turn $turn
done
refuses "--bands out of range" 2 2 "--bands: '16' is not a whole number from 1 to 15" --bands 16
# Looks of other techniques: watercolor paints their pictures; the others and their options go with this one.
draw="render-gl --size 32x24 -o picture.png torus.glb -t gouraud"
for option in solid:waves.ktx2 inks:red grain:.5; do
    refuses "--${option%:*} without a look" 2 2 "--${option%:*} needs --technique solid or --look watercolor or --window" \
        --${option%:*} ${option#*:}
done
refuses "--solid-size without a look" 2 2 \
    "--solid-size needs --technique solid or --look watercolor or --window or --needs" --solid-size 80
refuses "--texture-color without a look" 2 2 \
    "--texture-color needs --technique solid or --look watercolor or --window" --texture-color
for look in binary collage; do
    refuses "the look $look of another technique" 2 2 \
        "--look $look goes with solid; with gouraud, the look is plain or watercolor" --look $look
done
refuses "--blend of another technique" 2 2 "--blend needs --technique solid or --window" --blend linear
refuses "--wet without a look" 2 2 "--wet needs --look watercolor" --wet .2
refuses "two kinds of colours" 2 2 "--texture-color cannot be combined with --inks: give one of them" \
    --look watercolor --texture-color --inks red
refuses "colours and tones of materials" 2 2 \
    "--texture-color cannot be combined with --texture-tone, which would darken the colours twice" \
    --look watercolor --texture-color --texture-tone
refuses "a 2D texture on another technique" 2 2 \
    "--solid flat.ktx2: a 2D texture paints no pictures of a technique; want a 3D one, which solidgen makes" \
    --look watercolor --solid flat.ktx2
for other in "--show patches" "--probe --tam map.exr"; do
    try render-gl torus.glb --look watercolor $other -o picture.png
    is "--look with $other" "$status $(grep -c '^render-gl: --[a-z]* cannot be combined with --' .err)" "2 1"
done
for ending in svg tsv; do
    try render-gl torus.glb --look watercolor -o picture.$ending
    is "--look with a drawing, $ending" "$status $(grep -c ": --look .* --output \*.$ending.*: a drawing consists of lines" .err)" \
        "2 1"
done
ok "a technique in plain" $draw --look plain
rm -f picture.png
for drawn in gouraud rptam strokes "tam --tam map.exr"; do
    ok "a painted picture from very near, $drawn" render-gl torus.glb --size 32x24 -t $drawn --look watercolor \
        --solid waves.ktx2 --zoom 1e9 -o near.png
done
draws="render-gl --size 64x48 torus.glb -t rptam --look watercolor --solid waves.ktx2"
$draws --wobble 8 -o alone.png
ok "a painted film" $draws --frames 2 --animate wobble=0..8 -o 'film%d.png'
is "its pictures differ, and do not depend on those before" \
    "$(cmp -s film0.png film1.png; echo $?) $(cmp -s film1.png alone.png; echo $?)" "1 0"
try $draw --frames 2 --animate wobble=0..8 -o 'film%d.png'
is "a film without a look" "$status $(wc -l <.err)" "2 2"
rm -f picture.png
draw="render-gl --size 32x24 -o picture.png torus.glb -t solid"

refuses "colours in ink alone" 2 2 "--texture-color needs --look plain, watercolor or collage" --look binary --texture-color

refuses "--blend with washes" 2 2 "--blend needs --look plain, binary or collage" \
    --solid waves.ktx2 --look watercolor --blend linear
for how in contrast histogram; do
    refuses "--blend $how with thresholds" 2 2 "--blend: --look binary draws thresholds; want linear or union" \
        --solid waves.ktx2 --look binary --blend $how
done
for look in plain collage; do
    refuses "--blend union with the look $look" 2 2 "--blend union needs --look binary" \
        --solid waves.ktx2 --look $look --blend union
done
$draw --solid waves.ktx2 --look binary -o usual.png
$draw --solid waves.ktx2 --look binary --blend union -o union.png
is "binary blends by union" "$(cmp -s usual.png union.png; echo $?)" 0
rm -f usual.png union.png

# Which options a look takes: each of the others is refused, by name, and each that it takes changes the picture.
draw="render-gl --size 96x72 torus.glb -t solid --tone-range .2:.6"
for look in plain binary watercolor collage; do
    $draw --solid waves.ktx2 --look $look -o usual.png
    for option in blend:linear grain:.5 bands:3 wobble:1 dry:.8 wet:.1 edge-darkening:.1 paper-grain:.1 border:1 \
        solid-size:80; do
        try $draw --solid waves.ktx2 --look $look --${option%:*} ${option#*:} -o picture.png
        if [ $status -ne 0 ]; then
            grep -q "^render-gl: --${option%:*} needs --look [a-z ]*" .err ||
                echo "$look ${option%:*}: $status, $(cat .err)"
        elif cmp -s usual.png picture.png; then
            echo "$look ${option%:*} without effect"
        else
            echo "$look ${option%:*}"
        fi
    done
done >taken
is "looks and their options" "$(tr '\n' ';' <taken)" "$(tr -d '\n' <<'END'
plain blend;plain grain;plain solid-size;
binary blend;binary solid-size;
watercolor grain;watercolor bands;watercolor wobble;watercolor dry;watercolor wet;watercolor edge-darkening;watercolor paper-grain;
watercolor solid-size;
collage blend;collage grain;collage bands;collage wobble;collage border;collage solid-size;
END
)"

# Textures without a direction are turned, as --solid-turn tells; others are not.
solidgen --style perlin --size 16 -o perlin.ktx2
solidgen --style wood --size 16 -o wood.ktx2
for texture in waves.ktx2 wood.ktx2 wood waves.ktx2,perlin.ktx2 perlin.ktx2,waves.ktx2; do
    $draw --solid $texture -o usual.png
    $draw --solid $texture --solid-turn 0,0,0 -o aligned.png
    ok "$texture is not turned" cmp usual.png aligned.png
done
for texture in perlin.ktx2 perlin,stipple; do
    $draw --solid $texture -o usual.png
    $draw --solid $texture --solid-turn 23,37,11 -o turned.png
    $draw --solid $texture --solid-turn 0,0,0 -o aligned.png
    ok "$texture is turned" cmp usual.png turned.png
    ok "$texture, aligned, is another picture" test "$(cmp -l usual.png aligned.png 2>/dev/null | wc -l)" -gt 1000
done

# The two formats of a solid texture are drawn alike, also on a mesh without texture coordinates.
for style in wood perlin; do
    solidgen --style $style --size 16 -o $style.exr
    $draw bare.obj --solid $style.ktx2 -o usual.png
    $draw bare.obj --solid $style.exr -o slices.png
    ok "$style of an OpenEXR file" cmp usual.png slices.png
done
# Eight slices without compression, of halves 0.5 and, at the first texel, NaN.
perl -e 'my $attribute = sub { pack "Z* Z* V/a*", @_ };
    my @headers = map { join("", $attribute->("channels", "chlist", pack("Z* V C x3 V2 x", "Y", 1, 0, 1, 1)),
        $attribute->("compression", "compression", "\0"), $attribute->("lineOrder", "lineOrder", "\0"),
        (map { $attribute->($_, "box2i", pack "V4", 0, 0, 7, 7) } "dataWindow", "displayWindow"),
        $attribute->("pixelAspectRatio", "float", pack "f<", 1), $attribute->("screenWindowWidth", "float", pack "f<", 1),
        $attribute->("screenWindowCenter", "v2f", pack "f<2", 0, 0), $attribute->("chunkCount", "int", pack "V", 8),
        $attribute->("name", "string", sprintf "slice.%03d", $_), $attribute->("type", "string", "scanlineimage")) . "\0"
    } 0 .. 7;
    my $begin = pack("V2", 20000630, 0x1002) . join("", @headers) . "\0";
    my $at = length($begin) + 8 * 64;
    binmode STDOUT;
    print $begin, map { pack "Q<", $at + 28 * $_ } 0 .. 63;
    print map { pack "V3 v8", int($_ / 8), $_ % 8, 16, $_ ? 0x3800 : 0x7e00, (0x3800) x 7 } 0 .. 63' >nan.exr
try $draw --solid nan.exr -o picture.png
is "slices with numbers that are not finite" "$status $(cat .err)" \
    "0 render-gl: nan.exr: warning: 1 number is not finite: replaced by 1"
tamvol -q --tones 8 map.exr -o volume.exr
try $draw --solid volume.exr -o picture.png
is "an OpenEXR file of tamvol" "$status $(cat .err)" "3 render-gl: volume.exr: 64x64x8 texels, want a cube or a square"
head -c 3000 wood.exr >cut.exr
try $draw --solid cut.exr -o picture.png
is "slices that are cut off" "$status $(grep -c '^render-gl: cut.exr: .' .err) $(wc -l <.err)" "3 1 1"

# A second object takes a second texture, which draws as the first if it is a copy; textures in colours have three tables.
awk 'BEGIN {
    print "P3\n8 8\n255"
    for (i = 0; i < 192; i++) print i * 73 % 256
}' >colors.ppm
solidgen -q --exemplar colors.ppm --size 16 -o colors.ktx2
for look in plain collage; do
    $draw torus.glb --solid colors.ktx2 --look $look --zoom 3 -o one.png
    for copies in colors.ktx2,colors.ktx2 colors.ktx2,colors.ktx2,colors.ktx2; do
        $draw torus.glb --solid $copies --look $look --zoom 3 -o copies.png
        ok "$look: the picture with copies is the same, $copies" cmp one.png copies.png
    done
done

# The inks of objects, the pipeline, and a lapped surface with a 2D texture.
try render-gl torus.glb bare.obj -t solid --solid waves.ktx2 --inks red,nocolor -o picture.png
is "an ink that is no colour" "$status $(head -n 1 .err)" \
    "2 render-gl: --inks: 'nocolor' is neither the name of a colour nor #rrggbb"
ok "two inks" render-gl torus.glb bare.obj --size 64x48 -t solid --solid waves.ktx2 --inks red,blue --from 20:14 -o inks.png
ok "solid.mk" make -s -f "$TOP/pipelines/solid.mk" MESH=torus.glb SOLID=16 SIZE=48x36 TURN=2 OUT=out
ok "its texture, picture and turn" test -s out/torus.solid.ktx2 -a -s out/torus.png -a -s out/torus-001.png
ok "a lapped surface" sh -c 'meshgen torus --faces 400 | dirfield | lapped-param |
    render-gl - --size 48x36 -t solid --solid flat.ktx2 --look binary -o lapped.png'
ok "a map as a picture" render-gl torus.glb --size 48x36 -t solid --solid map.exr -o column.png
finish
