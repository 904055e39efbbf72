# tampack: names of files, folders, what is kept and what is warned of.
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
try tampack map.exr -o rgb/bare
is "a name without an ending gets one" "$(ls rgb/bare*)" "rgb/bare.0.ktx2
rgb/bare.1.ktx2"
try tampack -q map.exr -o folder
is "a folder takes the name of the map" "$(files folder)" "map.0.ktx2 map.1.ktx2"
try tampack - -o folder/ <map.exr
is "from standard input the name is tam" "$(files folder)" \
    "map.0.ktx2 map.1.ktx2 tam.0.ktx2 tam.1.ktx2"
cmp -s folder/map.1.ktx2 rgb/map.1.ktx2
is "the same bytes by every name" $? 0
try tampack -q three.exr -o one.ktx2
is "one file takes the name as it is" "$status $(find . -name 'one*' | paste -sd' ')" "0 ./one.ktx2"
try tampack map.exr
refused "two files and no name" 2 2

try tampack --layout png map.exr -o png/map.png
is "a picture for each tone and level" "$(find png -name 'map.00[0-4].0[0-6].png' | wc -l)" 35
grep -q 'warning: .*mip levels' .err
is "importers that make their own levels are warned of" "$? $(wc -l <.err)" "0 1"
is "level 1 is half of level 0" \
    "$(od -An -tu1 -j16 -N8 png/map.002.01.png | tr -d ' ')" 0003200032
try tampack -q --layout png map.exr -o png/quiet
is "--quiet says nothing" "$(wc -c <.err)" 0

try tampack -q --layout exr three.exr -o exr/three.exr
is "an EXR file for each tone" "$(files exr)" "three.000.exr three.001.exr three.002.exr"
try tampack -q --layout array three.exr -o array.ktx2
try tampack --layout array three.exr -o array.ktx2
is "ids that are left out are told" "$(grep -c 'ids are left out' .err)" 1
try tampack --layout exr --ink 1 three.exr -o exr/x
refused "--ink with EXR" 2 2
try tampack --layout rgb rgb/map.0.ktx2 -o x
refused "a file that is no map" 3 1

tampack -q --layout array --ink 0 map.exr -o paper.ktx2
tampack -q --layout array --ink 1 map.exr -o ink.ktx2
tail -c 20480 paper.ktx2 | od -An -v -tu1 -w1 >paper
tail -c 20480 ink.ktx2 | od -An -v -tu1 -w1 >ink
# (A half of a step is rounded up in both.)
is "ink as 1 is 255 less paper as 1" \
    "$(paste paper ink | awk '$1 + $2 < 255 || $1 + $2 > 256' | wc -l)" 0

# Of several outputs none is left when one cannot be written.
mkdir some
(ulimit -f 8; trap '' XFSZ; try tampack map.exr -o some/map.ktx2; exit $status)
is "no room: nothing is left" "$? $(files some)" "4 "
finish
