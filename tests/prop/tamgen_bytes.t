# A random seed determines the bytes of a map, for any number of threads, any locale, folder, compiler and level of
# optimisation.
. "${TOP:-.}/tests/tap.sh"
runs='--size_128_--tones_9 --size_64_--tones_255_--style_stipple --size_128_--style_pencil_--growth_0.4_--ids
    --size_128_--style_charcoal_--method_exhaustive_--candidates_40:10
    --size_128_--replay_drawing.svg_--fit_-q --size_64_--style_arcs_--palette_dusk'

# sums PROGRAM THREADS: prints a checksum of the map, the table of strokes and the contact sheet of each run
sums() {
    cp "$TOP/pipelines/hatching.svg" drawing.svg
    for run in $runs; do
        "$1" $(echo "$run" | tr _ ' ') -j "$2" --seed 3 --strokes s.tsv -x s.png -o s.exr || return
        cat s.exr s.tsv s.png | cksum
    done
}
want=$(sums tamgen 1)
for threads in 2 8; do
    is "$threads threads make the same bytes as one" "$(sums tamgen $threads)" "$want"
done
mkdir -p 'another folder/ink'
cd 'another folder' || exit 1
is "another folder makes the same bytes" "$(sums tamgen 1)" "$want"
cd ..
locale=$(locale -a 2>/dev/null | grep -iE '^(de|fr)_' | head -1)
if [ -n "$locale" ]; then
    is "another locale makes the same bytes" "$(LC_ALL=$locale sums tamgen 1)" "$want"
else
    skip "another locale" "no locale with a decimal comma"
fi

# build COMPILER FLAG: builds tamgen with only those flags of the Makefile that its results depend on
build() {
    mkdir -p objects bin
    rm -f objects/*
    (cd "$TOP" && ls cmd/tamgen/*.c cmd/shared/*.c cmd/shared/rules/*.c cmd/shared/names/*.c cmd/shared/values/*.c cmd/shared/needs/map.c \
        cmd/shared/needs/needs.c libhatch/base/*.c libhatch/image/*.c \
        libhatch/filter/*.c libhatch/stroke/*.c libhatch/tam/*.c libhatch/placement/*.c libhatch/io/exr/*.c \
        libhatch/io/svg/*.c libhatch/io/drawing/*.c libhatch/io/png/*.c libhatch/io/foreign/*.c libhatch/curve/stroke_look.c \
        libhatch/curve/width.c libhatch/needs/*.c) |
        grep -vE 'shared/(scene|surface|field|texels)' >files
    TOP=$TOP xargs -P 2 -I{} sh -c '"$0" "$1" -std=c11 -D_POSIX_C_SOURCE=200809L -I"$TOP"/libhatch \
        -I"$TOP"/cmd -ffp-contract=off -pthread -w -c "$TOP"/{} -o objects/$(echo {} | tr / _).o' \
        "$1" "$2" <files &&
        "$1" -pthread -o "bin/tamgen$1$2" objects/*.o -lOpenEXRCore -ldeflate -lexpat -lpng16 -ldl -lm
}
mkdir -p share/hatch && ln -s "$BUILD/share/hatch/styles" share/hatch/styles
other=gcc
command -v clang >/dev/null && other=clang
if build $other -O0 2>said; then
    is "$other -O0 makes the same bytes" "$(sums bin/tamgen$other-O0 1)" "$want"
else
    fail "$other -O0 builds tamgen" "$(tail -5 said)"
fi
finish
