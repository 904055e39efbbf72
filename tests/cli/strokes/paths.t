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
