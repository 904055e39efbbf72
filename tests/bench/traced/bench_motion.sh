#!/bin/sh
# Measures how the widths of traced strokes change from frame to frame while the camera turns by 2.5 degrees a frame, or
# comes nearer by a sixteenth of an octave, on shapes, and on scans if ../shared has them (programs/bench_motion.c).
# mean_px, p99_px: change of width of a point; gone: share of points of at least 0.3 pixels that are gone in the next
# frame.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
. "$(dirname "$0")/scenes.sh"
printf 'scene\tmotion\tpoints\tmean_px\tp99_px\tgone\n'
make_fields "$work"
for file in "$work"/*.glb; do
    name=$(basename "$file" .glb)
    strokegen -q "$file" -o "$work/strokes.glb.part"
    bench_motion "$(dirname "$0")/../../../styles/engraving.style" "$work/strokes.glb.part" 2>/dev/null | sed "s/^/$name\t/"
done
