# The shell lines of README.md run one by one, in their order, in an empty folder, as they stand, with smaller sizes.
# A user brings some files: here they are meshes of meshgen under those names; a line with --window writes a picture instead.
. "${TOP:-.}/tests/tap.sh"
[ -z "$SANITIZE" ] || { skip "README.md" "only run without sanitizers"; finish; }

# shell_lines: prints the lines of a Markdown file's indented blocks, with continued lines joined
shell_lines() {
    sed -n 's/^    //p' "$1" | sed ':more; /\\$/{N; s/\\\n *//; b more}'
}
shell_lines "$TOP/README.md" >all
line=$(grep '^export PATH=' all)
is "one line exports PATH and SHARE" "$line" 'export PATH="$PWD/build/bin:$PATH" SHARE="$PWD/build/share/hatch"'
sed '1,/^export PATH=/d' all >lines
is "only bootstrap stands before it" "$(sed '/^export PATH=/,$d; s/ .*//' all | sort -u)" ./bootstrap
eval "$(echo "$line" | sed "s|\$PWD/build|$BUILD|g")"
ok "SHARE has styles and pipelines" test -d "$SHARE/styles" -a -d "$SHARE/pipelines"

mkdir empty
. "$TOP/tests/small.sh"
cd empty || exit 1
while IFS= read -r line; do
    for brought in bunny.ply rocker-arm.obj; do
        case $line in *$brought*) [ -e $brought ] || meshgen teapot | cat >$brought ;; esac
    done
    bash -eo pipefail -c "$(echo "$line" | sed 's/ --window/ -o window.png/')" </dev/null >../.out 2>../.err
    status=$?
    case $line in *' --fit '*) : >../.err ;; esac # it prints what it has found
    is "$line" "$status $(grep -v ': warning: ' ../.err)" "0 "
done <../lines
is "the pictures of every line with -o are there" \
    "$(grep -o -- '-o [A-Za-z0-9_.-]*\.png' ../lines | sed 's/-o //' | grep -v % | while read -r name; do
        [ -s "$name" ] || echo "$name"; done)" ""
finish
