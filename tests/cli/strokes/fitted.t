# --technique strokes: strokes that are found in the picture and drawn anew.
. "${TOP:-.}/tests/tap.sh"

meshgen plane --faces 200 -o plane.glb
meshgen torus -o torus.glb

# draw FILE OPTION ...: draws without feature lines into $file
file=picture.exr
draw() {
    render-gl -q -t strokes --lines none -o $file "$@"
}

# The texture's own strokes cover the same pixels.
draw plane.glb --size 320x240 --tone-range .3:.3 --overdraw 0
render-gl -q plane.glb -t rptam --lines none --size 320x240 --tone-range .3:.3 -o texture.exr
rms=$(hatchstat diff texture.exr picture.exr | awk 'NR == 2 {print $4}')
ok "fitted strokes lie where the texture's strokes do: $rms" awk -v rms="$rms" 'BEGIN {exit !(rms != "" && rms < .12)}'

# Brushes with a grain, and pens with pressure, have the tone of the texture.
# ink TECHNIQUE STYLE SIZE FOV: prints the mean darkness of a plane
ink() {
    render-gl -q -t "$1" --style "$2" --lines none --size "$3" --fov "$4" --camera 0,0,2.4:0,0,0 --tone-range .4:.4 \
        -o ink.exr plane.glb
    hatchstat frames ink.exr ink.exr | awk 'NR == 2 {print 1 - $2}'
}
for style in pencil charcoal sketch; do
    want=$(ink rptam $style 256x256 30) got=$(ink strokes $style 256x256 30)
    ok "ink of $style: $got for $want" \
        awk -v a="$got" -v b="$want" 'BEGIN {exit !(b > .3 && (a - b) ^ 2 < .012 ^ 2)}'
done

# Dots stay dots: their few pixels seldom reach both of their own ends, but they do not go on by --overdraw.
meshgen sphere --faces 2000 -o sphere.glb
dots() {
    render-gl -q -t "$1" --style "$2" --lines none --size 320x240 --tone-range .3:.3 -o dots.exr sphere.glb
    hatchstat frames dots.exr dots.exr | awk 'NR == 2 {print 1 - $2}'
}
for style in stipple speckle; do
    want=$(dots rptam $style) got=$(dots strokes $style)
    ok "dots of $style: $got for $want" awk -v a="$got" -v b="$want" 'BEGIN {exit !(b > .1 && a > .95 * b && a < 1.05 * b)}'
done

# A low strip of the same plane is mostly border, which strokes cross as if there were none.
want=$(ink rptam pencil 256x12 2.2) got=$(ink strokes pencil 256x12 2.2)
ok "ink along borders: $got for $want" awk -v a="$got" -v b="$want" 'BEGIN {exit !(b > .3 && (a - b) ^ 2 < .012 ^ 2)}'

# The random looks of a stroke follow from its number, not from the order of threads.
draw torus.glb --size 320x240
for n in 1 2; do
    LP_NUM_THREADS=$n render-gl -q -t strokes --lines none -o again$n.exr torus.glb --size 320x240
done
ok "the same bytes again" cmp picture.exr again1.exr
ok "the same bytes with another number of threads" cmp again1.exr again2.exr

file=none.exr
draw torus.glb --size 320x240 --tone-range 0:0
is "no ink, no strokes" "$(hatchstat frames none.exr none.exr | awk 'NR == 2 {print 1 - $2}')" 0

# Strokes run over outlines by --overdraw, and by no more.
beyond() {
    file=over.exr
    draw torus.glb --size 320x240 --samples 1 --overdraw "$1"
    hatchstat frames over.exr over.exr | awk 'NR == 2 {print 1 - $2}'
}
none=$(beyond 0) some=$(beyond 12)
ok "overdraw adds ink: $none, $some" awk -v a="$none" -v b="$some" 'BEGIN {exit !(a > 0 && b > 1.005 * a && b < 1.3 * a)}'

# Options of rptam belong to this technique, too, and --animate moves them.
file=films%d.exr
draw plane.glb --size 64x64 --frames 2 --animate stroke=20x1..40x2
ok "its options may change" test -s films0.exr -a -s films1.exr

# The largest strokes are drawn if there are too many.
try render-gl -v -t strokes --lines none --size 320x240 --most-strokes 100 -o few.png torus.glb
is "one warning says how many there are" "$(grep -c 'strokes, of which the 100 largest are drawn: --most-strokes' .err)" 1
ok "these and parts of them are drawn" awk '/ strokes, .* fragments/ && $2 >= 100 && $2 < 300 {found = 1} END {exit !found}' .err
# They are the same ones, and have as much ink, in both ways of adding their fragments up.
few() {
    file=few.exr
    draw torus.glb --size 320x240 --samples 1 --most-strokes 200 --aggregate "$1" 2>few.err
    hatchstat frames few.exr few.exr | awk 'NR == 2 {print 1 - $2}'
}
sorted=$(few sort) blended=$(few blend)
ok "the largest strokes by blending: $blended for $sorted" awk -v a="$sorted" -v b="$blended" \
    'BEGIN {exit !(a > 0.005 && b > 0.9 * a && b < 1.1 * a)}'
# More strokes than the table has slots at first: 65536.
try render-gl -v -t strokes --lines none --stroke 3x1 --seed-tile 16 --tone-range .6:.6 --size 640x480 --samples 1 \
    --camera 0,0,2.4:0,0,0 -o many.png plane.glb
ok "all strokes find room" awk '/strokes, of which/ && $3 > 80000 {found = 1} END {exit !found}' .err

# More fragments than one row of work groups takes: 4,194,240.
try render-gl -v -t strokes --lines none --stroke 300x8 --tone-range .6:.6 --size 2300x2000 --samples 1 \
    --camera 0,0,2.4:0,0,0 -o large.png plane.glb
ok "a large picture" awk '/ fragments/ && $4 > 4194240 {found = 1} END {exit !found}' .err
is "its status" $status 0

# A drawing wider than a canvas, 8192 pixels, which is about 2170 mm: strokes are up to its right border.
render-gl -q -t strokes --lines none --stroke 80x4 --tone-range .5:.5 --size 8300x100 --camera 0,0,0.04:0,0,0 -o wide.svg plane.glb
ok "a wide drawing" perl -ne 'while (/M([\d.]+) /g) {$right++ if $1 > 1200} END {exit !($right > 20)}' wide.svg

# Drawings: ink of the paths of a plane, from their length and the pen's width, if they overlap at random.
drawn() {
    render-gl -q -t strokes --lines none --size 800x800 --camera 0,0,2.4:0,0,0 --tone-range "$1:$1" -o plane.svg plane.glb
    perl -ne 'BEGIN {$pen = 0} $pen = $1 if /stroke-width="([\d.]+)"/; $area = $1 * $2 if /viewBox="0 0 ([\d.]+) ([\d.]+)"/;
        next unless / d="M([^"]*)"/;
        my @n = split /[ ML]+/, $1;
        for ($i = 2; $i + 1 < @n; $i += 2) {$way += sqrt(($n[$i] - $n[$i - 2]) ** 2 + ($n[$i + 1] - $n[$i - 1]) ** 2)}
        END {printf "%.4f\n", 1 - exp(-$way * $pen / $area)}' plane.svg
}
for tone in .1 .3; do
    ink=$(drawn $tone)
    ok "a drawing of a plane has the tone $tone: $ink" \
        awk -v ink="$ink" -v tone=$tone 'BEGIN {exit !(ink > .93 * tone && ink < 1.07 * tone)}'
done
ok "each seed set has a layer" grep -q 'id="strokes-1"' plane.svg
for n in 0 1 2 3 4 5 6 7 8 9; do echo "turn $((10 * n))"; done >ten.layers
render-gl -q -t strokes --lines none --layers ten.layers --tone-range .9:.9 --size 128x128 -o ten.svg plane.glb
is "the last of eight layers has the strokes of more" "$(grep -o 'id="strokes-[0-9]*"' ten.svg | tr '\n' ' ')" \
    'id="strokes-1" id="strokes-2" id="strokes-3" id="strokes-4" id="strokes-5" id="strokes-6" id="strokes-7" id="strokes-8" '

# A drawing may be as large as the GPU's textures, which the refusal tells.
long() {
    render-gl -q -t strokes --lines none --stroke 80x4 --tone-range .5:.5 --size "$1" -o long.svg plane.glb 2>long.err
}
long 65536x16
side=$(sed -n 's/.*found in pictures of at most \([0-9]*\) pixels a side/\1/p' long.err)
for size in "${side}x16" "16x$side"; do
    ok "a drawing of $size" long "$size"
done
for size in "$((side + 1))x16" "16x$((side + 1))"; do
    long "$size"
    is "a drawing of $size" "$? $(grep -c "at most $side pixels" long.err)" "5 1"
done
for n in 1 2; do
    LP_NUM_THREADS=$n render-gl -q -t strokes --size 320x240 --hatch-turn 30 -o torus$n.svg torus.glb
done
ok "drawings have the same bytes with another number of threads" cmp torus1.svg torus2.svg
is "no point lies beyond the page" "$(perl -ne '($w, $h) = ($1, $2) if /viewBox="0 0 ([\d.]+) ([\d.]+)"/;
    next unless / d="M([^"]*)"/;
    my @n = split /[ ML]+/, $1;
    for ($i = 0; $i + 1 < @n; $i += 2) {print "$n[$i] $n[$i + 1]\n" if $n[$i] < 0 || $n[$i] > $w || $n[$i + 1] < 0 || $n[$i + 1] > $h}
    ' torus1.svg)" ""
render-gl -q -t strokes --size 320x240 -o torus.tsv torus.glb
ok "a stroke script has the strokes" test "$(wc -l <torus.tsv)" -gt 100
# Draws that are timed do not count.
meshgen teapot -o teapot.glb
for times in "" "--times times.tsv"; do
    # shellcheck disable=SC2086 # an option and its file
    render-gl -v teapot.glb -t strokes --size 64x64 --frames 3 --turntable $times -o f%d.png 2>&1 | grep -o '[0-9]* strokes' | paste -sd' '
done >counts
is "--times changes no counts" "$(head -n 1 counts)" "$(tail -n 1 counts)"
finish
