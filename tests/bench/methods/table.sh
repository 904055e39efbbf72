#!/bin/sh
# table.sh FILE: prints the means of methods.tsv as a table for README.
set -eu
echo '| technique | frame | files | made in | tone error | grey strokes | width, 3 octaves | flicker | across borders |'
echo '| --- | --: | --: | --: | --: | --: | --: | --: | --: |'
awk -f "$(dirname "$0")/means.awk" "$1" | awk -F'\t' '
    function or_none(format, value) { return value == "nan" ? "" : sprintf(format, value) }
    function size(bytes) { return bytes < 1 ? "none" : bytes < 1e6 ? sprintf("%.0f kB", bytes / 1e3) : sprintf("%.1f MB", bytes / 1e6) }
    $1 != "gouraud" {
        printf "| `%s` | %.1f | %s | %s | %s | %s | %s | %s | %s |\n", $1, $2, size($3), $4 < 0.005 ? "" : sprintf("%.1f s", $4),
            or_none("%.3f", $5), or_none("%.0f %%", 100 * $6), or_none("%.2f", $7), or_none("%.4f", $8), or_none("%.2f", $9)
    }'
