#!/bin/sh
# Measures the effect of --fade, --fade-by and --overlap of render-gl's technique rptam on a zoom of one octave towards
# a plane of tone .3. Drift: the largest less the smallest tone of nine large pictures, from peak to peak. Change
# and pop (hatchstat frames): how much, and how unevenly, the 120 frames of the zoom change.
#
# Fixed: the pop when the strokes of the middle of the zoom, drawn with the same options, scale with the surface, so
# that the depth does not change. This is the effect of resampling alone on the same edges. The edges must be the same
# because pop is proportional to the length of all contours times their contrast and sharpness, and small strokes have
# more contour per ink than large ones. The row `texture` is an ordinary mip-mapped texture of one picture for
# comparison; its levels soften edges, so it pops less than any drawing as sharp as the strokes.
#
# Allowed: fixed plus the strokes that must appear. From frame to frame the surface grows by g = 4^(1/119) on the
# screen, while the number of strokes per area of the screen is constant, so a share g - 1 of the ink appears in each
# frame. Ink a that appears suddenly between two frames adds a to the second difference of one frame and subtracts it
# from that of the next: 2 a in all, and no more when combined with other changes, since |x + a| <= |x| + |a|. For a
# mean tone t this is 2 t (g - 1).
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
printf 'method\tby\toverlap\tsize\tframes\tseconds\tseconds_min\tseconds_max\tcpu_seconds\tpeak_kib'
printf '\ttone\tdrift\tchange\tpop\tpop_box8\tfixed\tallowed\n'
cat >"$work/plane.gltf" <<'EOF'
{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
 "meshes":[{"primitives":[{"indices":2,"material":0,"attributes":{"POSITION":0,"TEXCOORD_0":1}}]}],
 "materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],
 "textures":[{"source":0}],"images":[{"uri":"strokes.png"}],
 "buffers":[{"byteLength":92,"uri":"plane.bin"}],"bufferViews":[{"buffer":0,"byteLength":92}],
 "accessors":[
  {"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[-1,-1,0],"max":[1,1,0]},
  {"bufferView":0,"byteOffset":48,"componentType":5126,"count":4,"type":"VEC2"},
  {"bufferView":0,"byteOffset":80,"componentType":5123,"count":6,"type":"SCALAR"}]}
EOF
perl -e 'print pack("f<12f<8S<6", -1,-1,0, 1,-1,0, 1,1,0, -1,1,0, 0,1, 1,1, 1,0, 0,0, 0,1,2, 0,2,3)' >"$work/plane.bin"
printf 'v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n' >"$work/plane.obj"
seedgen -n 64 --layers 4 --candidates 300 -o "$work/sets"
view="--camera 0,0,8:0,0,0 --fov 14.25 --lines none" # the square fills the picture
strokes="$work/plane.obj -t rptam --seeds $work/sets --tone-range .3:.3"

# film ARGUMENT ...: the 120 frames of a zoom
film() {
    "$MEASURE" 1 render-gl "$@" $view --size 160x160 --frames 120 --animate zoom=1..2 -o "$work/f%03d.png"
}
# row METHOD BY OVERLAP ARGUMENT ...
row() {
    printf '%s\t%s\t%s\t160x160\t120\t' "$1" "$2" "$3"
    shift 3
    film "$@" | tr '\n' '\t'
    render-gl "$@" $view --size 800x800 --samples 1 --frames 9 --animate zoom=1..2 -o "$work/g%d.png"
    hatchstat frames "$work"/g?.png | awk -F'\t' '
        NR > 1 && $1 != "all" {sum += $2; low = !n || $2 < low ? $2 : low; high = !n || $2 > high ? $2 : high; n++}
        $1 == "all" {printf "%.4f\t%.4f\t", 1 - sum / n, high - low}'
    hatchstat frames "$work"/f*.png | awk -F'\t' '
        NR > 1 && $1 != "all" {sum += 1 - $2; n++}
        $1 == "all" {printf "%.5f\t%.5f\t%.4f\t%.5f\n", $4, $5, $6, 2 * sum / n * (4 ^ (1 / 119) - 1)}' >"$work/row"
}
# fade LAW BY OVERLAP
fade() {
    how="--fade $1 --fade-by $2 --overlap $3"
    row "$1" "$2" "$3" $strokes $how --seed-tile 64 --stroke 14x1.5
    film $strokes $how --animate seed-tile=45.254834..90.509668 \
        --animate stroke=9.899495x1.06066..19.79899x2.12132 >"$work/time"
    hatchstat frames "$work"/f*.png | awk -F'\t' -v OFS='\t' '
        FILENAME == "-" {fixed = $5; next}
        {print $1, $2, $3, sprintf("%.5f\t%.5f", fixed, fixed + $4)}' - "$work/row"
}
# The strokes of the middle of the zoom at four times the resolution.
render-gl $strokes $view --size 904x904 --seed-tile 256 --stroke 56x6 -o "$work/strokes.png"
row texture - 0 "$work/plane.gltf" --technique gouraud --texture-tone --light 0:0 --tone-range 0:1
awk -F'\t' -v OFS='\t' '{print $1, $2, $3, $2, $2}' "$work/row"
for law in even weighted paper; do
    for overlap in 0 0.1 0.3 0.6 1; do
        fade $law opacity $overlap
    done
done
for overlap in 0 0.3 1; do
    fade even size $overlap
done
