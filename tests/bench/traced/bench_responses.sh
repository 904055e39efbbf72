#!/bin/sh
# Measures the responses of the styles of traced strokes: the ink that strokes of one direction make on planes of tone
# 1/8, 2/8 to 1, without the response and the colours of the style. Means of planes at 0, 30 and 75 degrees, of two seeds
# in 200 x 200 pixels and of one in 400 x 400. off: largest difference from the response that the style has.
# STYLES: names of styles, instead of all that have a response.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
styles=$(dirname "$0")/../../../styles
printf 'style\t0.125\t0.25\t0.375\t0.5\t0.625\t0.75\t0.875\t1\toff\n'
for angle in 0 30 75; do
    for seed in 1 2; do
        meshgen plane --faces 200 | strokegen -q --levels 6 --gap 0.04 --angles $angle --seed $seed \
            -o "$work/$angle.$seed.glb"
    done
done
# ink STYLE TONE
ink() {
    for plane in 0.1:200 0.2:200 0.1:400 30.1:200 30.2:200 30.1:400 75.1:200 75.2:200 75.1:400; do
        render-gl -q "$work/${plane%:*}.glb" -t traced --stroke-style "$1" --lines none --tone-range "$2:$2" \
            --size "${plane#*:}x${plane#*:}" --camera 0,0,3.7320508:0,0,0 --fov 25 -o "$work/plane.exr"
        hatchstat frames "$work/plane.exr" "$work/plane.exr" | tail -n 1
    done | awk '{
        sum += 1 - $2
    }
    END {
        printf "%.4f", sum / NR
    }'
}
for style in ${STYLES:-$(grep -l '^response' "$styles"/*.style | sed 's/.*\///; s/\.style$//')}; do
    sed '/^response/d; /^stroke-colors/d' "$styles/$style.style" >"$work/bare.style"
    echo 'response 0.125 0.25 0.375 0.5 0.625 0.75 0.875 1' >>"$work/bare.style"
    for tone in 0.125 0.25 0.375 0.5 0.625 0.75 0.875 1; do
        ink "$work/bare.style" $tone
        echo
    done >"$work/inks"
    sed -n 's/^response //p' "$styles/$style.style" | tr ' ' '\n' | paste "$work/inks" - | awk -v "style=$style" '{
        off = $1 - $2 > off ? $1 - $2 : $2 - $1 > off ? $2 - $1 : off
        row = row "\t" $1
    }
    END {
        printf "%s%s\t%.4f\n", style, row, off
    }'
done
