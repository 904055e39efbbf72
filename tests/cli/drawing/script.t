# Drawings of render-gl as stroke scripts: tamgen draws the same map of them as of the SVG drawing of the same view.
. "${TOP:-.}/tests/tap.sh"

meshgen teapot --faces 2000 -o bare.glb
strokegen -q --levels 5 bare.glb -o traced.glb

# replay SCRIPT DRAWING: prints whether two maps, one of each file, have the same images, and whether they show strokes
replay() {
    for file in "$1" "$2"; do
        tamgen -q --style drawing --size 128 --levels 2 --tones 3 --replay "$file" -o "$file.exr" || return 1
    done
    hatchstat diff "$1.exr" "$2.exr" | awk 'NR == 2 {print ($1 == 0 && $2 == 0)}'
    hatchstat tam "$1.exr" | awk -F'\t' 'NR == 1 {for (i = 1; i <= NF; i++) if ($i == "tone") at = i}
        $at > most {most = $at} END {print (most > 0.02)}'
}
same="1
1"

# A page of a colour, a pen, directions in layers; in both files lengths are rounded to a thousandth of a millimetre.
for options in "traced.glb -t traced --ink #804020 --page 150x150mm --pen 0.4mm --size 300x300" \
    "bare.glb --hidden dash --sort none --line-color blue --size 300x300"; do
    render-gl -q $options -o one.tsv
    render-gl -q $options -o one.svg
    is "a map of the script and of the drawing: $options" "$(replay one.tsv one.svg)" "$same"
    is "as many strokes as paths: $options" "$(sed 1d one.tsv | wc -l)" "$(grep -c '<path' one.svg)"
done
render-gl -q bare.glb --size 300x150 --page 200x100mm --margin 0 --pen 1 --sort none -o wide.tsv
render-gl -q bare.glb --size 300x150 --page 200x200mm --margin 0 --pen 1 --sort none -o wide.svg
is "a wide page lies in the middle of the tile" "$(replay wide.tsv wide.svg)" "$same"

ok "lines alone need no OpenGL" env __EGL_VENDOR_LIBRARY_FILENAMES=/dev/null render-gl -q bare.glb -o lines.TSV
render-gl -q bare.glb --turntable -n 2 --size 99x99 -o f%d.tsv
is "a film has a script per frame" "$(head -qn 1 f0.tsv f1.tsv | cut -f 1-3 | tr '\t\n' ' ')" "x y length x y length "
render-gl -q bare.glb --up z --lines none -o none.tsv
is "a script may have no strokes" "$(wc -l <none.tsv)" 1
render-gl -q bare.glb -t gouraud --samples 1 --size 9x9 --time 1 -o times.tsv
is "times are a table, whose name may end alike" "$(head -n 1 times.tsv | cut -f 1)" technique

refuses() { # refuses NAME WORDS ARGUMENTS ...
    name=$1 words=$2
    shift 2
    try render-gl -q bare.glb "$@"
    is "$name" "$status $(grep -cF -e "$words" .err)" "2 1"
}
refuses "samples of a script" "--samples cannot be combined with --output *.tsv without --time or --probe: a drawing" \
    --samples 4 -o a.tsv
refuses "paper of lines alone" "a stroke script of lines alone has neither paper nor tone" --paper grey -o a.tsv
refuses "light of lines alone" "a stroke script of lines alone has neither paper nor tone" --light 0:0 -o a.tsv
refuses "an option of a technique" "--stroke cannot be combined with --output *.tsv: a drawing has lines alone" \
    -t rptam --stroke 20x2 -o a.tsv
refuses "a page of a report" "--page cannot be combined with --time: it shapes a drawing" \
    -t gouraud --time 1 --page a4 -o a.tsv
refuses "the width of lines that are not timed" "--line-width cannot be combined with --time without" \
    -t gouraud --time 1 --line-width 3 -o a.tsv
try render-gl -q bare.glb --page 1x1mm --margin 0 --pen 5 -o a.tsv
refused "a pen wider than four pages" 5 1
finish
