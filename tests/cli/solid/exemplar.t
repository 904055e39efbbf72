# solidgen --exemplar and hatchstat solid: what pictures they take, what they refuse and warn of.
. "${TOP:-.}/tests/tap.sh"

# picture FILE WIDTH HEIGHT LARGEST: writes a PGM of blots, with values of 0 .. LARGEST
picture() {
    awk -v width="$2" -v height="$3" -v largest="$4" 'BEGIN {
        printf "P2\n%d %d\n%d\n", width, height, largest
        for (y = 0; y < height; y++)
            for (x = 0; x < width; x++)
                print int(((int(x / 3) * 37 + int(y / 3) * 91) % 16) * largest / 15) }' >"$1"
}
# tiff FILE PIXEL ...: writes 24 by 24 pixels of floats; each pixel is a list of channels, and the last one is repeated
tiff() {
    perl -e 'my ($file, @pixels) = @ARGV;
        my $channels = split /,/, $pixels[0];
        my $data = join "", map {pack "f<*", split /,/, $pixels[$_ < @pixels ? $_ : -1]} 0 .. 575;
        my @tags = ([256, 24], [257, 24], [258, 32], [259, 1], [262, $channels < 3 ? 1 : 2], [273, 8], [277, $channels],
            [278, 24], [279, length $data], [339, 3]);
        $tags[2] = [258, 32];
        my @extra = $channels == 4 ? ([338, 2]) : ();
        @tags = sort {$$a[0] <=> $$b[0]} @tags, @extra;
        open my $to, ">:raw", $file or die;
        print $to "II*\0", pack("V", 8 + length $data), $data, pack("v", scalar @tags),
            (map {pack "vvVV", $$_[0], 4, 1, $$_[1]} @tags), pack "V", 0' "$@"
}
# make OUTPUT [OPTION ...]: a small texture, quickly
make() {
    made=$1
    shift
    try solidgen --size 8 --iterations 1 "$@" -o "$made"
}
# figure NAME FILE [REFERENCE]
figure() {
    hatchstat solid -q "$2" ${3:+--reference "$3"} |
        awk -F'\t' -v name="$1" 'NR == 1 {for (i = 1; i <= NF; i++) at[$i] = i} NR == 2 {print $at[name]}'
}

picture eight.pgm 40 40 255
picture sixteen.pgm 40 40 65535
make eight.ktx2 --exemplar eight.pgm
is "a grey picture makes a grey texture" "$status $(figure channels eight.ktx2)" "0 1"
make sixteen.ktx2 --exemplar sixteen.pgm
is "a picture of 16 bits has the values of one of 8" "$status $(figure histogram sixteen.ktx2 eight.pgm | awk '{print ($1 < 0.06)}')" "0 1"
make threads.ktx2 --exemplar eight.pgm --threads 3
ok "three threads make the same texture" cmp eight.ktx2 threads.ktx2
make other.ktx2 --exemplar eight.pgm --seed 2
is "another seed makes another one" "$(cmp -s eight.ktx2 other.ktx2; echo $?)" 1
make pyramid.ktx2 --exemplar eight.pgm --method pyramid
is "pyramids have the picture's histogram" "$status $(figure histogram pyramid.ktx2 eight.pgm | awk '{print ($1 < 0.06)}')" "0 1"
make all.ktx2 --exemplar eight.pgm --exhaustive --axes xy -v
is "-v reports levels, neighbourhoods and size" "$(sed 's/[0-9][0-9.]*/N/g' .err | tr '\n' '|')" \
    "solidgen: N level, N iteration|solidgen: neighbourhoods of NxN pixels, mean difference to those of the picture N|solidgen: N texels along a side, N channel; N bytes|"
solidgen --size 8 --slices slices.png -o /dev/null
make file.ktx2 --exemplar slices.png
make pipe.ktx2 --exemplar - <slices.png
ok "a picture comes through a pipe" cmp file.ktx2 pipe.ktx2

tiff nan.tif 0.5 nan inf 0.5
make nan.ktx2 --exemplar nan.tif
is "numbers that are not finite become 0, with a warning" "$status $(cat .err)" \
    "0 solidgen: nan.tif: warning: 2 numbers are not finite: replaced by 0"
tiff alpha.tif 0.2,0.4,0.6,0 0.2,0.4,0.6,1
make alpha.ktx2 --exemplar alpha.tif
is "alpha is ignored" "$status $(figure channels alpha.ktx2) $(figure mean_g alpha.ktx2)" "0 3 0.4"
tiff dark.tif -1,7,0.5
make dark.ktx2 --exemplar dark.tif
is "values are clamped to 0 .. 1" "$(figure mean_r dark.ktx2) $(figure mean_g dark.ktx2)" "0 1"

picture wide.pgm 30000 20 255
make wide.ktx2 --exemplar wide.pgm
is "of a long picture the middle is used, with a warning" "$status $(cat .err)" \
    "0 solidgen: wide.pgm: warning: 30000x20 pixels are too many for --size 8: the middle 128x20 are used"
picture large.pgm 600 300 255
make large.ktx2 --exemplar large.pgm
is "a large picture is halved, with a warning" "$status $(cat .err)" \
    "0 solidgen: large.pgm: warning: 600x300 pixels are too many for --size 8: the resolution is halved, the middle 128x75 are used"
picture dot.pgm 1 1 255
make dot.ktx2 --exemplar dot.pgm
is "one pixel makes a texture of one value" "$status $(figure deviation_r dot.ktx2) $(figure neighborhood dot.ktx2 dot.pgm)" "0 0 0"

make x.ktx2 --exemplar eight.pgm --style wood
refused "a style and a picture" 2 2
make x.ktx2
refused "--iterations without a picture" 2 2
make x.ktx2 --exemplar eight.pgm --method pyramid --neighborhood 5
is "pyramids have no neighbourhoods" "$status $(head -n 1 .err)" "2 solidgen: --neighborhood needs --method kopf"
make x.ktx2 --exemplar missing.png
refused "a picture that is missing" 4 1
echo text >text.png
make x.ktx2 --exemplar text.png
refused "text in place of a picture" 3 1
for method in kopf pyramid; do
    try solidgen --exemplar eight.pgm --method $method --size 512 --max-memory 200M -o x.ktx2
    refused "$method: too much memory is refused" 5 1
done
ok "nothing is left of what was refused" test ! -e x.ktx2

solidgen --style wood --size 16 -o wood.ktx2
is "a texture of a style has no figures of a picture" \
    "$(figure size wood.ktx2) $(figure channels wood.ktx2) $(figure histogram wood.ktx2) $(figure neighborhood wood.ktx2)" \
    "16 3 nan nan"
ok "hatchstat solid reads standard input" sh -c 'hatchstat solid <wood.ktx2 >wood.tsv'
solidgen --style wood --size 16 -o wood.exr
is "slices in OpenEXR are measured as KTX2" "$(hatchstat solid wood.exr)" "$(cat wood.tsv)"
head -c 1000 wood.exr >cut.exr
try hatchstat solid cut.exr
is "hatchstat solid says how a file is damaged" "$status $(cat .err)" \
    "3 hatchstat: cut.exr: the OpenEXR file is damaged: end of file attempting to read header"
try hatchstat solid slices.png
refused "hatchstat solid wants no picture" 3 1
is "hatchstat solid says what it wants" "$(cat .err)" "hatchstat: slices.png: neither KTX2 nor slices in OpenEXR"
try hatchstat solid eight.ktx2 --reference missing.png
refused "a reference that is missing" 4 1
finish
