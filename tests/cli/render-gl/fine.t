# Volumes and thresholds in render-gl, pipelines/fine-tone.mk, --modulate and --pixel-light.
. "${TOP:-.}/tests/tap.sh"

tamgen --size 64 --levels 2 --tones 64 -o map.exr
tamvol -q --tones 16 map.exr -o volume.ktx2
tamvol -q --tones 16 --layout array map.exr -o layers.ktx2
tamvol -q --tones 16 --compress map.exr -o packed.ktx2
tamthresh -q map.exr -o thresholds.ktx2
tamthresh --exact map.exr -o exact.ktx2
meshgen sphere --faces 800 --uv whole -o ball.glb
meshgen torus --faces 800 | dirfield -q | lapped-param -q -o torus.lapped.glb

# figure NAME A B: prints the absolute value of a figure of hatchstat diff, in thousandths
figure() {
    hatchstat diff "$2" "$3" | awk -F'\t' -v name="$1" 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
        NR == 2 { x = 1000 * $at[name]; printf "%d", x < 0 ? -x : x }'
}
# within NAME LEAST MOST GOT: checks that a number is in a range
within() {
    [ "$4" -ge "$2" ] && [ "$4" -le "$3" ]
    is "$1 ($4)" $? 0
}
draw() {
    render-gl ball.glb --technique "$1" ${2:+--tam "$2"} --size 96x96 --lines none -o "$3" ${4-}
}
ok "a volume" draw volume volume.ktx2 volume.png
ok "a volume in layers" draw volume layers.ktx2 layers.png
ok "a block-compressed volume" draw volume packed.ktx2 packed.png
ok "thresholds" draw threshold thresholds.ktx2 thresholds.png
ok "threshold-soft" draw threshold-soft thresholds.ktx2 soft.png
ok "volume and thresholds with anisotropy" draw volume layers.ktx2 an.png "--anisotropy 8"
ok "exact runs" draw threshold exact.ktx2 exact.png
ok "threshold-soft with exact runs" draw threshold-soft exact.ktx2 exact-soft.png
ok "exact runs with anisotropy" draw threshold exact.ktx2 an.png "--anisotropy 8"
for technique in volume:volume threshold:thresholds threshold:exact; do
    ok "${technique%:*} on patches" render-gl torus.lapped.glb -t "${technique%:*}" -T "${technique#*:}.ktx2" \
        --size 64x48 -o patches.png
done

render-gl ball.glb -t tam-triple -T map.exr --size 96x96 --lines none -o columns.png
within "a volume in layers looks like the volume" 0 6 "$(figure mean volume.png layers.png)"
within "a block-compressed volume looks like the volume" 0 20 "$(figure mean volume.png packed.png)"
within "thresholds have the tone of the map" 0 15 "$(figure bias columns.png thresholds.png)"
within "the volume has the tone of the map" 0 15 "$(figure bias columns.png volume.png)"
within "exact runs have the tone of the map" 0 10 "$(figure bias columns.png exact.png)"
within "thresholds do not look like the volume" 3 200 "$(figure mean volume.png thresholds.png)"

# Black and white bands, a pair for each quarter of the way around the sphere.
awk 'BEGIN { print "P2 64 1 255"; for (i = 0; i < 64; i++) print i % 16 < 8 ? 0 : 255 }' >bands.pgm
lit="--tone-range 0:1"
ok "--modulate with a picture" draw gouraud '' modulated.png "--modulate bands.pgm $lit"
draw gouraud '' white.png "$lit"
dark=$(figure mean modulated.png white.png)
within "a dark band of the picture is dark" 140 260 "$dark"
ok "--pixel-light with thresholds" draw threshold thresholds.ktx2 pixels.png --pixel-light
within "on a fine sphere light at pixels equals light at vertices" 0 20 "$(figure bias pixels.png thresholds.png)"

ok "fine-tone.mk" make -s -f "$TOP/pipelines/fine-tone.mk" SIZE=64x64 TONES=32 TAM='--size 64 --levels 2' \
    VOLUME='-q --tones 16' BINS=-q OPTIONS=--pixel-light
is "fine-tone.mk writes its pictures" "$(echo fine-*.png)" "fine-tam.png fine-threshold.png fine-volume.png"
ok "fine-tone.mk of another shape" make -s -f "$TOP/pipelines/fine-tone.mk" SIZE=64x48 TONES=32 TAM='--size 64 --levels 2' \
    VOLUME='-q --tones 16' BINS=-q SHAPE=cone
printf 'color 0 000\n' >my.palette
# made: whether fine-tone.mk makes the map
made() {
    make -f "$TOP/pipelines/fine-tone.mk" TONES=4 TAM='--size 64 --levels 1 --palette ./my.palette' OUT=palette \
        palette/fine-ink.tam.exr | grep -c '^tamgen'
}
is "fine-tone.mk makes the map with a palette" "$(made)" 1
is "fine-tone.mk keeps the map" "$(made)" 0
touch -d '2 days ago' my.palette
is "fine-tone.mk makes the map anew with another palette" "$(made)" 1
is "fine-tone.mk draws the given shape" "$(meshgen cone | cmp - fine.glb && echo yes)" yes

try render-gl ball.glb -t volume -T map.exr -o no.png
is "a map instead of a volume" "$status $(cat .err)" \
    "3 render-gl: map.exr: technique volume needs a volume (tamvol makes one), this is a tonal art map"
try render-gl ball.glb -t threshold -T volume.ktx2 -o no.png
is "a volume instead of thresholds" "$status $(wc -l <.err)" "3 1"
try render-gl ball.glb -t volume -T exact.ktx2 -o no.png
is "exact runs instead of a volume" "$status $(wc -l <.err)" "3 1"
head -c 3000 exact.ktx2 >cut.ktx2
try render-gl ball.glb -t threshold -T cut.ktx2 -o no.png
is "truncated exact runs" "$status $(wc -l <.err)" "3 1"
try render-gl ball.glb -t tam -T volume.ktx2 -o no.png
is "a volume instead of a map" "$status $(wc -l <.err)" "3 1"
try render-gl ball.glb -t volume -o no.png
is "technique volume without a volume" "$status $(wc -l <.err)" "2 2"
head -c 3000 volume.ktx2 >cut.ktx2
try render-gl ball.glb -t volume -T cut.ktx2 -o no.png
is "a truncated volume" "$status $(wc -l <.err)" "3 1"
try render-gl ball.glb -t tam-flat -T map.exr --pixel-light -o no.png
is "--pixel-light with tam-flat" "$status" 2
try render-gl ball.glb -t gouraud --modulate volume.ktx2 -o no.png
is "--modulate with a file that is not an image" "$status $(wc -l <.err)" "3 1"
is "refused commands write no picture" "$(ls no.png 2>&1 | grep -c 'No such')" 1
finish
