# Messages that do not come from the parser of options: one clear line, two for wrong usage.
. "${TOP:-.}/tests/tap.sh"
meshgen torus --faces 60 -o mesh.glb
tamgen --size 64 --tones 1 --levels 1 -o map.exr

# says NAME STATUS LINES TEXT COMMAND ...: checks that COMMAND is refused and that the first line contains TEXT
says() {
    name=$1 want=$2 lines=$3 text=$4
    shift 4
    try "$@"
    refused "$name" "$want" "$lines"
    head -n 1 .err | grep -qF -e "$text"
    is "$name: the message contains '$text'" $? 0
}
says "an operand that is missing" 2 2 "too few operands, want SHAPE" meshgen
says "a subject that is missing" 2 2 "want SUBJECT [FILE ...]" hatchstat
says "wrong usage that only the library detects" 2 2 "powers of four" seedgen -n 100000 --method backtrack
says "--keep with --fit" 2 2 "--keep cannot be combined with --fit" tamgen --replay - --keep 0.5 --fit
says "--replay with --method" 2 2 "--method cannot be combined with --replay: its strokes are given" \
    tamgen --replay - --method field
says "--exact with --mask" 2 2 "--mask cannot be combined with --exact" \
    tamthresh --exact --mask a.png
says "--atlas with --tile" 2 2 "--tile cannot be combined with --atlas" lapped-param --atlas --tile 1
meshgen torus --faces 60 -o mesh.glb
says "a tile that is far too large" 3 1 "mesh.glb: --tile 1e+09: want a millionth to a million times the diagonal, 3.93" lapped-param --tile 1e9 mesh.glb
says "--hidden without feature lines" 2 2 "--hidden cannot be combined with --lines none: it dashes feature lines" render-gl mesh.glb --hidden dash --lines none -t traced -o x.svg
says "angles that are no numbers" 2 2 "--angles: '0,,60' is not a list of numbers from -360 to 360" strokegen --angles 0,,60
says "too many angles" 2 2 "--angles: more than 8" strokegen --angles 1,2,3,4,5,6,7,8,9
echo '{"asset":{"version":"2.0"},"nodes":[{"mesh":0,"scale":[0,0,0]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],
"bufferViews":[{"buffer":0,"byteLength":36}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}]}' \
    >flat.gltf
says "a scene without size" 3 1 "flat.gltf: the size of a mesh in the scene is zero or infinite" strokegen -q flat.gltf
says "too many levels" 2 2 "--levels 3: the coarsest would be under 32 pixels wide; want 2 at most" \
    tamgen --size 64 --levels 3
says "--ink with a layout that ignores it" 2 2 "--ink needs --layout rgb, array, dds or png: in OpenEXR ink is always 0" tampack --layout exr --ink 1
says "too many tones between bins" 2 2 "--bins '.1,.2,.3,.4,.5,.6,.7': want 6 tones at most" \
    tamthresh --bins .1,.2,.3,.4,.5,.6,.7 map.exr
says "bins that are no number" 2 2 "--bins 'x': want 1 to 7, or tones as in .4,.7,.9" tamthresh --bins x map.exr
says "a subject that is unknown" 2 2 "SUBJECT: 'bunny' is not one of coarse, diff, field, frames, ink, lapped, mesh, seeds, solid, tam, tones" \
    hatchstat bunny
says "a shape with a typing error" 2 2 "bump, helicoid, catenoid; perhaps teapot" meshgen teapto
says "a style with a typing error" 2 2 "speckle, stipple, wash, woodcut, and not a file; perhaps pencil" tamgen --style penci
# The longest line is cut; one that is just longer is as long.
hatchstat mesh "$(printf '%020000d' 0)" 2>cut
most=$(wc -c <cut)
rest="hatchstat: : cannot open: File name too long"
for more in -1 0 1; do
    hatchstat mesh "$(printf "%0$((most - 1 - ${#rest} + more))d" 0)" 2>.err
    is "a line of the greatest length and $more: bytes, and the last" \
        "$(wc -c <.err) $(tail -c 3 .err)" "$((more < 0 ? most - 1 : most)) $(printf '%s' long | cut -c $((3 - (more > 0)))-$((4 - (more > 0))))"
done
# A path of 4095 bytes is the longest that Linux opens.
for more in "" a; do
    path=$(perl -e "print 'abc/' x 1023, 'abc$more'")
    echo "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":4,\"uri\":\"$path\"}]}" >far.gltf
    try hatchstat mesh far.gltf
    is "a companion with a path of ${#path} bytes" "$status $(grep -c 'the path is too long' .err)" "3 ${#more}"
done
mkdir -p one/bin one/share/hatch/styles
cp "$BIN/tamgen" one/bin
says "a style where none is installed" 2 2 "no style 'penci': it is no file, and " one/bin/tamgen --style penci
cp "$BUILD/share/hatch/styles/pencil.style" one/share/hatch/styles
for other in README .style pencil.style.bak; do
    : >one/share/hatch/styles/$other
done
says "a style where one is installed" 2 2 "style: 'penci' is not one of pencil, and not a file; perhaps pencil" \
    one/bin/tamgen --style penci
for i in $(seq 70); do
    cp "$BUILD/share/hatch/styles/pencil.style" one/share/hatch/styles/$i.style
done
one/bin/tamgen --style penci 2>.err
is "a message names 64 styles at most" "$(head -n 1 .err | tr ',' '\n' | grep -cE '^ ([0-9]+|pencil)$|of 1')" 64
says "a palette that does not exist" 2 2 "palette: 'dawn' is not one of dusk, earth, sea, and not a file" \
    tamgen --palette dawn
says "a colour with a typing error" 2 2 "--ink: 'blak' is not one of black, white, grey, gray, cream, sepia, blue, red, and not #rrggbb; perhaps black" \
    render-gl mesh.glb --technique gouraud --ink blak
says "a technique with a typing error" 2 2 "; perhaps threshold" render-gl mesh.glb --technique treshold
printf 'stroke pencl\n' >bad.layers
says "a brush that does not exist" 3 1 "bad.layers: stroke: 'pencl', want ink, pencil, crayon, charcoal, stipple, round" \
    render-gl mesh.glb --technique rptam --layers bad.layers -o a.png
says "a layout with a typing error" 2 2 "--layout: 'rbg' is not one of" tampack --layout rbg map.exr
says "a camera on its target" 3 1 "the camera stands on its target" \
    render-gl mesh.glb --technique gouraud --camera 1,2,3:1,2,3 -o a.png
says "an option with a typing error" 2 2 "unknown option --stlye (is it --style?)" tamgen --stlye ink
says "an unknown letter after an option" 2 2 "unknown option -Z" tamgen --seed=1 -Zq
says "a parameter with a typing error" 2 2 "; perhaps stroke" \
    render-gl mesh.glb -t rptam --frames 2 -o f%d.png --animate storke=1..2
says "--check with a subject that has no checks" 2 2 "mesh: --check is for" hatchstat mesh mesh.glb --check
says "--max-difference with a subject that has none" 2 2 "mesh: --max-difference is for" hatchstat mesh mesh.glb -m 1
says "a picture that should be a film" 2 2 "film.mp4: the ending is that of another format: want .png, .exr, .svg or .tsv" \
    render-gl mesh.glb --technique gouraud -o film.mp4
says "frames in a format that is not written" 2 2 "f%d.jpg: the ending is that of another format: want .png, .exr, .svg or .tsv" \
    render-gl mesh.glb --technique gouraud --frames 2 -o f%d.jpg
says "figures in a picture's file" 2 2 "t.png: the ending is that of another format: want .tsv or .txt" \
    render-gl mesh.glb --technique gouraud --time 1 -o t.png
says "JSON that was not asked for" 2 2 "want .tsv or .txt" hatchstat mesh mesh.glb -o mesh.json
says "strokes as a drawing" 2 2 "s.svg: the ending is that of another format: want .tsv or .txt" \
    tamgen --strokes s.svg -o a.exr
says "a contact sheet as EXR" 2 2 "s.exr: the ending is that of another format: want .png" \
    tamgen --contact-sheet s.exr -o a.exr
says "a plot as PNG" 2 2 "p.png: the ending is that of another format: want .svg" seedgen --plot p.png -o a.seeds
says "a report as glTF" 2 2 "r.glb: the ending is that of another format: want .tsv or .txt" \
    dirfield mesh.glb --report r.glb -o a.glb
says "arrows as OBJ" 2 2 "a.obj: the ending is that of another format: want .ply" dirfield mesh.glb --arrows a.obj -o a.glb
try hatchstat mesh mesh.glb -o "a name without an ending"
is "a name without an ending is accepted" "$status $(cat .err)" "0 "
try hatchstat mesh mesh.glb -o figures.of.mine
is "an ending of no format is accepted" "$status $(cat .err)" "0 "
says "one file too few" 2 2 "diff: 1 file, want 2" hatchstat diff mesh.glb
says "a window without a display" 4 1 "no display" \
    env -u DISPLAY -u WAYLAND_DISPLAY render-gl mesh.glb --technique gouraud --window
says "a picture that is too large" 5 1 "bytes in use, limit" render-gl mesh.glb --technique gouraud --size 65536x65536
try tampack -v --layout dds --ink 1 map.exr -o map.dds
is "counts of 1 are singular" "$(cat .err)" "tampack: 1 tone, 7 levels; 1 file"
meshgen ellipsoid --faces 1000 -o ellipsoid.glb
try dirfield -v ellipsoid.glb -o field.glb
is "other counts are plural" "$(sed -n '$p' .err)" "dirfield: 4 singularities"
try seedgen -v -n 16 --method backtrack -o four.seeds
is "seedgen -v reports the smallest distances" "$(sed 's/[0-9][0-9.]*/N/g' .err | tr '\n' '|')" \
    "seedgen: smallest distances, relative to the largest possible: N within a set, N among all sets|seedgen: N search steps|"

# A refusal is one line alone: warnings that came before it are not printed.
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 2\n' >dirty.obj
says "warnings before a refusal" 3 1 "no direction field" hatchstat field dirty.obj
for refused in "hatchstat mesh dirty.obj nonesuch.obj" "dirfield dirty.obj -c nonesuch.tsv" \
    "render-gl dirty.obj --technique gouraud --camera 7" "tamgen --size 64 --palette ink.style --set width"; do
    try $refused
    count_lines .err
    is "$refused: no warning before the refusal" "$(grep -c warning .err) $((tap_lines <= 2))" "0 1"
done
try hatchstat mesh dirty.obj
is "warnings of a command that succeeds are printed" "$status $(grep -c warning .err)" "0 2"

# The file that is at fault is named.
dirfield mesh.glb -o a.glb
says "a reference without a field" 3 1 "hatchstat: mesh.glb: no direction field" hatchstat field a.glb -R mesh.glb
says "a file without a field" 3 1 "hatchstat: mesh.glb: no direction field" hatchstat field mesh.glb -R a.glb
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' | tee third.obj >plain.obj
says "the second of two scenes" 3 1 "render-gl: plain.obj: primitive 0 has no texture coordinates" \
    render-gl mesh.glb plain.obj --tam map.exr
lapped-param -q a.glb -o patches.glb
says "the third of three, behind patches" 3 1 "render-gl: third.obj: primitive 0 has no texture coordinates" \
    render-gl patches.glb mesh.glb third.obj --tam map.exr

# The words of other libraries stand behind a sentence that names the fault.
echo '{"asset":{"version":"2.0",},"meshes":3}' >bad.gltf
says "JSON with a comma too many" 3 1 "bad.gltf: JSON line 1, column 27: not valid: unexpected '}'" \
    hatchstat mesh bad.gltf
echo '{"asset":{"version":2}}' >bad.gltf
says "JSON that is not glTF" 3 1 "bad.gltf: not valid glTF: \"asset\"" hatchstat mesh bad.gltf
render-gl mesh.glb --technique gouraud --size 32x24 -o whole.png
head -c 100 whole.png >bad.png
says "half a PNG" 3 1 "bad.png: the PNG is damaged at byte " hatchstat ink bad.png
head -c 60 map.exr >bad.exr
says "the beginning of an OpenEXR file" 3 1 "bad.exr: the OpenEXR file is damaged: end of file" hatchstat tam bad.exr
printf '\377\330\377\340\000\020JFIF\0%060d\377\331' 0 >bad.jpg
says "a damaged JPEG" 3 1 "bad.jpg: the picture cannot be read: " hatchstat ink bad.jpg
echo '<svg><path></svg>' >bad.svg
says "XML with a wrong tag" 3 1 "bad.svg: line 1: not valid XML: mismatched tag" tamgen --replay bad.svg
cp -r "$TOP/cmd/render-gl/shaders" shaders
sed -i 's/void main()/void main(/' shaders/frame/tone.frag
says "a shader with an error" 3 1 "shader frame/tone.frag, line " \
    render-gl mesh.glb --technique gouraud --shader-dir shaders
for file in bad.*; do
    case $file in
    *.gltf) try hatchstat mesh $file ;;
    *.svg) try tamgen --replay $file ;;
    *) try hatchstat ink $file ;;
    esac
    is "$file: no name or mark that only a library knows" "$(grep -c -e 'exception' -e 'memory\.' -e '::' .err)" 0
done

# Commands need no environment variables, and file names are bytes.
try env -i "$BIN/tamgen" --size 64 -o "$(printf 'm\377 p.exr')"
is "an empty environment and a file name that is not UTF-8" "$status $(cat .err)" "0 "
try env -u HOME TMPDIR=/nonesuch "$BIN/render-gl" mesh.glb --tam "$(printf 'm\377 p.exr')" --size 64x48 -o a.png
is "no home and no folder for temporary files" "$status $(cat .err)" "0 "
says "a name with control characters" 4 1 "a?[1mb.glb: cannot open" dirfield "$(printf 'a\033[1mb.glb')"
printf 'mtllib \302\2332J\233.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >clear.obj
try hatchstat mesh clear.obj
is "a warning has no sequences that a terminal obeys" "$(tr -d -c '\200-\237' <.err | wc -c) $(grep -c '??2J?.mtl' .err)" "0 1"
cp clear.obj "$(printf '\302\2332J.obj')"
hatchstat mesh "$(printf '\302\2332J.obj')" 2>.err | tr -d -c '\200-\237' >.out
is "nor has a report" "$(wc -c <.out)" 0
for name in - /dev/stdout; do
    try sh -c "meshgen torus -o $name >&-"
    is "a closed standard output, as $name" "$status $(wc -l <.err)" "4 1"
done
says "a letter that is not ASCII" 2 2 "unknown option -é" tamgen --seed 1 -é
says "a letter that is not ASCII, among others" 2 2 "unknown option -vé" tamgen -vé
echo 'candidates 1000001 5' >many.style
says "a number just over its range" 3 1 "candidates: 1000001, want 1 to 1000000" tamgen --style many.style
echo 'candidates 123456.5 5' >many.style
says "a number that is not whole" 3 1 "candidates: 123456.5 5, want whole numbers" tamgen --style many.style
mkdir frames
says "the most outputs that a command may have" 4 1 "none.glb: cannot open" \
    render-gl none.glb -t gouraud --frames 4096 -o frames/f%04d.png --times times.tsv
is "none of them is left" "$(ls -A frames)" ""
finish
