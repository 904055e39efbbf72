#!/bin/sh
# runs.sh BUILD [PATTERN]: runs the commands of a build with all their features on small inputs, two runs at a time, and
# prints a line for each run, separated by tabs: its name, a checksum of all files it wrote, its exit status, a checksum
# of its standard error. A change that is to alter no output gives the same lines before and after (compare.sh).
#
# PATTERN, a regular expression, selects runs by name, the environment variable PARTS parts of the list ("maps meshes").
# The environment variable KEEP, a folder that does not exist yet, keeps the files of each run in runs/NAME. Pictures
# depend on the driver, so compare builds on one machine.
#
# The first lines are the inputs, which the build's own commands and scenes.pl make. The folder of each run has links to
# them. The name of a run starts with its subject.
set -u
LC_ALL=C
export LC_ALL
# shellcheck source-path=SCRIPTDIR
. "$(dirname "$0")/list.sh"
# shellcheck source-path=SCRIPTDIR
. "$(dirname "$0")/list_draw.sh"
. "$(dirname "$0")/../soon.sh"

# Functions for the commands in list.sh and list_draw.sh.

# draw SCENE [OPTION ...]: draws a picture
draw() {
    render-gl --size 160x120 -o picture.png "$@"
}

# film SCENE [OPTION ...]: draws three small frames
film() {
    render-gl --size 96x72 --samples 1 --frames 3 -o picture%d.png "$@"
}

# with_shaders COMMAND ...: runs a command with a copy of the build's shaders, which does not count as output
with_shaders() {
    cp -r "$BUILD/share/hatch/shaders" . || return
    "$@"
    with_status=$?
    rm -r shaders
    return $with_status
}

# without_ms: prints the report on standard input without its times
without_ms() {
    awk -F'\t' 'NR == 1 {for (i = 1; i <= NF; i++) timed[i] = $i ~ /_ms$/ || $i == "device"}
        {line = ""; for (i = 1; i <= NF; i++) if (!timed[i]) line = line "\t" $i; print substr(line, 2)}'
}

# mesh FILE: runs all commands that read meshes; --show field draws the field
mesh() {
    hatchstat mesh "$1"
    dirfield -r report.tsv -o directions.glb "$1"
    without_ms <report.tsv
    rm report.tsv
    lapped-param "$1" -o patches.glb
    lapped-param --atlas directions.glb -o charts.glb
    strokegen --levels 2 directions.glb -o traced.glb
    meshfit "$1" --size 320x240 -o fitted.glb
    hatchstat field directions.glb
    hatchstat lapped --samples 2000 patches.glb
    draw directions.glb --show field
}

# open_window SCENE [OPTION ...]: opens a window on a screen of its own and of the same size, so that the pointer is
# always in it, and waits for its first frame, which sets its title
open_window() {
    Xvfb -noreset -displayfd 3 -screen 0 200x150x24 3>.display >/dev/null 2>&1 &
    server=$!
    soon $server [ -s .display ]
    DISPLAY=:$(cat .display)
    export DISPLAY
    render-gl --window --size 200x150 -o shot%d.png "$@" &
    window=$!
    trap 'kill $server $window 2>/dev/null; wait; rm -f .display' EXIT
    soon $window xdotool search --name '^render-gl: ' >/dev/null
    shots=0
}

# shot KEY ...: presses these keys and s, and waits for the picture
shot() {
    shots=$((shots + 1))
    xdotool key "$@" s
    soon $window [ -s shot$shots.png ]
}

drag() {
    xdotool mousemove 60 70 mousedown "$1" mousemove 90 75 mousemove 120 85 mouseup "$1"
}

close_window() {
    xdotool key q
    wait "$window"
}

# line NAME STATUS: prints the line of a run, with checksums of the regular files in the working folder and of .err
line() {
    find . -type f ! -name .err | sort | xargs -r sha256sum >../.sums
    printf '%s\t%s\t%s\t%s\n' "$1" "$(sha256sum <../.sums | cut -c 1-64)" "$2" "$(sha256sum <.err | cut -c 1-64)"
}

# one N: executes the Nth run of the list in a folder of its own
one() {
    run=$(sed -n "$1p" "$WORK/runs.list")
    name=${run%% *}
    printf '%s\t-\tstopped\t-\n' "$name" >"$WORK/lines/$1"
    mkdir -p "$WORK/runs/$name/files"
    cd "$WORK/runs/$name/files" || exit 1
    ln -s "$WORK"/inputs/* .
    (eval "${run#* }") >.out 2>.err </dev/null
    line "$name" $? >"$WORK/lines/$1"
    find . -type l -exec rm {} +
    [ -n "${KEEP-}" ] || rm -r "$WORK/runs/$name"
}

# make_inputs: makes the inputs in the working folder and prints their lines
make_inputs() {
    cp "$TESTS/../pipelines/hatching.svg" . || exit 1
    perl "$TESTS/bytes/scenes.pl" || exit 1
    inputs >../inputs.list
    while read -r name command; do
        (eval "$command") >"$name" </dev/null || exit 1
    done <../inputs.list
    sha256sum -- * >../inputs.sums
    awk '{print "input-" $2 "\t" $1 "\t0\t-"}' ../inputs.sums
}

if [ "${1-}" = --one ]; then
    one "$2"
    exit
fi
[ -x "${1-}/bin/render-gl" ] || { echo "usage: runs.sh BUILD [PATTERN]" >&2; exit 2; }
BUILD=$(cd "$1" && pwd)
TESTS=$(cd "$(dirname "$0")/.." && pwd)
PATH=$BUILD/bin:$PATH
if [ -n "${KEEP-}" ]; then
    mkdir "$KEEP" || exit 1
    WORK=$(cd "$KEEP" && pwd)
else
    WORK=$(mktemp -d) || exit 1
    trap 'rm -rf "$WORK"' EXIT
fi
trap 'exit 1' INT TERM HUP
export BUILD TESTS PATH WORK
mkdir "$WORK/inputs" "$WORK/runs" "$WORK/lines"
(cd "$WORK/inputs" && make_inputs) || exit 1
list | awk -v pattern="${2-}" '$1 ~ pattern' >"$WORK/runs.list"
count=$(wc -l <"$WORK/runs.list")
seq "$count" | xargs -n 1 -P 2 timeout 300 sh "$0" --one
for number in $(seq "$count"); do
    cat "$WORK/lines/$number"
done
(cd "$WORK/inputs" && sha256sum --quiet -c ../inputs.sums) || { echo "runs.sh: a run wrote to an input" >&2; exit 1; }
