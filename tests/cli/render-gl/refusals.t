# Refusals of render-gl, each with one line that says what to do; warnings; frames; and reports as TSV and JSON.
. "${TOP:-.}/tests/tap.sh"

tamgen --size 64 --levels 2 -o map.exr
meshgen torus --faces 200 -o torus.glb
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >plain.obj

# refuses NAME STATUS LINES WORDS COMMAND ...: checks that COMMAND exits with STATUS and LINES of messages, one with
# WORDS
refuses() {
    name=$1 want=$2 lines=$3 words=$4
    shift 4
    try "$@"
    is "$name" "$status $(wc -l <.err) $(grep -cF -e "$words" .err)" "$want $lines 1"
    [ ! -e picture.png ] || fail "$name: no picture is left"
}
draw="render-gl --size 32x24 -o picture.png"

refuses "no map" 2 2 "--tam FILE" $draw torus.glb
refuses "a mesh without texture coordinates" 3 1 \
    "primitive 0 has no texture coordinates, which strokes follow; add them with dirfield FILE | lapped-param -o NEW.glb" \
    $draw plain.obj --tam map.exr
ok "a mesh without texture coordinates drawn by gouraud" render-gl --size 32x24 -t gouraud plain.obj -o tone.png
refuses "--show patches without patches" 3 1 \
    "the scene has no patches; add them with dirfield FILE | lapped-param -o NEW.glb" $draw torus.glb --show patches
refuses "--show field without a field" 3 1 "no mesh has directions; add them with dirfield FILE -o NEW.glb" \
    $draw torus.glb --show field
refuses "--show with --technique" 2 2 "--show cannot be combined with --technique" \
    $draw torus.glb --show field --technique tam --tam map.exr
refuses "a camera that does not exist" 3 1 "camera 2 is not in the scene; its files define 0, numbered from 0" \
    $draw torus.glb --tam map.exr --camera 2
refuses "the greatest number of a camera" 3 1 "camera 65535 is not in the scene" $draw torus.glb --tam map.exr --camera 65535
refuses "a greater number of a camera" 2 2 "--camera 65536" $draw torus.glb --tam map.exr --camera 65536
refuses "strokes that reach farther than tiles" 5 1 "strokes reach 1254 pixels beyond one" \
    render-gl -q torus.glb -t strokes --stroke 500x2 --size 2100x8 -o picture.png
refuses "highlights that are too strong" 2 2 "--specular 10.1:1: want a strength from 0 to 10" \
    $draw torus.glb -t gouraud --specular 10.1:1
try render-gl --size 32x24 torus.glb -t gouraud --ink white -o tone.png
is "ink of the paper's colour" "$status $(grep -c "warning: ink and paper have the same colour: strokes are invisible" .err)" \
    "0 1"
try render-gl --size 32x24 torus.glb -t gouraud --ink white,black -o tone.png
is "beside a second ink" "$status $(cat .err)" "0 "
ok "the strongest highlights" render-gl --size 32x24 torus.glb -t gouraud --specular 10:1 -o tone.png
refuses "too many repeats" 2 2 "--uv-scale 65536.1: want auto or a number over 0 and up to 65536" \
    $draw torus.glb --tam map.exr --uv-scale 65536.1
refuses "as many repeats as there may be" 3 1 "has no texture coordinates" $draw plain.obj --tam map.exr --uv-scale 65536
for more in "" 0; do # 127 characters are the most
    try render-gl torus.glb -t gouraud --size 32x24 --frames 2 --animate "fov=30..$(printf '%0127d' 40)$more" -o long%d.png
    is "a number of $((127 + ${#more})) characters" "$status $(grep -c 'fov: a number of 128 characters is too long' .err)" \
        "$((2 * ${#more})) ${#more}"
done
refuses "an animation that does not exist" 3 1 "animation 1 does not exist: the scene has 0, numbered from 0" \
    $draw torus.glb --tam map.exr --animation 1
refuses "an animation of a file without animations" 3 1 "animation 0 does not exist: the scene has 0" \
    $draw torus.glb --tam map.exr --animation 0
refuses "a camera at its own target" 3 1 "X,Y,Z:X,Y,Z" \
    $draw torus.glb --tam map.exr --camera 0,1,2:0,1,2
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 2\n' >dirty.obj
refuses "several faults with one cause give one line" 3 1 lapped-param $draw dirty.obj --tam map.exr
try $draw dirty.obj -t gouraud
is "a degenerate face is left out with a warning" "$status $(grep -c warning .err)" "0 1"
rm -f picture.png
refuses "--from with a camera of the scene" 2 2 "--from cannot be combined with --camera 0, only with --camera frame" \
    $draw torus.glb --tam map.exr --camera 0 --from 30:20
refuses "a camera that is none" 2 2 "--camera front: want a number, frame, or X,Y,Z[:X,Y,Z]" \
    $draw torus.glb --tam map.exr --camera front
refuses "--animate with --probe" 2 2 "--animate cannot be combined with --probe" \
    $draw torus.glb --tam map.exr --animate zoom=1..2 --frames 2 --probe
refuses "--animate with --time" 2 2 "--animate cannot be combined with --time" \
    $draw torus.glb --tam map.exr --animate zoom=1..2 --frames 2 --time 1
refuses "--time with --probe" 2 2 "--time cannot be combined with --probe" \
    $draw torus.glb --tam map.exr --time 1 --probe
refuses "--modulate with --texture-tone" 2 2 "--modulate cannot be combined with --texture-tone: give one of them" \
    $draw torus.glb --tam map.exr --modulate tone.png --texture-tone
refuses "an unknown colour" 2 2 "--ink" $draw torus.glb --tam map.exr --ink blak
refuses "a number of samples that is no square" 2 2 "--samples 5" $draw torus.glb --tam map.exr --samples 5
refuses "a size with half a pixel" 2 2 "whole numbers" render-gl --size 32.5x24 torus.glb --tam map.exr -o picture.png

# Message and manual must name exactly the techniques that accept --pixel-light, each tried with its own kind of asset.
strokegen -q --levels 3 torus.glb -o strokes.glb
tamvol -q map.exr -o volume.ktx2
tamthresh -q map.exr -o thresholds.ktx2
for technique in $(render-gl --options-table | awk -F'\t' '$2 == "technique" {gsub(",", " ", $7); print $7}'); do
    for asset in '' map.exr volume.ktx2 thresholds.ktx2; do
        try render-gl --size 32x24 -o lit.png strokes.glb -q -t "$technique" ${asset:+--tam $asset} --pixel-light
        [ $status -ne 0 ] || break
    done
    [ $status -ne 0 ] || echo "$technique"
done | sort >taken
refuses "--pixel-light with a technique that does not support it" 2 2 "not with tam-flat" $draw torus.glb -t tam-flat --tam map.exr --pixel-light
is "the message names the techniques that support --pixel-light" "$(sed -n '1s/.*goes with \(.*\), not with tam-flat$/\1/p' .err | sed 's/ and / /; s/,//g' | tr ' ' '\n' | sort)" \
    "$(cat taken)"
is "the manual names the techniques that support --pixel-light" "$(awk '/^\.It/ {there = /pixel-light/} there && sub(/^\.Cm /, "")' "$TOP/man/man1/render-gl.1" |
    tr ' ' '\n' | grep '[a-z]' | grep -v '^and$' | sort -u)" "$(cat taken)"

refuses "a percent sign beside the number of a picture" 2 2 %03d $draw torus.glb -t gouraud --frames 2 -o 'a%b-%d.png'
render-gl torus.glb -t gouraud --size 8x8 --frames 2 --turntable -o 'a%%b-%d%%.png'
is "two of them stand for one" "$(ls a%*)" "$(printf 'a%%b-0%%.png\na%%b-1%%.png')"
render-gl torus.glb -t gouraud --size 8x8 -o 'single%d.png'
render-gl torus.glb -t gouraud --size 8x8 -o 'single%%.png'
is "a single picture has the name that is given" "$(ls single*)" "$(printf 'single%%%%.png\nsingle%%d.png')"
refuses "--frames without a number in the output's name" 2 2 %03d $draw torus.glb --tam map.exr --frames 2
refuses "shadows with an edge of width 0" 2 2 "--shadows: '0'" $draw torus.glb --tam map.exr --shadows 0
refuses "haloes that are too wide" 2 2 "--haloes: '33'" $draw torus.glb --tam map.exr --haloes 33
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
is "a missing normal map is left out with one warning" "$status $(cat .err)" \
    "0 render-gl: bumpy.gltf: warning: 1 image could not be read and is left out: bumps.png"
printf '\000\000\000\034ftypavif\000\000\000\000avifmif1' >bumps.png
try $draw bumpy.gltf -t gouraud --pixel-light
is "a normal map in AVIF is missing, too" "$status $(cat .err)" \
    "0 render-gl: bumpy.gltf: warning: 1 image could not be read and is left out: bumps.png"
perl -e 'print pack "H*", "524946462c000000574542505650384c1f000000" .
    "2f014000001f201048de1f3a8df9171014fc1fddfc47640fe0060c11fd0f0100"' >bumps.png
ok "a normal map in WebP is read" $draw bumpy.gltf -t gouraud --pixel-light
rm -f picture.png
printf 'no picture' >bumps.png
refuses "a normal map that is not an image" 3 1 "texture 0:" $draw bumpy.gltf -t gouraud --pixel-light
ok "without --pixel-light a bad normal map is not read" render-gl --size 32x24 -t gouraud bumpy.gltf -o tone.png
refuses "a buffer of a glTF from standard input" 3 1 \
    "uri bumpy.bin: not found, since the glTF comes from standard input: give its path instead" \
    sh -c "$draw -t gouraud <bumpy.gltf"
for pattern in '%s%d.png' '%d%d.png' '%9999d.png' '%n.png'; do
    refuses "frames as $pattern" 2 2 %03d render-gl torus.glb --tam map.exr --frames 2 -o "$pattern"
done
many="render-gl --size 32x24 --frames 2 -o p%d.png"
refuses "--animate without a range" 2 2 "PARAM=FROM..TO" $many torus.glb -t rptam --animate zoom=2
refuses "--animate of an option that cannot be animated" 2 2 "is not one of stroke, stroke-ink" $many torus.glb -t rptam --animate nib=1..2
refuses "--animate out of the option's range" 2 2 "from 0 to 1" $many torus.glb -t rptam --animate overlap=0..2
refuses "--animate of a pair with a single number" 2 2 "LxW" $many torus.glb -t rptam --animate stroke=9x1..9
refuses "--animate of a factor from 0" 2 2 "want numbers over 0, since it changes by the same factor each frame" \
    $many torus.glb -t rptam --animate exposure=0..2
refuses "--animate of one option twice" 2 2 "given twice" $many torus.glb -t rptam --animate fov=9..20 --animate fov=20..9
refuses "--animate overlap with a technique without seed points" 2 2 "tam does not use it" $many torus.glb --tam map.exr --animate overlap=0..1
refuses "--animate hatch-turn with a technique without strokes" 2 2 "gouraud does not use it" $many torus.glb -t gouraud --animate hatch-turn=0..9
refuses "--animate line-width without lines" 2 2 "without --lines" $many torus.glb -t gouraud --animate line-width=1..2
for list in none,creases creases,none all,creases silhouettes,all none,none; do
    refuses "--lines $list" 2 2 "want none, all, or silhouettes, creases and boundaries separated by commas" \
        $draw torus.glb -t gouraud --lines $list
done
refuses "--style with a technique without seed points" 2 2 "not with tam" $draw torus.glb --tam map.exr --style pencil
refuses "--animate of a look's option without the look" 2 2 "--wet needs --look watercolor" \
    $many torus.glb -t solid --animate wet=0..1
refuses "--animate of an option that the look does not use" 2 2 "--grain needs --look plain, watercolor or collage" \
    $many torus.glb -t solid --look binary --animate grain=0..1
refuses "--animate exposure with --light" 2 2 "--exposure cannot be combined with --light" \
    $many torus.glb -t gouraud --light 0:0 --animate exposure=1..2
refuses "--animate of both exposure and light" 2 2 "--exposure cannot be combined with --light" \
    $many torus.glb -t gouraud --animate exposure=1..2 --animate light=0:0..9:9
refuses "--animate stroke with a map" 2 2 "--stroke cannot be combined with --tam" \
    $many torus.glb -t strokes --tam map.exr --animate stroke=20x1..60x3
try $many torus.glb -t gouraud --animate exposure=1..2
is "exposure without lights is warned of" "$status $(cat .err)" \
    "0 render-gl: torus.glb: warning: the scene has no lights: --exposure changes nothing"
try $many torus.glb -t gouraud --animate zoom=1..1 --animate light=0:0..0:0
is "--animate without change is warned of" "$status $(grep -c 'all frames are alike' .err)" "0 1"
try $many torus.glb -t gouraud --animate light=0:0..0:9
is "--animate of one number of a pair is a change" "$status $(cat .err)" "0 "
try $many torus.glb -t rptam --animate nib=1..2
sed -n 's/;.*//; s/.* is not one of //p' .err | tr -d ' ' | tr , '\n' | sort >animated
sed -n '/^\.Sh ANIMATION/,/^\.El/s/^\.Fl -\([a-z-]*\).*/\1/p' "$TOP/man/man1/render-gl.1" | grep -vx animate | sort >listed
is "the manual lists what --animate can change" "$(comm -3 animated listed)" ""
try $many torus.glb --tam map.exr
is "frames without motion are warned of" "$status $(grep -c 'all frames are alike' .err)" "0 1"
try render-gl --size 32x24 -o p0.png torus.glb --tam map.exr --ink white
is "white ink on white paper is warned of" "$status $(grep -c 'same colour' .err)" "0 1"
refuses "--animate without --frames" 2 2 "--frames 2" $draw torus.glb -t rptam --animate zoom=1..2
refuses "a picture larger than --max-memory" 5 1 memory \
    render-gl --size 65536x65536 torus.glb --tam map.exr --max-memory 100M -o picture.png
if [ -z "$SANITIZE" ]; then
    refuses "no OpenGL driver" 4 1 libgl1-mesa-dri env -u __EGL_VENDOR_LIBRARY_FILENAMES LIBGL_DRIVERS_PATH=/nonexistent \
        __EGL_VENDOR_LIBRARY_DIRS=/nonexistent $draw torus.glb --tam map.exr
    refuses "an OpenGL driver that is too old" 4 1 "OpenGL 4.5" env MESA_GL_VERSION_OVERRIDE=3.3 \
        $draw torus.glb --tam map.exr
fi

cp -r "$TOP/cmd/render-gl/shaders" shaders
try $draw torus.glb --tam map.exr --shader-dir shaders
is "--shader-dir draws with the shaders of a folder" "$status $(cat .err)" "0 "
rm -f picture.png
for more in "" 0; do # names of 63 bytes are the longest
    long=$(printf '%063d' 0)$more
    echo '#define INCLUDED 1' >"shaders/$long"
    printf '#include "%s"\n#ifndef INCLUDED\n#error\n#endif\n' "$long" | cat - "$TOP/cmd/render-gl/shaders/tam/tam.frag" >shaders/tam/tam.frag
    try $draw torus.glb --tam map.exr --shader-dir shaders
    is "a shader that includes a name of ${#long} bytes" $status "$((3 * ${#more}))"
    rm -f picture.png
done
cp "$TOP/cmd/render-gl/shaders/tam/tam.frag" shaders/tam
sed -i 's/void main()/void main(/' shaders/tam/tam.frag
refuses "a shader with an error is named" 3 1 tam/tam.frag \
    $draw torus.glb --tam map.exr --shader-dir shaders
refuses "a missing folder of shaders" 4 1 nonesuch $draw torus.glb --tam map.exr --shader-dir nonesuch

tamgen --size 64 --levels 1 --tones 8 -o eight.exr
try $draw torus.glb --tam eight.exr
is "the use of six of eight columns gives one warning" "$status $(wc -l <.err) $(grep -c "8 columns" .err)" "0 1 1"
try $draw torus.glb --tam eight.exr --technique tam-triple
is "tam-triple draws all eight columns" "$status $(cat .err)" "0 "
tamgen --size 64 --levels 1 --palette dusk -o colours.exr
try $draw torus.glb --tam colours.exr
is "drawing a coloured map in grey gives one warning" "$status $(wc -l <.err) $(grep -c "tam-triple" .err)" "0 1 1"
try $draw torus.glb --tam colours.exr --technique tam-triple
is "tam-triple draws a coloured map" "$status $(cat .err)" "0 "
# A light ink would draw the complementary colours.
tamvol -q colours.exr -o colours.ktx2
for colours in 'tam-triple --tam colours.exr' 'volume --tam colours.ktx2'; do
    for ink in '--ink white --paper black' '--ink black,white --paper grey'; do
        # shellcheck disable=SC2086 # options
        try $draw torus.glb --technique $colours $ink
        is "$colours $ink gives one warning" "$status $(wc -l <.err) $(grep -c "light ink" .err)" "0 1 1"
    done
done
for drawn in tam tam-triple; do
    render-gl -q torus.glb --lines none --technique $drawn --tam colours.exr --ink white --paper black -o $drawn.exr
done
rms=$(hatchstat diff tam.exr tam-triple.exr | awk 'NR == 2 {print $4}')
ok "white strokes of a coloured map are white: $rms" awk -v rms="$rms" 'BEGIN {exit !(rms != "" && rms < .01)}'
tamgen --size 64 --levels 1 --palette dusk --ids -o ids.exr
try $draw torus.glb --tam ids.exr --technique strokes
is "fitted strokes without the map's colours give one warning" "$status $(wc -l <.err) $(grep -c "not drawn" .err)" "0 1 1"
for drawn in tam tam-triple; do
    try $draw torus.glb --tam colours.exr --technique $drawn --look watercolor
    is "painting what $drawn draws of a coloured map gives one warning" \
        "$status $(wc -l <.err) $(grep -c "paints the map's colours" .err)" "0 1 1"
done

ok "60 frames fit in 4 MB of memory" render-gl torus.glb --tam map.exr --size 320x240 --frames 60 --turntable \
    --max-memory 4M -o 'film%d.png'
is "60 frames are written" "$(ls film*.png | wc -l)" 60
rm film*.png
render-gl torus.glb --tam map.exr --size 64x48 --frames 3 --turntable -o 'turn%02d.png'
is "frames are numbered in their names" "$(echo turn*.png)" "turn00.png turn01.png turn02.png"
is "frames of a turntable differ" "$(cmp -s turn00.png turn01.png; echo $?)" 1

json() {
    perl -MJSON::PP -e 'local $/; print ref decode_json(<STDIN>)'
}
render-gl torus.glb --tam map.exr --size 64x48 --time 2 --json >times.json
is "--time --json is JSON" "$(json <times.json)" ARRAY
render-gl torus.glb --tam map.exr --size 64x48 --time 2 >times.tsv
is "--time reports the frame and the reference" \
    "$(awk -F'\t' '$2 == "frame" {print $1}' times.tsv | tr '\n' ' ')" "tam gouraud "
is "times are positive numbers" "$(awk -F'\t' 'NR > 1 && !($4 > 0 && $7 > 0)' times.tsv)" ""
render-gl torus.glb --tam map.exr --size 64x48 --frames 3 --turntable --times times.tsv --draws 2 -o 'timed%02d.png'
is "--times: a line for each picture, with positive times" \
    "$(awk -F'\t' 'NR > 1 {print $1, $2, ($3 > 0 && $4 > 0 && $5 > 0)}' times.tsv | tr '\n' ';')" "0 2 1;1 2 1;2 2 1;"
is "--times does not change the pictures" "$(for i in 0 1 2; do cmp turn0$i.png timed0$i.png; done 2>&1)" ""
for options in "--times t.tsv --time 2" "--times t.tsv --probe" "--times t.tsv -o x.svg" "--draws 2"; do
    try render-gl torus.glb --tam map.exr --size 64x48 $options
    refused "render-gl $options" 2 2
done
try render-gl torus.glb --tam map.exr --size 64x48 --times /dev/full -o whole.png
is "--times on a full disk: no picture" "$status $(ls whole.png 2>/dev/null)" "4 "
render-gl torus.glb --tam map.exr --size 64x48 --probe --json >probe.json
is "--probe --json is JSON" "$(json <probe.json)" ARRAY
for samples in 1 4; do
    render-gl torus.glb --tam map.exr --size 3000x32 --samples $samples --probe | awk -F'\t' '$1 == "drawn" {printf "%.4f\n", $3}'
done >probes
is "--probe of a picture in tiles" "$(awk '{at[NR] = $1} END {print (at[1] > 0 && (at[1] - at[2]) ^ 2 < (at[1] / 50) ^ 2)}' probes)" 1
render-gl torus.glb --tam map.exr --size 64x48 --probe >probe.tsv
is "--probe: the share of drawn pixels is plausible" \
    "$(awk -F'\t' '$1 == "drawn" {print ($3 > 0.1 && $3 < 0.9)}' probe.tsv)" 1
is "--probe: no more texels are used than the map has" \
    "$(awk -F'\t' '$1 == "used" {u = $3} $1 == "map" {print (u > 0 && u <= $3)}' probe.tsv)" 1
meshgen plane --faces 50 -o plane.glb
for frames in 2 4; do
    render-gl plane.glb --tam map.exr --size 64x48 --from 0:0 --probe --turntable --frames "$frames"
done >plane.tsv
is "--probe: the mean of all frames; a plane that turns is seen edge on in half of four" \
    "$(awk -F'\t' '$1 == "drawn" {print $3 / first; first = $3}' first=1 plane.tsv | tail -1)" 0.5

# A scene that cannot show anything is refused; a picture that shows nothing of it is warned of.
echo '{"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{}]}' >bare.gltf
try $draw bare.gltf --technique gouraud
refused "a scene without faces is refused" 3 1
is "a scene without faces: message" "$(cat .err)" "render-gl: bare.gltf: the scene has no faces"
blank() {
    name=$1
    shift
    try $draw torus.glb --technique gouraud "$@"
    is "$name gets a warning" "$status $(cat .err)" \
        "0 render-gl: torus.glb: warning: the picture is blank: nothing is in sight, or nothing is dark enough for a stroke"
}
blank "a scene behind the camera" --camera 9,9,9:10,10,10
blank "a scene too far away" --camera 1e30,0,0
try render-gl torus.glb --technique gouraud --size 64x48 --camera 9,9,9:10,10,10 --frames 2 -o 'blank%d.png'
is "blank frames get one warning" "$status $(grep -c blank .err) $(grep -c '2 of 2 pictures are blank: ' .err)" "0 1 1"
try $draw torus.glb --technique gouraud
is "a picture of the scene gets none" "$status $(cat .err)" "0 "
finish
