#!/bin/sh
# Measures the errors of ways to fit cubics to the pixels of strokes, with programs/bench_fit.c.
set -eu
bench_fit error
