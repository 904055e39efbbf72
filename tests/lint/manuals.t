# Every command has a manual and a line in commands.tsv; mandoc accepts every manual.
. "${TOP:-.}/tests/tap.sh"
cd "$TOP" || exit 1
commands=$(ls cmd | sed -n 's/\.c$//p'; ls -d cmd/*/ | xargs -n1 basename)
for command in $commands; do
    [ -e "cmd/$command.c" ] || [ -e "cmd/$command/main.c" ] || continue
    ok "$command has a manual" test -e "man/man1/$command.1"
    ok "$command has a line in commands.tsv" grep -q "^$command	" tests/cli/commands.tsv
done
command -v mandoc >/dev/null || { skip "manuals are clean" "no mandoc"; finish; }
for manual in man/man*/*; do
    [ -e "$manual" ] || continue
    # Manuals that refer to each other need not be installed here, and lines may be longer than mandoc's limit.
    is "$manual is clean" "$(mandoc -Tlint "$manual" | grep -vE 'referenced manual not found|longer than 80 bytes')" ""
    for section in NAME SYNOPSIS DESCRIPTION 'EXIT STATUS' EXAMPLES 'SEE ALSO'; do
        case $manual in *.1) ok "$manual has $section" grep -q "^.Sh $section" "$manual" ;; esac
    done
done

# Examples can be pasted from a terminal of 80 columns: each literal line stands there unbroken, as mandoc and groff
# print it.
# literal_lines MANUAL: prints the lines as a reader should see them
literal_lines() {
    awk '/^\.Bd -literal/ {literal = 1; next} /^\.Ed/ {literal = 0; next}
        literal && $0 != "" && !/^\./ {print} sub(/^\.Dl /, "") {print}' "$1" |
        sed 's/\\e/\\/g; s/\\-/-/g; s/\\&//g'
}
# missing PRINTED MANUAL: prints the literal lines that are not lines of what was printed, or begin beyond column 80
missing() {
    sed 's/.\x08//g; s/\x1b\[[0-9;]*m//g' "$1" | awk 'length($0) <= 80' | sed 's/^ *//' | sort -u >"$WORK/printed"
    literal_lines "$2" | sed 's/^ *//' | sort -u | comm -23 - "$WORK/printed"
}
# Versions of groff indent them by up to 13 columns, and leave the last ones free.
for manual in man/man*/*; do
    is "$manual: an indented literal line has at most 64 columns" "$(sed '/^\.Bd -literal$/,/^\.Ed/d' "$manual" >"$WORK/indented"
        literal_lines "$WORK/indented" | awk 'length($0) > 64')" ""
    mandoc -Tutf8 -Owidth=78 "$manual" >"$WORK/page"
    is "$manual: mandoc prints its examples unbroken" "$(missing "$WORK/page" "$manual")" ""
    command -v groff >/dev/null && groff -mandoc -Tutf8 -rLL=78n "$manual" >"$WORK/page" 2>/dev/null || continue
    is "$manual: groff prints its examples unbroken" "$(missing "$WORK/page" "$manual")" ""
done
for command in "$BIN"/*; do
    [ -x "$command" ] || continue
    is "$(basename "$command") --help: no example is wider than a terminal" \
        "$("$command" --help | sed '1,/^examples:/d' | awk 'length($0) > 80')" ""
done
finish
