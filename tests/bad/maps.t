# Tonal art maps that are damaged in one way each, made by tests/bad/maps.c: every command that reads a map says
# one clear line with the column and the level, and leaves nothing. Strokes that do not nest stop those that
# build on it, and are told by those that draw or pack images as they are.
. "${TOP:-.}/tests/tap.sh"
maker=$BUILD/tests/bad/maps
[ -x "$maker" ] || { skip "damaged maps" "make check builds their maker"; finish; }

mkdir maps
ok "maps are made" "$maker" maps
meshgen plane --faces 2 -o plane.glb

# commands FILE: a line for each command that reads a map
commands() {
    echo "tamvol --tones 2 $1 -o out"
    echo "tamthresh $1 -o out"
    echo "tamthresh --exact $1 -o out"
    echo "tampack --layout dds $1 -o out.dds"
    echo "render-gl plane.glb --tam $1 --size 32x32 --lines none -o out.png"
    echo "render-gl plane.glb --tam $1 --probe --size 32x32 -o out"
    echo "hatchstat tam $1 -o out"
}
# told WORDS: the last .err has one line with them
told() {
    grep -qE "$1" .err && [ "$(wc -l <.err)" -eq 1 ]
}
# reason FILE: the words of its message
reason() {
    case $1 in
    no-first-part | part-*) echo "part [0-3] is named 'tone.*, want tone\.00[0-3]: not a tonal art map" ;;
    one-level) echo "tone.000: 1 mip levels, want the whole chain of 5" ;;
    attributes-missing | tone-is-text) echo "tone.001: no attribute hatch:tone" ;;
    channel-missing) echo "tone.000: no channel Y, and no channels R, G and B" ;;
    tones-out-of-order) echo "tone.002: tone 0.75 is lighter than the column before it, 0.8" ;;
    tone-below-0 | tone-above-1 | tone-nan) echo "tone.00[023]: hatch:tone [^ ]*, want 0 to 1" ;;
    no-levels) echo "tone.000: hatch:levels 0, want 1 to 5" ;;
    too-many-levels) echo "tone.003: hatch:levels 99, want 1 to 5" ;;
    levels-unequal) echo "tone.002: 3 drawn levels, but the first column has 2" ;;
    half-the-parts) echo "tone.000: hatch:tones 4, but the file has 2 parts" ;;
    a-part-too-many) echo "tone.000: hatch:tones 3, but the file has 4 parts" ;;
    counts-unequal) echo "tone.003: hatch:tones 5, but the file has 4 parts" ;;
    count-is-text) echo "tone.001: hatch:tones is not a whole number" ;;
    whole-is-smaller) echo "tone.000: hatch:whole-size 8, want 16 to 4096" ;;
    whole-has-fewer-tones) echo "tone.000: hatch:whole-tones 3, want 4 to 256" ;;
    whole-is-lighter) echo "tone.000: hatch:whole-tone 0.5, want 1 to 1" ;;
    tolerance-above-1) echo "tone.000: hatch:tolerance 2, want 0 to 1" ;;
    no-tolerance) echo "tone.000: no attribute hatch:tolerance of its type" ;;
    pixel-nan) echo "tone.002: level 1: a pixel is not a finite number" ;;
    pixel-infinite) echo "tone.003: level 0: a pixel is not a finite number" ;;
    last-pixel-infinite) echo "tone.000: level 4: a pixel is not a finite number" ;;
    colour-nan) echo "tone.001: level 0: a pixel is not a finite number" ;;
    sizes-unequal) echo "tone.001: 2 pixels and 1 levels, but tone.000 has 1 pixels and 1 levels" ;;
    channels-unequal) echo "tone.001: no channel Y" ;;
    nesting-broken) echo "tone.002: level 1: pixel \(3, 0\) gets lighter, .*: strokes do not nest" ;;
    nesting-broken-colour) echo "(tone.003: level 0: pixel \(1, 0\) gets lighter|coloured)" ;;
    *) echo "no reason is known for $1" ;;
    esac
}
commands maps/good.exr >good.list
while read -r line; do
    try $line
    is "a sound map: $line" "$status $(grep -c nest .err)" "0 0"
    rm -f out out.*
done <good.list

for file in maps/*.exr; do
    name=$(basename "$file" .exr)
    [ "$name" != good ] || continue
    words=$(reason "$name")
    commands "$file" >list
    while read -r line; do
        try $line
        want=3
        case $name:$line in nesting-*:tampack* | nesting-*:render-gl* | nesting-*:hatchstat*) want=0 ;; esac
        is "$name: ${line%% *} status" "$status" $want
        case $name:$line in
        nesting-*:hatchstat*) ;;
        nesting-*:render-gl*--probe*) ;;
        nesting-broken-colour:tampack* | nesting-broken-colour:render-gl*)
            ok "$name: ${line%% *} says so" grep -qE "warning: $words" .err ;;
        *) ok "$name: ${line%% *} says so" told "$words" ;;
        esac
        [ $want = 0 ] || is "$name: ${line%% *} leaves nothing" "$(ls out out.* 2>/dev/null)" ""
        rm -f out out.*
    done <list
done
try hatchstat tam maps/nesting-broken.exr --check
is "hatchstat tam --check says no" "$status" 1
finish
