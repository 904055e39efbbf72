# Every source is formatted as by clang-format 14 (Debian 12) with .clang-format.
. "${TOP:-.}/tests/tap.sh"
cd "$TOP" || exit 1
case $(clang-format --version 2>/dev/null) in
*"version 14."*) ;;
*)
    skip "the format of sources" "no clang-format 14"
    finish
    exit
    ;;
esac
find libhatch cmd tests -name '*.c' -o -name '*.h' -o -name '*.cc' | sort |
    xargs -n 40 -P 2 clang-format --dry-run -Werror 2>"$WORK/said"
is "clang-format changes nothing" "$(grep -E 'error:' "$WORK/said" | cut -d: -f1 | uniq)" ""
finish
