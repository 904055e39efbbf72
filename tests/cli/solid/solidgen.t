# solidgen: installed styles, files, slices, settings, refusals.
. "${TOP:-.}/tests/tap.sh"
command -v solidgen >/dev/null || { skip "solid textures" "no solidgen"; finish; }

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
# keys FILE: prints the keys and values of hatch in a KTX2 file
keys() {
    tr -c '[:print:]' '\n' <"$1" | grep -A1 '^hatch:' | paste -sd' '
}
# texels FILE: prints the finest level as numbers
texels() {
    od -An -v -tu1 -w1 -j "$(u32 "$1" 80)" -N "$(u32 "$1" 88)" "$1"
}

for file in "$TOP"/styles/*.solid; do
    style=$(basename "$file" .solid)
    format=9 bytes=37448
    ! grep -q '^color' "$file" || format=23 bytes=112344
    try solidgen --style "$style" --size 32 -j 1 -o "$style.ktx2"
    is "style $style" "$status $(shape "$style.ktx2") $(cat .err)" "0 $format 32 32 32 0 6 "
    ok "$style has all levels" test "$(wc -c <"$style.ktx2")" -gt $bytes
    solidgen --style "$style" --size 32 -j 3 -o three.ktx2
    ok "$style is the same for any number of threads" cmp "$style.ktx2" three.ktx2
    solidgen --style "$style" --size 32 --seed 2 -o other.ktx2
    ok "$style differs with the seed" test "$(cmp -l "$style.ktx2" other.ktx2 | wc -l)" -gt 10000
    case $style in
    perlin | turbulence | worley | stipple | paper) isotropic='hatch:isotropic yes -- ' ;;
    *) isotropic= ;;
    esac
    is "$style: keys of the file" "$(keys "$style.ktx2")" "${isotropic}hatch:seed 1 -- hatch:solid $style"
    if [ -z "$SANITIZE" ]; then
        ms=$(milliseconds 2000 solidgen --style "$style" --size 32 -j 1 -o timed.ktx2)
        ok "$style takes less than two seconds of a processor ($ms ms)" test "$ms" -le 2000
    fi
    grep -q "^\.It Cm $style\$" "$TOP/man/man1/solidgen.1"
    is "solidgen.1 names style $style" $? 0
done

# A threshold t covers the share t.
texels stipple.ktx2 | awk '{count[$1]++} END {
    for (value = 0; value < 256; value++) if (count[value] != 128) print value, count[value]}' >uneven
is "each value occurs equally often" "$(cat uneven)" ""
solidgen --style stipple --size 32 --set 'equalize no' -o raw.ktx2
ok "equalize no keeps the values" test "$(texels raw.ktx2 | sort -u | wc -l)" -lt 250

# Cells of noise take two texels at least.
solidgen --set 'scale 16' --size 32 -o most.ktx2
solidgen --size 8 --set 'scale 2; octaves 2' -o once.ktx2
solidgen --size 8 --set 'scale 2' --set 'octaves 2' -o twice.ktx2
ok "a repeated --set adds its lines" cmp once.ktx2 twice.ktx2
try solidgen --set 'scale 64' --size 32 -v -o lowered.ktx2
is "a scale beyond the texels: message" "$(head -n 1 .err)" \
    "solidgen: scale: lowered to the most that 32 texels along a side can show"
ok "and texture" cmp most.ktx2 lowered.ktx2
try solidgen --style marble --set 'veins 0 -32 0; warp 0' --size 32 -v -o lowered.ktx2
is "as many veins as texels: message" "$(head -n 1 .err)" \
    "solidgen: veins: lowered to the most that 32 texels along a side can show"
ok "and texture" test "$(texels lowered.ktx2 | sort -u | wc -l)" -gt 2

printf 'kind worley\nscale 4 # cells\ndistance f2-f1\n' >cells.solid
printf 'kind strokes\n' >strewn.solid
solidgen --style ./strewn.solid --size 16 -o strewn.ktx2
is "strokes in all directions have none" "$(keys strewn.ktx2)" "hatch:isotropic yes -- hatch:seed 1 -- hatch:solid strewn"
solidgen --style worley --set 'jitter 0' --size 8 -o lattice.ktx2
is "points of a lattice have directions" "$(keys lattice.ktx2)" "hatch:seed 1 -- hatch:solid worley"
try solidgen --style ./cells.solid --set 'scale 5; jitter 0.5' --size 16 -v -o cells.ktx2
is "a style of one's own" "$status $(sed 's/[0-9]* bytes/N bytes/' .err)" \
    "0 solidgen: 16 texels along a side, 1 channel; N bytes"
is "the file is named after it" "$(keys cells.ktx2)" "hatch:isotropic yes -- hatch:seed 1 -- hatch:solid cells"
solidgen --style - --set 'scale 5; jitter 0.5' --size 16 <cells.solid >piped.ktx2
is "a style from a pipe" "$(keys piped.ktx2)" "hatch:isotropic yes -- hatch:seed 1 -- hatch:solid custom"
is "with the same texels" "$(texels piped.ktx2 | cksum)" "$(texels cells.ktx2 | cksum)"
printf 'kind worley\nscale 5\njitter 0.5\ndistance f2-f1\n' >whole.solid
solidgen --style ./whole.solid --size 16 -o whole.ktx2
is "--set stands for lines of the file" "$(texels whole.ktx2 | cksum)" "$(texels cells.ktx2 | cksum)"
printf 'kind canvas\n' >wood
solidgen --style wood --size 16 -o installed.ktx2
is "installed styles take precedence over files" "$(shape installed.ktx2)" "23 16 16 16 0 5"

solidgen --style wood --size 16 --slices slices.png -o a.ktx2
try hatchstat diff slices.png slices.png
is "--slices draws a picture" "$status $(od -An -tu1 -j16 -N8 slices.png | tr -s ' ')" "0  0 0 0 56 0 0 0 16"
is "in colour" "$(od -An -tu1 -j25 -N1 slices.png | tr -d ' ')" 2
if command -v exrheader >/dev/null; then
    solidgen --style wood --size 16 -o wood.exr
    is "EXR has a part for each slice" "$(exrheader wood.exr | grep -c 'name (type string): "slice.0')" 16
    is "and the keys" "$(exrheader wood.exr | grep -c 'hatch:solid (type string): "wood"')" 16
else
    skip "parts of EXR files" "no exrheader"
fi

# says NAME STATUS LINES TEXT COMMAND ...: checks a refusal, and its first line
says() {
    says_name=$1 says_status=$2 says_lines=$3 says_text=$4
    shift 4
    try "$@"
    refused "$says_name" "$says_status" "$says_lines"
    is "$says_name: message" "$(head -1 .err)" "$says_text"
}
says "a size that is no power of two" 2 2 "solidgen: --size 48: want a power of two" solidgen --size 48 -o x
says "an unknown style" 2 2 "solidgen: solid: 'oak' is not one of canvas, crosshatch, marble, paper,\
 perlin, stipple, strokes, turbulence, wood, worley, and not a file" solidgen --style oak -o x
printf 'kind wood\nrings 3\ndots 4\n' >bad.solid
says "a key of another kind" 3 1 "solidgen: bad.solid: line 3: dots: kind wood does not use it" \
    solidgen --style bad.solid -o x
says "a wrong setting" 2 2 "solidgen: --set: line 2: scale: 0, want 1 to 128" \
    solidgen --style perlin --set 'octaves 2; scale 0' -o x
says "settings without a key" 2 2 "solidgen: --set: empty: want at least one line with a key, such as 'kind wood'" \
    solidgen --set ' ; # none' -o x
says "a texture beyond the memory" 5 1 \
    "solidgen: --size 512 needs 768 MB of memory, --max-memory allows 524 MB" \
    solidgen --style perlin --size 512 --max-memory 500M -o x
[ -z "$SANITIZE" ] && ms=$(milliseconds 50 solidgen --style perlin --size 512 --max-memory 500M -o x) || ms=0
ok "is refused before any work ($ms ms)" test "$ms" -le 50
# 128^3 values of 4 bytes and their ranks of one, a seventh more, and a megabyte.
enough=$((5 * 2097152 + 5 * 2097152 / 7 + 1048576))
ok "as much memory as a texture takes is enough" solidgen --style perlin --size 128 --max-memory $enough -o exact.ktx2
ok "for any number of threads" solidgen --style perlin --size 128 --max-memory $enough --threads 8 -o eight.ktx2
ok "which make the same texture" cmp exact.ktx2 eight.ktx2
for side in 32 64; do
    bytes=$((5 * side * side * side + 5 * side * side * side / 7 + 1048576))
    ok "and of a texture of $side texels" solidgen --style perlin --size $side --max-memory $bytes --threads 8 -o small.ktx2
done
# Three channels: the texels, and a block for the coarser levels. The least that is let through is enough.
colors=$(solidgen --style wood --size 128 --max-memory 1M -o x 2>&1 | sed 's/.* needs \([0-9]*\) MB .*/\1/')
ok "what a coloured texture is said to need is enough" solidgen --style wood --size 128 \
    --max-memory $((colors + 1))000000 -o colored.ktx2
try solidgen --style wood --size 128 --max-memory $((colors - 1))000000 -o none.ktx2
is "less is refused before any work" "$status $(grep -c 'needs .* of memory' .err)" "5 1"
says "one byte less is not" 5 1 "solidgen: --size 128 needs 13 MB of memory, --max-memory allows 13 MB" \
    solidgen --style perlin --size 128 --max-memory $((enough - 1)) -o x
many='width 0.005; length 0.01; density 16'
says "more strokes than the memory holds" 5 1 "solidgen: the strokes or points of the style and --size 64\
 need 6768 MB of memory, --max-memory allows 4295 MB" solidgen --style strokes --set "$many" -o x
[ -z "$SANITIZE" ] && ms=$(milliseconds 50 solidgen --style strokes --set "$many" -o x) || ms=0
ok "are refused before any work ($ms ms)" test "$ms" -le 50
says "an unknown ending" 2 2 "solidgen: x.png: the ending is that of another format: want .ktx2 or\
 .exr" solidgen -o x.png
ok "no output is left" test ! -e x
for shell in bash zsh fish; do
    case $shell in
    bash) completions=share/bash-completion/completions/solidgen ;;
    zsh) completions=share/zsh/site-functions/_solidgen ;;
    fish) completions=share/fish/vendor_completions.d/solidgen.fish ;;
    esac
    ok "$shell completes installed styles" grep -q '\[\.\]solid' "$BUILD/$completions"
done
# A solid is measured in a cube.
tamgen -q --size 64 --tones 4 --levels 1 | tampack -q --layout rgb -o flat.ktx2
set -- flat*.ktx2
says "a flat texture is no solid" 3 1 "hatchstat: $1: a flat texture, want a cube" hatchstat solid "$1"
finish
