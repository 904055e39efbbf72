# hatchstat tam: the figures of a map, and --check of maps and of strokes.
. "${TOP:-.}/tests/tap.sh"
size='--size 128 --tones 4'
tamgen $size --strokes ink.tsv -o ink.exr
tamgen $size --seed 2 --strokes other.tsv -o other.exr
tamgen $size --style pencil --set 'width 5' --growth 0.4 --strokes pencil.tsv -o pencil.exr

# cell COLUMN ROW: prints a cell of the table on standard input; row 1 is the first image
cell() {
    awk -F'\t' -v name="$1" -v row="$2" 'NR == 1 {for (i = 1; i <= NF; i++) if ($i == name) at = i}
        row != "last" && NR == row + 1 {print $at} END {if (row == "last") print $at}'
}
try hatchstat tam ink.exr
is "a map without its strokes is measured" "$status" 0
is "a row for each image and one for all" "$(wc -l <.out)" $((4 * 8 + 2))
is "every row has every column" "$(awk -F'\t' '{print NF}' .out | sort -u)" 23
is "figures of strokes are nan without a script" "$(cell missing last <.out) $(cell stroke 1 <.out)" "nan nan"
is "sizes of levels halve" "$(cell size 1 <.out) $(cell size 3 <.out) $(cell size 8 <.out)" "128 32 1"
is "targets are those of the columns" "$(cell target 1 <.out) $(cell target 9 <.out)" "0.224999994 0.449999988"
is "no pixel is lighter than in the previous column" "$(cell lighter last <.out)" 0

hatchstat tam ink.exr >alone.tsv
hatchstat tam <ink.exr >piped.tsv
ok "a map from a pipe gives the same table" cmp alone.tsv piped.tsv
ok "--check passes a map with its strokes" hatchstat tam ink.exr --strokes ink.tsv --check -o /dev/null
ok "--check passes growing strokes with --set" hatchstat tam pencil.exr --strokes pencil.tsv --set 'width 2' --set 'width 5' --check -o /dev/null
hatchstat tam ink.exr --strokes ink.tsv >full.tsv
is "no stroke is missing from an image" "$(cell missing last <full.tsv)" 0
ok "strokes are more even than random ones" test "$(cell even8 last <full.tsv | cut -c1-3)" = 0.4 -o \
    "$(cell even8 last <full.tsv | cut -c1-3)" = 0.3

try hatchstat tam ink.exr --strokes other.tsv --check
is "--check fails with the strokes of another map" "$status" 1
ok "the strokes of another map are counted as missing" test "$(cell missing last <.out)" -gt 100
try hatchstat tam other.exr --strokes ink.tsv
is "missing strokes are no failure without --check" "$status" 0


# Maps by needs are rounded, and say by how much: one that lacks columns and levels, one that lacks nothing, a drawing's.
# needs TOLERANCE DARKEST: prints needs of views that show nothing in particular
needs() {
    printf 'thing\tindex\tvalue\tunit\ntolerance\t0\t%s\t\nrelative\t0\t1\t\ndarkest\t0\t%s\ttone\n' "$1" "$2"
    printf 'region-low\t0\t-1\t\nregion-low\t1\t-1\t\nregion-low\t2\t0\t\n'
    printf 'region-side\t0\t.1875\t\nregion-side\t1\t.0625\t\nregion-side\t2\t0\t\nregion-cells\t0\t0\t\n'
}
needs .01 .7 >part.needs
needs .009 1 >all.needs
for of in part all; do
    tamgen $size --needs $of.needs --strokes $of.tsv -o $of.exr
    try hatchstat tam $of.exr --strokes $of.tsv --check
    is "--check passes a rounded map ($of)" "$status $(cell missing last <.out)" "0 0"
done
try hatchstat tam part.exr --strokes all.tsv
refused "not with strokes of columns that it lacks" 3 1
tamgen $size --replay ink.tsv --needs all.needs --strokes drawing.tsv -o drawing.exr
try hatchstat tam drawing.exr --strokes drawing.tsv
is "nor does a rounded drawing miss strokes" "$(cell missing last <.out)" 0
tamgen $size --seed 2 --needs all.needs -o others.exr
try hatchstat tam others.exr --strokes all.tsv --check
is "--check fails with the strokes of another rounded map" "$status" 1

try hatchstat tam ink.exr --strokes ink.tsv --json
is "JSON has all rows" "$(grep -c '"even4": ' .out)" 33
is "unknown figures are null in JSON" "$(grep -c nan .out) $(grep '"all"' .out | grep -c '"level": null')" "0 1"
head -c 1000 ink.exr >cut.exr
try hatchstat tam cut.exr
refused "a truncated map is bad input" 3 1
tamgen --size 64 --levels 1 --contact-sheet sheet.png -o /dev/null
try hatchstat tam sheet.png
refused "a picture instead of a map is bad input" 3 1
try hatchstat tam ink.exr --strokes ink.exr
refused "a map instead of a script is bad input" 3 1
sed 's/0\.5/x/' ink.tsv >bad.tsv
try hatchstat tam ink.exr --strokes bad.tsv
refused "a bad script is bad input" 3 1
ok "the message names the bad line" grep -q 'bad.tsv: line [0-9]' .err

cp "$TOP/styles/ink.style" mine.style
sed -i 's/^name .*/name mine/' mine.style
tamgen --size 64 --tones 1 --style ./mine.style --strokes mine.tsv -o mine.exr
try hatchstat tam mine.exr --strokes mine.tsv
refused "a style that is not installed must be given" 2 2
is "the message names the option --style" "$(grep -c "'mine'.*--style" .err)" 1
ok "a style given by --style is used" hatchstat tam mine.exr --strokes mine.tsv --style ./mine.style -o /dev/null
sed -i 's/^name .*/name .\/mine.style/' mine.style
tamgen --size 64 --tones 1 --style ./mine.style --strokes mine.tsv -o mine.exr
try hatchstat tam mine.exr --strokes mine.tsv
refused "a path in the metadata of a map is not opened" 2 2
try hatchstat tam ink.exr --style pencil
refused "--style without --strokes" 2 2
# Strokes that grow have other sizes in each column than the drawings at random positions would have.
tamgen -q --size 64 --tones 3 --levels 1 --growth 0.6 --strokes grown.tsv -o grown.exr
is "evenness of strokes that grow is unknown" \
    "$(hatchstat tam grown.exr -r grown.tsv | awk -F'\t' 'NR == 1 {for (i = 1; i <= NF; i++) if ($i ~ /^even/) c[i]}
        NR > 1 && $1 == "all" {for (i in c) printf "%s ", $i}')" "nan nan nan nan "
finish
