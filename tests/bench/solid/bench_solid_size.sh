#!/bin/sh
# Measures the size, the mean and the changes of a solid texture over distances, with programs/bench_solid_size.c.
set -eu
bench_solid_size 2>/dev/null
