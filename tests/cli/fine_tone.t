# tamvol and tamthresh: sizes, layouts, accuracy, refusals and warnings.
. "${TOP:-.}/tests/tap.sh"
command -v tamvol >/dev/null && command -v tamthresh >/dev/null || { skip "fine tones" "no tamvol"; finish; }

# u32 FILE OFFSET: prints a number of a KTX2 header
u32() {
    od -An -tu4 -j "$2" -N 4 "$1" | tr -d ' '
}
# shape FILE: prints VkFormat, width, height, depth, layers, levels
shape() {
    for offset in 12 20 24 28 32 40; do
        u32 "$1" $offset
    done | paste -sd' '
}
tamgen --tones 255 -o map.exr
tamgen --size 64 --tones 3 --levels 2 --ids -o few.exr

# A map of one column has fewer steps than there are bins.
tamgen -q --size 64 --tones 1 -o one.exr
tamthresh -q one.exr -o one.ktx2
is "bins rise from 0 to 1" "$(perl -0777 -ne 'print $1 if /hatch:bins\0([^\0]*)/' one.ktx2 | awk '
    {for (i = 2; i <= NF; i++) rising += $i > $(i - 1)} END {print $1, $NF, (NF > 2 && rising == NF - 1)}')" "0 1 1"

try tamvol map.exr -o volume.ktx2
is "a volume has the size given in the paper" "$status $(shape volume.ktx2) $(wc -c <.err)" "0 9 256 256 64 0 9 0"
try tamvol --tones 16 map.exr -o coarse.ktx2
is "levels of few slices are warned of" "$status $(cat .err)" "0 tamvol: map.exr: warning: strokes of 1 of 4 levels are \
grey, because these have fewer than 4 slices: want --layout array, or more --tones"
try tamvol --tones 2 --layout array map.exr -o two.ktx2
is "all slices of an array are on all levels" "$status $(wc -c <.err)" "0 0"
try tamvol --tones 32 --layout array map.exr -o array.ktx2
is "--layout array makes a texture array" "$status $(shape array.ktx2)" "0 9 256 256 0 32 9"
try tamvol --compress map.exr -o packed.ktx2
is "--compress makes BC4 blocks" "$status $(shape packed.ktx2)" "0 139 256 256 0 64 9"
tamgen --tones 64 --palette dusk --set 'darkest 1' --candidates 100:50 -o colour.exr
try tamvol -v --compress colour.exr -o colour.ktx2
is "--compress makes BC1 blocks of colours" "$status $(shape colour.ktx2)" "0 131 256 256 0 64 9"
is "-v reports the compression error" "$(grep -c 'compression error: 0\.[0-9]* at most, 0\.[0-9]* root mean square' .err)" 1
try tamvol -q --compress --layout volume --tones 16 colour.exr -o seven.ktx2
is "--compress --layout volume makes BC7 blocks of colours" "$status $(shape seven.ktx2)" "0 145 256 256 16 0 9"
try tamthresh map.exr -o thresholds.ktx2
is "tamthresh makes an array of RGBA8" "$status $(shape thresholds.ktx2) $(wc -c <.err)" "0 37 256 256 0 4 9 0"
try tamthresh --exact map.exr -o exact.ktx2
is "tamthresh --exact makes a texture of words" "$status $(shape exact.ktx2 | cut -d' ' -f1,2,4-)" "0 98 1024 0 0 1"

# Issue 5, memory of a map of 256² in 255 tones, in thousands of bytes.
at_most() {
    size=$(wc -c <"$2")
    [ "$size" -le "$(($1 * 1000))" ]
    is "$2 takes at most $1 kB ($size bytes)" $? 0
}
at_most 15000 volume.ktx2
at_most 4000 packed.ktx2
at_most 4000 colour.ktx2
at_most 1800 thresholds.ktx2
at_most 4000 exact.ktx2

# figures FILE [MAP]: prints the largest value of each figure over the levels of detail
figures() {
    hatchstat tones "$1" --reference "${2:-map.exr}" --samples 20000 -o figures.tsv
    awk -F'\t' 'NR > 1 {for (i = 3; i <= NF; i++) if ($i > most[i]) most[i] = $i}
        END {for (i = 3; i <= NF; i++) printf "%s ", most[i]}' figures.tsv
}
# below NAME VALUE LIMIT
below() {
    is "$1 ($2 < $3)" "$(awk -v a="$2" -v b="$3" 'BEGIN {print (a < b)}')" 1
}
tamvol -q --layout array --tones 8 map.exr -o eight.ktx2
set -- $(figures exact.ktx2)
below "exact runs are within 1/255 of the map" "$4" 0.00392
set -- $(figures packed.ktx2)
below "blocks: mean error" "$3" 0.02
below "blocks: tone" "$1" 0.005
set -- $(figures colour.ktx2 colour.exr)
below "blocks of colour: mean error" "$3" 0.03
below "blocks of colour: tone" "$1" 0.005
grey() {
    figures "$1" >/dev/null
    awk -F'\t' 'NR > 1 {sum += $7} END {print sum / (NR - 1)}' figures.tsv
}
below "thresholds have fewer grey strokes than a volume" "$(grey thresholds.ktx2)" "$(grey volume.ktx2)"
below "a volume has fewer than eight blended columns" "$(grey volume.ktx2)" "$(grey eight.ktx2)"

try tamvol few.exr -o few.ktx2
is "a map of few tones is warned of, with figures" \
    "$status $(sed 's/[0-9]* of 96/N of 96/; s/0\.[0-9]* away/X away/' .err | grep -v 'ids are left out')" \
    "0 tamvol: few.exr: warning: N of 96 slices are blends of two columns, because the nearest column is up to X away in\
 tone: 3 columns are too few for 64 tones"
is "ids that are left out are warned of" "$(grep -c 'ids are left out' .err)" 1
tamgen --size 64 --tones 1 --levels 2 -o one.exr
try tamvol one.exr -o x
refused "a map with too few tones" 3 1
try tamvol --tones 48 map.exr -o x
refused "a number of tones that is no power of two" 2 2
try tamvol --compress --layout volume map.exr -o x.ktx2
refused "--compress --layout volume with a grey map" 2 2
try tamvol --compress map.exr -o x.exr
refused "--compress with EXR" 2 2
try tamvol map.exr -o x.png
refused "an unknown file name extension" 2 2

for bins in 0 8 1.5 .5,.4 0,.5 .5,1 nan .5,nan .5, , '' x .1,.2,.3,.4,.5,.6,.7; do
    try tamthresh --bins "$bins" map.exr -o x
    refused "--bins '$bins'" 2 2
done
tamthresh --bins 1 map.exr -o one.ktx2
is "--bins may be 1" "$? $(grep -ac 'hatch:bins.0 1' one.ktx2)" "0 1"
try tamthresh --bins .5,.8 map.exr -o bins.ktx2
is "--bins sets the tones of the bins" "$status $(grep -ac 'hatch:bins.0 0.5 0.8 1' bins.ktx2)" "0 1"
try tamthresh --exact --bins 3 map.exr -o x
refused "--exact with --bins" 2 2
try tamthresh --exact map.exr -o x.exr
refused "--exact with EXR" 2 2
tamthresh --seed 2 map.exr -o other.ktx2
ok "another random seed gives other thresholds" test "$(cmp -l other.ktx2 thresholds.ktx2 | wc -l)" -gt 100
meshgen plane --faces 2 | render-gl - --technique gouraud --size 32x32 -o picture.png
try tamthresh --modulate picture.png --mask picture.png map.exr -o pictures.ktx2
is "--modulate and --mask fill the spare channels" "$status $(cmp -s pictures.ktx2 thresholds.ktx2; echo $?)" "0 1"
try tamthresh --mask nonesuch.png map.exr -o x
refused "a missing picture" 4 1

# OpenEXR is for looking at textures.
tamvol -q --tones 16 few.exr -o volume.exr
tamthresh -q few.exr -o thresholds.exr
try hatchstat tones volume.exr --reference map.exr
is "hatchstat refuses a volume in OpenEXR" "$status $(cat .err)" "3 hatchstat: volume.exr: not a tonal art map, but a \
volume; volumes are read in KTX2 only: tamvol -o FILE.ktx2"
try hatchstat tones thresholds.exr --reference map.exr
is "and thresholds" "$status $(cat .err)" "3 hatchstat: thresholds.exr: not a tonal art map, but thresholds, which are \
read in KTX2 only: tamthresh -o FILE.ktx2"
try tamvol volume.exr -o x
refused "a volume instead of a map" 3 1

# Parts of an EXR file are its slices, and its layers.
if command -v exrheader >/dev/null; then
    is "EXR has a part for each slice" "$(exrheader volume.exr | grep -c 'name (type string): "slice.0')" 16
    is "EXR has a part for each layer" \
        "$(exrheader thresholds.exr | sed -n 's/^name (type string): "\(.*\)"/\1/p' | paste -sd' ')" "x.0 x.1 dy.0 dy.1"
else
    skip "parts of EXR files" "no exrheader"
fi
try hatchstat tones volume.ktx2
refused "tones without a reference" 2 2
try hatchstat tones map.exr --reference volume.ktx2
refused "a reference that is no map" 3 1
rm -f x
try tamthresh volume.ktx2 -o x
refused "a texture instead of a map" 3 1
finish
