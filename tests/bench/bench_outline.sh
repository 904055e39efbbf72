#!/bin/sh
# Measures how well silhouettes agree with the faces that are drawn, with programs/bench_outline.c; with scans if the folder
# ../shared exists. PICTURES: a folder for pictures of the lines, with faults in colour.
set -eu
bench_outline "$(dirname "$0")/../../../shared/data/meshes" ${PICTURES:+"$PICTURES"} 2>/dev/null
