. "${TOP:-.}/tests/tap.sh"
[ -z "$SANITIZE" ] || { skip "examples" "only run without sanitizers"; finish; }

. "$TOP/tests/small.sh"

# The files that the examples assume.
mkdir given && cd given || exit 1
meshgen torus --faces 2000 -o model.glb
cp model.glb scene.glb
for style in ink pencil; do
    tamgen --style $style --size 128 -o $style.tam.exr
done
for turn in 000 001 002; do
    render-gl model.glb --technique gouraud --size 64x48 --from ${turn#00}0:20 -o turn.$turn.png
done
echo '<svg viewBox="0 0 9 9"><path stroke="navy" fill="none" d="m1,4q3-5,6,1m-6,2h8"/></svg>' >drawing.svg
for picture in a b picture reference bark; do
    cp turn.000.png $picture.png
done
cd .. || exit 1

# manual_examples MANUAL WHAT: prints the blocks of EXAMPLES, its lines, or both, as a reader sees them
manual_examples() {
    awk -v what="$2" '/^\.Sh/ {inside = /EXAMPLES/; next}
        inside && /^\.Bd -literal/ {literal = 1; next}
        inside && /^\.Ed/ {literal = 0; next}
        inside && literal && what != "lines" {print}
        inside && sub(/^\.Dl /, "") && what != "blocks" {print}' "$1" | sed 's/\\e/\\/g; s/\\-/-/g; s/\\&//g' |
        sed ':more; /\\$/{N; s/\\\n *//; b more}'
}

# run_examples NAME: runs the shell lines in .lines; they may warn, but not fail
run_examples() {
    cp -R given "in.$1"
    # Installed files are in the build folder.
    sed "s|/usr/local/share\\(/[^ ]*\\)|\"$BUILD/share\\1\"|" .lines >lines
    while IFS= read -r line; do
        (cd "in.$1" && bash -eo pipefail -c "$line" </dev/null >/dev/null 2>../.err)
        status=$?
        case $line in *' -v '* | *' --fit '*) : >.err ;; esac # messages were requested
        is "$1: $line" "$status $(grep -v ': warning: ' .err)" "0 "
    done <lines
}
for manual in "$TOP"/man/man[17]/*; do
    manual_examples "$manual" both >.lines
    [ -s .lines ] || fail "$(basename "$manual") has examples"
    run_examples "$(basename "$manual")"
done
for manual in hatch-style layers seeds solid; do
    manual_examples "$TOP/man/man5/$manual.5" blocks >"given/example.$manual"
done
mv given/example.hatch-style given/skin.style
mv given/example.solid given/stone.solid
for manual in "$TOP"/man/man5/*; do
    manual_examples "$manual" lines >.lines
    run_examples "$(basename "$manual")"
done
cd given || exit 1
render-gl model.glb --technique rptam --layers example.layers --size 64x48 -o layers.png
is "layers.5: the example is a valid file" $? 0
eval "$(sed -n 's/^# //p' example.seeds)" | cmp - example.seeds
is "seeds.5: the command in the example's comment makes the example" $? 0
cd .. || exit 1
for command in $(ls "$BIN"); do
    "$command" --help | sed '1,/^examples:/d' >.lines
    [ -s .lines ] || fail "$command --help has examples"
    run_examples "$command--help"
done
finish
