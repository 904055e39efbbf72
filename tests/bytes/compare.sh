#!/bin/sh
# compare.sh OLD NEW [PATTERN]: executes runs.sh for two builds and prints the runs that differ, each with the parts
# that do: the files written ("wrote"), the exit status ("status"), standard error ("said"). OLD may be a file with the
# output of runs.sh. Exits with 1 when a run differs or is missing, as runs of the window may be without a display.
set -u
[ $# -ge 2 ] || { echo "usage: compare.sh OLD NEW [PATTERN]" >&2; exit 2; }
runs=$(dirname "$0")/runs.sh
lines=$(mktemp -d) || exit 2
trap 'rm -rf "$lines"' EXIT
trap 'exit 2' INT TERM HUP
if [ -f "$1" ]; then
    awk -F'\t' -v pattern="${3-}" '$1 ~ /^input-/ || $1 ~ pattern' "$1" >"$lines/old"
else
    sh "$runs" "$1" "${3-}" >"$lines/old" || exit 2
fi
sh "$runs" "$2" "${3-}" >"$lines/new" || exit 2
awk -F'\t' '
    FNR == NR {wrote[$1] = $2; status[$1] = $3; said[$1] = $4; next}
    !($1 in wrote) {print $1 "\tis new"; differs = 1; next}
    {
        what = (wrote[$1] == $2 ? "" : " wrote") (status[$1] == $3 ? "" : " status") (said[$1] == $4 ? "" : " said")
        if (what) {print $1 "\t" substr(what, 2); differs = 1}
        delete wrote[$1]
    }
    END {for (name in wrote) {print name "\tis missing"; differs = 1}; exit differs}' "$lines/old" "$lines/new"
