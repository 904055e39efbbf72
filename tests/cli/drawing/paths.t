# Drawings of render-gl: the paths of scenes with a closed form, pages, layers, films and refusals.
. "${TOP:-.}/tests/tap.sh"

# measure FILE: prints "LAYER PATHS MM" for each layer, with the length of its paths in hundredths of a millimetre
cat >measure.pl <<'END'
my ($layer, %paths, %mm);
while (<>) {
    $layer = $1, $paths{$1} = $mm{$1} = 0 if /<g id="([a-z]+)" inkscape:groupmode="layer" inkscape:label="\1"/;
    next if !/ d="M([^"Z]*)(Z?)"/;
    my @at = split /[ L]/, $1;
    push @at, @at[0, 1] if $2;
    $paths{$layer}++;
    $mm{$layer} += sqrt(($at[$_] - $at[$_ - 2])**2 + ($at[$_ + 1] - $at[$_ - 1])**2) for map { 2 * $_ } 1 .. @at / 2 - 1;
}
print join(' ', map { sprintf '%s %d %.2f', $_, $paths{$_}, $mm{$_} } sort keys %mm), "\n";
END
measure() {
    perl measure.pl "$@"
}

# From (0, 0, 10), with half a field of view of 0.2 in each direction, a point is at 200 + 1000 x / (10 - z) of 400
# pixels; a pixel is 25.4 / 96 mm. The front square's half side is 500 / 9 pixels. The one behind it reaches from 0 to
# 120 and from -20 to 20: it loses its left side, and 500 / 9 pixels of its upper and lower side.
cat >squares.obj <<'END'
v -0.5 -0.5 1
v 0.5 -0.5 1
v 0.5 0.5 1
v -0.5 0.5 1
v 0 -0.2 0
v 1.2 -0.2 0
v 1.2 0.2 0
v 0 0.2 0
f 1 2 3 4
f 5 6 7 8
END
draw="render-gl -q squares.obj --camera 0,0,10:0,0,0 --fov 22.61986494804043 --size 400x400"
$draw -o squares.svg
is "a square hides a part of another one" "$(measure squares.svg)" \
    "outlines 2 $(awk 'BEGIN {printf "%.2f", (8 * 500 / 9 + 40 + 2 * (120 - 500 / 9)) * 25.4 / 96}')"
is "the page is as large as the picture" "$(grep -o 'width="[^"]*mm" height="[^"]*" viewBox="[^"]*"' squares.svg)" \
    'width="105.833mm" height="105.833mm" viewBox="0 0 105.833 105.833"'
is "the pen is as wide as the lines of the picture" "$(grep -o 'stroke-width="[^"]*"' squares.svg)" 'stroke-width="0.529"'

# The hidden path is 40 + 2 * 500 / 9 = 151.1 pixels long; dashes of 6 pens have gaps of about 4 between them.
$draw --hidden dash -o dashed.svg
is "hidden parts are dashed in a layer of their own" "$(measure dashed.svg | sed 's/ [0-9]* .*outlines/ N MM outlines/')" \
    "hidden N MM $(measure squares.svg)"
is "a dash is six pens long" \
    "$(measure dashed.svg | awk '{print $2, ($3 / $2 > 3.17 && $3 / $2 < 3.18)}')" "7 1"

# The sphere's outline is the circle of its tangents. From distance 6 with radius 1 it appears under the angle whose
# sine is 1 / 6: its radius is 1000 / sqrt(6 ^ 2 - 1) pixels where a distance of 1 at depth 1 is 1000 pixels.
meshgen sphere --faces 20000 -o sphere.glb
render-gl sphere.glb --camera 0,0,6:0,0,0 --fov 22.61986494804043 --size 400x400 -o sphere.svg
is "the outline of a sphere is one circle" "$(measure sphere.svg | awk '{
    want = 2 * 3.14159265 * 1000 / sqrt(35) * 25.4 / 96
    print $2, ($3 > 0.998 * want && $3 < 1.002 * want)}')" "1 1"

# A cylinder of radius 1 along y. From distance 10, its silhouettes are at z = 0.1 and x = sqrt(0.99); there, the right
# one is flush with a wall as far as y = 0, where depth does not step. A distance of 1 at z = 0.1 is 1000 / 9.9 pixels.
awk 'BEGIN {
    n = 960
    for (i = 0; i < n; i++)
        for (y = -1; y <= 1; y++) {
            x = cos(2 * 3.14159265 * i / n)
            z = sin(2 * 3.14159265 * i / n)
            print "v", x, y, z "\nvn", x, 0, z
        }
    for (i = 0; i < n; i++)
        for (k = 1; k <= 2; k++) {
            a = 3 * i + k
            b = 3 * ((i + 1) % n) + k
            print "f " a "//" a " " a + 1 "//" a + 1 " " b + 1 "//" b + 1 " " b "//" b
        }
    print "v 0.9 -1 0.1\nv 2 -1 0.1\nv 2 0 0.1\nv 0.9 0 0.1\nvn 0 0 1\nf -4//-1 -3//-1 -2//-1 -1//-1"
}' >wall.obj
render-gl -q wall.obj --camera 0,0,10:0,0,0 --fov 22.61986494804043 --size 400x400 -o wall.svg
is "an outline is left out where depth does not step" "$(perl -ne '
    my @at = / d="M([^"Z]*)/ ? split /[ L]/, $1 : ();
    for (1 .. @at / 2 - 1) {
        my ($x, $y, $u, $v) = map { $_ * 96 / 25.4 - 200 } @at[2 * $_ - 2 .. 2 * $_ + 1];
        $length[$x > 0] += abs($v - $y) if abs($u - $x) < 0.1 * abs($v - $y) && abs(abs($x) - 100.5) < 1;
    }
    END { printf "%.1f %.1f", map { $_ * 9.9 / 1000 } @length }' wall.svg)" "2.0 1.0"

# A fold from x = -0.5 to 0.5 at z = 0 hangs before a board, which lies 0.5 pixels behind it at one end and 10.5 at the
# other: a pixel is 0.01 there. The line begins where the board is 1.5 pixels behind, and goes on to the other end.
cat >fold.obj <<'END'
v -0.5 0 0
v 0.5 0 0
v 0.5 0.6 0
v -0.5 0.6 0
v 0.5 0.6 -0.3
v -0.5 0.6 -0.3
v -0.5 -0.6 -0.005
v 0.5 -0.6 -0.105
v 0.5 0.6 -0.105
v -0.5 0.6 -0.005
f 1 2 3 4
f 2 1 6 5
f 7 8 9 10
END
$(echo "$draw" | sed 's/squares/fold/') --lines silhouettes -o fold.svg
is "a step in depth is drawn until it is shallow" "$(measure fold.svg | awk '{
    px = $3 * 96 / 25.4
    print $2, (px > 86 && px < 94 ? "90" : px)}')" "1 90"

$(echo "$draw" | sed 's/squares/fold/') --lines silhouettes --hidden dash -o folded.svg
is "a line that is left out is not dashed" "$(measure folded.svg)" "hidden 0 0.00 $(measure fold.svg)"

# A board at z = 1 hides a larger one at z = -1, which has the same outline in the picture: no dash runs along that.
cat >boards.obj <<'END'
v -0.45 -0.45 1
v 0.45 -0.45 1
v 0.45 0.45 1
v -0.45 0.45 1
v -0.55 -0.55 -1
v 0.55 -0.55 -1
v 0.55 0.55 -1
v -0.55 0.55 -1
f 1 2 3 4
f 5 6 7 8
END
$(echo "$draw" | sed 's/squares/boards/') --hidden dash -o boards.svg
is "no dash runs along a line" "$(measure boards.svg | cut -d' ' -f 1-5)" "hidden 0 0.00 outlines 1"

# Two boards of 50 by 80 pixels, less a gap of 0.8 or 1.2 between them: two of their sides, which the pen of 2 pixels
# would draw over one another, are one line if they are at most half a pen apart.
for gap in 0.008 0.012; do
    cat >beside.obj <<END
v -0.5 -0.4 0
v 0 -0.4 0
v 0 0.4 0
v -0.5 0.4 0
v $gap -0.4 0
v 0.5 -0.4 0
v 0.5 0.4 0
v $gap 0.4 0
f 1 2 3 4
f 5 6 7 8
END
    $(echo "$draw" | sed 's/squares/beside/') -o beside.svg
    measure beside.svg | awk '{printf "%.0f ", $3 * 96 / 25.4}'
done >lengths
is "lines at most half a pen apart are one" "$(cat lengths)" "438 518 " # 520 - 2 * 0.8 - 80, 520 - 2 * 1.2

# Bars before the fold, at z = 1, hide 1.5 and 2.5 pixels of its line. The pen is 2 pixels wide, and its round caps fill
# the gap of the first one.
for width in 0.0135 0.0225; do
    { sed '/^f/d' fold.obj
      echo "v 0.2 -0.1 1"
      awk -v "x=$width" 'BEGIN {print "v", 0.2 + x, "-0.1 1\nv", 0.2 + x, "0.1 1"}'
      echo "v 0.2 0.1 1"
      sed -n '/^f/p' fold.obj
      echo "f 11 12 13 14"; } >bar.obj
    $(echo "$draw" | sed 's/squares/bar/') --lines silhouettes -o $width.svg
done
is "ends whose caps touch are joined" "$(grep -c '<path' 0.0135.svg) $(grep -c '<path' 0.0225.svg)" "1 2"

# Lines of 8 and of 5 pixels that meet no other
for length in 0.08 0.05; do
    sed "s/^v -0.5 0/v 0 0/; s/^v 0.5 0/v $length 0/; s/^v -0.5 0.6/v 0 0.6/; s/^v 0.5 0.6/v $length 0.6/; /^f 7/d" \
        fold.obj >short.obj
    $(echo "$draw" | sed 's/squares/short/') --lines silhouettes -o $length.svg 2>.err
done
is "a line of 8 pixels is drawn, one of 5 is not" "$(grep -c '<path' 0.08.svg) $(grep -c '<path' 0.05.svg)" "1 0"

size() {
    grep -o 'viewBox="[^"]*"' a.svg
}
render-gl -q squares.obj --size 400x300 --page a4 --pen 0.3mm -o a.svg
is "a named page lies as the picture does" "$(size)" 'viewBox="0 0 297 210"'
is "--pen is the width of the strokes" "$(grep -o 'stroke-width="[^"]*"' a.svg)" 'stroke-width="0.3"'
render-gl -q squares.obj --size 300x400 --page letter -o a.svg
is "a high picture is on an upright page" "$(size)" 'viewBox="0 0 215.9 279.4"'
render-gl -q squares.obj --size 300x400 --page 10000x1mm --margin 0 -o a.svg
is "a page may be ten metres long" "$(size)" 'viewBox="0 0 10000 1"'
refuses() { # refuses NAME WORDS ARGUMENTS ...
    name=$1 words=$2
    shift 2
    try render-gl -q squares.obj "$@"
    is "$name" "$status $(grep -cF -e "$words" .err)" "2 1"
}
refuses "a page of no size" "--page 0x10: want" --page 0x10 -o a.svg
refuses "a page that is too large" "from 1x1 to 10000x10000" --page 10001x10 -o a.svg
refuses "an unknown page" "want a0 to a6" --page a9 -o a.svg
refuses "margins that leave nothing" "--margin 105mm leaves nothing of a page of 297 by 210 mm" \
    --page a4 --margin 105mm -o a.svg
refuses "a margin that is no length" "--margin 5cm: want a length" --page a4 --margin 5cm -o a.svg
refuses "a margin without a page" "--margin needs --page" --margin 5 -o a.svg
refuses "a pen that is too narrow" "--pen 0.009: want a length from 0.01 to 100 mm" --pen 0.009 -o a.svg
refuses "a pen that is too wide" "--pen 100.1mm: want a length from 0.01 to 100 mm" --pen 100.1mm -o a.svg
for width in 0.01 100; do
    render-gl -q squares.obj --pen ${width}mm -o pen.svg
    is "a pen of $width mm" "$(grep -o 'stroke-width="[^"]*"' pen.svg)" "stroke-width=\"$width\""
done
render-gl -q squares.obj --page 1x1mm --margin 0 --line-width 0.25 -o small.svg
is "no pen is so narrow that it draws nothing" "$(grep -o 'stroke-width="[^"]*"' small.svg)" 'stroke-width="0.001"'
ok "margins that leave a little" render-gl -q squares.obj --page a4 --margin 104.9mm -o little.svg
refuses "a pen without width" "--pen 0: want a length from 0.01 to 100 mm" --pen 0 -o a.svg
refuses "a page for a picture" "--page needs --output *.svg or *.tsv: it shapes a drawing" -t gouraud --page a4 -o a.png
refuses "shadows in a drawing" \
    "--shadows cannot be combined with --output *.svg without --technique traced or strokes: a drawing without strokes" \
    --shadows 0.1 -o a.svg
refuses "samples of a drawing" "--samples cannot be combined with --output *.svg: a drawing consists of lines" \
    --samples 4 -o a.svg

refuses "an option of a technique" "--stroke cannot be combined with --output *.svg: a drawing has lines alone" \
    -t rptam --stroke 20x2 -o a.svg
refuses "light that moves in a film of drawings" "--animate light: a drawing, which has lines alone, does not use it" \
    -n 2 --animate light=0:0..9:9 -o a%d.svg
ok "any technique draws lines" render-gl -q squares.obj -t gouraud --crease 30 -n 2 --animate zoom=1..2 -o any%d.svg

# A sheet that a morph target folds has a crease in the second frame only. The triangle behind it in the file, which
# stays as it is, keeps its number.
perl -MMIME::Base64 -e '
    my $data = pack("f<*", (-3, 0, 0, -2, 0, 0, -1, 0, 0, -3, 1, 0, -2, 1, 0, -1, 1, 0),
        (0) x 6, -1, 0, 1, (0) x 6, -1, 0, 1, (1, 0, 0, 2, 0, 0, 1, 1, 0), 0, 1, 0, 1)
        . pack("v*", 0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4);
    my @views = map { qq({"buffer":0,"byteOffset":$_->[0],"byteLength":$_->[1]}) }
        [0, 72], [72, 72], [144, 36], [180, 8], [188, 8], [196, 24];
    my @of = (["VEC3", 6, qq("min":[-3,0,0],"max":[-1,1,0],)], ["VEC3", 6, qq("min":[-1,0,0],"max":[0,0,1],)],
        ["VEC3", 3, qq("min":[1,0,0],"max":[2,1,0],)], ["SCALAR", 2, qq("min":[0],"max":[1],)], ["SCALAR", 2, ""]);
    my @accessors = map { qq({"bufferView":$_,"type":"$of[$_][0]","count":$of[$_][1],$of[$_][2]"componentType":5126}) }
        0 .. 4;
    printf q({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0},{"mesh":1}],
        "meshes":[{"weights":[0],"primitives":[{"attributes":{"POSITION":0},"indices":5,"targets":[{"POSITION":1}]}]},
        {"primitives":[{"attributes":{"POSITION":2}}]}],"animations":[{"samplers":[{"input":3,"output":4}],
        "channels":[{"sampler":0,"target":{"node":0,"path":"weights"}}]}],"bufferViews":[%s],"accessors":[%s,
        {"bufferView":5,"type":"SCALAR","count":12,"componentType":5123}],
        "buffers":[{"byteLength":220,"uri":"data:application/octet-stream;base64,%s"}]}),
        join(",", @views), join(",", @accessors), encode_base64($data, "")' >sheet.gltf
render-gl -q sheet.gltf -n 2 --rate 1 --camera 0,2,9:0,0,0 --lines creases --size 300x200 -o fold%d.svg
is "a fold is a crease in the frames in which it is folded" "$(grep -c '<path' fold0.svg fold1.svg | tr '\n' ' ')" \
    "fold0.svg:0 fold1.svg:1 "
render-gl -q sheet.gltf -n 2 --rate 1 --camera 0,2,9:0,0,0 --lines creases,boundaries --size 300x200 -o sheet%d.svg
for frame in 0 1; do
    grep 'id="outlines-1"' sheet$frame.svg | grep -oE '[0-9.]+ [0-9.]+' | sort >corners$frame
done
ok "what stays the same keeps its number" cmp corners0 corners1

# A prism turns by 45 degrees at its eight long edges. Smooth normals that a command adds tell nothing of them; those of
# a file do.
awk 'BEGIN {
    for (i = 0; i < 16; i++)
        print "v", cos(int(i / 2) * atan2(1, 1)), i % 2 * 2 - 1, sin(int(i / 2) * atan2(1, 1))
    for (i = 0; i < 8; i++)
        print "f", 2 * i + 1, 2 * i + 2, (2 * i + 3) % 16 + 1, (2 * i + 2) % 16 + 1
    print "f 1 3 5 7 9 11 13 15\nf 16 14 12 10 8 6 4 2"
}' >prism.obj
awk '/^f/ && NF == 5 {$0 = "f " $2 "//" $2 " " $3 "//" $3 " " $4 "//" $4 " " $5 "//" $5}
    1
    /^v/ {print "vn", $2, 0, $4}' prism.obj >smooth.obj
for by in dirfield lapped-param "strokegen --levels 2" meshfit; do
    $by -q prism.obj -o prism.glb
    $by -q smooth.obj -o smooth.glb
    for of in prism.obj prism.glb smooth.obj smooth.glb; do
        render-gl -q $of --lines creases -o $of.svg
    done
    is "creases are the same after $by" "$(measure prism.glb.svg)" "$(measure prism.obj.svg)"
    is "normals of a file are so after $by" "$(measure smooth.glb.svg)" "$(measure smooth.obj.svg)"
done
is "a smooth prism has the creases of its ends alone" "$(measure smooth.obj.svg | cut -d ' ' -f 2)" 2

render-gl -q squares.obj --turntable -n 3 --size 200x200 -o f%d.svg
is "a film has a drawing per frame" "$(grep -c 'id="outlines-1"' f0.svg f1.svg f2.svg | tr '\n' ' ')" \
    "f0.svg:1 f1.svg:1 f2.svg:1 "
render-gl -q squares.obj -j 1 --size 200x200 -o one.SVG
render-gl -q squares.obj -j 2 --size 200x200 -o two.svg
ok "the drawing does not depend on threads" cmp one.SVG two.svg
try render-gl --up z squares.obj --lines none -o none.svg
is "a drawing may be empty, and needs no pen" "$status$(measure none.svg)" 0
empty="render-gl: squares.obj: warning: 1 of 1 drawings is empty:"
is "a warning tells that it is" "$(cat .err)" \
    "$empty --lines none draws no feature lines, and the technique has no strokes for a pen"
try render-gl --up z squares.obj --camera 0,0,9:0,0,20 -o none.svg
is "a warning tells that nothing is in sight" "$status $(cat .err)" "0 $empty no feature line is in sight"
sed "/^f 5/d" squares.obj >one.obj
try render-gl -v --camera 0,0,9:0,0,0 one.obj -o one.svg
is "one path is singular" "$(grep -oE '[0-9]+ paths?' .err)" "1 path"
ok "a drawing needs no OpenGL" env __EGL_VENDOR_LIBRARY_FILENAMES=/dev/null render-gl -q squares.obj -o a.svg

cp squares.obj 'two squares.obj'
ok "plot.mk draws into another folder" make -s -f "$TOP/pipelines/plot.mk" SCENE='two squares.obj' PAGE=a5 OUT=away \
    OPTIONS=-q
is "plot.mk names the drawing after the scene" "$(grep -c 'viewBox="0 0 210 148"' 'away/two squares.svg')" 1

# A single-sided square from behind: nothing of it is in sight, and no surface hides it.
meshgen plane --faces 2 -o back.glb
unpack back.glb back
sed -i 's/"meshes":/"materials":[{}],&/; s/"indices":/"material":0,&/' back.gltf
try render-gl back.gltf --camera 0,0,-4:0,0,0 --hidden dash -o back.svg
is "edges of faces that are seen from behind are not hidden ones" "$status $(grep -c '<path' back.svg) $(grep -c 'is empty' .err)" "0 0 1"

# A pipe along the view, and a bar before its near end, nearer by much less than a pixel is large at its far end: the bar
# hides the outline, whichever end of the pipe comes first in the file.
for far in 0 1; do
    awk -v far=$far 'BEGIN {
        for (ring = 0; ring < 2; ring++)
            for (i = 0; i < 64; i++)
                print "v", .1 * cos(i * .09817477), .1 * sin(i * .09817477) - .3, ring == far ? 9 : -190
        for (i = 1; i <= 64; i++)
            print "f", i, i % 64 + 1, i % 64 + 65, i + 64
        print "v -.3 -.3 8.2\nv .3 -.3 8.2\nv .3 -.261 8.2\nv -.3 -.261 8.2\nf 129 130 131 132"
    }' >pipe.obj
    view='pipe.obj --camera 0,0,10:0,0,0 --fov 22.62 --size 400x400 --lines silhouettes'
    # shellcheck disable=SC2086
    render-gl -q $view -o pipe$far.svg
    # shellcheck disable=SC2086
    render-gl -q $view -t gouraud --tone-range 0:0 -o pipe$far.png
done
is "a bar hides a pipe's outline, whichever end is first" "$(measure pipe0.svg | cut -d' ' -f 1-2) $(measure pipe1.svg)" \
    "outlines 3 $(measure pipe0.svg)"
is "in pictures, too" "$(hatchstat diff pipe0.png pipe1.png | awk 'NR == 2 {print ($6 < 1e-4)}')" 1
finish
