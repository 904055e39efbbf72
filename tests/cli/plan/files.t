# hatchplan: the files beside a scene's file count as the scene's.
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
finish
