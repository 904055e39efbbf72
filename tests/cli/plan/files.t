# hatchplan: the files beside a scene's file count as the scene's; a plan is made anew when a file that it was made from
# has changed.
. "${TOP:-.}/tests/tap.sh"
small="--size 32x24"
printf '%s\n' 'v 0 0 0' 'v 1 0 0' 'v 0 1 0' 'v 0 0 1' 'f 1 3 2' 'f 1 2 4' 'f 1 4 3' 'f 2 3 4' >bare.obj
dirfield -q bare.obj -o bare.glb
unpack bare.glb bare

# bytes FILE: those of the patches, less those of the scene that has no texture coordinates
bytes() {
    hatchplan $small --techniques rptam --all "$1" | awk -F'\t' 'NR == 2 {print $4}'
}
is "a glTF with a buffer of its own is as large as both files" \
    "$(($(bytes bare.gltf) + $(cat bare.gltf bare.bin | wc -c)))" "$(($(bytes bare.glb) + $(wc -c <bare.glb)))"

meshgen plane --faces 2 -o plane.glb
unpack plane.glb "my plane"
meshgen plane --faces 2 | render-gl - --technique gouraud --size 16x16 -o my.png
cp my.png light.png
printf 'brush image my.png\nwidth 3\n' >my.style
options="--techniques rptam --style ./my.style --draw '--modulate light.png'"
try hatchplan $small --techniques rptam --style ./my.style --draw '--modulate light.png' "my plane.gltf" --tolerance 1 --make
is "a plan lists what it was made from" "$(grep ^INPUTS .out)" \
    "INPUTS := 'my plane.gltf' 'my plane.bin' light.png ./my.style ./my.png"
is "with their times and sizes" "$(grep ^STAMPS .out)" \
    "STAMPS := $(stat -c %.9Y:%s "my plane.gltf" "my plane.bin" light.png my.style my.png | xargs)"
is "an installed style and standard input are no files of a plan" \
    "$(hatchplan $small --techniques rptam --tolerance 1 --make <plane.glb | grep 'INPUTS\|STAMPS')" "INPUTS :=
STAMPS :="
if command -v make >/dev/null; then
    # planned: draws, and prints whether a plan was made
    planned() {
        make -f "$TOP/pipelines/plan.mk" SIZE=32x24 MESH="my plane.gltf" OUT=out TOLERANCE=1 OPTIONS="$options" >made 2>&1 &&
            grep -c '^hatchplan' made
    }
    is "plan.mk: a first plan" "$(planned)" 1
    is "plan.mk: the plan is kept" "$(planned)" 0
    for file in "my plane.bin" light.png my.png; do
        touch -d '2 days ago' "$file"
        is "plan.mk: another $file, an older one" "$(planned)" 1
    done
    mv "my plane.bin" away.bin
    make -s -f "$TOP/pipelines/plan.mk" SIZE=32x24 MESH="my plane.gltf" OUT=out TOLERANCE=1 OPTIONS="$options" 2>words
    is "plan.mk: a file is missing" "$(grep -c '^hatchplan: my plane.gltf: my plane.bin: cannot open' words)" 1
    cp plane.glb ./-t.glb
    make -s -f "$TOP/pipelines/plan.mk" SIZE=32x24 MESH=-t.glb OUT=dash TOLERANCE=1 OPTIONS="--techniques rptam" >made 2>&1
    is "plan.mk: a name that begins with a dash" "$? $(ls ./dash/*.png)" "0 ./dash/-t.png"
else
    skip "plan.mk" "no make"
fi
finish
