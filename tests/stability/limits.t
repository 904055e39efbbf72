# The table of limits: each plain method fails on its input, and hatch does not, by a figure of both pictures; and
# docs/limits.md shows this table. See limits/one.sh; `make limits` draws the page.
. "${TOP:-.}/tests/tap.sh"
here=$TOP/tests/stability/limits
PATH=$BUILD/tests/stability/limits/programs:$PATH
[ -z "$SANITIZE" ] || { skip "the table of limits" "only run without sanitizers"; finish; }
command -v limits_picture >/dev/null || { skip "the table of limits" "its programs were not built"; finish; }

sh "$here/run.sh" "$WORK/table" >table.tsv 2>said
while IFS='	' read -r entry limit plain ours verdict; do
    [ "$entry" = entry ] || is "$entry: $plain and $ours, limit $limit" "$verdict$(grep "^$entry:" said)" right
done <table.tsv
is "all entries have run" "$(sed 1d table.tsv | cut -f 1)" "$(cd "$here" && ls */*.limit | sed 's/\.limit$//')"

# A pair whose remedy is taken out fails: here, both pictures are plain.
mkdir -p swapped/tests/stability
cp -R "$here" swapped/tests/stability
ln -s "$TOP/cmd" swapped/cmd
echo 'ours() { plain "$1"; }' >>swapped/tests/stability/limits/maps/uneven-strokes.limit
is "a pair without its remedy fails" \
    "$(TOP=$WORK/swapped sh "$here/run.sh" "$WORK/again" maps/uneven-strokes 2>&1 | awk -F'\t' 'NR == 2 {print $5}')" wrong

# The page has the texts of the table, and its figures to a tenth: drivers differ in the pixels at edges.
sh "$here/page.sh" table.tsv >page.md
bold='s/: \*\*[^*]*\*\* |/: FIGURE |/g'
is "the page has the texts of the table" "$(
    sed "$bold" page.md >want; sed "$bold" "$TOP/docs/limits.md" | diff - want | head -n 5)" ""
figures() {
    grep -o ': \*\*[^*]*\*\* |' "$1" | sed 's/[^-+0-9.e]//g'
}
figures page.md >new
figures "$TOP/docs/limits.md" >old
is "the page has the figures of the table" "$(paste old new | awk '
    function size(x) {return x < 0 ? -x : x}
    size($1 - $2) > 0.1 * (size($1) > size($2) ? size($1) : size($2)) + 0.005 {print $1 " in the page, now " $2}')" ""
pictures=$(sed 1d table.tsv | awk -F'\t' '{if ($3 != "-") print $1 "-plain.png"; print $1 "-ours.png"}' | sort)
is "the page has its pictures and no others" "$(cd "$TOP/docs/pictures/limits" && find . -type f | sed 's|^\./||' | sort)" \
    "$pictures"
for picture in $pictures; do
    hatchstat diff "$TOP/docs/pictures/limits/$picture" "$WORK/table/${picture%-*}/${picture##*-}" |
        awk -F'\t' -v picture="$picture" 'NR == 2 && !($2 < 0.05) {print picture, $2}'
done >changed
is "the pictures are those of the table" "$(cat changed)" ""
finish
