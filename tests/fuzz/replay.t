# Every fuzz target has a corpus and runs on it, and on all bad inputs of its format, without a failure.
. "${TOP:-.}/tests/tap.sh"
bad=$TOP/../shared/bad
ok "inputs are generated" perl "$TOP/tests/bad/make.pl" own
for target in "$TOP"/tests/fuzz/fuzz_*.c "$TOP"/tests/fuzz/fuzz_*.cc; do
    [ -e "$target" ] || continue
    name=$(basename "${target%.*}" | sed 's/^fuzz_//')
    corpus=$TOP/tests/fuzz/corpus/$name
    is "fuzz $name has a corpus" "$(ls "$corpus" 2>/dev/null | wc -l | awk '{print ($1 > 0)}')" 1
    find "$corpus" own "$bad/" -type f -size -256k -print0 2>/dev/null |
        xargs -0 "$BUILD/tests/fuzz/$name" >replayed 2>said
    is "fuzz $name replays its corpus" "$? $(grep -c '^ok' replayed) $(head -c 2000 said)" \
        "0 $(sed -n 's/^1\.\.//p' replayed) "
done
finish
