#!/bin/sh
# page.sh TABLE: prints docs/limits.md, from the table that run.sh has printed. TOP: the source.
set -eu
TOP=${TOP:-$PWD}
export TOP
here=$TOP/tests/stability/limits
table=$1
cat <<'END'
# Limits

Inputs on which methods of hatching fail: on the left done plainly, in the middle as hatch does it. The number under each
picture is a figure that tells them apart, and the last column gives the limit between the two. `make limits` draws this
page; `make check` tests that each pair stays on both sides of its limit. Each row is a script in
[tests/stability/limits](../tests/stability/limits), which shows the commands.

The sources are Praun, Hoppe, Webb and Finkelstein, "Real-Time Hatching" (2001); Webb, Praun, Finkelstein and Hoppe, "Fine
Tone Control in Hardware Hatching" (2002); Bénard, Bousseau and Thollot, "Dynamic Solid Textures" (2009); Szécsi and
Szirányi, "Recursive Procedural Tonal Art Maps" (2014); Szécsi, Szirányi and Kacsó, "Tonal Art Maps with Image Space
Strokes", with the section that names or has the failure.
END
while IFS='	' read -r method heading sentence; do
    printf '\n## %s\n\n%s\n\n' "$heading" "$sentence"
    if [ "$method" = open ]; then
        echo '| as it is | what fails |'
        echo '| --- | --- |'
    else
        echo '| plain | hatch | what fails |'
        echo '| --- | --- | --- |'
    fi
    for file in "$here/$method"/*.limit; do
        entry=$method/$(basename "$file" .limit)
        figures=$(awk -F'\t' -v OFS='\t' -v entry="$entry" '$1 == entry {print $3, $4}' "$table")
        sh "$here/one.sh" "$file" texts | awk -F'\t' -v entry="$entry" -v figures="$figures" '
            function picture(what, caption, figure) {
                return "![" caption "](pictures/limits/" entry "-" what ".png)<br>" caption ": **" figure "**"
            }
            {
                split(figures, f, "\t")
                side = substr($7, 1, 1) == "<" ? "under " : "over "
                line = "| " picture("ours", $5, f[2]) " | **" $1 ".** " $2 "<br>*" toupper(substr($6, 1, 1)) substr($6, 2) \
                    ": " side substr($7, 2) ".* " toupper(substr($3, 1, 1)) substr($3, 2) ". |"
                print (f[1] == "-" ? "" : "| " picture("plain", $4, f[1]) " ") line
            }'
    done
done <"$here/methods.tsv"
