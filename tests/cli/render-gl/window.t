# Operates the window with keys and mouse on its own display, and compares saved pictures.
. "${TOP:-.}/tests/tap.sh"

for tool in Xvfb xdotool; do
    command -v $tool >/dev/null || { skip "the window" "no $tool"; finish; exit; }
done

# The window is as large as the screen, so that the pointer is always in it. -noreset: a server that resets when its
# last client leaves refuses new ones for a moment.
Xvfb -noreset -displayfd 3 -screen 0 320x240x24 3>display >/dev/null 2>&1 &
server=$!
trap 'kill $server $window 2>/dev/null; rm -rf "$WORK"' EXIT
window=

soon $server [ -s display ]
DISPLAY=:$(cat display)
export DISPLAY

# A rectangle that turns around its centre once in two seconds, and after 300 seconds is still as at the start, which is
# seen where its animation plays backward.
perl -e '
    use MIME::Base64;
    my ($count, $quarter) = (302, atan2(1, 0));
    my @turns = map { (0, 0, sin($quarter * $_), cos($quarter * $_)) } 0 .. 300, 300;
    my $data = encode_base64(pack("f<12f<8S<6", -1,-0.4,0, 1,-0.4,0, 1,0.4,0, -1,0.4,0, 0,1, 1,1, 1,0, 0,0,
            0,1,2, 0,2,3) .
        pack("f<*", 0 .. 300, 10000, @turns), "");
    my ($from, $size) = (92 + 4 * $count, 92 + 20 * $count);
    print qq({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
        "nodes":[{"mesh":0,"rotation":[0,0,0,1]}],
        "meshes":[{"primitives":[{"indices":2,"attributes":{"POSITION":0,"TEXCOORD_0":1}}]}],
        "animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"rotation"}}],
            "samplers":[{"input":3,"output":4}]}],
        "buffers":[{"byteLength":$size,"uri":"data:application/octet-stream;base64,$data"}],
        "bufferViews":[{"buffer":0,"byteLength":$size}],
        "accessors":[
            {"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[-1,-0.4,0],"max":[1,0.4,0]},
            {"bufferView":0,"byteOffset":48,"componentType":5126,"count":4,"type":"VEC2"},
            {"bufferView":0,"byteOffset":80,"componentType":5123,"count":6,"type":"SCALAR"},
            {"bufferView":0,"byteOffset":92,"componentType":5126,"count":$count,"type":"SCALAR","min":[0],"max":[10000]},
            {"bufferView":0,"byteOffset":$from,"componentType":5126,"count":$count,"type":"VEC4"}]});' >turning.gltf
tamgen --size 64 --levels 2 -o map.exr
meshgen teapot --faces 2000 -o teapot.glb

# open_window SCENE PICTURES [OPTION ...]: opens the window and waits for its first frame, whose time is in the title;
# earlier keys would be lost
open_window() {
    scene=$1
    pictures=$2
    shift 2
    timeout 1200 render-gl "$scene" --window --size 320x240 --samples "${samples:-1}" -o "$pictures%d.png" "$@" 2>err &
    window=$!
    soon $window shown
}

shown() {
    xdotool search --name '^render-gl: ' >/dev/null 2>&1
}

gone() {
    ! shown
}

# closed: waits until the window is closed, for the server too, so that a search finds only the next one; returns the
# exit status
closed() {
    soon $server gone || kill $window
    wait $window
}

# shot NAME: presses s and waits for NAME.png
shot() {
    xdotool key s
    (soon $window [ -s "$1.png" ]) || fail "$1.png is saved" "$(cat err)"
}

# changed A B: whether two pictures differ in more than a hundredth of the pixels
changed() {
    hatchstat diff "$1.png" "$2.png" | awk 'NR == 2 {exit !($6 > 0.01)}'
}

# moves PICTURES: saves another picture, numbered $taken; whether it differs from the first. On a busy machine a turning
# object may be back at its start, so call it with soon.
moves() {
    taken=$((taken + 1))
    shot "$1$taken"
    changed "${1}1" "$1$taken"
}

# plays NAME PAUSE_NAME PICTURES: checks that the picture moves until space is pressed
plays() {
    taken=0
    moves "$3"
    ok "$1" soon $window moves "$3"
    xdotool key space
    taken=$(ls "$3"*.png | wc -l) # ok runs moves in a subshell
    shot "$3$((taken + 1))"
    sleep 0.4
    shot "$3$((taken + 2))"
    ok "$2" cmp "$3$((taken + 1)).png" "$3$((taken + 2)).png"
}

drag() {
    xdotool mousemove 100 120 mousedown "$1" mousemove 140 120 mousemove 180 130 mouseup "$1"
}

open_window teapot.glb shot --tam map.exr
shot shot1
render-gl teapot.glb --tam map.exr --size 320x240 --samples "${samples:-1}" -o drawn.png
ok "the first picture is the one without a window" cmp shot1.png drawn.png
drag 1
shot shot2
ok "dragging turns" changed shot1 shot2
xdotool key f
shot shot3
ok "f restores the first view" cmp shot1.png shot3.png
drag 3
shot shot4
ok "the right button pans" changed shot3 shot4
xdotool key f click 4 click 4
shot shot5
ok "the wheel zooms" changed shot3 shot5
xdotool key f Left Left Up
shot shot6
ok "arrows turn" changed shot3 shot6
xdotool key f keydown ctrl
drag 1
xdotool keyup ctrl
shot shot7
ok "dragging with control moves the light" changed shot3 shot7
xdotool key 7
shot shot8
ok "7 shows the tone alone" changed shot7 shot8
titled_by() {
    xdotool search --name render-gl getwindowname | grep -qE "$1"
}
ok "the title shows technique and milliseconds" soon $window titled_by '^render-gl: gouraud, [0-9]+\.[0-9] ms$'
xdotool key t
shot shot9
ok "t shows the next technique" changed shot8 shot9
xdotool key 1
shot shot10
xdotool key l
shot shot11
ok "l hides the lines" changed shot10 shot11
xdotool key l
shot shot12
ok "l shows the lines again" cmp shot10.png shot12.png
xdotool key question key q
closed
is "q closes" $? 0
is "? lists keys and techniques" "$(grep -cE '^render-gl: [1-8] (tam|gouraud|rptam)' err)" 8
is "no other message is printed" "$(grep -vE '^render-gl: ([0-9]+ [a-z]|saved shot|drag|arrows|1 to 9|p and P|\[ and|s: )' err)" ""

open_window turning.gltf turn --tam map.exr
plays "animations play" "space pauses animations" turn
xdotool keydown Escape
closed
is "escape closes as it is pressed" $? 0
xdotool keyup Escape

# still_of NAME OPTION ...: whether the picture of the window is that of render-gl with these options
still_of() {
    name=$1
    shift
    render-gl teapot.glb -t gouraud --lines none --samples 1 -o still.png "$@"
    hatchstat diff "$name.png" still.png | awk 'NR == 2 {same = $6 < 0.001} END {exit !same}'
}
open_window teapot.glb at -t gouraud --lines none --camera 0,0,4:0,0,0
shot at1
ok "the first view is that of the options" still_of at1 --size 320x240 --camera 0,0,4:0,0,0
xdotool key Right Right Right shift+Left Up
shot at2
ok "an arrow turns by a tenth of a radian, and by a fifth of it with shift" \
    still_of at2 --size 320x240 --camera 1.0999,.39933,3.82502:0,0,0
xdotool key f
shots=2
for size in 200x240 200x100; do
    xdotool search --name '^render-gl: ' windowsize ${size%x*} ${size#*x}
    shots=$((shots + 1))
    shot at$shots
    ok "a window of $size pixels shows a picture of that size" still_of at$shots --size $size --camera 0,0,4:0,0,0
done
xdotool key q
closed

# Parameters: the window shows them in its title.
# titled NAME TITLE: waits until the title, without the milliseconds, is TITLE
has_title() {
    title=$(xdotool search --name render-gl getwindowname | sed 's/, [0-9.]* ms//')
    [ "$title" = "$1" ]
}
titled() {
    soon $window has_title "$2"
    is "$1" "$title" "$2"
}
open_window teapot.glb set --technique rptam --tam map.exr --stroke 20x2 --overlap 0.5
shot set1
xdotool key p
titled "p chooses a parameter, and the title shows it" "render-gl: rptam, stroke [20]x2"
xdotool key period period period period
titled ". increases the parameter" "render-gl: rptam, stroke [29.28]x2"
shot set2
ok "the picture follows the parameter" changed set1 set2
xdotool key p comma
titled "p chooses the next number, and , decreases it" "render-gl: rptam, stroke 29.28x[1.818]"
xdotool key d
titled "d resets both numbers" "render-gl: rptam, stroke 20x[2]"
shot set3
ok "d restores the picture" cmp set1.png set3.png
xdotool key p p p p p
titled "p goes on to other parameters" "render-gl: rptam, overlap [0.5]"
xdotool key period period period period period period period
titled "parameters stay in the range of their option" "render-gl: rptam, overlap [1]"
xdotool key P comma comma comma comma
titled "P goes back to the previous parameter" "render-gl: rptam, seed-layers [0]"
shot set4
ok "without layers there are no strokes" changed set1 set4
xdotool key 7
titled "the title hides parameters that the technique does not use" "render-gl: gouraud"
xdotool key q
closed
is "changing parameters prints no message" "$(grep -v 'saved set' err)" ""

open_window teapot.glb way --technique rptam --animate overlap=0..1 --animate stroke=10x1..40x4
plays "--animate plays in the window" "space pauses --animate" way
xdotool key t
ok "t passes techniques that need files" soon $window titled_by '^render-gl: strokes'
xdotool key q
closed

# A light shines on a triangle. The key d gives the scene's lights back, which --light replaces.
cat >lit.gltf <<'END'
{"asset": {"version": "2.0"}, "extensionsUsed": ["KHR_lights_punctual"], "scenes": [{"nodes": [0, 1]}],
 "extensions": {"KHR_lights_punctual": {"lights": [{"type": "directional"}]}},
 "nodes": [{"mesh": 0}, {"extensions": {"KHR_lights_punctual": {"light": 0}}}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
 "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36, "uri": "lit.bin"}]}
END
{
    head -c 12 /dev/zero
    printf '\0\0\200\077\0\0\0\0\0\0\0\0\0\0\0\0\0\0\200\077\0\0\0\0'
} >lit.bin
open_window lit.gltf lit --technique gouraud
shot lit1
xdotool key p p p p
titled "p comes to the light" "render-gl: gouraud, light [-40]:40"
xdotool key period
shot lit2
ok "--light replaces the lights of the scene" changed lit1 lit2
xdotool key d
shot lit3
ok "d gives them back" cmp lit1.png lit3.png
xdotool key q
closed

# A window that becomes too wide for its samples has fewer.
samples=4
open_window lit.gltf wide --technique gouraud
samples=1
xdotool search --name '^render-gl: ' windowsize 9000 20
ok "a window that is too wide for its samples stays open" soon $window grep -q 'drawn with 1 sample:' err
xdotool key q
closed
is "and can be closed" $? 0

# Techniques share options: each draws with the present values, though another one drew when they changed.
open_window teapot.glb shared --technique strokes --stroke 40x3
xdotool key 8
shot shared1
xdotool key t p comma comma comma
ok "comma shortens the strokes" soon $window titled_by '^render-gl: strokes, .* stroke \[30[0-9.]*\]x3$'
xdotool key 8
shot shared2
ok "a technique follows the options that another one has changed" changed shared1 shared2
xdotool key q
closed

# rptam has the tone range of its own strokes, whenever it begins.
open_window teapot.glb own --technique rptam
shot own1
xdotool key 7
shot own2
xdotool key 8
shot own3
ok "a technique draws the same when it is chosen again" cmp own1.png own3.png
xdotool key q
closed
open_window teapot.glb late --technique gouraud
xdotool key 8
shot late1
ok "and when it is chosen later" cmp own1.png late1.png
xdotool key q
closed

printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >bare.off
open_window bare.off bare --technique gouraud --tam map.exr
shot bare1
xdotool key 1
shot bare2
is "a technique that cannot draw the scene is refused with a message" "$(grep -c 'no texture coordinates' err)" 1
xdotool key q
closed
is "the window stays open after a refused technique" $? 0

# Two sessions with the same name, which has no field: the second one's pictures come after the first one's.
saved() {
    [ "$(grep -c saved err)" = $picture ]
}
for session in 1 2; do
    open_window teapot.glb one -o one.50%.png --technique gouraud
    for picture in 1 2; do
        xdotool key s
        soon $window saved
    done
    cp one.50%-001.png kept$session.png
    xdotool key q
    closed
done
is "s never replaces a picture" "$(echo one*) $(cmp kept1.png kept2.png)" \
    "one.50%-001.png one.50%-002.png one.50%-003.png one.50%-004.png "

# The folder of the pictures is removed while the window is open.
mkdir gone
open_window teapot.glb gone/shot --tam map.exr
rmdir gone
xdotool key s
soon $window grep -q 'cannot be saved' err
xdotool key q
closed
is "a picture that cannot be saved does not end the window" \
    "$? $(grep -c 'cannot be saved' err)" "0 1"

unset DISPLAY
try render-gl teapot.glb --tam map.exr --window
is "no display: one line, exit 4" "$status $(wc -l <.err)" "4 1"
finish
