#!/bin/sh
# page.sh TABLE: prints docs/limits.md, from the table that run.sh has printed. TOP: the source.
set -eu
TOP=${TOP:-$PWD}
export TOP
here=$TOP/tests/stability/limits
table=$1
picture() {
    echo "![$3]($(echo "pictures/limits/$1-$2.png"))<br>$4"
}
cat <<'END'
# Limits

Inputs on which methods of hatching fail. On the left is the plain method, in the middle hatch; under each picture is a
figure that tells them apart, and on the right a limit for this figure, which the plain method exceeds. `make limits`
draws this page, and `make check` tests each pair. Each entry is a script in
[tests/stability/limits](../tests/stability/limits).
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
                    ": " side substr($7, 2) ".* " $3 ". |"
                print (f[1] == "-" ? "" : "| " picture("plain", $4, f[1]) " ") line
            }'
    done
done <"$here/methods.tsv"
