#!/bin/sh
# run.sh FOLDER [ENTRY ...]: runs the table of limits, or some of its entries (METHOD/NAME), in a folder: pictures are
# FOLDER/METHOD/NAME/plain.png and ours.png. Prints a table: entry, limit, figure of plain, figure of ours, and right,
# if each figure is on its side of the limit, or wrong. TOP: the source; PATH has the commands.
set -eu
TOP=${TOP:-$PWD}
here=$TOP/tests/stability/limits
folder=$1
shift
[ $# -gt 0 ] || set -- $(cd "$here" && ls */*.limit | sed 's/\.limit$//')
MADE=$folder/made
export TOP MADE
mkdir -p "$MADE"
printf 'entry\tlimit\tplain\tours\tverdict\n'
for entry in "$@"; do
    mkdir -p "$folder/$entry"
    figures=
    for what in plain ours; do
        figure=-
        case $what-$entry in
        plain-open/*) ;;
        *) figure=$(cd "$folder/$entry" && sh "$here/one.sh" "$here/$entry.limit" $what) || figure=failed ;;
        esac
        figures="$figures$figure	"
    done
    limit=$(sh "$here/one.sh" "$here/$entry.limit" texts | cut -f 7)
    printf '%s\t%s\t%s\n' "$entry" "$limit" "$figures" | awk -F'\t' -v OFS='\t' '
        function number(text) {return text ~ /^[-+]?[0-9.]+(e[-+]?[0-9]+)?$/}
        function within(text) {return side == "<" ? text + 0 < bound : text + 0 > bound}
        {
            side = substr($2, 1, 1)
            bound = substr($2, 2) + 0
            right = number($4) && (number($3) || $3 == "-")
            if ($3 == "-")
                right = right && !within($4)
            else
                right = right && within($4) && !within($3)
            for (i = 3; i <= 4; i++)
                if (number($i))
                    $i = sprintf($i >= 100 ? "%.0f" : "%.3g", $i)
            print $1, $2, $3, $4, right ? "right" : "wrong"
        }'
done
