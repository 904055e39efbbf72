# Readers of other projects read exactly the texels that were written, on every level: OpenImageIO and
# exrheader read EXR; ktx-parse and three.js read KTX2, PixiJS reads DDS; `make check-interop` fetches these.
# None of them supports DDS arrays, see tests/unit/io/test_container.c.
. "${TOP:-.}/tests/tap.sh"
TESTS=$BUILD/tests/interop
INTEROP=$BUILD/interop
export INTEROP
[ -x "$TESTS/samples" ] || { skip "sample files" "make check builds them"; finish; }
ok "sample files are written" "$TESTS/samples" "$WORK"

for file in *.exr; do
    read -r channels <"$file.channels" || true
    # shellcheck disable=SC2086
    "$TESTS/oiio_texels" "$file" $channels >got 2>.err
    if cmp -s got "$file.raw"; then
        pass "OpenImageIO reads $file"
    else
        fail "OpenImageIO reads $file" "$(cat .err)" "$(cmp got "$file.raw" 2>&1)"
    fi
    if command -v exrheader >/dev/null; then
        ok "exrheader opens $file" exrheader "$file"
    else
        skip "exrheader opens $file" "no exrheader"
    fi
done

# by NAME SCRIPT FILE PACKAGE: compares the texels that a reader prints with FILE.raw
by() {
    if [ ! -d "$INTEROP/node_modules/$4" ]; then
        skip "$1 reads $3" "make check-interop fetches it"
        return
    fi
    node "$TOP/tests/interop/$2" "$3" >got 2>.err
    if cmp -s got "$3.raw"; then
        pass "$1 reads $3"
    else
        fail "$1 reads $3" "$(cat .err)" "$(cmp got "$3.raw" 2>&1)"
    fi
}
for file in *.ktx2; do
    by ktx-parse ktx_parse.mjs "$file" ktx-parse
done
for file in rgba.ktx2 rgba-volume.ktx2; do # three.js supports neither arrays of uncompressed formats nor RGB8
    by three.js three_ktx2.mjs "$file" three
done
by PixiJS pixi_dds.mjs rgba.dds pixi.js # supports neither arrays nor volumes
finish
