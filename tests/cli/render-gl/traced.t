# --technique traced: strokes of strokegen follow tone, perspective, shadows and poses, and stay on their surfaces.
. "${TOP:-.}/tests/tap.sh"

meshgen plane --faces 200 | strokegen -q --levels 5 --gap 0.06 -o plane.glb
meshgen sphere --faces 2000 | strokegen -q --levels 5 -o ball.glb
meshgen plane --faces 200 -o bare.glb

# draw FILE OPTION ...: draws without feature lines into $file
file=picture.exr
draw() {
    render-gl -q -t traced --lines none -o $file "$@"
}
# mean_ink OPTION ...: prints the mean darkness of pictures of a plane with four sets of strokes, since each is random
mean_ink() {
    for seed in 1 2 3 4; do
        [ -f plane$seed.glb ] || meshgen plane --faces 200 | strokegen -q --seed $seed --levels 5 --gap 0.06 -o plane$seed.glb
        draw plane$seed.glb "$@"
        ink
    done | awk '{sum += $1} END {print sum / NR}'
}
# ink: prints the mean darkness of the picture
ink() {
    hatchstat frames $file $file | awk 'NR == 2 {print 1 - $2}'
}
# near NAME GOT WANT OFF
near() {
    is "$1: $2 for $3" "$(awk -v got="$2" -v want="$3" -v off="$4" \
        'BEGIN {print (got != "" && (got - want) ^ 2 <= off ^ 2)}')" 1
}

try draw bare.glb
refused "a scene without strokes" 3 1
is "the message names the command to use" "$(cat .err)" \
    "render-gl: bare.glb: there are no strokes on the meshes: make them with strokegen"
# Meshes that stay blank among others are told, and the ground, which has no strokes.
try render-gl -t traced --size 64x48 -o $file ball.glb bare.glb --ground 2
is "meshes without strokes are told" "$(cat .err)" "render-gl: bare.glb: warning: 1 mesh has no strokes and stays \
blank: make them with strokegen
render-gl: ball.glb and 1 more: warning: the plane of --ground has no strokes: --technique traced draws no shadows on it"
try render-gl -t traced --size 64x48 -o $file ball.glb plane.glb
is "no word if all have strokes" "$(cat .err)" ""
try draw plane.glb --stroke-style nothing
refused "a pen that does not exist" 2 2

# The light at pixels is that at vertices, of a mesh as fine as this.
draw ball.glb --size 320x240
by_vertex=$(ink)
draw ball.glb --size 320x240 --pixel-light
near "the ink of a sphere with --pixel-light" "$(ink)" "$by_vertex" .005
# A sphere throws no shadow on its lit side: its faces, not their corners, say which side that is.
draw ball.glb --size 320x240 --pixel-light --shadows .3
near "with shadows, too" "$(ink)" "$by_vertex" .001

# The plane fills the picture: its ink is its tone, near, far, slanted, and with any pen.
for camera in 0,0,3.7320508:0,0,0 0,0,2:0,0,0 1.2,0,1.6:0.2,0,0; do
    near "a plane seen from $camera" "$(mean_ink --size 200x200 --camera $camera --fov 25 --tone-range .4:.4)" .4 .02
done
# A node that would make it thinner leaves it as it is.
unpack plane.glb thin
sed 's/"nodes":\[{/&"scale":[1,1,0.001],/' thin.gltf >t.gltf && mv t.gltf thin.gltf
draw plane.glb --size 200x200 --camera 0,0,2:0,0,0 --fov 25 --tone-range .4:.4
whole=$(ink)
draw thin.gltf --size 200x200 --camera 0,0,2:0,0,0 --fov 25 --tone-range .4:.4
near "a plane whose node is flat" "$(ink)" "$whole" .0005
# A mesh that is much smaller than the gaps of the scene has few strokes; finer ones do not take over that some lack.
meshgen torus -o torus.glb
unpack torus.glb small
node='"scale":[0.001,0.001,0.001],"translation":[0,1,0]'
sed 's/"scenes":\[{"nodes":\[0\]}\],"nodes":\[{/"scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0},{'"$node"',/
    s/"mesh":0}\],"meshes"/"mesh":1}],"meshes"/
    s/"meshes":\[\({.*}\]}\),*\],"accessors"/"meshes":[\1,\1],"accessors"/' small.gltf >t.gltf && mv t.gltf small.gltf
strokegen -q small.gltf -o small.glb
draw small.glb --size 160x120 --camera 0,1.003,.002:0,1,0 --tone-range .5:.5
small=$(ink)
render-gl -q small.glb -t gouraud --lines none -o $file --size 160x120 --camera 0,1.003,.002:0,1,0 --tone-range .5:.5
near "a small mesh from near by" "$small" "$(ink)" .05
# Marks and their overlaps grow with the width.
near "sketched marks three times as wide" "$(mean_ink --stroke-style sketch --stroke-width 6 --size 200x200 \
    --camera 0,0,2:0,0,0 --fov 25 --tone-range .4:.4)" .4 .02
for pen in etching woodcut sketch pencil stipple; do
    draw plane.glb --stroke-style $pen --size 200x200 --camera 0,0,3.7320508:0,0,0 --fov 25 --tone-range .4:.4
    near "a plane drawn by $pen" "$(ink)" .4 .025
done
# Dots fill the plane where strokes are too few, and between two scales.
for camera in 0,0,2.7:0,0,0 0,0,1:0,0,0 0,0,0.6:0,0,0; do
    draw plane.glb --stroke-style stipple --size 200x200 --camera $camera --fov 25 --tone-range .4:.4
    near "a stippled plane seen from $camera" "$(ink)" .4 .03
done
draw plane.glb --stroke-width 3 --size 200x200 --camera 0,0,3.7320508:0,0,0 --fov 25 --tone-range .4:.4
near "a plane of wide strokes" "$(ink)" .4 .02
# Strokes lie evenly: ends leave no white where they meet, and long strokes are not turned over their neighbours.
plain="--size 200x200 --camera 0,0,3.7320508:0,0,0 --fov 25"
# unevenness TONE STYLE: uneven24 of hatchstat(1), the mean of four sets of strokes
unevenness() {
    # shellcheck disable=SC2086 # the options are words
    render-gl -q bare.glb -t gouraud --lines none $plain --tone-range "$1:$1" -o tone.exr
    for seed in 1 2 3 4; do
        # shellcheck disable=SC2086 # the options are words
        draw plane$seed.glb $plain --tone-range "$1:$1" --stroke-style "$2"
        hatchstat ink --reference tone.exr $file
    done | awk '$8 + 0 > 0 {sum += $8} END {print sum / 4}'
}
even=$(unevenness .4 engraving)
is "an engraved plane is even: $even" "$(awk -v even="$even" 'BEGIN {print (even > .01 && even < .03)}')" 1
for turn in 0 5; do
    printf 'name turned\ntaper 16\nvary 0\nwobble 0\nturn %s\n' $turn >turned$turn.style
done
straight=$(unevenness .8 ./turned0.style)
turned=$(unevenness .8 ./turned5.style)
is "turned strokes are about as even: $turned, $straight" \
    "$(awk -v turned="$turned" -v straight="$straight" 'BEGIN {print (straight > .01 && turned < straight + .008 && straight < .0195)}')" 1
# Strokes do not taper where a border ends them: a strip along it, about as wide as tapered ends are long, is not light.
# Few strokes reach a border.
near "the border of a plane" "$(mean_ink --size 20x200 --camera -0.9,0,3.7320508:-0.9,0,0 --fov 30 --tone-range .4:.4)" .42 .03

# Feature lines by the brush of a style: wider before a deep step, narrower in the light, paler with a light ink.
outline() {
    echo "$1" >outline.style
    render-gl -q -t traced --stroke-style ./outline.style ball.glb --size 200x200 --tone-range "$2" -o $file
}
outline "thin 1" 0:0
plain=$(ink)
outline "line-depth 1" 0:0
near "an outline before nothing" "$(ink)" "$(awk -v plain="$plain" 'BEGIN {print 1.5 * plain}')" .002
outline "line-tone 1" 0:0
near "an outline in the light" "$(ink)" "$(awk -v plain="$plain" 'BEGIN {print .5 * plain}')" .002
outline "line-taper 9
ink 0.5" 0:0
near "an outline of pale ink" "$(ink)" "$(awk -v plain="$plain" 'BEGIN {print .5 * plain}')" .001

# Two inks: the lit parts have the light one, and no part has both.
draw plane.glb --size 64x64 --camera 0,0,3:0,0,0 --paper grey --ink black,white --tone-range 0:1 --light 0:0
is "the light ink draws lit parts" "$(awk -v ink="$(ink)" 'BEGIN {print (ink < .5)}')" 1

ok "all that changes the light at once" render-gl -q ball.glb -t traced --size 64x48 --shadows .1 --specular .5:8 \
    --pixel-light --paper grey --ink black,white -o light.png

# A tile of a picture is the same part of the picture drawn at once.
draw ball.glb --size 2200x20
cp $file wide.exr
draw ball.glb --size 2200x20 -j 1
ok "the same picture with another number of threads" cmp -s wide.exr $file

# Strokes on far sides are hidden, and those at silhouettes are not: closed shapes have their tone.
meshgen torus --faces 2000 | strokegen -q --levels 5 -o torus.glb
for shape in ball torus; do
    draw $shape.glb --size 320x240 --tone-range .5:.5
    traced=$(ink)
    draw $shape.glb --size 320x240 --tone-range .5:.5 -t gouraud
    near "a $shape" "$traced" "$(ink)" .015
done
# Meshes with one family of strokes and with four keep their tone beside each other.
for angles in 0 0,45,90,135; do
    meshgen sphere --faces 2000 | strokegen -q --levels 5 -a $angles -o ball$angles.glb
done
for technique in traced gouraud; do
    draw ball0.glb ball0,45,90,135.glb --size 320x160 --tone-range .8:.8 -t $technique
    ink >$technique.ink
done
near "balls of one and of four families" "$(cat traced.ink)" "$(cat gouraud.ink)" .01
# Near views add finer levels, so that the tone stays; without them, the few strokes of the file are all. With LONG=1
# they are nearer.
near=32
[ -z "${LONG:-}" ] || near=4096
for zoom in $near 8; do
    draw torus.glb --size 160x120 --zoom $zoom --tone-range .4:.4
    near "the tone $zoom times as near" "$(ink)" .4 .02
done
cp $file finer.exr
draw torus.glb --size 160x120 --zoom 8 --tone-range .4:.4 -j 1
ok "the same finer strokes with another number of threads" cmp -s finer.exr $file
draw torus.glb --size 160x120 --zoom $near --tone-range .4:.4 --finer 0
is "no finer strokes" "$(awk -v ink="$(ink)" 'BEGIN {print (ink < .15)}')" 1

# Somewhat more strokes than the file has are made up for by their widths: nothing is traced.
draw torus.glb --size 480x360 --tone-range .8:.8
cp $file plain.exr
traced=$(ink)
draw torus.glb --size 480x360 --tone-range .8:.8 --finer 0
ok "a view that needs few strokes more than the file has" cmp -s plain.exr $file
draw torus.glb --size 480x360 --tone-range .8:.8 -t gouraud
near "its tone" "$traced" "$(ink)" .008
# From there on, finer strokes join without a change of tone.
for zoom in 2.6 3.4; do
    draw torus.glb --size 240x180 --zoom $zoom --tone-range .8:.8
    near "the tone $zoom times as near" "$(ink)" .8 .02
done

# Strokes that run straight away from the eye, on slanted faces, are whole, though they wobble aside: in the mean of four
# sets, as few strokes are in sight.
strip="--finer 0 --size 24x360 --camera 0,1.2,2.5:0,0,0 --fov 30 --tone-range .5:.5"
for seed in 1 2 3 4; do
    meshgen torus | strokegen -q --levels 6 --seed $seed -o fine$seed.glb
done
draw fine1.glb ${strip#--finer 0 } -t gouraud
toned=$(ink)
for pen in engraving woodcut; do
    traced=$(for seed in 1 2 3 4; do
        draw fine$seed.glb $strip --stroke-style $pen
        ink
    done | awk '{sum += $1} END {print sum / NR}')
    near "strokes away from the eye by $pen" "$traced" "$toned" .02
done

# Inside of the torus, faces meet in hollows: strokes do not pass under them.
draw torus.glb --size 160x120 --camera 1,0,0:1.3,0.1,0.2 --tone-range .4:.4
near "the torus from inside" "$(ink)" .4 .05
# Nor do they sink into slanted back sides.
draw torus.glb --size 160x120 --camera 1,0,0:1,0,-1 --fov 60 --tone-range .5:.5
near "the torus from inside, along it" "$(ink)" .5 .02
# Two walls that lean against each other: strokes on the back of the one behind do not come through.
for side in 0.1 0.3; do
    printf '%s\n' 'v -1 1 0' 'v 1 1 0' "v 1 -1 $side" "v -1 -1 $side" "v 1 -1 -$side" "v -1 -1 -$side" \
        'f 4 3 2 1' 'f 1 2 5 6' >walls.obj
    strokegen -q --levels 5 --angles 90 walls.obj -o walls.glb 2>/dev/null
    for technique in traced gouraud; do
        render-gl -q walls.glb -t $technique --lines none --size 320x240 --from 0:10 --light 0:40 -o picture.exr
        ink >$technique.ink
    done
    near "thin walls, $side" "$(cat traced.ink)" "$(cat gouraud.ink)" .002
done
meshgen wave --faces 2000 | strokegen -q --levels 5 -o wave.glb
for technique in traced gouraud; do
    draw wave.glb --size 320x240 --from 180:50 --tone-range .3:.3 -t $technique
    ink >$technique.ink
done
near "a wave from behind" "$(cat traced.ink)" "$(cat gouraud.ink)" .006

# Strokes whose next points lie just before the eye stay on their surface.
before_eye="--size 160x120 --camera 0,0.05,0.55:0,0,-3 --fov 60 --tone-range .5:.5"
draw torus.glb $before_eye
traced=$(ink)
draw torus.glb $before_eye -t gouraud
near "a torus around the eye" "$traced" "$(ink)" .006

# Strokes end where the camera's planes cut the surface: there is no ink beside the surface, which is black here.
unpack torus.glb cut
for planes in 3.6,100 0.1,4; do
    perl -MJSON::PP -0777 -ne 'BEGIN {($near, $far) = split /,/, shift} my $scene = decode_json($_);
        $scene->{cameras} = [{type => "perspective", perspective => {yfov => 1, znear => 0 + $near, zfar => 0 + $far}}];
        push @{$scene->{nodes}}, {camera => 0, translation => [0, 1, 4], rotation => [-.1, 0, 0, .995]};
        push @{$scene->{scenes}[0]{nodes}}, $#{$scene->{nodes}};
        print encode_json($scene)' $planes cut.gltf >planes.gltf
    draw planes.gltf --size 240x160 -t gouraud --tone-range 1:1
    cp $file black.exr
    draw planes.gltf --size 240x160 --tone-range .4:.4
    is "a torus between planes at $planes: $(ink)" "$(hatchstat diff black.exr $file | awk '
        NR == 2 {print ($2 > .05), ($2 + $3 < .0008)}')" "1 1"
done

# Strokes follow skins and nodes: the moved surfaces keep their tone.
perl "$TOP/tests/bytes/scenes.pl"
for scene in skinned nodes; do
    strokegen -q --levels 5 --gap 0.06 $scene.gltf -o $scene.glb
    for technique in traced gouraud; do
        draw $scene.glb --size 160x120 --from 0:30 --fov 20 --time-s 0.7 --tone-range .4:.4 -t $technique
        ink >$technique.ink
    done
    near "the scene $scene" "$(cat traced.ink)" "$(cat gouraud.ink)" .012
done
# A strip that is 30 pixels wide is crossed by one family with the whole tone; one of 90 pixels has both.
printf 'v -2 -.1 0\nv 2 -.1 0\nv 2 .1 0\nv -2 .1 0\nf 1 2 3 4\n' >strip.obj
strokegen -q --levels 7 strip.obj -o strip.glb
# strip SIZE: draws the strip, which covers half of the picture; prints how many paths lead along and across it
strip() {
    draw strip.glb --size "$1" --camera 0,0,5:0,0,0 --fov 4.5813 --tone-range .5:.5
    render-gl -q -t traced --lines none -o strip.svg strip.glb --size "$1" --camera 0,0,5:0,0,0 --fov 4.5813 \
        --tone-range .5:.5
    grep -o ' d="[^"]*"' strip.svg | tr 'MLd="' '     ' | awk '
        {x = $(NF - 1) - $1; y = $NF - $2; if (x ^ 2 > y ^ 2) along++; else across++}
        END {print along + 0, across + 0}'
}
is "a narrow strip has strokes across only" "$(strip 480x60 | awk '{print $1, ($2 > 50)}')" "0 1"
near "its tone" "$(ink)" .25 .02
is "a wide strip has strokes along, too" "$(strip 1440x180 | awk '{print ($1 > 50), ($2 > 20)}')" "1 1"
near "its tone" "$(ink)" .25 .02

finish
