# Sizes of files and functions, forbidden words, and functions that libhatch must not call.
. "${TOP:-.}/tests/tap.sh"
cd "$TOP" || exit 1
sources=$(find libhatch cmd tests -name '*.c' -o -name '*.h' -o -name '*.cc' -o -name '*.glsl' \
    -o -name '*.vert' -o -name '*.frag' | sort)

is "no source file over 500 lines" "$(wc -l $sources | awk '$2 != "total" && $1 > 500')" ""
is "no function over 60 lines" "$(awk '
    FNR == 1 {begin = 0}
    /^\{/ {begin = FNR}
    /^\}/ {if (begin && FNR - begin > 60) print FILENAME ":" begin ": " FNR - begin; begin = 0}' \
    $(echo "$sources" | grep -E '\.(c|cc)$'))" ""
is "no line over 120 columns" "$(awk 'length($0) > 120 {print FILENAME ":" FNR}' $sources)" ""
is "no folder of sources with more than 22 files" "$(find libhatch cmd tests -path tests/fuzz/corpus -prune -o -type f -print |
    sed "s|/[^/]*\$||" | sort | uniq -c | awk '$1 > 22')" ""
is "the Makefile has at most 220 lines" "$(wc -l <Makefile | awk '$1 > 220')" ""

texts=$(find . -path ./build -prune -o -path ./.git -prune -o -path ./tests/lint -prune -o -type f \
    \( -name '*.[ch1-7]' -o -name '*.cc' -o -name '*.sh' -o -name '*.t' -o -name '*.limit' -o -name '*.md' -o -name '*.mk' \
    -o -name '*.glsl' -o -name '*.vert' -o -name '*.frag' -o -name Makefile -o -name bootstrap \) -print)
is "no marks of unfinished work" \
    "$(grep -nwE 'TODO|FIXME|XXX' $texts
        grep -nwiE 'todo|fixme|stub|not implemented|for now|placeholder' $texts)" ""
is "no paths of a particular machine" "$(grep -nE '/work/|/home/[a-z]' $texts)" ""

# calls PATTERN FILE ...: prints calls outside comments and strings
calls() {
    calls_pattern=$1
    shift
    awk -v pattern="(^|[^A-Za-z0-9_.>])($calls_pattern)[ ]*\\\\(" '
        {line = $0; gsub(/"([^"\\]|\\.)*"/, "", line); gsub(/\/\*.*\*\//, "", line)
         sub(/\/\/.*/, "", line); sub(/^ \*.*/, "", line); sub(/\/\*.*/, "", line)}
        line ~ pattern {print FILENAME ":" FNR ": " $0}' "$@"
}
library=$(find libhatch -name '*.c' -o -name '*.cc' -o -name '*.h')
is "libhatch neither prints nor ends the process" \
    "$(calls 'v?f?printf|f?puts|f?putc|putchar|perror|_?exit|abort|signal' $library)" ""
is "libhatch allocates only from arenas, and where a package asks it to" \
    "$(calls 'malloc|calloc|realloc|aligned_alloc|strdup' $(echo "$library" |
        grep -vxE 'libhatch/(base/arena|io/(exr/stream|png/read|cxx/new))\.cc?'))" ""
is "libhatch does not depend on clock, environment or locale" \
    "$(calls 'time|clock|clock_gettime|gettimeofday|getenv|setlocale|s?rand|random' $library)" ""
is "commands print only through cmd" \
    "$(calls 'v?f?printf|f?puts|putchar|perror|_?exit|abort|setlocale|getenv' \
        $(find cmd -name '*.c' | grep -v '^cmd/shared/'))" ""
finish
