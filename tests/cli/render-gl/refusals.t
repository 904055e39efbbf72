# What render-gl refuses, each in one line that says what to do; and its reports as TSV and JSON.
. "${TOP:-.}/tests/tap.sh"

tamgen --size 64 --levels 2 -o map.exr
meshgen torus --faces 200 -o torus.glb
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >plain.obj

# refuses NAME STATUS LINES WORDS COMMAND ...
refuses() {
    name=$1 want=$2 lines=$3 words=$4
    shift 4
    try "$@"
    is "$name" "$status $(wc -l <.err) $(grep -cF -e "$words" .err)" "$want $lines 1"
    [ ! -e picture.png ] || fail "$name: no picture is left"
}
draw="render-gl --size 32x24 -o picture.png"

refuses "no map" 2 2 "--tam FILE" $draw torus.glb
refuses "a mesh that strokes cannot follow" 3 1 lapped-param $draw plain.obj --tam map.exr
ok "its tone can be drawn" render-gl --size 32x24 -t gouraud plain.obj -o tone.png
refuses "patches where there are none" 3 1 lapped-param $draw torus.glb --show patches
refuses "directions where there are none" 3 1 dirfield $draw torus.glb --show field
refuses "two things to show" 2 2 "--show" $draw torus.glb --show field --technique tam --tam map.exr
refuses "a camera that is not there" 3 1 "camera 2" $draw torus.glb --tam map.exr --camera 2
refuses "an animation that is not there" 3 1 "animation 1" $draw torus.glb --tam map.exr --animation 1
refuses "an animation where there is none" 3 1 "animation 0" $draw torus.glb --tam map.exr --animation 0
refuses "a camera on what it looks at" 3 1 "X,Y,Z:X,Y,Z" \
    $draw torus.glb --tam map.exr --camera 0,1,2:0,1,2
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 2\n' >dirty.obj
refuses "one cause, one line" 3 1 lapped-param $draw dirty.obj --tam map.exr
try $draw dirty.obj -t gouraud
is "a picture all the same, with a warning" "$status $(grep -c warning .err)" "0 1"
rm -f picture.png
refuses "a colour of no name" 2 2 "--ink" $draw torus.glb --tam map.exr --ink blak
refuses "samples that are no square" 2 2 "--samples 5" $draw torus.glb --tam map.exr --samples 5
refuses "half a pixel" 2 2 "whole numbers" render-gl --size 32.5x24 torus.glb --tam map.exr -o picture.png

# The message and the manual name the techniques that light pixels: those that do it, each with the file that it wants.
tamvol -q map.exr -o volume.ktx2
tamthresh -q map.exr -o thresholds.ktx2
for technique in $(render-gl --options-table | awk -F'\t' '$2 == "technique" {gsub(",", " ", $7); print $7}'); do
    for asset in map.exr volume.ktx2 thresholds.ktx2; do
        try render-gl --size 32x24 -o lit.png torus.glb -q -t "$technique" --tam $asset --pixel-light
        [ $status -eq 3 ] || break
    done
    [ $status -ne 0 ] || echo "$technique"
done | sort >taken
refuses "light at pixels of a technique without" 2 2 "not with tam-flat" $draw torus.glb -t tam-flat --tam map.exr --pixel-light
is "those with it are named" "$(sed -n '1s/.*goes with \(.*\), not with tam-flat$/\1/p' .err | tr -d , | tr ' ' '\n' | grep -v '^and$' | sort)" \
    "$(cat taken)"
is "and in the manual" "$(awk '/^\.It/ {there = /pixel-light/} there && sub(/^\.Cm /, "")' "$TOP/man/man1/render-gl.1" |
    tr ' ' '\n' | grep '[a-z]' | grep -v '^and$' | sort -u)" "$(cat taken)"

refuses "frames without a place for their number" 2 2 %03d $draw torus.glb --tam map.exr --frames 2
refuses "shadows without edges" 2 2 "--shadows: '0'" $draw torus.glb --tam map.exr --shadows 0
refuses "haloes as wide as the picture" 2 2 "--haloes: '33'" $draw torus.glb --tam map.exr --haloes 33
cat >bumpy.gltf <<'EOF'
{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{
"attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2},"material":0}]}],"materials":[{"normalTexture":{"index":0}}],
"textures":[{"source":0}],"images":[{"uri":"bumps.png"}],"buffers":[{"byteLength":96,"uri":"bumpy.bin"}],
"bufferViews":[{"buffer":0,"byteLength":36},
{"buffer":0,"byteOffset":36,"byteLength":36},{"buffer":0,"byteOffset":72,"byteLength":24}],"accessors":[
{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
{"bufferView":1,"componentType":5126,"count":3,"type":"VEC3"},
{"bufferView":2,"componentType":5126,"count":3,"type":"VEC2"}]}
EOF
zero='\000\000\000\000' one='\000\000\200\077'
printf "$zero$zero$zero$one$zero$zero$zero$one$zero$zero$zero$one$zero$zero$one$zero$zero$one" >bumpy.bin
printf "$zero$one$one$one$zero$zero" >>bumpy.bin
try $draw bumpy.gltf -t gouraud --pixel-light
is "a missing normal map: a picture, and one line that names it" "$status $(cat .err)" \
    "0 render-gl: bumpy.gltf: warning: 1 image is left out that could not be read: bumps.png"
rm -f picture.png
printf 'no picture' >bumps.png
refuses "a normal map that is none" 3 1 "texture 0:" $draw bumpy.gltf -t gouraud --pixel-light
ok "which nobody reads at vertices" render-gl --size 32x24 -t gouraud bumpy.gltf -o tone.png
for pattern in '%s%d.png' '%d%d.png' '%9999d.png' '%n.png'; do
    refuses "frames as $pattern" 2 2 %03d render-gl torus.glb --tam map.exr --frames 2 -o "$pattern"
done
many="render-gl --size 32x24 --frames 2 -o p%d.png"
refuses "what animates nothing" 2 2 "PARAM=FROM..TO" $many torus.glb -t rptam --animate zoom=2
refuses "an animated option that is none" 2 2 "want one of stroke, stroke-ink" $many torus.glb -t rptam --animate nib=1..2
refuses "an animated number that the option would not take" 2 2 "from 0 to 1" $many torus.glb -t rptam --animate overlap=0..2
refuses "one that animates with half a pair" 2 2 "LxW" $many torus.glb -t rptam --animate stroke=9x1..9
refuses "a factor from nothing" 2 2 "by factors" $many torus.glb -t rptam --animate exposure=0..2
refuses "an animated option twice" 2 2 "given twice" $many torus.glb -t rptam --animate fov=9..20 --animate fov=20..9
refuses "seeds of a technique without" 2 2 "tam does not use it" $many torus.glb --tam map.exr --animate overlap=0..1
refuses "strokes of a technique without" 2 2 "gouraud does not use it" $many torus.glb -t gouraud --animate hatch-turn=0..9
refuses "the width of no lines" 2 2 "without --lines" $many torus.glb -t gouraud --animate line-width=1..2
refuses "what is for seeds alone" 2 2 "not with tam" $draw torus.glb --tam map.exr --style pencil
try $many torus.glb --tam map.exr
is "frames in which nothing moves" "$status $(grep -c 'all frames are alike' .err)" "0 1"
try render-gl --size 32x24 -o p0.png torus.glb --tam map.exr --ink white
is "white ink on white paper" "$status $(grep -c 'same colour' .err)" "0 1"
refuses "an animation of one picture" 2 2 "--frames 2" $draw torus.glb -t rptam --animate zoom=1..2
refuses "a picture that memory does not hold" 5 1 memory \
    render-gl --size 65536x65536 torus.glb --tam map.exr --max-memory 100M -o picture.png
if [ -z "$SANITIZE" ]; then
    refuses "no driver" 4 1 libgl1-mesa-dri env LIBGL_DRIVERS_PATH=/nonexistent \
        __EGL_VENDOR_LIBRARY_DIRS=/nonexistent $draw torus.glb --tam map.exr
    refuses "an old driver" 4 1 "OpenGL 4.5" env MESA_GL_VERSION_OVERRIDE=3.3 \
        $draw torus.glb --tam map.exr
fi

cp -r "$TOP/cmd/render-gl/shaders" shaders
try $draw torus.glb --tam map.exr --shader-dir shaders
is "shaders of a folder" "$status $(cat .err)" "0 "
rm -f picture.png
sed -i 's/void main()/void main(/' shaders/tam/tam.frag
refuses "a shader with an error, and its file" 3 1 tam/tam.frag \
    $draw torus.glb --tam map.exr --shader-dir shaders
refuses "no shaders" 4 1 nonesuch $draw torus.glb --tam map.exr --shader-dir nonesuch

tamgen --size 64 --levels 1 --tones 8 -o eight.exr
try $draw torus.glb --tam eight.exr
is "six of eight columns, in one warning" "$status $(wc -l <.err) $(grep -c "8 columns" .err)" "0 1 1"
try $draw torus.glb --tam eight.exr --technique tam-triple
is "all eight, in three passes" "$status $(cat .err)" "0 "
tamgen --size 64 --levels 1 --palette dusk -o colours.exr
try $draw torus.glb --tam colours.exr
is "a coloured map's grey, in one warning" "$status $(wc -l <.err) $(grep -c "tam-triple" .err)" "0 1 1"
try $draw torus.glb --tam colours.exr --technique tam-triple
is "its colours, in three passes" "$status $(cat .err)" "0 "

ok "a film takes no more memory than a frame" render-gl torus.glb --tam map.exr --size 320x240 --frames 60 --turntable \
    --max-memory 4M -o 'film%d.png'
is "all of it" "$(ls film*.png | wc -l)" 60
rm film*.png
render-gl torus.glb --tam map.exr --size 64x48 --frames 3 --turntable -o 'turn%02d.png'
is "frames have numbers" "$(echo turn*.png)" "turn00.png turn01.png turn02.png"
is "a turntable turns" "$(cmp -s turn00.png turn01.png; echo $?)" 1

json() {
    perl -MJSON::PP -e 'local $/; print ref decode_json(<STDIN>)'
}
render-gl torus.glb --tam map.exr --size 64x48 --time 2 --json >times.json
is "--time --json is JSON" "$(json <times.json)" ARRAY
render-gl torus.glb --tam map.exr --size 64x48 --time 2 >times.tsv
is "--time tells the frame and the reference" \
    "$(awk -F'\t' '$2 == "frame" {print $1}' times.tsv | tr '\n' ' ')" "tam gouraud "
is "times are numbers over 0" "$(awk -F'\t' 'NR > 1 && !($4 > 0 && $7 > 0)' times.tsv)" ""
render-gl torus.glb --tam map.exr --size 64x48 --probe --json >probe.json
is "--probe --json is JSON" "$(json <probe.json)" ARRAY
render-gl torus.glb --tam map.exr --size 64x48 --probe >probe.tsv
is "--probe: pixels drawn, between none and all" \
    "$(awk -F'\t' '$1 == "drawn" {print ($3 > 0.1 && $3 < 0.9)}' probe.tsv)" 1
is "--probe: no more texels than there are" \
    "$(awk -F'\t' '$1 == "used" {u = $3} $1 == "map" {print (u > 0 && u <= $3)}' probe.tsv)" 1
finish
