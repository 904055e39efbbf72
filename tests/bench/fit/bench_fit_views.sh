#!/bin/sh
# Measures how far the curves of fitted strokes are from the pseudo-inverse in doubles of the same fragments, and from the
# problem that the fit states (stated_...), solved in doubles by another way; in views of five scenes, 960x720 pixels, with
# the options' defaults (programs/bench_fit_views.c, which has the kinds of systems). Without ../shared, two shapes take the
# place of Duck.glb and CesiumMan.glb. p50, p99, most: of the distances of strokes, in pixels; over: strokes of more than a
# pixel. ranked_...: from the pseudo-inverse without singular values under 3 % of the largest. Of the strokes that are over
# a pixel from the pseudo-inverse, together, for it and for the curve: off, the length that no fragment is near, within 1.5
# widths and a pixel; missed, the weight of fragments that it is not near; weight, of all their fragments, in pixels; worse:
# strokes for which the curve has over a pixel more.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
files=$(dirname "$0")/../../../../shared/data/gltf
style=$(dirname "$(command -v render-gl)")/../share/hatch/styles/ink.style
printf 'scene\twhat\tkind\tstrokes\tp50\tp99\tmost\tover\tranked_p50\tranked_p99\tranked_most\tranked_over\tstated_p50\tstated_p99\tstated_most\tstated_over\toff_inverse\toff\tmissed_inverse\tmissed\tweight\tworse_off\tworse_missed\n'
shapes="teapot torus sphere"
for name in Duck CesiumMan; do
    if [ -e "$files/$name.glb" ]; then
        cp "$files/$name.glb" "$work"
    else
        shapes="$shapes $([ $name = Duck ] && echo ellipsoid || echo superquadric)"
    fi
done
for shape in $shapes; do
    meshgen "$shape" -o "$work/$shape.glb"
done
for scene in "$work"/*.glb; do
    bench_fit_views "$(basename "$scene" .glb)" -q -t strokes --style "$style" --lines none --size 960x720 "$scene"
done
