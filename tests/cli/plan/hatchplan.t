# hatchplan: the table, the choice, its inputs, what goes wrong in the commands that it runs, and pipelines/plan.mk.
. "${TOP:-.}/tests/tap.sh"
mkdir own
TMPDIR=$WORK/own
export TMPDIR
small="--size 96x72"
few="--techniques tam,rptam"
flat="--techniques tam-flat"
meshgen torus --faces 400 -o torus.glb
printf '%s\n' 'v 0 0 0' 'v 1 0 0' 'v 0 1 0' 'v 0 0 1' 'f 1 3 2' 'f 1 2 4' 'f 1 4 3' 'f 2 3 4' >bare.obj

# chosen: the technique and the parameters of the choice, from a table
chosen() {
    awk -F'\t' '$8 == "yes" {print $1, $2}'
}
# inside: whether no useful candidate of a table is covered by another one
inside() {
    awk -F'\t' 'NR > 1 {ms[NR] = $3; b[NR] = $4; s[NR] = $5; e[NR] = $6}
        END {for (i in ms) for (j in ms)
            if (i != j && ms[j] <= ms[i] && b[j] <= b[i] && s[j] <= s[i] && e[j] <= e[i]) print i, j}' "$1"
}

try hatchplan $small $few torus.glb
is "without bounds" "$status $(cat .err)" "0 "
cp .out front.tsv
is "nothing is chosen" "$(chosen <front.tsv)" ""
is "no candidate of the front is covered by another one" "$(inside front.tsv)" ""
is "rows are sorted by time" "$(tail -n +2 front.tsv | cut -f 3 | sort -g)" "$(tail -n +2 front.tsv | cut -f 3)"
is "strokes at seed points need no files" "$(awk -F'\t' '$1 == "rptam" {print $4, $5}' front.tsv | sort -u)" "0 0"
hatchplan $small $few --tolerance 1 torus.glb >table.tsv
is "any tolerance: the fastest, or one that is as fast" \
    "$(awk -F'\t' 'NR == 2 {ms = $3} $8 == "yes" && $3 <= 1.03 * ms' table.tsv | wc -l)" 1
hatchplan $small $few --budget mb=.2 torus.glb >table.tsv
is "a budget: the most exact, or one that is as exact" "$(awk -F'\t' 'NR > 1 && (!least || $6 < least) {least = $6}
    $8 == "yes" {error = $6; bytes = $4} END {print (error <= 1.03 * least), (bytes <= 2e5)}' table.tsv)" "1 1"
hatchplan $small $flat --budget mb=.2 --json torus.glb >table.json
is "the table as JSON" "$(perl -MJSON::PP -0ne 'print ref decode_json($_)' table.json)" ARRAY
hatchplan $small $few --budget mb=0 torus.glb >table.tsv
is "no files: strokes at seed points" "$(chosen <table.tsv | cut -d' ' -f1)" rptam
hatchplan $small --techniques rptam --budget mb=0 --samples 1,4 torus.glb --all >table.tsv
is "samples are chosen, too" "$(cut -f 2 table.tsv | grep -o 'samples=.*' | sort -u | tr '\n' ' ')" \
    "samples=1 samples=4 "
for order in 1,9 9,1,9; do
    hatchplan $small $flat --tolerance 1 --samples $order torus.glb | chosen | grep -o 'samples=.*'
done >samples
is "in any order" "$(uniq samples)" samples=1
try hatchplan $small --techniques tam-flat --all --exhaustive torus.glb
is "all candidates" "$(cut -f 1,2 .out | tail -n +2 | sort | tr '\t\n' '  ')" \
    "tam-flat size=128 tones=6 samples=4 tam-flat size=512 tones=6 samples=4 "

# Nothing within the limits.
try hatchplan $small --techniques rptam --tolerance .0001 torus.glb
is "nothing is exact enough" "$status $(sed 's/with .*, at .* times/TIMES/' .err)" \
    "1 hatchplan: nothing is within the limits; nearest is rptam TIMES the limit of tone error"
is "the table is written" "$(head -n 1 .out | cut -f 1)" technique
try hatchplan $small $few --tolerance 0 torus.glb
least=$(tail -n +2 .out | sort -t "$(printf '\t')" -k 6,6g | awk -F'\t' '{printf "%s with %s, at %.3g", $1, $2, $6; exit}')
is "no tone error at all: nearest is the most exact one" "$status $(cat .err)" \
    "1 hatchplan: nothing is within the limits; nearest is $least where the limit of tone error is 0"
try hatchplan $small --techniques rptam --tolerance .0001 torus.glb --make -o none.mk
refused "nothing for make" 1 1
is "and no file" "$(ls none.mk 2>&1 | grep -c 'No such')" 1
for technique in solid traced; do
    try hatchplan $small --techniques $technique --budget s=.001 torus.glb
    is "a limit of the set-up time of $technique" "$status $(grep -c 'times the limit s$' .err)" "1 1"
done
ok "a limit of more seconds than a process can count" hatchplan $small $flat --budget s=1e20 torus.glb
try hatchplan $small --techniques tam --budget mb=.01 torus.glb
is "a limit of the bytes" "$status $(grep -c 'times the limit mb$' .err)" "1 1"

# Scenes.
# choice FILE: what was chosen, without the names and times of the files that the plan was made from
choice() {
    grep -v '^INPUTS\|^STAMPS' "$1"
}
hatchplan $small $flat --budget mb=.2 --make torus.glb >named.mk
hatchplan $small $flat --budget mb=.2 --make <torus.glb >piped.mk
is "from standard input" "$(choice piped.mk)" "$(choice named.mk)"
mkfifo pipe
cat torus.glb >pipe &
hatchplan $small $flat --budget mb=.2 --make pipe >piped.mk
is "from a pipe with a name" "$(choice piped.mk)" "$(choice named.mk)"
cp torus.glb "a torus.glb"
hatchplan $small $flat --budget mb=.2 --make "a torus.glb" >spaces.mk
is "from a name with spaces" "$(choice spaces.mk)" "$(choice named.mk)"
try hatchplan $small - - <torus.glb
is "two scenes from standard input" "$status $(head -n 1 .err)" \
    "2 hatchplan: two inputs come from standard input or a pipe"
hatchplan $small --techniques rptam --budget mb=2 bare.obj >table.tsv
is "a mesh without texture coordinates gets patches" "$(chosen <table.tsv | grep -c 'patches=1')" 1
ok "several objects on the ground, in a film" hatchplan $small --techniques rptam --ground 3 --frames 5 --turntable \
    --tolerance 1 torus.glb torus.glb

# Commands that fail.
head -c 300 torus.glb >short.glb
try hatchplan $small short.glb
refused "a damaged scene" 3 1
try hatchplan $small --lines nonsense torus.glb
is "an option that render-gl refuses" "$status $(head -n 1 .err | cut -c 1-38)" \
    "2 hatchplan: render-gl: --lines nonsense"
try hatchplan $small --draw '--up z" ' torus.glb
is "a quotation mark is missing" "$status $(head -n 1 .err)" '2 hatchplan: --draw: the last " is missing'
try hatchplan $small --style nonesuch --techniques tam torus.glb
is "an option that tamgen refuses" "$status $(head -n 1 .err | cut -d' ' -f 1-2)" "2 hatchplan: tamgen:"
try sh -c "ulimit -f 40; hatchplan $small --techniques tam torus.glb"
is "a full disk" "$status $(head -n 1 .err | grep -c '^hatchplan: .*: .*file too large$')" "4 1"
try env TMPDIR=/nonesuch hatchplan $small torus.glb
is "no folder for temporary files" "$status $(cat .err)" \
    "4 hatchplan: /nonesuch: cannot make a temporary folder there: set TMPDIR: no such file or directory"
mkdir -p alone/bin
cp "$BIN/hatchplan" alone/bin
try env PATH=/usr/bin:/bin alone/bin/hatchplan $small torus.glb
is "without the other commands" "$status $(cat .err)" \
    "4 hatchplan: render-gl: cannot run this command of hatch: no such file or directory"
# In place of another command, a script that counts the descriptors which lead to the folder of temporary files: its
# standard error is a file there, and no other descriptor is handed down.
cat >alone/bin/render-gl <<'END'
#!/bin/sh
echo "$(readlink /proc/$$/fd/* | grep -c /hatchplan-)" >&2
exit 3
END
chmod +x alone/bin/render-gl
try alone/bin/hatchplan $small torus.glb
is "a command has no descriptors of others" "$(sed 's/.* //' .err)" 1
is "nothing is left of all these" "$(ls -A own)" ""

# The folder is that of the system where TMPDIR is not set, or empty.
if unprivileged test -x "$BIN/hatchplan" 2>/dev/null; then
    for unset in "-u TMPDIR" TMPDIR=; do
        try unprivileged env $unset "$BIN/hatchplan" $small short.glb
        is "a damaged scene, with $unset" "$status $(cut -d: -f 1-2 .err)" "3 hatchplan: short.glb"
    done
fi

# Signals end the command that runs, too, and leave nothing; also where the caller of this test ignores them.
for signal in HUP TERM; do
    env --default-signal=$signal hatchplan --exhaustive torus.glb >/dev/null 2>&1 &
    process=$!
    is_drawing() {
        child=$(cat /proc/$process/task/$process/children 2>/dev/null) && [ -n "$child" ]
    }
    soon $process is_drawing
    kill -$signal $process
    wait $process
    is "SIG$signal: nothing is left" "$(ls -A own) $(ls -d /proc/$child 2>/dev/null)" " "
done

# The pipeline.
if command -v make >/dev/null; then
    plan="make -s -f $TOP/pipelines/plan.mk SIZE=96x72"
    ok "plan.mk: a budget" $plan MESH="a torus.glb" OUT=out BUDGET=mb=.2 OPTIONS="$few"
    ok "the picture is there" test -s "out/a torus.png"
    is "its map is within the budget" "$(find out -name 'plan.map.exr' -size -200k | wc -l)" 1
    ls -l --time-style=full-iso out/plan.chosen.mk >before
    $plan MESH="a torus.glb" OUT=out BUDGET=mb=.2 OPTIONS="$few"
    is "the plan is kept" "$(ls -l --time-style=full-iso out/plan.chosen.mk)" "$(cat before)"
    ok "plan.mk: a film of traced strokes" $plan MESH=torus.glb OUT=film TOLERANCE=1 TURN=2 OPTIONS="--techniques traced"
    is "two frames" "$(ls film | grep -c 'torus-00[01].png')" 2
    for technique in solid volume threshold; do
        ok "plan.mk: $technique" $plan MESH=torus.glb OUT=$technique BUDGET=mb=9 OPTIONS="--techniques $technique"
        ok "$technique: the picture is there" test -s $technique/torus.png
    done
    ok "plan.mk: patches" $plan MESH=bare.obj OUT=patches BUDGET=mb=9 OPTIONS="--techniques rptam"
    ok "plan.mk: a colour in quotes" timeout 60 $plan MESH=torus.glb OUT=quoted BUDGET=mb=9 \
        OPTIONS='--techniques tam-flat --draw "--paper #ffeedd"'
    try $plan MESH=torus.glb OUT=none TOLERANCE=.0001 OPTIONS="--techniques rptam"
    is "plan.mk: nothing is exact enough" "$((status > 0)) $(grep -c '^hatchplan: nothing is within' .err) \
$(ls none/*.png 2>/dev/null)" "1 1 "
else
    skip "plan.mk" "no make"
fi
is "nothing is left in the folder of temporary files" "$(ls -A own)" ""
finish
