# Memory that runs out in any allocation, also inside libraries, ends a command with status 5, one line and no output,
# or does not matter to the result. LONG=1 makes every allocation fail, and takes hours.
. "${TOP:-.}/tests/tap.sh"
library=$BUILD/tests/memory/fail_malloc.so
[ -z "$SANITIZE" ] || { skip "failing allocations" "sanitizers have an allocator of their own"; finish; }
[ -e "$library" ] || { skip "failing allocations" "make check builds the library that makes them fail"; finish; }

mkdir in
(
    cd in || exit
    perl "$TOP/tests/bytes/scenes.pl"
    cp "$TOP"/tests/fuzz/corpus/foreign/a.* .
    echo '<svg viewBox="0 0 9 9"><style>path{stroke:red}</style><path d="m1,4q3-5,6,1m-6,2h8" fill="none"
        stroke-dasharray="2 .5"/></svg>' >drawing.svg
    # A palette with transparent entries, for which libpng allocates memory.
    perl -e 'print pack "H*", join "", @ARGV' 89504e470d0a1a0a0000000d4948445200000003000000010203000000668efc27 \
        00000009504c5445ff00000033000000ff01afc8500000000274524e53ff335a67515c0000000a494441 \
        5478da63900000001a001980008ebb0000000049454e44ae426082 >clear.png
    printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n' >a.obj
    printf 'vertex\tdx\tdy\tdz\tweight\n7\t1\t1\t0\t10\n' >hand.tsv
    printf 'brush pencil\nwidth 3\nlength 0.2 0.5\n' >own.style
    printf 'kind strokes\nlength 0.1\nwidth 0.1\ndensity 2\n' >own.solid
    printf 'tone 0..0.6 turn 30 length 30 width 3 ink 0.6 stroke pencil\ntone 0.4..1 length 6 width 6\n' >two.layers
    tamgen -n 64 -l 2 -t 3 -o map.exr
    tamgen -n 64 -l 1 -t 2 --set 'darkest 1' -r strokes.tsv -o fine.exr
    tamgen -n 64 -l 1 -t 2 -p dusk --set 'darkest 1' -o colour.exr
    tamgen -n 64 -l 1 -t 1 -o /dev/null -x stroke.png
    tamvol -q -t 4 fine.exr -o volume.ktx2
    tamvol -q -t 2 fine.exr -o plain.exr
    tamthresh -q fine.exr -o steps.ktx2
    tamthresh --exact fine.exr -o exact.ktx2
    meshgen torus --faces 60 -o torus.glb
    render-gl torus.glb --size 32x24 --needs -o torus.needs
    dirfield torus.glb -o field.glb
    lapped-param --mask-size 64 field.glb -o lapped.glb
    strokegen -g 0.5 -l 2 torus.glb -o strokes.glb
    strokegen -g 0.1 -l 1 torus.glb -o sparse.glb
    seedgen -n 16 -l 2 -o two.seeds
    solidgen -n 8 -o solid.ktx2
    solidgen -n 8 -o solid.exr
) || exit 1

tab=$(printf '\t')
perl "$TOP/tests/memory/runs.pl" "$library" "$TOP/tests/memory/cases.tsv" >report
while IFS=$tab read -r name last runs limits wrong; do
    is "$name: $last allocations, $runs runs, $limits with status 5" "$wrong" ""
done <report
[ -n "${ONLY:-}" ] || is "every case was run" "$(wc -l <report)" "$(grep -cv '^#' "$TOP/tests/memory/cases.tsv")"
for command in $(cut -f1 "$TOP/tests/cli/commands.tsv" | grep -v '^#' | sort -u); do
    ok "$command is among the cases" grep -q "$tab$command " "$TOP/tests/memory/cases.tsv"
done
finish
