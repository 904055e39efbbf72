#!/bin/sh
# Measures rptam over eighty octaves of zoom, drawn with floats alone and with pieces, with programs/bench_zoom.c.
set -eu
bench_zoom 2>/dev/null
