#!/bin/sh
# draw.sh: draws docs/limits.md and its pictures from the table of limits. TOP: the source; PATH has the commands.
set -eu
TOP=${TOP:-$PWD}
export TOP
here=$TOP/tests/stability/limits
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
sh "$here/run.sh" "$work" >"$work/table.tsv"
if grep '	wrong$' "$work/table.tsv" >&2; then
    echo "draw.sh: these figures are on the wrong side of their limits" >&2
    exit 1
fi
rm -rf "$TOP/docs/pictures/limits"
for file in "$work"/*/*/plain.png "$work"/*/*/ours.png; do
    entry=$(dirname "${file#"$work"/}")
    mkdir -p "$TOP/docs/pictures/limits/$(dirname "$entry")"
    limits_picture small "$file" "$TOP/docs/pictures/limits/$entry-$(basename "$file")"
done
sh "$here/page.sh" "$work/table.tsv" >"$TOP/docs/limits.md"
