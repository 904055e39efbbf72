# tampack: names of files and folders, layouts, refusals and warnings.
. "${TOP:-.}/tests/tap.sh"
command -v tampack >/dev/null || { skip "packing" "no tampack"; finish; }
tamgen --size 64 --tones 5 --levels 2 -o map.exr
tamgen --size 64 --tones 3 --levels 1 --ids -o three.exr

files() {
    (cd "$1" && find . -type f | LC_ALL=C sort | sed 's|^\./||' | paste -sd' ')
}

mkdir rgb png exr folder
try tampack map.exr -o rgb/map.ktx2
is "five tones make two textures" "$status $(files rgb) $(wc -c <.err)" "0 map.0.ktx2 map.1.ktx2 0"
try tampack map.exr -o -
refused "two textures do not go to standard output" 2 2
is "nor to files of that name" "$(ls -A | grep -c '^-')" 0
try tampack map.exr -o rgb/bare
is "a name without an extension gets one" "$(ls rgb/bare*)" "rgb/bare.0.ktx2
rgb/bare.1.ktx2"
try tampack -q map.exr -o folder
is "in a folder textures are named after the map" "$(files folder)" "map.0.ktx2 map.1.ktx2"
try tampack - -o folder/ <map.exr
is "in a folder textures of standard input are named tam" "$(files folder)" \
    "map.0.ktx2 map.1.ktx2 tam.0.ktx2 tam.1.ktx2"
mkdir far hidden
try tampack -q "$PWD/map.exr" -o far
is "also after a map that lies elsewhere" "$(files far)" "map.0.ktx2 map.1.ktx2"
try tampack -q map.exr -o hidden/.map
is "a leading dot begins no ending" "$(files hidden)" ".map.0.ktx2 .map.1.ktx2"
cmp -s folder/map.1.ktx2 rgb/map.1.ktx2
is "the name of the output does not change the bytes" $? 0
try tampack -q three.exr -o one.ktx2
is "a single file has exactly the given name" "$status $(find . -name 'one*' | paste -sd' ')" "0 ./one.ktx2"
mkdir alone
for layout in rgb array dds; do
    try tampack -q --layout $layout three.exr -o alone/
done
try tampack -q - -o alone/ <three.exr
is "in a folder a single file is named after the map" "$(files alone)" "tam.ktx2 three.dds three.ktx2"
try tampack map.exr
refused "two files to standard output" 2 2

try tampack --layout png map.exr -o png/map.png
is "a picture for each tone and level" "$(find png -name 'map.00[0-4].0[0-6].png' | wc -l)" 35
grep -q 'warning: .*mip levels' .err
is "PNG pictures of levels are warned of" "$? $(wc -l <.err)" "0 1"
is "pictures of level 1 are half as wide as those of level 0" \
    "$(od -An -tu1 -j16 -N8 png/map.002.01.png | tr -d ' ')" 0003200032
tamgen -q --size 64 --tones 1 --levels 2 -o single.exr
mkdir single
try tampack -q --layout png single.exr -o single/as.png
is "pictures of a map of one tone" "$status $(files single)" "0 $(printf 'as.000.%02d.png\n' 0 1 2 3 4 5 6 | paste -sd' ')"
tamgen -q --size 64 --tones 2 --levels 1 --palette dusk -o color.exr
mkdir color
tampack -q --layout png color.exr -o color/as.png
tampack -q --layout exr color.exr -o color/as.exr
is "pictures have the colours of the map" "$(for tone in 000 001; do
    hatchstat diff color/as.$tone.exr color/as.$tone.00.png
done | awk '$1 != "max" {print $1 < 0.005}' | paste -sd' ')" "1 1"
try tampack -q --layout png map.exr -o png/quiet
is "--quiet prints nothing" "$(wc -c <.err)" 0

try tampack -q --layout exr three.exr -o exr/three.exr
is "an EXR file for each tone" "$(files exr)" "three.000.exr three.001.exr three.002.exr"
try tampack -q --layout array three.exr -o array.ktx2
try tampack --layout array three.exr -o array.ktx2
is "ids that are left out are warned of" "$(grep -c 'ids are left out' .err)" 1
try tampack --layout exr --ink 1 three.exr -o exr/x
refused "--ink with EXR" 2 2
try tampack --layout rgb rgb/map.0.ktx2 -o x
refused "a texture instead of a map" 3 1

tampack -q --layout array --ink 0 map.exr -o paper.ktx2
tampack -q --layout array --ink 1 map.exr -o ink.ktx2
tail -c 20480 paper.ktx2 | od -An -v -tu1 -w1 >paper
tail -c 20480 ink.ktx2 | od -An -v -tu1 -w1 >ink
# (Halves are rounded up in both.)
is "--ink 1 is the inverse of --ink 0" \
    "$(paste paper ink | awk '$1 + $2 < 255 || $1 + $2 > 256' | wc -l)" 0

# When one of several outputs cannot be written, none is left.
mkdir some
(ulimit -f 8; trap '' XFSZ; try tampack map.exr -o some/map.ktx2; exit $status)
is "no output is left when one cannot be written" "$? $(files some)" "4 "
finish
