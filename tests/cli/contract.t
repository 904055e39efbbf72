# The rules that all commands follow (hatch(7)): runs contract.sh for each command and for each line of commands.tsv,
# two at a time.
. "${TOP:-.}/tests/tap.sh"

# Makes small inputs with the commands.
FIXTURES=$WORK/fixtures
export FIXTURES
mkdir "$FIXTURES"
fixture() {
    case $1 in
    mesh.glb) meshgen torus --faces 60 ;;
    field.glb) meshgen torus --faces 60 --field ;;
    torus.glb) meshgen torus --faces 600 ;;
    lapped.glb) meshgen torus --faces 60 | lapped-param ;;
    map.exr) tamgen --size 64 --tones 3 --levels 2 ;;
    four.seeds) seedgen -n 512 --layers 4 --candidates 1 ;;
    drawing.svg)
        echo '<svg viewBox="0 0 9 9"><g fill="none" stroke="red"><path d="m1,4q3-5,6,1m-6,2h8"/>'
        echo '<circle cx="5" cy="4" r="3" stroke="#214"/></g></svg>'
        ;;
    solid.ktx2) solidgen --size 64 ;;
    small.png) solidgen --size 16 --slices - -o /dev/null ;;
    picture.png) tamgen --size 64 --tones 2 --levels 1 --contact-sheet - -o /dev/null ;;
    esac >"$FIXTURES/$1"
    [ -s "$FIXTURES/$1" ] || fail "fixture $1 is made"
}
for name in $(grep -v '^#' "$TOP/tests/cli/commands.tsv" | cut -f2 | sort -u | grep -v '^-$'); do
    fixture "$name"
done

for command in $(ls "$BIN"); do
    echo "command $command"
done >jobs
grep -v '^#' "$TOP/tests/cli/commands.tsv" | awk -F'\t' '{print $1, NR}' |
    while read -r command line; do
        [ ! -x "$BIN/$command" ] || echo "line $line"
    done >>jobs
mkdir results
awk '{print $1, $2, "results/" NR}' jobs >numbered
xargs -P 2 -L 1 sh -c 'sh "$TOP/tests/cli/contract.sh" "$0" "$1" >"$2" 2>&1' <numbered
# Merges the TAP of all parts: checks each part's plan and prints one plan.
cat $(awk '{print $3}' numbered) | awk -v jobs="$(wc -l <jobs)" '
    /^1\.\./ {jobs--; if (substr($0, 4) + 0 != part) print "not ok " ++all " - a part broke off"; part = 0; next}
    /^(not )?ok / {part++; sub(/ok [0-9]+/, "ok " (++all))}
    {print}
    END {if (part || jobs) print "not ok " ++all " - a part broke off"; print "1.." all}'
