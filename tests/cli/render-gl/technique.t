# The technique that HACKING.md walks through, in a copy of the tree: built from its file, its shaders and its one line
# in the list, and nothing else.
. "${TOP:-.}/tests/tap.sh"
# With their times, so that only objects that depend on the list are made again.
cp -Rp "$TOP/cmd" "$TOP/libhatch" "$TOP/Makefile" "$TOP/man" "$TOP/styles" "$TOP/pipelines" "$TOP/tests" .
folder=${BUILD#"$TOP/"}
mkdir -p "$folder"
cp -Rp "$BUILD/obj" "$BUILD/lib" "$BUILD/gen" "$BUILD/flags" "$folder" 2>/dev/null

# A file of the chapter is named before its block.
awk '/^## / {chapter = $0 == "## A technique"}
    chapter && /^`cmd\// {split($1, part, "`"); file = part[2]}
    chapter && /^```/ {inside = !inside && file != ""; if (!inside) file = ""; next}
    inside {folder = file; sub(/\/[^\/]*$/, "", folder); if (!(folder in made)) {made[folder] = system("mkdir -p " folder) + 1}
        print > file}' "$TOP/HACKING.md"
line=$(sed -n '/^## A technique$/,/^## /s/^ *X(\([a-z]*\)) \\$/\1/p' "$TOP/HACKING.md")
is "the chapter has a file, two shaders and a line" \
    "$(cd cmd/render-gl && find . -newer "$TOP/HACKING.md" -path "*$line*" | sort | tr '\n' ' ')$line" \
    "./shaders/bleed ./shaders/bleed/copy.frag ./shaders/bleed/spread.comp ./technique/bleed.c bleed"
sed "/X(volume) /i\\    X($line) \\\\" "$TOP/cmd/render-gl/technique/list.h" >cmd/render-gl/technique/list.h
is "one line is added to the list" "$(diff "$TOP/cmd/render-gl/technique/list.h" cmd/render-gl/technique/list.h | grep -c '^[<>]')" 1
ok "it builds" make SANITIZE="$SANITIZE" B="$folder" "$folder/bin/render-gl"
draw="$PWD/$folder/bin/render-gl --size 96x72 --samples 1"
meshgen sphere --faces 2000 -o sphere.glb

ok "it draws" $draw -t bleed --bleed 4 sphere.glb -o bled.png
$draw -t bleed --bleed 0 sphere.glb -o dry.png
$draw -t gouraud sphere.glb -o tone.png
is "what does not bleed is the tone" \
    "$(hatchstat diff dry.png tone.png | awk 'NR == 2 {print $2 <= 1 / 255}')" 1
inked() { # pixels that are not paper
    hatchstat ink "$1" | awk 'NR == 1 {for (i = 1; i <= NF; i++) column[$i] = i} NR == 2 {print $column["inked"]}'
}
echo "$(inked dry.png) $(inked bled.png)" >both
ok "the tone runs over its edges by 4 pixels" awk '{exit !($2 - $1 > 0.03 && $2 - $1 < 0.2)}' both
ok "its option goes through an animation" \
    $draw -t bleed --animate bleed=0..4 --frames 2 sphere.glb -o frame%d.png
is "from its first value" "$(hatchstat diff frame0.png dry.png | awk 'NR == 2 {print $2}')" 0
is "to its last" "$(hatchstat diff frame1.png bled.png | awk 'NR == 2 {print $2}')" 0
$draw -t gouraud --bleed 4 sphere.glb -o /dev/null 2>said
is "another technique refuses it" "$?" 2
ok "--help lists it" sh -c "$draw --help | grep -q -- --bleed"
ok "times name its passes" sh -c "$draw -t bleed --time 2 sphere.glb >times; grep -q spread times && grep -q copy times"
finish
