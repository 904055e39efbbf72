# Strokes of --technique traced in SVG drawings: their tone, their places, their layers.
. "${TOP:-.}/tests/tap.sh"

meshgen plane --faces 200 | strokegen -q --levels 7 --angles 0 -o plane.glb
meshgen sphere --faces 2000 | strokegen -q --levels 5 -o ball.glb

# figures FILE: prints the area of the strokes' centre lines times their width, as a share of the page, and their largest
# distance from the middle of the page
figures() {
    perl -ne 'if (/<svg.*width="([\d.]+)mm" height="([\d.]+)mm"/) { ($w, $h) = ($1, $2) }
        if (/<g id="([a-z]+).*stroke-width="([\d.]+)"/) { ($layer, $pen) = ($1, $2) }
        next unless $layer eq "strokes" && / d="([^"]*)"/;
        for my $part (split /M/, $1) {
            my @n = $part =~ /-?[\d.]+/g;
            for (my $i = 0; $i < @n; $i += 2) {
                my $far = sqrt(($n[$i] - $w / 2) ** 2 + ($n[$i + 1] - $h / 2) ** 2);
                $most = $far if $far > $most;
                $sum += $pen * sqrt(($n[$i] - $n[$i - 2]) ** 2 + ($n[$i + 1] - $n[$i - 1]) ** 2) if $i;
            }
        }
        END { printf "%.3f %.2f\n", $sum / ($w * $h), $most }' "$1"
}
# near NAME GOT WANT OFF
near() {
    is "$1: $2 for $3" "$(awk -v got="$2" -v want="$3" -v off="$4" \
        'BEGIN {print (got != "" && (got - want) ^ 2 <= off ^ 2)}')" 1
}
draw() {
    render-gl -q -t traced --lines none --margin 0mm "$@"
}

# The plane fills the page: strokes cover the share of it that is its tone, with any pen.
for tone in .1 .3 .5; do
    for pen in 0.3mm 0.6mm; do
        draw plane.glb --size 400x400 --camera 0,0,3.7320508:0,0,0 --fov 25 --tone-range $tone:$tone \
            --page 160x160mm --pen $pen -o plane.svg
        near "a plane of tone $tone drawn by a pen of $pen" "$(figures plane.svg | cut -d' ' -f1)" $tone .03
    done
done

# A pen cannot draw wider strokes where a file has too few; finer ones are traced.
meshgen plane --faces 200 | strokegen -q --levels 4 --angles 0 -o coarse.glb
for pen in 0.8mm 1mm 1.5mm; do
    draw coarse.glb --size 400x400 --camera 0,0,3.7320508:0,0,0 --fov 25 --tone-range .6:.6 --page 160x160mm --pen $pen \
        -o plane.svg
    near "a plane with few strokes drawn by a pen of $pen" "$(figures plane.svg | cut -d' ' -f1)" .6 .05
done

echo "width 24" >broad.style
draw plane.glb --size 400x400 --camera 0,0,3.7320508:0,0,0 --fov 25 --tone-range .3:.3 --page 160x160mm --pen 0.3mm \
    --stroke-style ./broad.style -o plane.svg
near "a plane in a style of broad strokes drawn by a thin pen" "$(figures plane.svg | cut -d' ' -f1)" .3 .03

# Each dot of a stippled plane is a path; together they cover its tone. Strokes with breaks have more paths than whole ones.
marks() {
    draw plane.glb --size 400x400 --camera 0,0,3.7320508:0,0,0 --fov 25 --tone-range .2:.2 --page 100x100mm --pen 0.65mm \
        --stroke-style "$1" -o plane.svg
    grep -o M plane.svg | wc -l
}
near "the dots of a stippled plane cover" "$(marks stipple | awk '{print 1 - exp(-$1 * 3.14159 * .65 ^ 2 / 4 / 1e4)}')" .2 .03
echo "marks 20 4" >dashes.style
echo "marks 0 0" >whole.style
whole=$(marks ./whole.style)
is "strokes with breaks are several paths" "$(marks ./dashes.style | awk -v whole="$whole" '{print ($1 > 3 * whole)}')" 1

try render-gl -t traced plane.glb --camera 0,0,2:0,0,9 --size 64x64 -o empty.svg
is "a drawing without lines and strokes" "$status $(grep -c 'no stroke and no feature line is in sight' .err)" "0 1"
try render-gl -t traced plane.glb --lines none --camera 0,0,2:0,0,9 --size 64x64 -o empty.svg
is "a drawing without strokes" "$status $(grep -c 'empty: no stroke is in sight' .err)" "0 1"

# A ball of radius 1 at distance 4, field of view 60 degrees: its outline is a circle of 1 / sqrt(15) / tan(30) half pages.
draw ball.glb --size 400x400 --camera 0,0,4:0,0,0 --fov 60 --page 100x100mm --pen 0.2mm -o ball.svg
is "no stroke leaves the ball" "$(figures ball.svg | awk '{print ($2 > 15 && $2 < 22.4)}')" 1
is "each direction is a layer" "$(grep -o 'inkscape:label="strokes-[0-9]*"' ball.svg | sort -u | wc -l)" 2
draw ball.glb --size 400x400 --camera 0,0,4:0,0,0 --fov 60 --page 100x100mm --pen 0.2mm -j 1 -o again.svg
ok "the same drawing with another number of threads" cmp -s ball.svg again.svg
# Two inks on a middle tone: each has layers of its own, and lines lie over the lighter ones.
render-gl -q -t traced ball.glb --size 400x400 --paper '#808080' --ink '#102030,#f0e0d0' -o inks.svg
is "each ink has its layers" "$(grep -o '<g id="[^"]*"\|stroke="#[^"]*"' inks.svg | tr '\n' ' ')" \
    '<g id="light-1" stroke="#f0e0d0" <g id="light-2" stroke="#f0e0d0" <g id="outlines" stroke="#102030" '\
'<g id="strokes-1" stroke="#102030" <g id="strokes-2" stroke="#102030" '
is "the lighter ink draws the lit half, the other one the rest" "$(perl -ne '
    $layer = $1 if /<g id="(\w+)/;
    next unless / d="([^"]*)"/;
    my @n = $1 =~ /-?[\d.]+/g;
    for (my $i = 0; $i < @n; $i += 2) {
        $count{$layer}++;
        $sum{$layer} += $n[$i] + $n[$i + 1];
    }
    END { printf "%d %d", $sum{light} / $count{light} < 95, $sum{strokes} / $count{strokes} > 115 }' inks.svg)" "1 1"
for format in svg tsv; do
    try render-gl -q -t traced ball.glb --stroke-width 2 -o "wide.$format"
    refused "the width of strokes of a .$format" 2 2
    try render-gl -q -t traced ball.glb -n 2 --animate stroke-width=1..2 -o "wide%d.$format"
    refused "a film of widths of strokes of a .$format" 2 2
done
ok "strokes with outlines" render-gl -q -t traced ball.glb --size 400x400 --page 100x100mm -o outlined.svg
ok "outlines have a layer of their own" grep -q 'inkscape:label="outlines"' outlined.svg
# groups OPTION ...: the layers of a drawing
groups() {
    render-gl -q -t traced ball.glb --size 100x80 -o groups.svg "$@"
    grep -o '<g id="[^"]*"' groups.svg | cut -d '"' -f 2 | tr '\n' ' '
}
is "each layer is of a pen that draws" "$(groups), $(groups --hidden dash), $(groups --lines none)" \
    "outlines strokes-1 strokes-2 , outlines hidden strokes-1 strokes-2 , strokes-1 strokes-2 "
meshgen sphere >bare.glb
try render-gl -t traced bare.glb -o bare.svg
refused "a scene without strokes" 3 1
finish
