# Every command writes the same bytes whichever compiler and optimisation built it. With LONG=1 alone: it builds all
# commands again for each of them, and executes the list of runs, tests/bytes/list.sh and list_draw.sh.
. "${TOP:-.}/tests/tap.sh"
[ -n "${LONG:-}" ] || { skip "bytes of all commands" "only with LONG=1"; finish; }
sh "$TOP/tests/bytes/runs.sh" "$BUILD" >runs.tsv
ok "there are runs" test "$(wc -l <runs.tsv)" -gt 100
for compiler in "gcc -O0" "gcc -O1" "clang -O2"; do
    set -- $compiler
    command -v "$1" >/dev/null || { skip "$compiler" "no $1"; continue; }
    other=$WORK/$1$2
    if (cd "$TOP" && make -j2 B="$other" CC="$1" CFLAGS="$2" all) >built 2>&1; then
        is "$compiler makes the same bytes" "$(sh "$TOP/tests/bytes/compare.sh" runs.tsv "$other")" ""
    else
        fail "$compiler builds the commands" "$(tail -3 built)"
    fi
    rm -rf "$other"
done
finish
