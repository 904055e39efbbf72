# Texels of volumes, threshold textures and exact runs as read by ktx-parse equal those that OpenImageIO reads from the
# map and from EXR files of tamvol and tamthresh, on every level.
. "${TOP:-.}/tests/tap.sh"
INTEROP=$BUILD/interop
export INTEROP
if [ ! -d "$INTEROP/node_modules/ktx-parse" ]; then
    skip "other readers read fine tones exactly" "make check-interop fetches them"
    finish
fi
# texels FILE: prints the texels as read by ktx-parse
texels() {
    node "$TOP/tests/interop/ktx_parse.mjs" "$1"
}
compare() {
    name=$1
    shift
    ok "$name" node "$TOP/tests/interop/fine_tone.mjs" "$@"
}
tamgen --size 128 --tones 64 --style pencil --set 'darkest 1' -o map.exr
"$BUILD/tests/interop/oiio_texels" map.exr Y >map.raw
tamvol --tones 32 map.exr -o volume.ktx2 && texels volume.ktx2 >volume
compare "a volume's slices are the map's columns" volume map.raw volume 128 64 32 3
tamvol --tones 32 map.exr -o volume.exr && "$BUILD/tests/interop/oiio_texels" volume.exr Y >slices.raw
compare "a volume as EXR has the same slices" slices slices.raw volume 128 32
tamthresh map.exr -o thresholds.ktx2 && texels thresholds.ktx2 >thresholds
tamthresh map.exr -o thresholds.exr &&
    "$BUILD/tests/interop/oiio_texels" thresholds.exr R G B A >layers.raw
compare "thresholds as EXR equal those of KTX2" layers layers.raw thresholds 128
compare "thresholds sum to the map's last column" sums map.raw thresholds 128 64
tamthresh --exact map.exr -o exact.ktx2 && texels exact.ktx2 >exact
compare "exact runs contain the map exactly" exact map.raw exact 128 64
finish
