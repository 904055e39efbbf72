# tamgen --replay, --palette and styles in colour, and coloured maps in the other commands.
. "${TOP:-.}/tests/tap.sh"
drawing=$TOP/pipelines/hatching.svg

try sh "$TOP/tests/drawings/hatching.sh"
ok "the drawing equals the output of its script" cmp .out "$drawing"

try tamgen --replay "$drawing" --size 128 --fit --strokes drawn.tsv -x sheet.png -o drawn.exr
is "a drawing is replayed" $status 0
ok "strokes outside the page are warned of" grep -q 'warning: 15 of 540 strokes lie outside the page$' .err
ok "-v reports the error of tone and its bound" grep -qE '^tamgen: tone within 0\.0[0-9]+ \(bound 0\.[0-9]+\) on every level$' .err
ok "-v reports errors of chroma and hue" grep -qE "^tamgen: chroma within 0\.[0-9]+, hue within [0-9.]+ degrees of the finest level's\$" .err
is "no other message is printed" "$(wc -l <.err)" 3
is "the table has a column for drawn lines" "$(head -1 drawn.tsv | cut -f14- | tr '\t' ' ')" path
hatchstat tam drawn.exr --strokes drawn.tsv -o figures.tsv
is "no stroke is missing from the images, and no pixel is lighter" "$(tail -1 figures.tsv | cut -f10,11)" "0	0"
ok "the hue of every image is within 2 degrees" awk -F"\t" 'END {exit !($23 < 2)}' figures.tsv

tamgen --replay drawn.tsv --style drawing --size 128 --fit --quiet -o again.exr
ok "replaying the table of strokes gives the same map" cmp drawn.exr again.exr
tamgen --replay - --size 128 --fit --quiet -o piped.exr <"$drawing"
ok "a drawing from a pipe gives the same map" cmp drawn.exr piped.exr
tamgen --replay "$drawing" --size 128 --quiet -o first.exr
tamgen --replay "$drawing" --size 128 --quiet --keep .5 -o kept.exr
tamgen --replay "$drawing" --size 128 --quiet --keep .5 --seed 2 -o other.exr
ok "--keep draws other strokes than the first ones" sh -c '! cmp -s first.exr kept.exr'
ok "the strokes that --keep draws depend on the random seed" test "$(cmp -l other.exr kept.exr 2>&1 | wc -l)" -gt 100

try tamgen --replay "$drawing" --size 64 --tones 10 --set 'darkest .9' -o light.exr
ok "a drawing too light for its targets is warned of" grep -qE \
    'warning: the whole drawing has a tone of 0\.6[0-9]+: 3 of 10 columns are meant to be darker, and hold all its strokes$' .err

# Of two columns, a wide stroke makes the first one far too dark, and leaves the last .02 too light.
printf 'x\ty\tlength\tangle\twidth\ttone\tr\tg\tb\n.5\t.5\t1\t0\t.3\t1\t0\t0\t0\n' >wide.tsv
whole=$(tamgen -v --size 64 --levels 1 --tones 1 --replay wide.tsv -o wide.exr 2>&1 | sed -n 's/.* tone up to //p')
try tamgen --size 64 --levels 1 --tones 2 --replay wide.tsv --set "darkest $(echo "$whole" | awk '{print $1 + .02}')" -o wide.exr
is "how much images are too light is that of the lightest: $whole" \
    "$(sed -n 's/.*1 image stays lighter than the target, by up to \(0...\).*/\1/p' .err)" 0.02

# However thin a stroke of a drawing is, its script can be read.
echo '<svg viewBox="0 0 1000 1000"><path fill="none" stroke="black" stroke-width="1e-7" d="M20 800L800 20"/>
    <path stroke="black" stroke-width="5" d="M10 10L900 800"/></svg>' >thin.svg
tamgen -q --size 64 --tones 1 --replay thin.svg --strokes thin.tsv -o thin.exr
ok "a script of thin strokes is read" hatchstat tam thin.exr --strokes thin.tsv

# The first stroke is the longest and the widest, and both are far beyond the style's.
big="0.5\t0.5\t6\t0.5\t0.6\t1\t0\t0\t0" tiny="0.2\t0.2\t0.1\t0\t0.01\t1\t0\t0\t0"
for order in "$big\n$tiny" "$tiny\n$big"; do
    printf "x\ty\tlength\tangle\twidth\ttone\tr\tg\tb\n$order\n" >big.tsv
    ok "a stroke over six tiles among a tiny one" tamgen -q --size 64 --replay big.tsv --tones 2 -o big.exr
done

tamgen --size 64 --strokes ink.tsv -o ink.exr
tamgen --size 64 --replay ink.tsv --palette sea --fit --quiet --strokes sea.tsv -o sea.exr
hatchstat tam sea.exr --strokes sea.tsv -o figures.tsv
is "--palette colours a table of strokes" "$(tail -1 figures.tsv | cut -f10,11)" "0	0"
ok "palettes run from light to dark" sh -c 'tail -n +2 sea.tsv | awk -F"\t" "NR == 1 {g = \$8; b = \$9} END {exit !(\$8 < g && \$9 < b)}"'

for style in speckle arcs; do
    tamgen --size 64 --style $style --palette earth --ids --strokes strokes.tsv -o map.exr
    hatchstat tam map.exr --strokes strokes.tsv -o figures.tsv
    is "$style in a palette" "$(tail -1 figures.tsv | cut -f8,10,11)" "yes	0	0"
done
is "the table has a column for arcs" "$(head -1 strokes.tsv | cut -f14)" bend
printf 'color 0 ff0000\ncolor 1 000000\n' >own.palette
tamgen --size 64 --tones 1 --palette own.palette --strokes red.tsv -o red.exr
is "a palette in a style is interpolated in linear light by tone" "$(sed -n 2p red.tsv | cut -f7-9)" "0.100000024	0	0"

tampack --layout array -q map.exr -o map.ktx2
is "tampack: a coloured array is RGBA8" "$(od -An -tu4 -j12 -N4 map.ktx2 | tr -d ' ')" 37
tampack --layout png -q map.exr -o picture
is "tampack: PNG of a coloured map is RGB" "$(od -An -tu1 -j25 -N1 picture.000.00.png | tr -d ' ')" 2
try tampack --layout rgb map.exr -o packed
refused "tampack: --layout rgb of a coloured map" 3 1
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
refused "an invalid colour" 2 2
echo 'width 3' >no.palette
try tamgen --palette ./no.palette -o x.exr
refused "a palette without colours" 3 1
ok "refused commands leave no file" test ! -e x.exr

# The last value of display counts, unless a group around an element has none; visibility is that of the element.
cat >hidden.svg <<'END'
<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100" stroke="black" stroke-width="2" fill="none">
<g visibility="hidden"><path d="M5 10h9"/><path visibility="visible" d="M5 20h9"/></g>
<path display="none" style="display:inline" d="M5 30h9"/><path style="display:inline;display:none" d="M5 40h9"/>
<path visibility="collapse" d="M5 50h9"/><g display="none"><path display="inline" d="M5 60h9"/></g><path d="M5 70h9"/>
</svg>
END
tamgen -q --replay hidden.svg --size 64 --tones 1 --levels 1 --strokes shown.tsv -o /dev/null
is "hidden elements of a drawing" "$(awk -F'\t' '/^[0-9]/ {print int(100 * $2 + .5)}' shown.tsv | sort -n | paste -sd' ')" "20 30 70"
# A guide across a drawing, and a stroke wider than the page.
cat >guide.svg <<'END'
<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100" stroke="black" fill="none">
<path d="M-9e4 20H9e4"/><path d="M20 20h40" stroke-width="120"/><path d="M-9e4 -20H9e4"/></svg>
END
try tamgen --replay guide.svg --size 64 --tones 1 --levels 1 --strokes guide.tsv -o /dev/null
is "a drawing with guides is replayed" $status 0
ok "guides are warned of" grep -q 'left out: 1 stroke that reaches more than 64 page widths beyond the page$' .err
is "the wide stroke remains" "$(awk "NR == 2 {printf \"%.3f\", \$5}" guide.tsv)" 1.200
# Strokes without numbers are numbered in drawing order.
tamgen -q --size 64 --tones 4 --strokes with.tsv -o /dev/null
cut -f1-9 with.tsv >without.tsv
{ cat with.tsv; tail -n +2 with.tsv; } >twice.tsv
for script in without twice; do
    tamgen -q --replay $script.tsv --size 64 --tones 4 --ids --strokes numbered.tsv -o numbered.exr
    is "a script $script numbers" "$(awk -F'\t' 'NR == 1 {for (i = 1; i <= NF; i++) if ($i == "id") id = i; next}
        {n[$id]++; zero += $id == 0} END {for (i in n) if (n[i] > 1) twice++; print zero + 0, twice + 0}' numbered.tsv)" "0 0"
done
finish
