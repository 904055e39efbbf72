# hatchstat diff and frames: figures known in closed form, other image formats, exit statuses.
. "${TOP:-.}/tests/tap.sh"
command -v hatchstat >/dev/null || { skip "pictures" "no hatchstat"; finish; }

# flat FILE GREY [WIDTH HEIGHT]: writes a PPM of one grey, an sRGB code
flat() {
    awk -v grey="$2" -v width="${3:-16}" -v height="${4:-16}" 'BEGIN {
        printf "P3\n%d %d\n255\n", width, height
        for (i = 0; i < width * height * 3; i++) print grey }' >"$1"
}
# field NAME: prints a column of the report on standard input
field() {
    awk -F'\t' -v name="$1" 'NR == 1 {for (i = 1; i <= NF; i++) if ($i == name) at = i; next}
        {print $at}'
}

flat black.ppm 0
flat white.ppm 255
flat grey.ppm 128
flat wide.ppm 128 17 16
is "the difference of black and white is 1" "$(hatchstat diff black.ppm white.ppm | field max)" 1
is "a picture is equal to itself" "$(hatchstat diff grey.ppm grey.ppm | field psnr_db)" inf
is "grey 128 is 0.2159 in linear light" \
    "$(hatchstat diff grey.ppm black.ppm | field mean | cut -c 1-6)" 0.2158
is "grey 128 is 128/255 in sRGB" "$(hatchstat diff --srgb grey.ppm black.ppm | field bias)" 0.501960814
awk 'BEGIN {print "P2\n4 2\n255"; for (i = 0; i < 8; i++) print 30 * i}' >steps.pgm
awk 'BEGIN {print "P3\n4 2\n255"; for (i = 0; i < 24; i++) print 30 * int(i / 3)}' >steps.ppm
is "a grey picture is equal to the same in colour" "$(hatchstat diff steps.pgm steps.ppm | field max)" 0
is "JSON has no number for infinity" \
    "$(hatchstat diff --json grey.ppm grey.ppm | grep -o '"psnr_db": [a-z]*')" '"psnr_db": null'

try hatchstat diff black.ppm grey.ppm --max-difference 0.2159 -o report
is "a difference within the limit" $status 0
try hatchstat diff black.ppm grey.ppm --max-difference 0.2158 -o report
is "a difference over the limit exits with 1" "$status $(wc -l <report) $(wc -c <.err)" "1 2 0"
{
    printf 'Pf\n2 1\n-1.0\n'
    printf '\0\0\300\177\0\0\0\0' # NaN and 0
} >nan.pfm
printf 'P2\n2 1\n255\n0 0\n' >zero.pgm
try hatchstat diff nan.pfm zero.pgm --max-difference 1e9 -o report
is "a number that is not finite exceeds every limit" "$status $(field max <report) $(field mean <report) $(field differing <report)" \
    "1 inf 0 0.5"
is "and is warned of" "$(cat .err)" "hatchstat: nan.pfm: warning: 1 number is not finite"
is "it is as good as another one" "$(hatchstat diff -q nan.pfm nan.pfm -m 0 | field differing)" 0
try hatchstat diff grey.ppm wide.ppm
refused "pictures of two sizes" 3 1
try hatchstat diff grey.ppm
refused "one picture" 2 2
try hatchstat frames grey.ppm
refused "one frame" 2 2
try hatchstat nonesuch grey.ppm
refused "an unknown subject" 2 2

# Black, grey, white: 0, 0.2159 and 1 in linear light.
hatchstat frames black.ppm white.ppm >two.tsv
is "frames: two pictures have no pop" "$(field pop <two.tsv | paste -sd' ') $(field pop_box8 <two.tsv | paste -sd' ')" \
    "nan nan nan nan nan nan"
hatchstat frames black.ppm grey.ppm white.ppm >frames.tsv
is "a row for each frame and one for all" "$(wc -l <frames.tsv)" 5
is "frames: the mean of each frame" "$(field mean <frames.tsv | cut -c 1-5 | paste -sd' ')" "0 0.215 1 0.405"
is "frames: the change from frame to frame" "$(field change <frames.tsv | cut -c 1-5 | paste -sd' ')" \
    "nan 0.215 0.784 0.5"
is "frames: the pop at the second frame" "$(field pop <frames.tsv | cut -c 1-5 | paste -sd' ')" \
    "nan 0.568 nan 0.568"
is "frames: the largest drift" "$(field drift <frames.tsv | tail -n 1)" 1

# Files that have been read are closed.
many=$(yes grey.ppm | head -n 40 | xargs)
is "frames: more pictures than descriptors" "$(ulimit -n 20; hatchstat frames $many | wc -l)" 42

# A sequence of grey and coloured pictures is measured in RGBA: opacity, which is 1, counts as a fourth channel.
perl -e 'print pack("a2 V3 V3 v2 V6", "BM", 78, 0, 54, 40, 4, 2, 1, 24, 0, 24, 0, 0, 0, 0),
    pack("C*", map { (30 * $_) x 3 } 4 .. 7, 0 .. 3)' >steps.bmp
for order in "steps.pgm steps.ppm steps.pgm" "steps.ppm steps.ppm steps.pgm" "- steps.pgm steps.ppm" \
    "steps.pgm steps.ppm -"; do
    is "frames: no change between grey and colour, $order" \
        "$(hatchstat frames $order <steps.bmp | awk -F'\t' 'NR > 1 {print $3, $4, $5, $6}' | paste -sd,)" \
        "0 nan nan nan,0 0 0 0,0 0 nan nan,0 0 0 0"
done
awk 'BEGIN {print "P2\n16 16\n255"; for (i = 0; i < 256; i++) print 0}' >black.pgm
hatchstat frames black.pgm grey.ppm white.ppm >mixed.tsv
is "frames: means of grey and colour" "$(field mean <mixed.tsv | cut -c 1-5 | paste -sd' ')" "0.25 0.411 1 0.553"
is "frames: pop of grey and colour" "$(field pop <mixed.tsv | cut -c 1-5 | paste -sd' ')" "nan 0.426 nan 0.426"
try hatchstat frames black.pgm grey.ppm wide.ppm
refused "frames: pictures of two sizes" 3 1

# A 2 x 2 picture in formats that the plugin reads: red, green; blue, white.
printf 'P6\n2 2\n255\n\377\0\0\0\377\0\0\0\377\377\377\377' >colours.ppm
printf 'BM\106\0\0\0\0\0\0\0\066\0\0\0\050\0\0\0\2\0\0\0\2\0\0\0\1\0\030\0\0\0\0\0\020\0\0\0' >colours.bmp
printf '\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0' >>colours.bmp
printf '\377\0\0\377\377\377\0\0\0\0\377\0\377\0\0\0' >>colours.bmp
printf '\0\0\2\0\0\0\0\0\0\0\0\0\2\0\2\0\030\040\0\0\377\0\377\0\377\0\0\377\377\377' >colours.tga
for format in bmp tga; do
    is "$format is read like ppm" "$(hatchstat diff colours.$format colours.ppm | field max)" 0
done
# hdr AXES PIXEL ...: prints a Radiance file of 2 x 2 pixels
red='\200\0\0\201' green='\0\200\0\201' blue='\0\0\200\201' white='\200\200\200\201'
hdr() {
    printf '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n%s\n' "$1"
    printf "$2$3$4$5"
}
hdr '-Y 2 +X 2' $red $green $blue $white >colours.hdr
# webp HEX: prints a WebP file of lossless pixels
webp() {
    perl -e 'my $bytes = pack "H*", shift;
        print pack "a4 V a8 V a*", "RIFF", 12 + length $bytes, "WEBPVP8L", length $bytes, $bytes' "$1"
}
webp 2f014000001f201048de1f3a8df9171014fc1fddfc47640fe0060c11fd0f0100 >colours.webp
for format in ppm webp hdr; do
    is "$format is known by its content" "$(hatchstat diff - colours.bmp <colours.$format | field max)" 0
done
hdr '+Y 2 +X 2' $blue $white $red $green >up.hdr
hdr '-Y 2 -X 2' $green $red $white $blue >left.hdr
hdr '+Y 2 -X 2' $white $blue $green $red >up_left.hdr
for file in up left up_left; do
    is "hdr: rows may run $file" "$(hatchstat diff $file.hdr colours.bmp | field max)" 0
done
hdr '+X 2 -Y 2' $red $blue $green $white >columns.hdr
try hatchstat diff columns.hdr columns.hdr
refused "hdr: columns after one another" 3 1
ok "hdr: the message tells that they are columns" grep -q 'stored column by column' .err
cp colours.webp colours.jpg
is "webp is known under another name" "$(hatchstat diff colours.jpg colours.bmp | field max)" 0
# Pictures of four channels have transparency; more channels have no meaning here. A TIFF of one pixel of 8 bits each.
printf '\0\0\2\0\0\0\0\0\0\0\0\0\2\0\2\0\040\050\0\0\377\377\0\377\0\377\377\0\0\377\377\377\377\377' >alpha.tga
is "tga with transparency is read" "$(hatchstat diff alpha.tga alpha.tga | field max)" 0
# tif EXTRA VALUE ...: prints a TIFF file of one pixel of 8 bits each; EXTRA is the kind of channels after the third: 0
# none, 1 alpha by which colours are multiplied, 2 alpha
tif() {
    perl -e 'my ($extra, @values) = @ARGV; my $n = @values; my $at = 8; my $more = $at + 2 + 12 * 10 + 4;
        my @entries = ([256, 3, 1, 1], [257, 3, 1, 1], [258, 3, $n, $more], [259, 3, 1, 1], [262, 3, 1, 2],
            [273, 4, 1, $more + 2 * $n], [277, 3, 1, $n], [278, 3, 1, 1], [279, 4, 1, $n], [338, 3, $n - 3, $extra]);
        print pack("a2 v V v", "II", 42, $at, 10), map({ pack "v v V V", @$_ } @entries), pack("V v*", 0, (8) x $n),
            pack "C*", @values' "$@"
}
tif 2 255 255 255 255 >channels4.tif
tif 0 255 255 255 255 255 >channels5.tif
is "tif of four channels is read" "$(hatchstat diff channels4.tif channels4.tif | field max)" 0
try hatchstat diff channels5.tif channels5.tif
refused "a picture of five channels" 3 1
ok "the message tells how many" grep -q '5 channels, want 1 to 4' .err
# Codes that are multiplied by alpha: 17 of 51 is 85 of 255, and none is over 255.
tif 1 17 60 0 51 >multiplied.tif
tif 2 85 255 0 51 >straight.tif
is "colours of tif are divided by alpha where they are multiplied by it" \
    "$(hatchstat diff multiplied.tif straight.tif | field max)" 0
# Pixels of 200, 100, 50, 127 and 255, 0, 128, 51; OpenImageIO multiplies the codes by alpha and rounds them.
webp 2f010000100f30644ffe3fa0ec6798421a19d1ff0000 >alpha.webp
printf '\0\0\2\0\0\0\0\0\0\0\0\0\2\0\1\0\040\050\062\144\310\177\200\0\377\063' >alpha.tga
try hatchstat diff --srgb --max-difference 0.01 alpha.webp alpha.tga
is "colours of webp are not multiplied by alpha" $status 0
is "formats are recognised by content, not by name" \
    "$(hatchstat diff - colours.ppm <colours.bmp | field max)" 0
for format in ppm bmp tga; do
    size=$(wc -c <colours.$format)
    head -c $((size - 4)) colours.$format >"cut.$format"
    try hatchstat diff "cut.$format" colours.ppm
    refused "a truncated $format" 3 1
done
# OpenEXR files of kinds that only the plugin reads. Rows that a compression does not shorten are stored as they are, so
# that these files need none.
# exr COMPRESSION CHANNEL=VALUE ...: writes an OpenEXR file of 2 x 2 pixels of constant half floats, given in hexadecimal
exr() {
    perl -e 'my $compression = shift; my %value = map { split /=/ } @ARGV; my @names = sort keys %value;
        sub attribute { my ($name, $type, $data) = @_; "$name\0$type\0" . pack("V", length $data) . $data }
        my $list = join "", map { "$_\0" . pack "V C x3 V V", 1, 0, 1, 1 } @names;
        my $head = pack("V V", 20000630, 2) . attribute("channels", "chlist", "$list\0") .
            attribute("compression", "compression", pack "C", $compression) .
            attribute("dataWindow", "box2i", pack "V4", 0, 0, 1, 1) .
            attribute("displayWindow", "box2i", pack "V4", 0, 0, 1, 1) .
            attribute("lineOrder", "lineOrder", "\0") . attribute("pixelAspectRatio", "float", pack "f", 1) .
            attribute("screenWindowCenter", "v2f", pack "f2", 0, 0) .
            attribute("screenWindowWidth", "float", pack "f", 1) . "\0";
        my $row = join "", map { pack "v2", (hex $value{$_}) x 2 } @names;
        my @rows = $compression ? ($row x 2) : ($row, $row);
        my $at = length($head) + 8 * @rows;
        print $head, map({ my $here = $at; $at += 8 + length; pack "Q<", $here } @rows);
        print pack("V V", $_, length $rows[$_]), $rows[$_] for 0 .. $#rows' "$@"
}
exr 0 R=3800 G=3c00 B=3400 >plain.exr
for compression in 5 6 7 8 9; do
    exr $compression R=3800 G=3c00 B=3400 >lossy.exr
    is "an OpenEXR file of compression $compression" "$(hatchstat diff lossy.exr plain.exr | field max)" 0
done
# In a display window that has a row above and a column to the left, 4 of 9 pixels are theirs: 4 (0.5 + 1 + 0.25) / 27.
exr 7 R=3800 G=3c00 B=3400 >lossy.exr
flat black3.ppm 0 3 3
for file in plain lossy; do
    perl -0777 -pe 's/(displayWindow.box2i.{5}).{16}/$1 . pack "l<4", -1, -1, 1, 1/es' $file.exr >"$file.framed.exr"
    is "$file.exr in a larger display window" "$(hatchstat diff "$file.framed.exr" black3.ppm | field mean)" 0.259259259
done
is "both are placed alike" "$(hatchstat diff plain.framed.exr lossy.framed.exr | field max)" 0
exr 0 L.R=3800 L.G=3c00 L.B=3400 >layer.exr
is "an OpenEXR file with a layer" "$(hatchstat diff layer.exr plain.exr | field max)" 0
exr 0 R=3800 G=3c00 B=3400 L.R=0 L.G=0 L.B=0 M.R=0 M.G=0 M.B=0 >many.exr
is "an OpenEXR file of nine channels" "$(hatchstat diff many.exr plain.exr | field max)" 0
exr 0 Y=3400 A=3800 >alpha.exr
exr 6 Y=3400 A=3800 >lossy.exr
is "an OpenEXR file of a compression that loses, with alpha" "$(hatchstat diff lossy.exr alpha.exr | field max)" 0
exr 0 Y=3800 >opaque.exr
is "colours are divided by alpha once" "$(hatchstat diff lossy.exr opaque.exr | field max)" 0.5
exr 5 X=3800 >lossy.exr
try hatchstat diff lossy.exr lossy.exr
refused "an OpenEXR file without colours" 3 1
# A row of 2^24 pixels, of which 256 rows are compressed together.
exr 9 R=3800 G=3c00 B=3400 | perl -0777 -pe 's/(dataWindow.box2i.{13}).{8}/$1\xff\xff\xff\0\0\0\0\0/s' >wide.exr
try hatchstat diff --max-memory 1G wide.exr wide.exr
refused "an OpenEXR file whose chunks need too much memory" 5 1
exr 5 R=3800 G=3c00 B=3400 | head -c 330 >lossy.exr
try hatchstat diff lossy.exr lossy.exr
refused "a truncated OpenEXR file of a compression that loses" 3 1
printf '\377\330\377\300\0\021\10\377\334\377\334\3\1\042\0\2\021\1\3\021\1\377\332' >huge.jpg
try hatchstat diff huge.jpg huge.jpg
refused "a JPEG header of 65500 x 65500" 5 1
if [ -z "$SANITIZE" ]; then
    ms=$(milliseconds 50 hatchstat diff huge.jpg huge.jpg)
    [ "$ms" -le 50 ]
    is "the JPEG header is refused within 50 ms ($ms)" $? 0
fi
printf 'neither this nor that' >text.foo
try hatchstat diff text.foo text.foo
refused "an unknown format" 3 1

# A plugin for which there is no room; without the limit of the address space, it is opened.
if [ -z "$SANITIZE" ]; then
    for limit in 150000 400000 440000; do
        try sh -c "ulimit -v $limit && exec hatchstat diff grey.ppm grey.ppm"
        refused "an address space of $limit KiB" 5 1
        ok "an address space of $limit KiB: the message says so" grep -q 'the plugin .* needs 512 MB of address' .err
    done
    try sh -c "ulimit -v 900000 && exec hatchstat diff grey.ppm grey.ppm"
    is "an address space of 900000 KiB is enough" $status 0
fi

mkdir -p bin lib/hatch
echo 'no plugin' >lib/hatch/hatch-oiio.so
cp "$BIN/hatchstat" bin
try bin/hatchstat diff grey.ppm grey.ppm
refused "the plugin is damaged" 4 1
rm lib/hatch/hatch-oiio.so
try bin/hatchstat diff grey.ppm grey.ppm
refused "the plugin is missing" 3 1
finish
