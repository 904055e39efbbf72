# A command with several outputs writes all of them or none, and never two to one place.
. "${TOP:-.}/tests/tap.sh"
[ -x "$BIN/tamgen" ] || finish

echo old >map.exr
echo old >strokes.tsv
try tamgen --size 64 -o map.exr --strokes strokes.tsv --contact-sheet /dev/full
refused "the last of three outputs is a full disk" 4 1
is "the other outputs stay as they were" "$(cat map.exr strokes.tsv)" "$(printf 'old\nold')"
try sh -c 'tamgen --size 64 --strokes strokes.tsv >/dev/full'
is "standard output is a full disk: the other output stays" "$status $(cat strokes.tsv)" "4 old"
is "no temporary file is left" "$(ls -A | grep -c '^\.hatch')" 0

ln -s map.exr link
for second in map.exr ./map.exr "$WORK/map.exr" link; do
    try tamgen --size 64 -o map.exr --strokes "$second"
    refused "two outputs go to map.exr: $second" 2 2
done
try tamgen --size 64 -o new.exr --strokes ./new.exr
refused "two outputs go to one new file" 2 2
try tamgen --size 64 --strokes -
refused "two outputs go to standard output" 2 2
is "the old output stays" "$(cat map.exr)" old
ok "two outputs go to a device" tamgen --size 64 -o /dev/null --strokes /dev/null
try sh -c 'meshgen plane --faces 2 | hatchstat mesh - -'
refused "two inputs come from standard input" 2 2
ok "all outputs at once" tamgen --size 64 -o map.exr --strokes strokes.tsv --contact-sheet sheet.png
try sh -c 'hatchstat diff - - <sheet.png'
refused "two pictures come from standard input" 2 2
try sh -c 'hatchstat frames - sheet.png - <sheet.png'
refused "two of a sequence come from standard input" 2 2

# New files have the mode that the mask of the process leaves, and the mask stays for the next one.
for mask in 027 000; do
    (umask $mask && tamgen --size 64 --levels 1 --tones 1 -o "new$mask.exr" --strokes "new$mask.tsv")
done
is "new files are for those whom the mask lets" "$(stat -c %a new027.exr new027.tsv new000.exr new000.tsv | xargs)" \
    "640 640 666 666"

# Either all files of a set are replaced or none.
echo old >tiles.000.00.png
ln -s /dev/full tiles.005.01.png
try tampack --quiet --layout png map.exr -o tiles.png
refused "one of the last of many files is a full disk" 4 1
is "the other files stay as they were" "$(cat tiles.000.00.png; ls -A | grep -c tiles)" "old
2"

# A crash, of a driver for example, leaves no temporary file, which exists before standard input is read.
mkfifo pipe
tampack --layout array -o crashed.ktx2 <pipe 2>.err &
process=$!
exec 3>pipe
# has_hidden NUMBER: whether this many hidden files exist
has_hidden() { [ "$(ls -A | grep -c '^\.hatch')" -ge "$1" ]; }
soon "$process" has_hidden 1
kill -ABRT "$process"
wait "$process" 2>.err
is "a crash leaves no file" "$? $(ls -A | grep -c '^\.hatch\|crashed')" "134 0"
exec 3>&-

# A killed process cannot remove its hidden file: the next one that writes the same output does, and only this file.
# start FILE NUMBER: starts a writer of FILE that waits for its input; waits until NUMBER hidden files exist
start() {
    hatchstat mesh - -o "$1" <pipe 2>.err 3>&- &
    process=$!
    soon $process has_hidden "$2"
}
hidden() {
    ls -A | grep -c '^\.hatch'
}
meshgen plane --faces 2 -o plane.glb
exec 3<>pipe
start report.tsv 1
kill -KILL "$process"
wait "$process" 2>.err
is "a killed process leaves its hidden file" "$(hidden) $([ -e report.tsv ] && echo written)" "1 "
stale=$(ls -A | grep '^\.hatch')
ok "another output beside it" hatchstat mesh plane.glb -o other.tsv
is "another output leaves it alone" "$(ls -A | grep '^\.hatch')" "$stale"
printf 'longer than the report, so that a rest of it would be seen %0999d' 0 >"$stale"
ok "the same output again" hatchstat mesh plane.glb -o ./report.tsv
is "the same output removes it" "$(hidden)" 0
cmp -s report.tsv other.tsv
is "nothing of it is left in the output" $? 0

# Writers of one output at the same time do not disturb each other.
start report.tsv 1
first=$process
start report.tsv 2
second=$process
start report.tsv 3
kill -KILL "$second" "$process"
wait "$second" "$process" 2>.err
echo old >report.tsv
ok "a third writer of one output, while the first one lives" hatchstat mesh plane.glb -o report.tsv
is "it removes the hidden files of the killed, not that of the living" "$(hidden)" 1
cmp -s report.tsv other.tsv
is "its output is whole" $? 0
echo old >report.tsv
cat plane.glb >pipe
exec 3>&-
wait "$first"
is "the first writer's output is whole" "$? $(hidden) $(cmp report.tsv other.tsv)" "0 0 "

# Files with the names of hidden ones that are no hidden files stay as they are.
stem=${stale%-*}
echo mine >precious
for number in 0 1 2; do
    rm -rf "$stem"-*
    case $number in
    0) ln -s precious "$stem-0" ;;
    1) ln precious "$stem-0" ;;
    2) mkdir "$stem-0" ;;
    esac
    echo mine >"$stem-x"
    echo mine >.hatch-0
    ok "an output beside a decoy ($number)" hatchstat mesh plane.glb -o report.tsv
    is "the decoys stay ($number)" "$(cat precious "$stem-x" .hatch-0) $(ls -d "$stem-0")" "mine
mine
mine $stem-0"
done
rm -rf .hatch-*
is "outputs beyond half of the descriptors" \
    "$(ulimit -n 32; tampack --quiet --layout png map.exr -o many.png && ls many.* | wc -l) $(hidden)" \
    "$(ls tiles.* many.* 2>/dev/null | grep -c many) 0"

# A name that leads to an open descriptor is that descriptor: what others have written to its file stays.
hatchstat mesh plane.glb >table.tsv
echo head >head.tsv
echo tail >tail.tsv
for name in /dev/stdout /dev/fd/1 /proc/self/fd/1 log; do
    (echo head && hatchstat mesh plane.glb -o $name && echo tail) >log
    is "-o $name, between other lines of its file" "$(cksum <log)" "$(cat head.tsv table.tsv tail.tsv | cksum)"
done
ln -s /dev/fd/3 third
for name in /dev/fd/3 /proc/self/fd/3 "$WORK/third" third; do
    (echo head >&3 && hatchstat mesh plane.glb -o $name && echo tail >&3) 3>log
    is "-o $name, between other lines of its file" "$(cksum <log)" "$(cat head.tsv table.tsv tail.tsv | cksum)"
done
(echo head >&2 && hatchstat mesh plane.glb -o /dev/stderr) 2>log
is "-o /dev/stderr, after another line" "$(cksum <log)" "$(cat head.tsv table.tsv | cksum)"
echo head >log
hatchstat mesh plane.glb -o /dev/stdout >>log
is "a file that is appended to" "$(cksum <log)" "$(cat head.tsv table.tsv | cksum)"
is "-o /dev/fd/3, a pipe" "$(hatchstat mesh plane.glb -o /dev/fd/3 3>&1 >/dev/null | cksum)" "$(cksum <table.tsv)"
try hatchstat mesh plane.glb -o /dev/stdin <table.tsv
refused "a descriptor that is open for reading" 4 1
while read -r line; do
    : >both
    sh -c "{ tamgen -q --size 64 $line; } 2>words; wc -c <both" 2>&1 | cksum >size
    is "two outputs go to one descriptor: $line" "$(head -n 1 words | cut -d' ' -f 1-5) $(cat size)" \
        "tamgen: two outputs go to $(echo 0 | cksum)"
done <<'END'
--strokes /dev/stdout >both
--strokes both >both
-o both --strokes - >both
--strokes /dev/stdout | cat
-o /dev/fd/3 --strokes /dev/fd/3 3>both
-o both --strokes /dev/fd/3 3>both
-o /dev/fd/3 --strokes both 3>both
-o /dev/fd/3 --strokes /dev/fd/4 3>both 4>&3
END
tamgen -q --size 64 -o /dev/stdout --strokes /dev/null >/dev/null
is "two outputs go to a device that is standard output" $? 0

# File name extensions of other formats are refused.
for line in "meshgen plane -o plane.obj" "tamgen --size 64 -o map.png" "tampack map.exr -o map.dds" \
    "tamgen --size 64 -o /dev/null --contact-sheet sheet.jpg"; do
    try $line
    refused "$line" 2 2
done
mkdir other.obj
for name in plane plane.GLB plane.v2 other.obj/plane; do
    ok "meshgen plane -o $name" meshgen plane --faces 2 -o $name
done
# A file system may say that files which a process has just made are another user's.
if [ -z "$SANITIZE" ]; then
    printf '#include <unistd.h>\nuid_t geteuid(void) {return getuid() + 1;}\n' >other.c
    ${CC:-cc} -shared -fPIC -o other.so other.c
    mkdir other
    LD_PRELOAD=$WORK/other.so meshgen plane --faces 2 -o other/plane.glb
    is "an output in a folder of another user" "$(ls -A other)" plane.glb
fi
# The ending of a name tells the format, in capitals, too.
tamgen -q --size 64 --tones 2 --levels 1 | tamvol -q -o CAPITALS.EXR
is "an EXR file with a name in capitals" "$(head -c 4 CAPITALS.EXR | od -An -tx1)" " 76 2f 31 01"
finish
