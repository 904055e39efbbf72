# Meshes that are unusual or get repaired are drawn like the ordinary mesh with the same surface.
. "${TOP:-.}/tests/tap.sh"
ok "inputs are generated" perl "$TOP/tests/bad/make.pl" own

# drawn FILE IMAGE
drawn() {
    render-gl "own/$1" --technique gouraud --size 64x64 -o "$2" 2>.err || fail "$1 is drawn" "$(cat .err)"
}
# same REFERENCE FILE ...: each file gives the same image as the reference
same() {
    as=$1
    shift
    drawn "$as" as.png
    for file in "$@"; do
        drawn "$file" picture.png
        ok "$file is drawn as $as" hatchstat diff as.png picture.png --max-difference 0.01
    done
}
same shape/sphere.obj shape/scale-1e30.obj shape/scale-1e-30.obj shape/isolated-vertices.obj shape/duplicate-faces.obj \
    shape/opposite-faces.obj shape/inconsistent.obj shape/inside-out.obj shape/unwelded.obj shape/zero-area.obj
same gltf/mirrored.glb gltf/mirror.glb
same gltf/sound.glb gltf/node-chain-100k.glb gltf/node-flat-100k.glb glb/unknown-chunk.glb ply/big-endian-double.ply \
    stl/header-says-solid.stl
same obj/negative-indices.obj obj/crlf-tabs-continued.obj obj/mtllib-climbs.obj
drawn shape/needles.obj picture.png
hatchstat diff as.png picture.png --max-difference 0.01 >.out 2>&1
is "a different mesh gives a different image" $? 1
finish
