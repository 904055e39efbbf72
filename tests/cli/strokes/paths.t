# --technique strokes: sorting and blending collect the same strokes, and draw nearly the same pictures.
. "${TOP:-.}/tests/tap.sh"

meshgen plane --faces 200 -o plane.glb
meshgen torus -o torus.glb
meshgen teapot -o teapot.glb

# draw HOW ARGUMENT ...: draws HOW.exr; HOW.note says how many strokes, fragments and waiting strokes there were
draw() {
    how=$1
    shift
    render-gl -v -t strokes --aggregate "$how" --lines none --size 480x360 "$@" 2>"$how.err"
    sed -n 's/.*: \([0-9]* strokes\), \([0-9]* fragments\), \([0-9]*\) waited$/\1 \2 \3/p' "$how.err" >"$how.note"
}

for shape in plane torus teapot; do
    draw sort $shape.glb -o sort.exr
    draw blend $shape.glb -o blend.exr
    is "$shape: both find the same strokes and fragments" "$(cut -d' ' -f1-4 blend.note)" "$(cut -d' ' -f1-4 sort.note)"
    is "$shape: nobody waits when fragments are sorted" "$(cut -d' ' -f5 sort.note)" 0
    ok "$shape: strokes meet in a new table" test "$(cut -d' ' -f5 blend.note)" -gt 0
    hatchstat diff sort.exr blend.exr >diff.tsv
    ok "$shape: the pictures differ little" awk 'NR == 2 {exit !($2 < 0.04)}' diff.tsv
    ok "$shape: the tones are equal" awk 'NR == 2 {exit !($3 > -0.01 && $3 < 0.01)}' diff.tsv
done

# The report of times has the numbers that --verbose tells.
for how in sort blend; do
    draw $how torus.glb -o picture.exr
    render-gl -q -t strokes --aggregate $how --lines none --size 480x360 torus.glb --time 1 -o times.tsv
    is "$how: --time counts strokes" "$(cut -f1,2,11- times.tsv | sed -n '1p;2p;$p' | tr '\t\n' '  ')" \
        "technique span stroke_count fragment_count waited strokes frame \
$(sed 's/ [a-z][a-z]*//g' $how.note) gouraud frame nan nan nan "
done

# A film: the totals are the sums of its pictures, in notes and in the report. With blending, which strokes wait depends on
# the order of the fragments, but not how many they are with those that are drawn.
for how in sort blend; do
    draw $how torus.glb --frames 3 --turntable -o film%d.exr
    sums=$(awk '{s += $1; f += $3; w += $5} END {print s, f, w}' $how.note)
    is "$how: a film tells its totals" "$(sed -n 's/.*: \(.*\) in all 3 pictures$/\1/p' $how.err)" \
        "$(echo "$sums" | sed 's/ / strokes, /; s/ \([0-9]*\)$/ fragments, \1 waited/')"
    render-gl -q -t strokes --aggregate $how --lines none --size 480x360 torus.glb --time 1 --frames 3 --turntable \
        -o times.tsv
    is "$how: --time has them in a line of the film" \
        "$(tail -n 1 times.tsv | awk '{print $1, $2, $3, $(NF - 2) + $NF, $(NF - 1), ($NF > 0)}')" \
        "strokes film 3 $(echo "$sums" | awk '{print $1 + $3, $2, ($3 > 0)}')"
    is "$how: and the first picture's in that of the frame" "$(sed -n 2p times.tsv | cut -f2,11- | tr '\t' ' ')" \
        "frame $(sed -n '1s/ [a-z][a-z]*//gp' $how.note)"
done
render-gl -q -t gouraud --lines none --size 48x36 torus.glb --time 1 --frames 2 --turntable --json -o times.json
ok "the film of a technique without strokes" grep -q '"span": *"film", *"frames": *2,.*"waited": *null' times.json

# A film leaves out strokes that are in sight for one or two frames; before the first and after the last, all are.
film="torus.glb -q -t strokes --lines none --size 240x180"
for threads in 1 2; do
    render-gl $film --frames 5 --animate from=0:20..40:20 --threads $threads -o film$threads-%d.png
done
for from in 0 20 40; do
    render-gl $film --from $from:20 -o alone$from.png
done
is "threads do not change a film" "$(cat film1-?.png | cksum)" "$(cat film2-?.png | cksum)"
is "strokes come into sight in its first picture" "$(cksum <film1-0.png)" "$(cksum <alone0.png)"
is "and go in its last" "$(cksum <film1-4.png)" "$(cksum <alone40.png)"
hatchstat diff film1-2.png alone20.png >diff.tsv
ok "between, some do not last" awk 'NR == 2 {exit !($3 > 0)}' diff.tsv
render-gl $film --frames 5 --animate from=0:20..200:20 -o far%d.png
render-gl $film --from 100:20 -o alone100.png
is "views far apart have all strokes" "$(cksum <far2.png)" "$(cksum <alone100.png)"

# The table grows with the strokes, and none is lost.
draw sort plane.glb --stroke 5x1 -o sort.exr
draw blend plane.glb --stroke 5x1 -o blend.exr
is "a table that is too small" "$(cut -d' ' -f1-4 blend.note)" "$(cut -d' ' -f1-4 sort.note)"
ok "has many strokes: $(cat blend.note)" test "$(cut -d' ' -f1 blend.note)" -gt 4000

# A frame whose strokes are in the table of the frame before finds them there.
draw blend torus.glb --frames 3 -o still%d.exr
is "later frames of a still film wait for nobody" "$(cut -d' ' -f5 blend.note | tail -n 2 | tr '\n' ' ')" "0 0 "
ok "and show the same" test "$(hatchstat diff still0.exr still2.exr | awk 'NR == 2 {print ($2 < 0.001)}')" = 1
finish
