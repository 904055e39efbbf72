# Inputs that are not regular files or not readable are refused with one line, without delay and without output.
# Endless inputs are read up to the memory limit.
. "${TOP:-.}/tests/tap.sh"
ok "inputs are generated" perl "$TOP/tests/bad/make.pl" own
meshes="hatchstat mesh|dirfield -o out.glb|lapped-param -o out.glb"
meshes="$meshes|render-gl --technique gouraud --size 64x64 -o out.png"
pictures="hatchstat ink|tamgen --size 64 --tones 1 -o out.exr --brush|tampack -o out.ktx2|tamvol -o out.ktx2"
pictures="$pictures|tamthresh -o out.ktx2|hatchstat tam"

# each COMMANDS FUNCTION FILE: calls FUNCTION FILE COMMAND ... for each command
each() {
    echo "$1" | tr '|' '\n' >commands
    while read -r words <&3; do
        $2 "$3" $words
    done 3<commands
}
# limited COMMAND ...: ends commands that hang or wait forever
limited() {
    (ulimit -t 30 && exec timeout 600 "$@")
}
# refused_with NAME STATUS PATTERN: the last command of try failed with this status and message, without output
refused_with() {
    refused "$1" "$2" 1
    is "$1: message" "$(grep -cE "$3" .err) $(cat .err)" "1 $(cat .err)"
    is "$1: no output" "$(ls -A | grep -E '^out|^\.[a-z]+-')" ""
}

# writes FILE COMMAND ...: in the background, writes the command's output to a pipe, for a limited time
writes() {
    timeout 100 sh -c 'file=$1; shift; exec "$@" >"$file" 2>/dev/null' sh "$@" &
}
empty_pipe() {
    file=$1
    shift
    writes "$file" true
    try limited "$@" "$file"
    wait
    refused_with "$*: a pipe of 0 bytes" 3 "$file: (empty|0 bytes|not an OpenEXR file)"
}
endless() {
    file=$1 command=$2
    shift 2
    writes "$file" yes
    try limited "$command" --max-memory 100000000 "$@" "$file"
    wait
    refused_with "$command $*: a pipe that never ends" 5 "$file: out of memory"
    try limited "$command" --max-memory 100000000 "$@" /dev/zero
    refused_with "$command $*: a device that never ends" 3 "/dev/zero: a stream of no known format"
}
folder() {
    file=$1
    shift
    try limited "$@" "$file"
    refused_with "$*: a folder" 3 "$file: is a directory"
}
mkfifo pipe.obj pipe.exr
mkdir folder.obj folder.exr
each "$meshes" empty_pipe pipe.obj
each "$pictures" empty_pipe pipe.exr
each "$meshes" endless pipe.obj
each "$pictures" endless pipe.exr
each "$meshes" folder folder.obj
each "$pictures" folder folder.exr

# Buffers of glTF files.
cp own/gltf/companion-missing.gltf beside.gltf
companion() {
    file=$1
    shift
    try limited "$@" "$file"
    refused_with "$*: a buffer that is $kind" 3 "$file: missing.bin: is a pipe or a device, not a file"
}
mkfifo missing.bin
kind="a pipe"
each "$meshes" companion beside.gltf
ln -sf /dev/zero missing.bin
kind="a device"
each "$meshes" companion beside.gltf

cp own/shape/sphere.obj secret.obj
cp own/exr/sound.exr secret.exr
rm missing.bin
cp own/outside.bin missing.bin
chmod 0 secret.obj secret.exr missing.bin
secret() {
    file=$1
    shift
    try unprivileged "$@" "$file"
    refused_with "$*: a file that may not be read" 4 "$file: cannot open: permission denied"
}
secret_companion() {
    file=$1
    shift
    try unprivileged "$@" "$file"
    refused_with "$*: a buffer that may not be read" 3 "$file: missing.bin: cannot open: permission denied"
}
if unprivileged test -x "$BIN/hatchstat" 2>/dev/null && ! unprivileged cat secret.obj >/dev/null 2>&1; then
    chmod 777 . # for another user
    each "$meshes" secret secret.obj
    each "$pictures" secret secret.exr
    each "$meshes" secret_companion beside.gltf
else
    skip "unreadable files" "needs an unprivileged user"
fi
finish
