# glTF files written by the commands pass Khronos' validator, which `make check-interop` fetches.
. "${TOP:-.}/tests/tap.sh"
INTEROP=$BUILD/interop
export INTEROP
if [ ! -d "$INTEROP/node_modules/gltf-validator" ]; then
    skip "files pass the glTF validator" "make check-interop fetches it"
    finish
fi
for shape in teapot sphere cylinder cone torus plane ellipsoid saddle wave; do
    for options in '' '--faces 2' '--faces 200000' '--jitter 1 --noise 0.3 --uv even --seed 7'; do
        case $shape$options in
        teapot* | torus*) ;;
        *200000) continue ;; # a mesh whose indices have 32 bits is written alike for each shape
        esac
        # shellcheck disable=SC2086
        meshgen $shape $options -o shape.glb
        is "meshgen $shape $options passes the glTF validator" \
            "$(node "$TOP/tests/interop/gltf_validator.mjs" shape.glb 2>&1)" "0 errors, 0 warnings"
    done
done
validated() {
    is "$1 passes the glTF validator" "$(node "$TOP/tests/interop/gltf_validator.mjs" "$1" 2>&1)" "0 errors, 0 warnings"
}
# kept WHAT FROM TO [fewer]
kept() {
    is "$1 keeps nodes, cameras, lights, skins, animations and attributes" \
        "$(node "$TOP/tests/interop/gltf_kept.mjs" "$2" "$3" ${4:-} 2>&1)" kept
}
if [ -x "$BUILD/tests/interop/samples" ]; then
    "$BUILD/tests/interop/samples" .
    validated scene.glb
    dirfield -q scene.glb -o field.glb
    validated field.glb
    kept dirfield scene.glb field.glb
    lapped-param -q field.glb -o lapped.glb
    validated lapped.glb
    kept lapped-param scene.glb lapped.glb
    strokegen -q --levels 3 scene.glb -o strokes.glb
    validated strokes.glb
    kept strokegen scene.glb strokes.glb
    render-gl -q scene.glb --needs -o scene.needs
    strokegen -q --needs scene.needs scene.glb -o needed.glb
    validated needed.glb
    lapped-param -q --needs scene.needs scene.glb -o needed.lapped.glb
    validated needed.lapped.glb
    meshfit -q --size 320x180 --error 3 scene.glb -o fit.glb
    validated fit.glb
    kept meshfit scene.glb fit.glb fewer
    meshfit -q --size 320x180 --levels 3 scene.glb -o levels.glb
    validated levels.glb
else
    skip "a scene with every kind of object" "make check builds it"
fi
for shape in teapot plane ellipsoid; do
    meshgen $shape --faces 1500 | dirfield -q -o $shape.field.glb
    validated $shape.field.glb
    lapped-param -q $shape.field.glb -o $shape.lapped.glb
    validated $shape.lapped.glb
    lapped-param -q --atlas $shape.field.glb -o $shape.atlas.glb
    validated $shape.atlas.glb
    strokegen -q --levels 3 $shape.field.glb -o $shape.strokes.glb
    validated $shape.strokes.glb
done
finish
