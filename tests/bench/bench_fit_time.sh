#!/bin/sh
# Measures the time and the errors of ways to fit cubics to the pixels of whole strokes, with programs/bench_fit.c.
set -eu
bench_fit time
