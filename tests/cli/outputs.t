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
is "no temporary file is left" "$(ls -A | grep -c '^\.tamgen')" 0

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
has_temporary() { ls -A | grep -q '^\.tampack'; }
soon "$process" has_temporary
kill -ABRT "$process"
wait "$process" 2>.err
is "a crash leaves no file" "$? $(ls -A | grep -c '^\.tampack\|crashed')" "134 0"
exec 3>&-

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
finish
