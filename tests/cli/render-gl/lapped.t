# From any mesh to a picture in one pipe, and with pipelines/lapped.mk.
. "${TOP:-.}/tests/tap.sh"

tamgen --size 64 --levels 2 -o ink.tam.exr
meshgen torus --faces 800 | dirfield -q | lapped-param -q -o torus.lapped.glb
printf 'v 0 0 0\nv 4 0 0\nv 4 1 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 3 4\nf 1 5 2\n' >'an edge.obj'

# row FILE THING: prints a figure of --probe
row() {
    render-gl "$1" --tam ink.tam.exr --size 96x72 --probe | awk -F'\t' -v thing="$2" '$1 == thing {print $3}'
}
is "the patches are one item" "$(row torus.lapped.glb items)" 1
is "the surface's faces are counted once" "$(row torus.lapped.glb faces)" \
    "$(meshgen torus --faces 800 | hatchstat mesh - | awk 'NR == 2 {print $2}')"
is "patches overlap" "$(echo "$(row torus.lapped.glb patch-faces) $(row torus.lapped.glb faces)" |
    awk '{print ($1 > $2)}')" 1
for technique in tam tam-flat tam-face tam-gouraud tam-triple tam-threshold gouraud rptam; do
    case $technique in
    tam*) map=ink.tam.exr ;;
    *) map= ;;
    esac
    ok "$technique draws patches" render-gl torus.lapped.glb ${map:+--tam $map} -t "$technique" --size 64x48 -o t.png
done
for what in patches field; do
    ok "--show $what" render-gl torus.lapped.glb --show "$what" --size 64x48 -o "$what.png"
done
meshgen torus --faces 800 -o bare.glb
render-gl torus.lapped.glb bare.glb --show patches --size 96x48 --samples 1 -o both.png
render-gl torus.lapped.glb --show patches --size 96x48 --samples 1 -o patches.png
is "--show patches: a mesh without patches is light" "$(hatchstat frames both.png patches.png | awk '
    NR > 1 {mean[NR] = $2} END {print (mean[2] > .88 && mean[2] > mean[3])}')" 1
ok "in one pipe, from a name with a space" make -s -f "$TOP/pipelines/lapped.mk" \
    MESH="an edge.obj" SIZE=64x48 OPTIONS='--samples 1'
is "lapped.mk writes the picture" "$(ls "an edge.png")" "an edge.png"
meshgen sphere --faces 200 -o ball.glb
meshgen plane --faces 50 -o plane.glb
ok "lapped.mk draws several meshes in a row" make -s -f "$TOP/pipelines/lapped.mk" MESHES='ball.glb plane.glb' SIZE=96x48
ok "lapped.mk draws a turntable" make -s -f "$TOP/pipelines/lapped.mk" MESH=ball.glb SIZE=48x48 TURN=2 SHOW=1
ok "lapped.mk draws one with patches that it needs" make -s -f "$TOP/pipelines/lapped.mk" MESH=ball.glb SIZE=48x48 \
    TURN=2 NEEDS=.02 OUT=needed
ok "which are fewer" test "$(wc -c <needed/ball.lapped.glb)" -lt "$(wc -c <ball.lapped.glb)"
is "lapped.mk writes all pictures of a turntable" "$(echo ball-*.png)" "ball-000.png ball-001.png ball-field.png ball-patches.png"
printf 'width 3\n' >my.style
ok "gltf.mk draws with the user's style into another folder" make -s -f "$TOP/pipelines/gltf.mk" SCENE=ball.glb STYLE=./my.style OUT=away SIZE=48x48
is "gltf.mk writes its map and picture" "$(echo away/*)" "away/ball.png away/my.style.tam.exr"
# Two styles of one name, in two folders, both older than the first map.
mkdir one other
printf 'width 3\n' >one/my.style
printf 'width 6\n' >other/my.style
touch -d '1 hour ago' one/my.style other/my.style
for folder in one other; do
    make -s -f "$TOP/pipelines/gltf.mk" SCENE=ball.glb STYLE=$folder/my.style OUT=both SIZE=48x48
    mv both/ball.png $folder.png
done
is "gltf.mk has a map for each style, whatever their names" "$(cmp -s one.png other.png && echo the same)" ""
cp ball.glb 'a $HOME 100%.glb'
ok "a file name may have any characters" make -s -f "$TOP/pipelines/gltf.mk" SCENE='a $$HOME 100%.glb' TURN=2 \
    SIZE=48x48 OUT=odd
is "pictures are named after it" "$(ls odd | grep -c '^a $HOME 100%-00[01].png$')" 2
try make -s -f "$TOP/pipelines/lapped.mk" MESHES='ball.glb plane.glb' TURN=2
is "lapped.mk turns one mesh alone" "$((status > 0)) $(grep -c 'TURN, FRAMES and SHOW are for one MESH' .err)" "1 1"
ok "engrave.mk has widths for pictures and for drawings" make -s -f "$TOP/pipelines/engrave.mk" MESH=ball.glb WIDTH=2 \
    PAGE=a6 SIZE=48x48 OUT=engraved
is "engrave.mk writes both" "$(ls engraved | tr '\n' ' ')" "ball.png ball.strokes.glb ball.svg "
try make -s -f "$TOP/pipelines/lapped.mk" MESH=ball.glb OUT='a way'
is "lapped.mk refuses a folder with a space in its name" "$status $(ls -d a way 2>/dev/null)" "2 "
meshgen torus --faces 2000 -o smooth.glb
perl "$TOP/tests/cli/render-gl/bumpy.pl" <smooth.glb >bumpy.glb
dirfield -q bumpy.glb | lapped-param -q -o bumpy.lapped.glb
lapped-param -q --atlas bumpy.glb -o bumpy.atlas.glb
for file in smooth bumpy bumpy.lapped bumpy.atlas; do
    render-gl $file.glb -t gouraud --pixel-light --size 200x150 -o $file.png
done
away=$(hatchstat diff smooth.png bumpy.png | awk 'NR == 2 {print ($2 > 0.05)}')
near=$(hatchstat diff bumpy.png bumpy.lapped.png | awk 'NR == 2 {print ($2 < 0.005)}')
is "a normal map changes the picture and survives lapped-param" "$away $near" "1 1"
near=$(hatchstat diff bumpy.png bumpy.atlas.png | awk 'NR == 2 {print ($2 < 0.005)}')
is "and an atlas" "$near" 1
# Numbers of texture coordinates have no gap.
for file in bumpy.lapped bumpy.atlas; do
    unpack $file.glb $file
    grep -o '"TEXCOORD_[0-9]' $file.gltf | sort -u | tr -d '\n'
    echo
done >sets
is "the map's texture coordinates are the next set" "$(cat sets)" '"TEXCOORD_0"TEXCOORD_1"TEXCOORD_2
"TEXCOORD_0"TEXCOORD_1'
finish
