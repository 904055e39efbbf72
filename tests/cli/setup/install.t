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
is "bash completes a shape" "$(bash ask.bash "$here" meshgen s)" "sphere saddle superquadric "
is "bash completes a subject before files" "$(bash ask.bash "$here" hatchstat --json f)" "field frames "
touch model.glb
is "bash completes a file after a subject" "$(bash ask.bash "$here" hatchstat mesh mod)" "model.glb "
is "bash completes a style" "$(bash ask.bash "$here" tamgen --style ch)" "chalk charcoal "
is "bash completes a palette" "$(bash ask.bash "$here" tamgen --palette s)" "sea "
is "bash completes a style of solid textures" "$(bash ask.bash "$here" solidgen --style st)" "stipple strokes "
is "bash completes the style of rptam" "$(bash ask.bash "$here" render-gl --style pen)" "pencil "
is "bash completes a colour" "$(bash ask.bash "$here" render-gl --ink b)" "black blue "
is "bash completes a kind of line" "$(bash ask.bash "$here" render-gl --lines cr)" "creases "
if command -v zsh >/dev/null; then
    for asked in "meshgen :SHAPE: saddle" "hatchstat :SUBJECT: frames" "render-gl :COLOUR: sepia"; do
        set -- $asked
        grep -q "$2(.*\b$3\b" "$here/share/zsh/site-functions/_$1"
        is "zsh completes $3" $? 0
    done
    zsh -c 'compadd() { print -r -- $* }; _files() { : }; _arguments() { for a; do
        [[ $a = *:STYLE:* ]] && eval "${a##*:STYLE:}"; done }; . "$0"' "$here/share/zsh/site-functions/_tamgen" >said
    grep -qw -- '-- arcs chalk charcoal' said
    is "zsh completes a style" $? 0
else
    skip "zsh completes names" "no zsh"
fi
if command -v fish >/dev/null; then
    asked() { HOME=$WORK fish -c 'source $argv[1]; complete -C $argv[2]' "$here/share/fish/vendor_completions.d/$1.fish" "$2"; }
    is "fish completes a shape" "$(asked meshgen 'meshgen sad' | cut -f1)" saddle
    is "fish completes a style" "$(asked tamgen 'tamgen --style penc' | cut -f1)" pencil
    is "fish completes a colour" "$(asked render-gl 'render-gl --ink sep' | cut -f1)" sepia
else
    skip "fish completes names" "no fish"
fi
is "bash completes a choice after =" "$(bash ask.bash "$here" meshgen --uv = e)" "even "

ln -s "$here/share/hatch" share
is "an installed pipeline finds its neighbours" "$(make -n -f share/pipelines/gallery.mk OUT=out |
    grep -o 'share/pipelines/[a-z-]*\.[a-z]*' | sort | tr '\n' ' ')" \
    "share/pipelines/fine-tone.mk share/pipelines/hatching.svg share/pipelines/rptam.mk "
ok "an installed pipeline draws" make -s -f share/pipelines/rptam.mk SIZE=64x48 OUT=out
ok "tamgen replays the installed drawing" tamgen --replay share/pipelines/hatching.svg --fit -q --size 64 -o drawing.exr

chmod -R a-w "$here"
if [ -x "$here/bin/tamgen" ]; then
    for style in "$TOP"/styles/*.style; do
        name=$(basename "$style" .style)
        ok "tamgen --style $name finds the installed style" \
            tamgen --size 64 --tones 2 --levels 1 --style "$name" -o "$name.exr"
    done
    for style in "$TOP"/styles/*.solid; do
        name=$(basename "$style" .solid)
        ok "solidgen --style $name finds the installed style" solidgen --size 8 --style "$name" -o "$name.ktx2"
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
