# An installation works after it was moved, and the source tar depends on the commit only. Needs $BUILD/stage, into
# which `make check` installs.
. "${TOP:-.}/tests/tap.sh"

cp -R "$BUILD/stage" "moved here" || exit 1
here="$WORK/moved here/usr"
PATH=$here/bin:/usr/bin:/bin
for command in $(ls "$BIN"); do
    is "$command is found in the moved installation" "$(command -v "$command")" "$here/bin/$command"
    ok "$command runs there" "$command" --version
    manual=$here/share/man/man1/$command.1
    [ ! -e "$TOP/man/man1/$command.1" ] || ok "$command has its manual" test -e "$manual"
    ok "$command has its bash completion" \
        bash -n "$here/share/bash-completion/completions/$command"
    for shell in zsh/site-functions/_"$command" fish/vendor_completions.d/"$command".fish; do
        if command -v "${shell%%/*}" >/dev/null; then
            ok "$command: ${shell%%/*} reads its completion" "${shell%%/*}" -n "$here/share/$shell"
        else
            ok "$command has its ${shell%%/*} completion" test -s "$here/share/$shell"
        fi
    done
done

# Asks bash for completions like readline.
cat >ask.bash <<'ASK'
. "$1/share/bash-completion/completions/$2"
shift
COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
"_hatch_$1"
printf '%s ' "${COMPREPLY[@]}"
ASK
is "bash completes an option's name" "$(bash ask.bash "$here" meshgen --max)" "--max-memory "
is "bash completes a choice" "$(bash ask.bash "$here" meshgen --uv n)" "natural "
is "bash completes a choice after =" "$(bash ask.bash "$here" meshgen --uv = e)" "even "

chmod -R a-w "$here"
if [ -x "$here/bin/tamgen" ]; then
    for style in "$TOP"/styles/*.style; do
        name=$(basename "$style" .style)
        ok "tamgen --style $name finds the installed style" \
            tamgen --size 64 --tones 2 --levels 1 --style "$name" -o "$name.exr"
    done
fi
chmod -R u+w "$here"

if command -v git >/dev/null && git -C "$TOP" rev-parse HEAD >/dev/null 2>&1; then
    for copy in one two; do
        ok "make dist" make -s -C "$TOP" dist B="$WORK/$copy"
        sleep 1.1
    done
    ok "make dist makes the same bytes again" sh -c 'cmp one/*.tar.gz two/*.tar.gz'
    tar xzf one/*.tar.gz
    ok "the source tar can be built" sh -c 'cd hatch-*/ && make -n >/dev/null 2>&1'
else
    skip "make dist" "not a git checkout"
fi
finish
