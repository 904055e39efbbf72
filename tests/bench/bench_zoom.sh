#!/bin/sh
# render-gl rptam through eighty octaves of zoom, drawn by floats alone and with pieces: bench_zoom.c.
set -eu
bench_zoom 2>/dev/null
