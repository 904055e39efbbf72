# tamgen: styles by name, file and pipe; brush images; sizes; additional outputs.
. "${TOP:-.}/tests/tap.sh"
small='--size 64 --tones 2 --levels 1 --candidates 20:20'

tamgen $small --style pencil -o pencil.exr
mkdir pencil
echo 'brush stipple' >ink
tamgen $small --style pencil -o again.exr
ok "a folder does not hide an installed style of the same name" cmp pencil.exr again.exr
ok "strokes may be bent very little" tamgen --size 256 --tones 3 --set 'bend 0 .001' -o /dev/null
for bend in 0 1e-40; do
    tamgen $small --method exhaustive --set "bend 0 $bend" -o bent$bend.exr
done
ok "and so little that they are straight, whatever the method" cmp bent0.exr bent1e-40.exr
tamgen $small -o default.exr
tamgen $small --style ./ink -o mine.exr
ok "a style given as a path is a file" test "$(cksum <default.exr)" != "$(cksum <mine.exr)"
echo 'brush stipple' >dots
ok "a name of no installed style is a file" tamgen $small --style dots -o dots.exr
try tamgen $small --style - -o piped.exr <dots
is "a style is read from a pipe" "$status" 0
is "the map names the style by its file or its name" \
    "$(grep -aoc dots dots.exr) $(grep -aoc custom piped.exr) $(grep -aoc pencil pencil.exr)" "2 2 2"

cp dots dots.wide.style
tamgen $small --style dots.wide.style -o wide.exr
is "a name may have a dot" "$(grep -aoc 'dots\.wide' wide.exr) $(grep -aoc 'wide\.style' wide.exr)" "2 0"

try tamgen $small --style nowhere -o x.exr
refused "an unknown style is wrong usage" 2 2
try tamgen $small --style nowhere.style -o x.exr
refused "a missing style file cannot be opened" 4 1
printf 'width 3\nwidth wide\n' >bad.style
try tamgen $small --style bad.style -o x.exr
refused "a bad style is bad input" 3 1
is "the message names the bad line" "$(cat .err)" "tamgen: bad.style: line 2: width: 'wide' is not a number"
try tamgen $small --set 'width 3; colour red' -o x.exr
refused "a bad setting is wrong usage" 2 2
ok "the message names the bad key" grep -q "line 2: no such key 'colour'" .err
try tamgen $small --style . -o x.exr
refused "a folder as a style is bad input" 3 1

tamgen $small --set 'width 5' -o wide.exr
printf 'name ink\nwidth 5\n' >wide.style
tamgen $small --style wide.style -o same.exr
ok "--set overrides the style; unset keys are those of the style ink" cmp wide.exr same.exr

mkdir brushes
tamgen --size 64 --tones 1 --levels 1 --contact-sheet brushes/bar.png -o /dev/null
echo 'brush image bar.png' >brushes/bar.style
tamgen $small --style brushes/bar.style -o beside.exr
ok "a brush image is found beside its style" test -s beside.exr
tamgen $small --style brushes/bar.style --brush brushes/bar.png -o given.exr
ok "--brush gives the same map as the style's brush" cmp beside.exr given.exr
try tamgen $small --brush missing.png -o x.exr
refused "a missing brush image" 4 1
try tamgen $small --brush bad.style -o x.exr
refused "a brush that is not an image" 3 1

# Six tones rise to .9, on two levels. Two strokes of half ink on each other are no darker than one; and one that is as
# wide as the tile covers it.
try tamgen --size 64 --set 'overlap flat; ink .5' -o light.exr
is "tones over that of the ink are warned of" "$status $(cat .err)" \
    "0 tamgen: ink: warning: 6 of 12 images miss their tone, by up to 0.40: the ink is too light"
try tamgen --size 64 --levels 1 --set 'width 64' -o large.exr
is "and strokes that are too large" "$status $(sed 's/up to 0\.[0-9]*/up to X/' .err)" "0 tamgen: ink: warning: 6 of 6 images miss \
their tone, by up to X: strokes are too large for the level of 64 pixels"
try tamgen --size 64 --levels 1 --set 'width 4' -o wide.exr
is "not others" "$status $(wc -c <.err)" "0 0"

for wrong in '--size 100' '--size 128 --levels 4' '--tones 0' '--tones 257' '--growth 1' '--growth nan' \
    '--candidates 0:5' '--candidates 5' '--method best'; do
    try tamgen $wrong -o x.exr
    refused "$wrong is wrong usage" 2 2
done
for size in "64 2" "128 3"; do
    tamgen -q --size ${size% *} --levels ${size#* } --tones 1 --candidates 20:20 -o levels.exr
    is "as many levels as have 32 pixels: ${size#* } of ${size% *}" \
        "$? $(hatchstat tam levels.exr | cut -f 8 | grep -c tone)" "0 ${size#* }"
done
ok "refused commands leave no file" test ! -e x.exr

tamgen $small -q --set 'width 4; darkest .5' --set 'width 3' -o once.exr
tamgen $small -q --set 'width 4' -e 'darkest .5' --set 'width 3' -o thrice.exr
ok "a repeated --set adds its lines" cmp once.exr thrice.exr
tamgen $small -q --set 'darkest .5' --set 'width 4' -o other.exr
is "and the last line of a key counts" "$(cmp -s once.exr other.exr || echo differs)" differs
try tamgen $small --set 'width 4' --set '' --set 'wdth 3' -o x.exr
is "a wrong line of a repeated --set" "$status $(head -n 1 .err | grep -o -- '--set: .*wdth')" "2 --set: line 3: no such key 'wdth"

tamgen $small --strokes strokes.tsv --contact-sheet sheet.png -o map.exr
is "--strokes writes a table with these columns" "$(head -1 strokes.tsv | tr '\t' ' ')" \
    "x y length angle width tone r g b id column level grain"
is "strokes are counted from 1" "$(tail -n +2 strokes.tsv | cut -f10 | sort -n | head -1)" 1
is "--contact-sheet writes a PNG" "$(head -c 4 sheet.png | tail -c 3)" PNG
tamgen $small --strokes - -o map2.exr >piped.tsv
ok "--strokes may write to a pipe" cmp strokes.tsv piped.tsv
finish
