# Texels that three.js uploads from textures of tampack equal those that OpenImageIO reads from the map, rounded to 8
# bits, on every level.
. "${TOP:-.}/tests/tap.sh"
INTEROP=$BUILD/interop
export INTEROP
if [ ! -d "$INTEROP/node_modules/three" ]; then
    skip "three.js reads a map exactly" "make check-interop fetches it"
    finish
fi
tamgen --size 128 --tones 5 --style pencil -o map.exr
"$BUILD/tests/interop/oiio_texels" map.exr Y >map.raw
for ink in 0 1; do
    tampack --ink $ink map.exr -o map.ktx2
    for index in 0 1; do
        node "$TOP/tests/interop/three_ktx2.mjs" map.$index.ktx2 >got
        ok "three.js reads texture $index with ink as $ink exactly" \
            node "$TOP/tests/interop/compare_tam.mjs" map.raw got 128 5 $index $ink
    done
done
finish
