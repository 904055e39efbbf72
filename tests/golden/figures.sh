#!/bin/sh
# figures.sh PART BUILD: executes the runs of a part of tests/bytes/list.sh (maps, meshes, techniques, pictures, seeds,
# reports, solids) with a build, and prints the figures of their files (figures.pl).
set -eu
[ $# -eq 2 ] || { echo "usage: figures.sh PART BUILD" >&2; exit 2; }
here=$(dirname "$0")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
trap 'exit 1' INT TERM HUP
PARTS=$1 KEEP=$folder/kept sh "$here/../bytes/runs.sh" "$2" >/dev/null
perl "$here/figures.pl" "$2/tests/golden/pixels" "$folder/kept"
