# What other projects' readers see in our files is what was written, texel for texel, on every level:
# EXR by OpenImageIO and exrheader; KTX2 by ktx-parse and three.js, DDS by PixiJS, which `make
# check-interop` fetches. (No such reader knows DDS arrays: tests/unit/io/test_container.c.)
. "${TOP:-.}/tests/tap.sh"
TESTS=$BUILD/tests/interop
INTEROP=$BUILD/interop
export INTEROP
[ -x "$TESTS/samples" ] || { skip "sample files" "they are built by make check"; finish; }
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

# by NAME SCRIPT FILE PACKAGE
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
for file in rgba.ktx2 rgba-volume.ktx2; do # three.js has no arrays of plain formats and no RGB8
    by three.js three_ktx2.mjs "$file" three
done
by PixiJS pixi_dds.mjs rgba.dds pixi.js # it takes no arrays and no volumes
finish
