# render-gl --layers: layers with default values and others, strokes from pictures beside the file, and refusals.
. "${TOP:-.}/tests/tap.sh"

meshgen torus --faces 200 -o torus.glb
draw="render-gl -t rptam --size 96x72 --samples 1 --lines none torus.glb"
mkdir folder
seedgen -n 16 --layers 2 -o two.seeds

ok "a picture without --layers" $draw -o plain.png
printf 'turn 0\n# a comment\nink 1\ntone 0.5..0.75\nink 1\n' >folder/same.layers
ok "a file of layers with default values" $draw --layers folder/same.layers -o same.png
ok "default values change nothing" cmp plain.png same.png
printf 'ink 1\nturn 91\ntone 0.5..0.75\nwidth 1.8\n' >other.layers
ok "a file of layers with other values" $draw --layers other.layers -o other.png
is "other values change the picture" "$(cmp -s plain.png other.png || echo another)" another

for i in 1 2 3 4; do echo "length 40 width 5 ink 0.6 stroke crayon"; done >crayon.layers
ok "layers with crayon strokes" $draw --layers crayon.layers -o crayons.png
ok "the style crayon" $draw --style crayon --stroke 40x5 --stroke-ink .6 -o crayon.png
ok "crayon strokes of layers and of the style are the same" hatchstat diff crayons.png crayon.png

printf 'ink 1\nwidth 9 stroke crayon\n' >grow.layers
ok "a layer whose strokes differ joins one whose strokes do not" $draw --layers grow.layers --tone-range .8:.8 \
    --frames 2 --animate seed-layers=1..2 -o grow%d.png
ok "both layers without animation" $draw --layers grow.layers --tone-range .8:.8 -o grown.png
ok "the last frame equals the picture of both layers" cmp grow1.png grown.png

render-gl -t gouraud --size 64x8 torus.glb -o folder/stroke.png
printf 'stroke stroke.png\nstroke stipple\n' >folder/own.layers
ok "a stroke from a picture beside the file" $draw --layers folder/own.layers -o own.png
is "a stroke from a picture changes the picture" "$(cmp -s plain.png own.png || echo another)" another
ok "a file of layers with given seed sets" $draw --layers folder/own.layers --seeds two.seeds -o two.png
ok "--seed-layers below the number of layers in the file" $draw --layers folder/own.layers --seed-layers 1 -o one.png

# Keys of a style that strokes at seed points do not have.
for key in arcs:bend marker:overlap speckle:color; do
    try $draw --style "${key%:*}" -o style.png
    is "$key has no effect" "$status $(wc -l <.err) $(grep -c "'${key#*:}' of the style ${key%:*} has no effect" .err)" "0 1 1"
done
try $draw --style pencil -o style.png
is "the keys of other styles have" "$status $(cat .err)" "0 "

# refuses NAME STATUS WORDS OPTION ...: checks that render-gl exits with STATUS and one message with WORDS
refuses() {
    name=$1 want=$2 words=$3
    shift 3
    try $draw "$@" -o picture.png
    is "$name" "$status $(wc -l <.err) $(grep -cF -e "$words" .err)" "$want 1 1"
    [ ! -e picture.png ] || fail "$name: no picture is left"
}
refuses "an unknown key" 3 "bad.layers: line 2: no such key 'nib'" --layers "$(printf 'turn 3\nnib 3\n' >bad.layers && echo bad.layers)"
refuses "a file without layers" 3 "the file has no layer" --layers /dev/null
refuses "fewer seed sets than layers" 3 "two.seeds: 2 seed sets, but 4 layers in other.layers" --layers other.layers --seeds two.seeds
printf 'stroke gone.png\n' >gone.layers
refuses "a missing image of a stroke" 4 "gone.png" --layers gone.layers
echo 'stroke nosuch' >unknown.layers
refuses "an unknown stroke" 3 "render-gl: unknown.layers: stroke: 'nosuch'" --layers unknown.layers
try $draw --layers - -o picture.png <unknown.layers
is "an unknown stroke in standard input" "$status $(grep -c "^render-gl: standard input: stroke: 'nosuch'" .err)" "3 1"
printf 'length 900 tile 100\n' >long.layers
refuses "strokes longer than 8 tiles" 5 \
    "layer 1: strokes of 900 by 1.8 pixels are too large: the limit is 8 tiles of 100 pixels" --layers long.layers
finish
