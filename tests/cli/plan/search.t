# hatchplan: which candidates it looks at, measures in full and times again, where the figures of all are known.
. "${TOP:-.}/tests/tap.sh"
mkdir -p known/bin
cp "$BIN/hatchplan" known/bin
cp "$TOP/tests/cli/plan/known.pl" known/bin/render-gl
chmod +x known/bin/render-gl
KNOWN=$WORK/candidates RUNS=$WORK/runs
export KNOWN RUNS
meshgen plane --faces 2 -o plane.glb

# plan OPTION ...: runs hatchplan with the candidates of standard input, for known.pl. Prints the runs: s and f for
# small and full pictures of rptam, S and F for those of strokes; the length of strokes, and b if they are blended; and
# how often each picture is drawn.
plan() {
    : >"$RUNS"
    cat >"$KNOWN"
    known/bin/hatchplan --size 320x320 --stroke-width 1 "$@" plane.glb >table.tsv || echo "status $?"
    sed '/gouraud/d
        s/^small rptam /s/; s/^full rptam /f/; s/^small strokes /S/; s/^full strokes /F/
        s/x1 blend /b:/; s/x1 /:/' "$RUNS" | paste -sd' '
}
# table: the candidates of the table, with their times and errors, and with a star beside the choice
table() {
    awk -F'\t' 'NR > 1 {
        split($2, parameters, /[= ]/)
        printf "%s %s: %.4g ms, %.3g%s\n", $1, parameters[2], $3, $6, $8 == "yes" ? " *" : "" }' table.tsv
}

# The first look misses the tolerance: both neighbours are looked at, the one with more work first. Strokes of 40 are so
# far from it that they are not measured in full.
is "a tolerance: to more work, until it is kept" "$(plan --techniques rptam --tolerance .1 <<'EOF'
rptam 40x1 | 45 .2 | 45 .2
rptam 20x1 | 50 .12 | 50 .12
rptam 10x1 | 80 .06 | 80 .06
EOF
)" "s20:6 s10:6 s40:6 f10:4 f20:4"
is "the only one within it is chosen" "$(table)" "rptam 20: 50 ms, 0.12
rptam 10: 80 ms, 0.06 *"
is "full pictures count, and no more work is tried than is needed" "$(plan --techniques rptam --tolerance .1 <<'EOF'
rptam 40x1 | 40 .12 | 40 .09
rptam 20x1 | 50 .08 | 50 .08
EOF
)" "s20:6 s40:6 f20:4 f40:4"
is "the faster one is chosen" "$(table)" "rptam 40: 40 ms, 0.09 *
rptam 20: 50 ms, 0.08"
# Strokes of length 20 are slower and less exact than those of 10 in small pictures, and may be faster in full ones.
is "one that another covers is measured where it may be the best" "$(plan --techniques rptam --tolerance .1 <<'EOF'
rptam 40x1 | 90 .2 | 90 .2
rptam 20x1 | 50 .11 | 45 .09
rptam 10x1 | 49 .08 | 52 .08
EOF
)" "s20:6 s10:6 s40:6 f10:4 f20:4"
is "and chosen where it is" "$(table)" "rptam 20: 45 ms, 0.09 *
rptam 10: 52 ms, 0.08"

# Strokes of 10 are useful until those of 40 have been looked at, which are faster and more exact.
is "without limits the useful ones are measured, the most exact first" "$(plan --techniques rptam <<'EOF'
rptam 40x1 | 60 .04 | 60 .04
rptam 20x1 | 50 .08 | 50 .08
rptam 10x1 | 80 .05 | 80 .05
EOF
)" "s20:6 s10:6 s40:6 f40:4 f20:4"
is "and told by time" "$(table)" "rptam 20: 50 ms, 0.08
rptam 40: 60 ms, 0.04"

# In full pictures the most exact one takes 62 ms at first, but may be within the limit: it is timed again.
is "a budget of time: what is nearly within it is timed again" "$(plan --techniques rptam --budget ms=60 <<'EOF'
rptam 40x1 | 45 .12 | 45 .12
rptam 20x1 | 50 .08 | 50 .08
rptam 10x1 | 70 .05 | 62,58,58 .05
EOF
)" "s20:6 s10:6 s40:6 f20:4 f10:4 f10:6 f10:6"
is "the median counts" "$(table)" "rptam 20: 50 ms, 0.08
rptam 10: 58 ms, 0.05 *"

# None is faster than strokes of 20 by a twentieth, so that their neighbours are not tried. At first strokes of 40 are
# the fastest.
is "near the best one, all are timed again in turns" "$(plan --techniques rptam,strokes --tolerance .1 <<'EOF'
rptam 40x1 | 48 .07 | 48,60,60 .07
rptam 20x1 | 50 .08 | 50 .08
strokes 20x1 | 49 .05 | 49 .05
EOF
)" "s20:6 s40:6 S20:6 f40:4 F20:4 f20:4 f40:6 f20:6 F20:6"
is "of two that take as long, the first is chosen" "$(table)" "strokes 20: 49 ms, 0.05
rptam 20: 50 ms, 0.08 *"
is "what suggests nothing better by itself is left at its neighbours" \
    "$(plan --techniques rptam,strokes --tolerance .1 <<'EOF'
rptam 40x1 | 40 .07 | 40 .07
rptam 20x1 | 50 .08 | 50 .08
strokes 40x1 | 20 .07 | 20 .07
strokes 20x1 | 30 .05 | 30 .05
EOF
)" "s20:6 s40:6 S20:6 S40:6 F40:4"
# rptam is faster by a fourteenth at 40, where it suggests strokes that are not faster by another twentieth.
is "what a better neighbour suggests must be better than that" "$(plan --techniques rptam,strokes --tolerance .1 <<'EOF'
rptam 40x1 | 46.5 .07 | 46.5 .07
rptam 20x1 | 50 .08 | 50 .08
strokes 20x1 | 44.5 .05 | 44.5 .05
EOF
)" "s20:6 s40:6 S20:6 F20:4 f40:4 f20:4 f40:6 F20:6 f40:6 F20:6"
# Strokes of 10 miss the tolerance by half of it, and those of 20 exceed it by more than 1.3 times as much.
is "nothing is within a tolerance: neighbours of the nearest ones are tried" "$(plan --techniques rptam \
    --tolerance .02 2>said <<'EOF'
rptam 20x1 | 50 .05 | 50 .05
rptam 10x1 | 80 .03 | 80 .03
EOF
)" "status 1
s20:6 s10:6 f10:4"
is "which is told" "$(cat said)" "hatchplan: nothing is within the limits; nearest is rptam with length=10 samples=4, \
at 1.5 times the limit of tone error"
is "at most five are measured in full" "$(plan --techniques rptam,strokes --budget ms=90 <<'EOF'
rptam 40x1 | 10 .2 | 10 .2
rptam 20x1 | 10 .098 | 10 .098
rptam 10x1 | 10 .093 | 10 .093
strokes 40x1 | 10 .2 | 10 .2
strokes 20x1 | 10 .088 | 10 .088
strokes 10x1 | 10 .083 | 10 .083
strokes 20x1 blend | 10 .0835 | 10 .0835
strokes 10x1 blend | 10 .078 | 10 .078
EOF
)" "s20:6 s10:6 S20:6 S10:6 S10b:6 S20b:6 S40:6 s40:6 F10b:4 F10:4 F20b:4 F20:4 f10:4"
is "all are measured in turns" "$(plan --techniques rptam --exhaustive --rounds 3 --all <<'EOF'
rptam 40x1 | | 48,60,61 .07
rptam 20x1 | | - .08
rptam 10x1 | | 49,30,40 .05
EOF
)" "f40:6 f20:6 f10:6 f40:6 f10:6 f40:6 f10:6"
is "but those that cannot be drawn" "$(table)" "rptam 10: 40 ms, 0.05
rptam 40: 60 ms, 0.07"
is "nor those that reach a limit" "$(plan --techniques rptam --exhaustive --rounds 3 --all <<'EOF'
rptam 40x1 | | 48,60,61 .07
rptam 20x1 | | limit .08
rptam 10x1 | | 49,30,40 .05
EOF
)" "f40:6 f20:6 f10:6 f40:6 f10:6 f40:6 f10:6"
is "the status tells of the limit where there is no other candidate" "$(plan --techniques rptam 2>said <<'EOF' | head -1
rptam 40x1 | limit .2 | limit .2
rptam 20x1 | limit .2 | limit .2
rptam 10x1 | limit .2 | limit .2
EOF
)" "status 5"

# Of ten pictures three are measured, in the same time; render-gl then draws all of them.
is "a film is measured in three pictures" "$(plan --techniques rptam --tolerance .1 --make --frames 10 --rate 20 \
    --tone-range .1:.6 <<'EOF'
rptam 40x1 | 90 .05 | 90 .05
rptam 20x1 | 50 .08 | 50 .08
EOF
)" "s20:6 3 6 s40:6 3 6 f20:4 3 6"
is "and drawn in ten" "$(grep ^DRAW table.tsv)" "DRAW := --technique rptam --samples 4 --style ink --stroke 20x1 \
--size 320x320 --zoom 1 --tone-range 0.1:0.6 --lines none --frames 10 --rate 20"
is "a long film is measured no slower than render-gl can draw it" "$(plan --techniques rptam --tolerance .1 \
    --frames 4096 --rate 1 <<'EOF'
rptam 40x1 | 90 .05 | 90 .05
rptam 20x1 | 50 .08 | 50 .08
EOF
)" "s20:6 3 0.001 s40:6 3 0.001 f20:4 3 0.001"
finish
