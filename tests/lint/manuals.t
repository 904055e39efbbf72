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
finish
