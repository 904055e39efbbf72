# The look of strokes by their style: zigzags and colours, of fitted and of traced strokes, in pictures and drawings.
. "${TOP:-.}/tests/tap.sh"

meshgen plane --faces 200 -o plane.glb
meshgen torus --faces 2000 -o torus.glb
strokegen -q --levels 5 --angles 0 plane.glb -o plane.strokes.glb
dirfield -q torus.glb | strokegen -q --levels 4 -o torus.strokes.glb

printf 'width 2\nwobble 0\nvary 0\nstroke-colors list ff0000 00ff00 0000ff\nzigzag 4 20\n' >zigzag.style
printf 'width 2\nwobble 0\nvary 0\n' >plain.style
fitted="-t strokes --style ./zigzag.style --stroke 90x2 --lines none"
traced="-t traced --stroke-style ./zigzag.style --lines none"

# A pen of 2 pixels: corners lie 8 pixels beside the line, 20 pixels apart, which is half a wave.
front="--size 480x480 --camera 0,0,4:0,0,0 --fov 20 --page 480x480mm --margin 0mm --pen 2mm --tone-range .12:.12"
# sides FILE: prints the median height and width of the sides between two corners, whether there are many, and whether the
# line turns at nearly all of their ends
sides() {
    perl -ne 'next unless / d="([^"]*)"/;
        my @n = $1 =~ /-?[\d.]+/g;
        for (my $i = 4; $i + 3 < @n; $i += 2) {
            push @high, abs($n[$i + 1] - $n[$i - 1]);
            push @wide, abs($n[$i] - $n[$i - 2]);
            $turns++ if ($n[$i + 1] - $n[$i - 1]) * ($n[$i + 3] - $n[$i + 1]) < 0;
        }
        END {
            @high = sort { $a <=> $b } @high;
            @wide = sort { $a <=> $b } @wide;
            printf "%.0f %.0f %d %d", $high[@high / 2], $wide[@wide / 2], @high > 50, $turns > 0.8 * @high;
        }' "$1"
}
render-gl -q $fitted $front plane.glb -o fitted.svg
is "a straight fitted stroke is a zigzag" "$(sides fitted.svg)" "16 20 1 1"

# The zigzag of traced strokes has a whole number of octaves on their mesh.
render-gl -q $traced $front plane.strokes.glb -o traced.svg
is "and a straight traced one, too" "$(sides traced.svg | sed 's/ .. / /')" "16 1 1"
wide=$(sides traced.svg | cut -d' ' -f2)
ok "with waves of about the length: $wide" test "$wide" -ge 14 -a "$wide" -le 28

# A drawing has the tone: a pen has fewer strokes if they are longer.
area() {
    perl -ne 'next unless / d="([^"]*)"/;
        my @n = $1 =~ /-?[\d.]+/g;
        for (my $i = 2; $i < @n; $i += 2) { $sum += 2 * sqrt(($n[$i] - $n[$i - 2]) ** 2 + ($n[$i + 1] - $n[$i - 1]) ** 2) }
        END { printf "%.3f\n", $sum / 480 ** 2 }' "$1"
}
ok "a drawing of fitted zigzags has the tone: $(area fitted.svg)" \
    test "$(area fitted.svg | awk '{print ($1 > .10 && $1 < .15)}')" = 1
ok "one of traced zigzags, too: $(area traced.svg)" test "$(area traced.svg | awk '{print ($1 > .09 && $1 < .15)}')" = 1

# A picture has the tone of plain strokes: lines are as much thinner as they are longer. Traced ones overlap a little more.
printf 'width 2\nwobble 0\nvary 0\nzigzag 1.5 6\n' >black.style
ink() {
    render-gl -q --lines none --size 320x320 --camera 0,0,4:0,0,0 --fov 20 --tone-range .3:.3 "$@" -o ink.exr
    hatchstat frames ink.exr ink.exr | awk 'NR == 2 {printf "%.3f\n", 1 - $2}'
}
for kind in fitted traced; do
    if [ $kind = fitted ]; then
        zigzag=$(ink plane.glb -t strokes --style ./black.style) plain=$(ink plane.glb -t strokes --style ./plain.style)
    else
        zigzag=$(ink plane.strokes.glb -t traced --stroke-style ./black.style)
        plain=$(ink plane.strokes.glb -t traced --stroke-style ./plain.style)
    fi
    ok "$kind: a picture of zigzags has the tone: $zigzag, $plain" \
        awk -v a="$zigzag" -v b="$plain" 'BEGIN {exit !(b > .25 && b < .35 && (a - b) ^ 2 < .045 ^ 2)}'
done

# colors FILE: prints the ids of paths and their colours, sorted
colors() {
    sed -n 's/^<path id="\(strokes-[0-9]*-[0-9]*\)[-0-9]*".* stroke="\(#[0-9a-f]*\)".*/\1 \2/p' "$1" | sort -u
}
for kind in fitted traced; do
    mesh=torus.glb draw=$fitted
    if [ $kind = traced ]; then
        mesh=torus.strokes.glb draw=$traced
    fi
    render-gl -q $draw --size 320x240 --frames 24 --turntable $mesh -o film%02d.svg
    colors film00.svg >first
    colors film01.svg >second
    is "$kind: a drawing has the colours of the list" "$(cut -d' ' -f2 first | sort -u | tr '\n' ' ')" \
        "#0000ff #00ff00 #ff0000 "
    ok "$kind: a stroke has one colour" test "$(cut -d' ' -f1 first | uniq -d | wc -l)" = 0
    ok "$kind: and keeps it in the next frame" test "$(sort -u first second | cut -d' ' -f1 | uniq -d | wc -l)" = 0
    ok "$kind: in which many strokes stay" test "$(comm -12 first second | wc -l)" -gt 50
    render-gl -q $draw --size 320x240 $mesh -o script.tsv
    is "$kind: a script has the colours, too" "$(sed 1d script.tsv | cut -f7-9 | sort -u | tr '\t\n' '  ')" \
        "0 0 1 0 1 0 1 0 0 "
    for n in 1 3; do
        LP_NUM_THREADS=$n render-gl -q $draw --size 320x240 $mesh -o threads$n.exr
    done
    ok "$kind: a picture has the same bytes with one thread and with three" cmp threads1.exr threads3.exr
done

printf 'stroke-colors list red\n' >bad.style
try render-gl torus.glb -t strokes --style ./bad.style -o bad.png
refused "a colour by name" 3 1
finish
