# clang compiles all C sources without warnings, as gcc does.
. "${TOP:-.}/tests/tap.sh"
cd "$TOP" || exit 1
command -v clang >/dev/null || { skip "clang's warnings" "no clang"; finish; }
flags='-std=c11 -D_POSIX_C_SOURCE=200809L -Ilibhatch -Icmd -Itests/support -Itests/fuzz -ffp-contract=off -pthread'
# Numbers of the tests are constants of enumerations, and meet doubles. Newer libraries deprecate what older ones need.
warnings='-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wvla -Wno-enum-float-conversion -Wno-deprecated-declarations'
# The command that clang would start anew for each file takes many.
one=$(clang '-###' $flags $warnings -fsyntax-only -x c - 2>&1 | tail -n 1 | sed 's/ "-main-file-name" "[^"]*"//; s/ "-"$//')
find libhatch cmd tests -name '*.c' | xargs -n 64 -P 2 sh -c "$one \"\$@\"" sh 2>"$WORK/said"
is "all files were compiled" $? 0
is "clang gives no warnings" "$(grep -E 'warning|error' "$WORK/said")" ""
finish
