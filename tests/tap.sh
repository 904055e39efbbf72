# Functions for shell tests, which print TAP. Start a test with
#     . "${TOP:-.}/tests/tap.sh"
# and end it with `finish`. tests/run sets TOP (the source), BIN and BUILD; by hand, run `sh tests/cli/x.t` in the top
# folder. PATH has the commands; the working folder is empty, and removed at the end.
set -u
TOP=${TOP:-$PWD}
BUILD=${BUILD:-$TOP/build}
BIN=${BIN:-$BUILD/bin}
SANITIZE=${SANITIZE:-}
PATH=$BIN:$PATH
LC_ALL=C
export TOP BUILD BIN PATH LC_ALL
tap_count=0
tap_failed=0
WORK=$(mktemp -d) || exit 1
trap 'chmod -R u+w "$WORK" 2>/dev/null; rm -rf "$WORK"' EXIT
trap 'exit 1' INT TERM HUP
chmod 755 "$WORK"
cd "$WORK" || exit 1

pass() {
    tap_count=$((tap_count + 1))
    echo "ok $tap_count - $1"
}

# fail NAME [LINE ...]: reports a failure; the lines give the reason
fail() {
    tap_count=$((tap_count + 1))
    tap_failed=$((tap_failed + 1))
    echo "not ok $tap_count - $1"
    shift
    [ $# -eq 0 ] || printf '%s\n' "$@" | sed 's/^/# /'
}

skip() {
    tap_count=$((tap_count + 1))
    echo "ok $tap_count - $1 # SKIP $2"
}

# ok NAME COMMAND ...: checks that a command succeeds; shows its output if it fails
ok() {
    tap_name=$1
    shift
    if tap_said=$("$@" 2>&1); then
        pass "$tap_name"
    else
        fail "$tap_name" "exit $? of: $*" "$tap_said"
    fi
}

# is NAME GOT WANT: checks that two strings are equal
is() {
    if [ "$2" = "$3" ]; then
        pass "$1"
    else
        fail "$1" " got: $2" "want: $3"
    fi
}

# count_lines FILE: sets $tap_lines to the number of lines, without starting a process
count_lines() {
    tap_lines=0
    while read -r tap_line; do
        tap_lines=$((tap_lines + 1))
    done <"$1"
}

# try COMMAND ...: runs a command with its output in $WORK/.out and $WORK/.err; sets $status to its exit status
try() {
    "$@" >"$WORK/.out" 2>"$WORK/.err"
    status=$?
}

# refused NAME STATUS LINES: checks that the last try exited with STATUS (one of several: "3 5"), with LINES lines on
# standard error and nothing on standard output
refused() {
    count_lines "$WORK/.err"
    tap_right=no
    for tap_status in $2; do
        [ "$status" != "$tap_status" ] || tap_right=yes
    done
    if [ $tap_right = yes ] && [ "$tap_lines" -eq "$3" ] && [ ! -s "$WORK/.out" ]; then
        pass "$1"
    else
        fail "$1" "exit $status, want $2; $tap_lines lines on standard error, want $3;" \
            "$(wc -c <"$WORK/.out") bytes on standard output" "$(head -c 600 "$WORK/.err")"
    fi
}

# unpack FILE.glb NAME: splits a GLB into NAME.gltf, which sed can edit, and NAME.bin
unpack() {
    tap_length=$(od -An -tu4 -j12 -N4 "$1" | tr -d ' ')
    tail -c +21 "$1" | head -c "$tap_length" |
        sed "s/\"buffers\":\\[{/&\"uri\":\"$2.bin\",/" >"$2.gltf"
    tail -c +$((29 + tap_length)) "$1" >"$2.bin"
}

# numbers FILE.glb: prints the binary chunk of a GLB, all numbers of all meshes
numbers() {
    tail -c +$((29 + $(od -An -tu4 -j12 -N4 "$1" | tr -d ' '))) "$1"
}

# milliseconds LIMIT COMMAND ...: prints the processor time of the fastest of up to forty runs, stopping at the first
# within LIMIT; time of other processes on a busy machine is not counted
milliseconds() {
    bash -c 'TIMEFORMAT="%3U %3S" limit=$1 best=999999
        shift
        command -v "$1" >/dev/null || exit
        for run in {1..40}; do
            read -r user system < <({ time "$@" >/dev/null 2>&1 </dev/null; } 2>&1)
            took=$((10#${user/./} + 10#${system/./}))
            [ $took -ge $best ] || best=$took
            [ $best -gt "$limit" ] || break
        done
        echo $best' bash "$@"
}

# As another user than root, who may read and write everything; false where that cannot be had.
unprivileged() {
    if [ "$(id -u)" -ne 0 ]; then
        "$@"
    else
        setpriv --reuid=65534 --regid=65534 --clear-groups "$@"
    fi
}

. "$TOP/tests/soon.sh"

finish() {
    [ $tap_count -gt 0 ] || skip "nothing to test" "no command was built yet"
    echo "1..$tap_count"
    exit $((tap_failed > 0))
}
