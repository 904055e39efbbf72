# Commands treat malformed, hostile and unusual inputs as the manifest expects, within 5 seconds of processor time
# and 512 MB. make.pl generates the inputs; a folder shared/bad beside the source, if there is one, adds others.
. "${TOP:-.}/tests/tap.sh"
bad=$TOP/../shared/bad

# runs FOLDER: prints the arguments of one.sh, a line for each pair of an input in FOLDER/MANIFEST.tsv and a command.
# Inputs of tier core get all commands, including some that expect another kind of file, other inputs get one.
runs() {
    awk -F '\t' -v folder="$1" '
    function add(command, wants, words, numbers) {
        list[count++] = wants " " words " " numbers " " folder " " file " " command
    }
    function picture_commands(core) {
        add("hatchstat diff IN IN -o OUT.tsv", expect, says, "-")
        add("tamgen --size 64 --tones 1 --brush IN -o OUT.exr", expect, says, "-")
        if (!core && file !~ /\.exr$/) return
        # No input is a tonal art map,
        add("tampack IN -o OUT.ktx2", "ERR", "-", "-")
        add("tamvol IN -o OUT.ktx2", "ERR", "-", "-")
        add("tamthresh IN -o OUT.ktx2", "ERR", "-", "-")
        add("hatchstat tam IN -o OUT.tsv", "ERR", "-", "-")
        add("render-gl plane.glb --tam IN --size 64x64 -o OUT.png", "ERR", "-", "-")
        if (!core) return
        # and no image is a mesh.
        add("dirfield IN -o OUT.glb", "ERR", "-", "-")
        add("lapped-param IN -o OUT.glb", "ERR", "-", "-")
    }
    function mesh_commands() {
        # Commands differ in the wording of warnings.
        own = expect == "ERR" || expect == "EITHER" ? says : "-"
        add("hatchstat mesh IN -o OUT.tsv", expect, says, figures)
        add("render-gl IN --technique gouraud --size 64x64 -o OUT.png", expect, own, "-")
        add("dirfield IN -o OUT.glb", expect, own, "-")
        add("lapped-param IN -o OUT.glb", expect, own, "-")
        if (file !~ /\.json$/) return
        add("tamgen --size 64 --style IN -o OUT.exr", "ERR", "-", "-")
        add("tamgen --size 64 --palette IN -o OUT.exr", "ERR", "-", "-")
        add("solidgen --size 8 --style IN -o OUT.ktx2", "ERR", "-", "-")
    }
    NR == 1 {for (i = 1; i <= NF; i++) at[$i] = i; next}
    {
        file = $at["path"]
        expect = $at["expect"]
        says = "says" in at ? $at["says"] : "-"
        figures = "figures" in at ? $at["figures"] : "-"
        core = $at["tier"] == "core"
        count = 0
        if (file ~ /\.(png|exr|jpg|tif|bmp|gif|tga|hdr|ppm)$/) picture_commands(core)
        else mesh_commands()
        for (i = 0; i < count; i++) if (core || i == NR % count) print list[i]
    }' "$1/MANIFEST.tsv"
}

{
    perl "$TOP/tests/bad/make.pl" own && meshgen plane --faces 2 -o plane.glb && runs own
} >runs.list 2>made || {
    fail "inputs are generated" "$(cat made)"
    finish
}
[ ! -e "$bad/MANIFEST.tsv" ] || runs "$bad" >>runs.list
xargs -P 2 -L 1 sh "$TOP/tests/bad/one.sh" <runs.list >results
awk -v runs="$(wc -l <runs.list)" '
    /^(not )?ok - / {sub(/ok -/, "ok " ++count " -"); failed += /^not/}
    {print}
    END {
        print (count == runs ? "" : "not ") "ok " count + 1 " - each of " runs " runs reported a result"
        print "1.." count + 1
        exit failed > 0 || count != runs
    }' results
