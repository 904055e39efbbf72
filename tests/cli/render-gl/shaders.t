# Compiles all variants of all shader programs: each technique with textures as tone, with holes, with one ink and with
# two, with shadows, haloes and light at pixels, on patches. The reference compiler must accept what the driver accepts,
# since drivers differ in strictness.
. "${TOP:-.}/tests/tap.sh"

# drawn OPTION ...: runs render-gl and keeps the source of every shader stage
SHADERS=$WORK/shaders
spy=
if command -v glslangValidator >/dev/null && [ -z "$SANITIZE" ]; then
    spy=$WORK/spy.so
    ${CC:-cc} -shared -fPIC -o "$spy" "$TOP/tests/cli/render-gl/shader_spy.c" -lepoxy
fi
mkdir "$SHADERS"
drawn() {
    SHADERS=$SHADERS LD_PRELOAD=$spy render-gl "$@"
}

tamgen --size 64 --tones 6 --levels 2 --contact-sheet texture.png -o map.exr

# scene MODE [U0 U1 WRAP]: prints a glTF of a square with texture.png as its base colour from u = U0 to U1; MODE is
# OPAQUE or MASK, WRAP the wrapS of the sampler
scene() {
    perl -e '
        use MIME::Base64;
        local $/;
        open my $png, "<:raw", "texture.png" or die; my $image = encode_base64(<$png>, "");
        my ($mode, $u, $v, $wrap) = @ARGV;
        my $bytes = pack("f<12f<12f<8S<6", -1,-1,0, 1,-1,0, 1,1,0, -1,1,0, (0,0,1) x 4,
            $u,1, $v,1, $v,0, $u,0, 0,1,2, 0,2,3);
        my $data = encode_base64($bytes, "");
        print qq({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
            "meshes":[{"primitives":[{"material":0,"indices":3,"attributes":
                {"POSITION":0,"NORMAL":1,"TEXCOORD_0":2}}]}],
            "materials":[{"alphaMode":"$mode","pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],
            "textures":[{"source":0,"sampler":0}],"samplers":[{"wrapS":$wrap}],"images":[{"uri":"data:image/png;base64,$image"}],
            "buffers":[{"byteLength":140,"uri":"data:application/octet-stream;base64,$data"}],
            "bufferViews":[{"buffer":0,"byteLength":128},
                {"buffer":0,"byteOffset":128,"byteLength":12}],
            "accessors":[
                {"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[-1,-1,0],"max":[1,1,0]},
                {"bufferView":0,"byteOffset":48,"componentType":5126,"count":4,"type":"VEC3"},
                {"bufferView":0,"byteOffset":96,"componentType":5126,"count":4,"type":"VEC2"},
                {"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"}]});' "$1" "${2:-0}" "${3:-1}" "${4:-10497}"
}
for mode in OPAQUE MASK; do
    scene $mode >$mode.gltf
    strokegen -q --levels 3 $mode.gltf -o $mode.strokes.glb # for --technique traced
done

techniques=$(render-gl --options-table | awk -F'\t' '$2 == "technique" {gsub(",", " ", $7); print $7}')
tamvol -q map.exr -o volume.ktx2
tamthresh -q map.exr -o steps.ktx2
# The asset of a technique is the first of these that it accepts.
for technique in $techniques; do
    for asset in "--tam map.exr" "--tam volume.ktx2" "--tam steps.ktx2" ""; do
        # shellcheck disable=SC2086 # the options are words
        try render-gl OPAQUE.strokes.glb --technique "$technique" --size 32x24 $asset -o picture.png
        [ $status -ne 0 ] || break
    done
    is "$technique draws with a map, a volume, thresholds or nothing" "$status" 0
    echo "$asset" >"$technique.asset"
done
# Every two of these choices together; with LONG=1 all of them.
combined() {
    cat <<'END'
OPAQUE
OPAQUE --texture-tone --paper grey --ink black,white
MASK --texture-tone
MASK --paper grey --ink black,white
END
    [ -z "${LONG:-}" ] || cat <<'END'
OPAQUE --texture-tone
OPAQUE --paper grey --ink black,white
MASK
MASK --texture-tone --paper grey --ink black,white
END
}
for technique in $techniques; do
    combined | while read -r mode options; do
        # shellcheck disable=SC2046,SC2086 # the options are words
        drawn $mode.strokes.glb --technique "$technique" $(cat "$technique.asset") --size 32x24 $options \
            -o picture.png 2>&1 || echo "fails: $mode $options"
    done >said
    is "$technique with a texture as colour or tone, holes, one ink or two" "$(cat said)" ""
done

for uv in "1 2 33648" "1 0 33071"; do
    # shellcheck disable=SC2086 # the numbers are words
    scene OPAQUE $uv >wrapped.gltf
    render-gl wrapped.gltf --technique gouraud --size 64x48 --from 0:0 --texture-tone -o "${uv##* }.exr"
done
ok "a texture is mirrored where its sampler says so" \
    hatchstat diff 33648.exr 33071.exr --max-difference 1e-3
render-gl OPAQUE.gltf --technique gouraud --size 20000x16 --samples 1 -o texture.png
scene OPAQUE >large.gltf
ok "a texture wider than the driver's limit" render-gl large.gltf --technique gouraud --size 32x24 \
    --texture-tone -o picture.png

ok "a probe of the driver's anisotropic reads" render-gl MASK.gltf --tam map.exr --size 32x24 \
    --anisotropy 4 --probe -o probe.tsv

render-gl OPAQUE.gltf --technique gouraud --size 32x24 --from 0:0 -o plain.png
render-gl OPAQUE.gltf --technique gouraud --size 32x24 --from 0:0 --texture-tone -o toned.png
try hatchstat diff plain.png toned.png --max-difference 0.01
is "--texture-tone changes the tone" $status 1

# A pixel that covers thousands of tiles shows their mean and takes no longer than others.
meshgen plane --faces 2 -o plane.glb
ok "tiles far smaller than pixels are drawn within 20 s" sh -c 'ulimit -t 20 && exec "$@"' sh render-gl plane.glb --tam map.exr \
    --uv-scale 65536 --size 320x180 --lines none --from 0:0 -o far.exr
render-gl plane.glb --technique gouraud --tone-range 0:0.9 --size 320x180 --from 0:0 -o tone.exr
ok "tiles far smaller than pixels have the right tone" hatchstat diff far.exr tone.exr --max-difference 0.02

# Other options, on patches and on ordinary meshes.
tamgen --size 64 --tones 8 --levels 2 -o eight.exr
tamvol -q eight.exr -o volume.ktx2
tamvol -q --compress eight.exr -o blocks.ktx2
tamthresh --exact eight.exr -o exact.ktx2
meshgen torus --faces 800 -o torus.glb
dirfield torus.glb | lapped-param -o patches.glb
strokegen -q --levels 3 torus.glb -o strokes.glb
for scene in torus.glb patches.glb; do
    for technique in $techniques; do
        asset=$(cat "$technique.asset") file=$scene
        [ $technique != traced ] || file=strokes.glb
        # shellcheck disable=SC2086 # the options are words
        ok "$technique with shadows and haloes, $scene" drawn $file -t "$technique" $asset --size 32x24 \
            --shadows 0.05 --haloes 3 --ground 2 -o picture.png
        # shellcheck disable=SC2086
        try drawn $file -t "$technique" $asset --size 32x24 --pixel-light -o picture.png
        is "$technique with --pixel-light is drawn or refused, $scene" \
            "$status $(grep -c "pixel-light.* not with $technique\$" .err)" "$((status ? 2 : 0)) $((status != 0))"
    done
    while read -r technique options; do
        # shellcheck disable=SC2086 # the options are words
        ok "$technique $options, $scene" drawn $scene --technique "$technique" --size 32x24 $options -o picture.png
    done <<'END'
tam --tam map.exr --pixel-light --shadows 0.05
volume --tam blocks.ktx2 --modulate texture.png
threshold --tam exact.ktx2
rptam --seed-loop brute
rptam --seed-layers 3 --overlap 1
strokes --aggregate blend
END
done
ok "--show patches" drawn patches.glb --size 32x24 --show patches -o picture.png
ok "--show field" drawn patches.glb --size 32x24 --show field -o picture.png

if [ "$spy" ]; then
    kept=$(find "$SHADERS" -type f | wc -l)
    [ "$kept" -gt 150 ]
    is "all shader stages are kept ($kept)" $? 0
    ok "the reference compiler accepts all stages" glslangValidator "$SHADERS"/*
else
    skip "the reference compiler" "no glslangValidator, or sanitizers"
fi

finish
