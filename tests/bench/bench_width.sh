#!/bin/sh
# Measures the widths of strokes on the screen, on the teapot from 0.01 to 1000 radii, with programs/bench_width.c.
set -eu
bench_width 2>/dev/null
