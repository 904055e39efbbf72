# Every asset has the same bytes whichever compiler and optimisation built its command. With LONG=1 alone: it builds the
# commands again for each of them.
. "${TOP:-.}/tests/tap.sh"
[ -n "$LONG" ] || { skip "bytes of all commands" "only with LONG=1"; finish; }
commands='meshgen meshfit dirfield lapped-param strokegen seedgen tamgen tamvol tamthresh solidgen'
mkdir -p "$WORK/there" && ln -s "$BUILD/share" "$WORK/there/share"

# sums: prints a checksum of each asset that the commands on PATH make
sums() {
    {
        meshgen torus -o torus.glb && dirfield -q -o field.glb torus.glb && lapped-param -q -o lapped.glb field.glb &&
            lapped-param -q --atlas -o atlas.glb field.glb && strokegen -q --levels 5 -o strokes.glb field.glb &&
            strokegen -q --levels 3 --angles 0,90,45 -o crossed.glb field.glb &&
            meshfit -q --faces 500 -o fitted.glb torus.glb && seedgen -q -n 64 -o seeds.txt &&
            tamgen --size 64 --ids -o map.exr && tamvol -o volume.ktx2 map.exr && tamthresh -o fine.exr map.exr &&
            for style in perlin crosshatch; do solidgen --style $style --size 32 -o $style.ktx2 || return; done
    } >said 2>&1 || { cat said && return; }
    cksum ./*.glb seeds.txt ./*.exr ./*.ktx2
}
want=$(sums)
is "every command makes its asset" "$(printf '%s\n' "$want" | wc -l)" 13
for compiler in "gcc -O0" "gcc -O1" "clang -O2"; do
    set -- $compiler
    command -v "$1" >/dev/null || { skip "$compiler" "no $1"; continue; }
    other=$WORK/there/$1$2
    mkdir -p "$other" && ln -sfn "$BUILD/share" "$other/share"
    (cd "$TOP" && make -j2 B="$other" CC="$1" CFLAGS="$2" $(printf "$other/bin/%s " $commands)) >built 2>&1 ||
        { fail "$compiler builds the commands" "$(tail -3 built)"; continue; }
    is "$compiler makes the same bytes" "$(PATH=$other/bin:$PATH sums)" "$want"
done
finish
