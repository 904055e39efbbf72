#!/bin/sh
# Widths of strokes on the screen over the teapot from 0.01 to 1000 radii: bench_width.c.
set -eu
bench_width 2>/dev/null
