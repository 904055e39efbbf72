# hatchstat tam: the figures of a map, and what --check says of a broken one.
. "${TOP:-.}/tests/tap.sh"
size='--size 128 --tones 4'
tamgen $size --strokes ink.tsv -o ink.exr
tamgen $size --seed 2 --strokes other.tsv -o other.exr
tamgen $size --style pencil --set 'width 5' --growth 0.4 --strokes pencil.tsv -o pencil.exr

# cell COLUMN ROW: of the table on standard input; row 1 is the first image
cell() {
    awk -F'\t' -v name="$1" -v row="$2" 'NR == 1 {for (i = 1; i <= NF; i++) if ($i == name) at = i}
        row != "last" && NR == row + 1 {print $at} END {if (row == "last") print $at}'
}
try hatchstat tam ink.exr
is "the map alone" "$status" 0
is "a row for each image, one for all" "$(wc -l <.out)" $((4 * 8 + 2))
is "every row has every column" "$(awk -F'\t' '{print NF}' .out | sort -u)" 23
is "without strokes none is missing or known" "$(cell missing last <.out) $(cell stroke 1 <.out)" "nan nan"
is "sizes halve" "$(cell size 1 <.out) $(cell size 3 <.out) $(cell size 8 <.out)" "128 32 1"
is "targets are the columns'" "$(cell target 1 <.out) $(cell target 9 <.out)" "0.224999994 0.449999988"
is "no pixel is lighter" "$(cell lighter last <.out)" 0

hatchstat tam ink.exr >alone.tsv
hatchstat tam <ink.exr >piped.tsv
ok "a pipe gives the same" cmp alone.tsv piped.tsv
ok "the map and its strokes hold" hatchstat tam ink.exr --strokes ink.tsv --check -o /dev/null
ok "so do growing ones with settings" hatchstat tam pencil.exr --strokes pencil.tsv --set 'width 5' --check -o /dev/null
hatchstat tam ink.exr --strokes ink.tsv >full.tsv
is "nothing is missing" "$(cell missing last <full.tsv)" 0
ok "and it is more even than chance" test "$(cell even8 last <full.tsv | cut -c1-3)" = 0.4 -o \
    "$(cell even8 last <full.tsv | cut -c1-3)" = 0.3

try hatchstat tam ink.exr --strokes other.tsv --check
is "another map's strokes are missing" "$status" 1
ok "and counted" test "$(cell missing last <.out)" -gt 100
try hatchstat tam other.exr --strokes ink.tsv
is "without --check that is no failure" "$status" 0

try hatchstat tam ink.exr --strokes ink.tsv --json
is "JSON holds the rows" "$(grep -c '"even4": ' .out)" 33
is "and null where a figure is not known" "$(grep -c nan .out) $(grep '"all"' .out | grep -c '"level": null')" "0 1"
head -c 1000 ink.exr >cut.exr
try hatchstat tam cut.exr
refused "a cut map is bad input" 3 1
tamgen --size 64 --levels 1 --contact-sheet sheet.png -o /dev/null
try hatchstat tam sheet.png
refused "a picture is no map" 3 1
try hatchstat tam ink.exr --strokes ink.exr
refused "a map is no script" 3 1
sed 's/0\.5/x/' ink.tsv >bad.tsv
try hatchstat tam ink.exr --strokes bad.tsv
refused "a bad script is bad input" 3 1
ok "its line is named" grep -q 'bad.tsv: line [0-9]' .err

cp "$TOP/styles/ink.style" mine.style
sed -i 's/^name .*/name mine/' mine.style
tamgen --size 64 --tones 1 --style ./mine.style --strokes mine.tsv -o mine.exr
try hatchstat tam mine.exr --strokes mine.tsv
refused "a style of the user's must be named" 2 2
is "and the message says how" "$(grep -c "'mine'.*--style" .err)" 1
ok "named, it is taken" hatchstat tam mine.exr --strokes mine.tsv --style ./mine.style -o /dev/null
sed -i 's/^name .*/name .\/mine.style/' mine.style
tamgen --size 64 --tones 1 --style ./mine.style --strokes mine.tsv -o mine.exr
try hatchstat tam mine.exr --strokes mine.tsv
refused "a map that names a path opens nothing" 2 2
try hatchstat tam ink.exr --style pencil
refused "a style without the strokes" 2 2
finish
