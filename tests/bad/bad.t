# Malformed, hostile and unusual inputs get what their manifest says, from every command that reads
# such a file, within 5 seconds of a processor and 512 MB.
. "${TOP:-.}/tests/tap.sh"
bad=$TOP/../shared/bad
[ -e "$bad/MANIFEST.tsv" ] || { skip "bad inputs" "no folder shared/bad beside the source"; finish; }

meshgen plane --faces 2 -o plane.glb

# expect, folder, file, command ... for each pair of a file and a command that reads it
tail -n +2 "$bad/MANIFEST.tsv" | cut -f1,3 | while read -r file expect; do
    case $file in
    *.png | *.jpg | *.exr)
        echo "$expect $bad $file hatchstat diff IN IN -o OUT.tsv"
        echo "$expect $bad $file tamgen --size 64 --tones 1 --brush IN -o OUT.exr"
        # none of them is a tonal art map
        for command in tampack tamvol tamthresh; do
            echo "ERR $bad $file $command IN -o OUT.ktx2"
        done
        echo "ERR $bad $file hatchstat tam IN -o OUT.tsv"
        echo "ERR $bad $file render-gl plane.glb --tam IN --size 64x64 -o OUT.png"
        # nor a mesh
        echo "ERR $bad $file dirfield IN -o OUT.glb"
        echo "ERR $bad $file lapped-param IN -o OUT.glb"
        ;;
    *)
        echo "$expect $bad $file hatchstat mesh IN -o OUT.tsv"
        echo "$expect $bad $file render-gl IN --technique gouraud --size 64x64 -o OUT.png"
        echo "$expect $bad $file dirfield IN -o OUT.glb"
        echo "$expect $bad $file lapped-param IN -o OUT.glb"
        ;;
    esac
done >all.list
while read -r line; do
    set -- $line
    [ -x "$BIN/$4" ] || continue
    [ "$4" != hatchstat ] || hatchstat --help | grep -qw "$5" || continue
    echo "$line"
done <all.list >runs.list
if [ -s runs.list ]; then
    xargs -P 2 -L 1 sh "$TOP/tests/bad/one.sh" <runs.list >results
    awk '/^(not )?ok - / {sub(/ok -/, "ok " ++count " -")} {print} END {print "1.." count}' results
    exit
fi
skip "bad inputs" "no command that reads them"
finish
