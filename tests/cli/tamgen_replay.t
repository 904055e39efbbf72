# tamgen --replay, --palette and styles in colour, and what the other commands make of such maps.
. "${TOP:-.}/tests/tap.sh"
drawing=$TOP/tests/drawings/hatching.svg

try sh "$TOP/tests/drawings/hatching.sh"
ok "the drawing is what its script draws" cmp .out "$drawing"

try tamgen --replay "$drawing" --size 128 --fit --strokes drawn.tsv -x sheet.png -o drawn.exr
is "a drawing is replayed" $status 0
ok "strokes outside the page are told of" grep -q 'warning: 15 of 540 strokes lie outside the page$' .err
ok "so is the tone, with its bound" grep -qE '^tamgen: tone within 0\.0[0-9]+ \(bound 0\.[0-9]+\) on every level$' .err
ok "and the hue" grep -qE "^tamgen: chroma within 0\.[0-9]+, hue within [0-9.]+ degrees of the finest level's\$" .err
is "and nothing else" "$(wc -l <.err)" 3
is "the script has a column for drawn lines" "$(head -1 drawn.tsv | cut -f14- | tr '\t' ' ')" path
hatchstat tam drawn.exr --strokes drawn.tsv -o figures.tsv
is "every stroke is where it is to be" "$(tail -1 figures.tsv | cut -f10,11)" "0	0"
ok "and the hue of every image is within 2 degrees" awk -F"\t" 'END {exit !($23 < 2)}' figures.tsv

tamgen --replay drawn.tsv --style drawing --size 128 --fit --quiet -o again.exr
ok "its script replays to the same map" cmp drawn.exr again.exr
tamgen --replay - --size 128 --fit --quiet -o piped.exr <"$drawing"
ok "a drawing may be piped" cmp drawn.exr piped.exr
tamgen --replay "$drawing" --size 128 --quiet -o first.exr
tamgen --replay "$drawing" --size 128 --quiet --keep .5 -o kept.exr
tamgen --replay "$drawing" --size 128 --quiet --keep .5 --seed 2 -o other.exr
ok "--keep keeps others than the first" sh -c '! cmp -s first.exr kept.exr'
ok "and which follows from the seed" sh -c '! cmp -s other.exr kept.exr'

try tamgen --replay "$drawing" --size 64 --tones 10 --set 'darkest .9' -o light.exr
ok "a drawing too light for what is asked is told of" grep -qE \
    'warning: the whole drawing has a tone of 0\.6[0-9]+: 3 of 10 columns should be darker and hold all strokes$' .err

tamgen --size 64 --strokes ink.tsv -o ink.exr
tamgen --size 64 --replay ink.tsv --palette sea --fit --quiet --strokes sea.tsv -o sea.exr
hatchstat tam sea.exr --strokes sea.tsv -o figures.tsv
is "a palette colours a script" "$(tail -1 figures.tsv | cut -f10,11)" "0	0"
ok "from light to dark" sh -c 'tail -n +2 sea.tsv | awk -F"\t" "NR == 1 {g = \$8; b = \$9} END {exit !(\$8 < g && \$9 < b)}"'

for style in speckle arcs; do
    tamgen --size 64 --style $style --palette earth --ids --strokes strokes.tsv -o map.exr
    hatchstat tam map.exr --strokes strokes.tsv -o figures.tsv
    is "$style in a palette" "$(tail -1 figures.tsv | cut -f8,10,11)" "yes	0	0"
done
is "arcs have a column" "$(head -1 strokes.tsv | cut -f14)" bend
printf 'color 0 ff0000\ncolor 1 000000\n' >own.palette
tamgen --size 64 --tones 1 --palette own.palette --strokes red.tsv -o red.exr
is "a palette of one's own: linear light, by the tone" "$(sed -n 2p red.tsv | cut -f7-9)" "0.100000024	0	0"

tampack --layout array -q map.exr -o map.ktx2
is "tampack: a coloured array is RGBA8" "$(od -An -tu4 -j12 -N4 map.ktx2 | tr -d ' ')" 37
tampack --layout png -q map.exr -o picture
is "tampack: and its pictures are RGB" "$(od -An -tu1 -j25 -N1 picture.000.00.png | tr -d ' ')" 2
try tampack --layout rgb map.exr -o packed
refused "tampack: three tones of it are no texture" 3 1
meshgen sphere --faces 500 -o sphere.glb
render-gl sphere.glb --tam red.exr --technique tam-triple --size 48x48 -o color.png
render-gl sphere.glb --tam red.exr --technique tam --size 48x48 -o grey.png
ok "render-gl: tam-triple draws the colours" sh -c '! cmp -s color.png grey.png'

for wrong in '--keep .5' '--fit' "--replay $drawing --keep 0" "--replay $drawing --keep 1.1" \
    "--replay $drawing --keep .5 --fit" "--replay $drawing --growth .5" "--replay $drawing --method field" \
    '--palette nonesuch' '--style nonesuch'; do
    try tamgen $wrong -o x.exr
    refused "$(echo "$wrong" | sed 's|[^ ]*/||') is wrong usage" 2 2
done
try tamgen --palette own.palette --set 'color 0.5 xyz' -o x.exr
refused "a colour that is none" 2 2
echo 'width 3' >no.palette
try tamgen --palette ./no.palette -o x.exr
refused "a palette without colours" 3 1
ok "nothing was left by any of these" test ! -e x.exr
finish
