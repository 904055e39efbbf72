# Looks of solid textures: haloes beside watercolours, and the borders of collages.
. "${TOP:-.}/tests/tap.sh"

perl "$TOP/tests/support/solid/make.pl" 16 waves:4 >waves.ktx2
draw="render-gl --size 96x72 --solid waves.ktx2 -t solid"

# The bare paper beside an object is no surface: haloes lie on surfaces alone.
meshgen sphere --faces 500 -o sphere.glb
for look in plain binary watercolor collage; do
    $draw sphere.glb --look $look -o bare.png
    $draw sphere.glb --look $look --haloes 8 -o haloes.png
    ok "$look: a single object has no halo" cmp bare.png haloes.png
done
$draw sphere.glb --ground 4 --look watercolor -o bare.png
$draw sphere.glb --ground 4 --look watercolor --haloes 8 -o haloes.png
is "watercolor: an object before the ground has one" "$(cmp -s bare.png haloes.png; echo $?)" 1

# Two balls side by side, which meet, and a number of others inside the first one, between the two in their order: none
# of these is seen, and the picture is that of two balls, with a border where they meet.
meshgen sphere --faces 200 -o ball.glb
unpack ball.glb ball
for count in 0 31 127 4095; do
    perl -MJSON::PP -0777 -pe '
        BEGIN { $hidden = shift }
        my $scene = decode_json($_);
        $scene->{nodes} = [map { {mesh => 0, translation => [$_ > $hidden ? 1.9 : 0, 0, 0],
            $_ > 0 && $_ <= $hidden ? (scale => [.1, .1, .1]) : ()} } 0 .. $hidden + 1];
        $scene->{scenes} = [{nodes => [0 .. $hidden + 1]}];
        $_ = encode_json($scene)' $count ball.gltf >balls$count.gltf
    $draw balls$count.gltf --look collage --bands 1 --from 0:0 -o balls$count.png
done
for count in 31 127 4095; do
    ok "collage: a border between objects whose numbers differ by $((count + 1))" cmp balls0.png balls$count.png
done

# Feature lines over a collage: those of a ball are seen, and those of another behind it are not.
for behind in 0 1; do
    perl -MJSON::PP -0777 -pe '
        BEGIN { $behind = shift }
        my $scene = decode_json($_);
        $scene->{nodes} = [{mesh => 0}, $behind ? {mesh => 0, translation => [0, 0, -3], scale => [.3, .3, .3]} : ()];
        $scene->{scenes} = [{nodes => [0 .. $behind]}];
        $_ = encode_json($scene)' $behind ball.gltf >behind$behind.gltf
    for lines in none silhouettes; do
        $draw behind$behind.gltf --camera 0,0,6:0,0,0 --look collage --bands 1 --lines $lines -o $lines$behind.png
    done
done
is "collage: the outline of a ball is drawn" "$(cmp -s none0.png silhouettes0.png; echo $?)" 1
ok "collage: an outline behind the ball is not" cmp silhouettes0.png silhouettes1.png

# A texture for each tone.
for bands in 2 3; do
    $draw ball.glb --solid waves.ktx2,waves.ktx2,waves.ktx2 --look collage --bands $bands -o three.png
done 2>said
is "collage: textures beyond the tones are left out, with a warning" "$(cat said)" \
    "render-gl: warning: --solid: 3 textures, of which --bands 2 uses 2"

# A square of one tone, with all effects off: as dark as if so much of the ink covered the paper, of which the lightest
# tone is a thin wash of a quarter. Of inks whose channels are all or nothing, the mean of the channels shows that, too.
perl "$TOP/tests/support/solid/make.pl" 8 grey:128 >one.ktx2
meshgen plane --faces 2 -o plane.glb
square="render-gl plane.glb --camera 0,0,4:0,0,0 --size 16x16 --fov 10 --samples 1 --lines none -t solid"
flat="$square --solid one.ktx2 --look watercolor --bands 15 --wobble 0 --dry 0 --paper-grain 0 --grain 0
    --edge-darkening 0 --wet 0"
# grey FILE: prints the mean of a picture's channels
grey() {
    hatchstat frames "$1" "$1" | awk 'NR == 2 {print $2}'
}
for colors in ffff00:.66667 00ffff:.66667 00ff00:.33333 000000:0; do
    ink=${colors%:*} least=${colors#*:}
    wrong=$(for tone in 0 .4 .8 1; do
        $flat --ink "#$ink" --tone-range "$tone:$tone" -o square.exr
        echo "$tone $(grey square.exr)"
    done | awk -v least="$least" '{
        want = 1 + (.25 + .75 * $1) * (least - 1)
        if ($2 < want - .006 || $2 > want + .006) print $1, $2, want
    }')
    is "watercolor: tones of #$ink on white" "$wrong" ""
done

# A square of 16 by 16 pixels in the middle of 32 by 32, as dark as the paper: its border, 3 pixels wide on all sides,
# is as light as the lightest channel of the paper, but at least 0.9.
for case in 000000:0 ff0000:.33333; do
    paper=${case%:*}
    render-gl -q plane.glb --camera 0,0,4:0,0,0 --size 32x32 --fov 53.1301 --samples 1 --lines none -t solid \
        --solid one.ktx2 --look collage --bands 1 --wobble 0 --grain 0 --border 3 \
        --paper "#$paper" --ink "#$paper" -o border.exr
    echo "$(grey border.exr) ${case#*:}"
done | awk '{
    share = (16 * 16 - 10 * 10) / (32 * 32)
    want = $2 + share * ((NR == 1 ? .9 : 1) - $2)
    print ($1 > want - .004 && $1 < want + .004) ? "ok" : $1 ", want " want
}' >border
is "collage: the border on black paper and on red paper" "$(tr '\n' ' ' <border)" "ok ok "

# The same square, moved by parts of a pixel: where it covers samples of a pixel but not its middle, these have the
# strip's colour, too.
for at in 0,0 -.075,0 .075,0 0,-.075 0,.075; do
    render-gl -q plane.glb --camera $at,4:$at,0 --size 32x32 --fov 53.1301 --samples 4 --lines none -t solid \
        --solid one.ktx2 --look collage --bands 1 --wobble 0 --grain 0 --border 0 -o moved.exr
    printf '%.4f\n' "$(grey moved.exr)"
done | uniq -c | awk '{print $1, ($2 > .8 && $2 < .95)}' >moved
is "collage: a square that is moved by parts of a pixel" "$(cat moved)" "5 1"

# Bare paper, beside the scene: a texture without grain leaves it as it is, however dark; in one with grain, the part
# that is lower than the mean is in the shade, be the texture dark or light.
bare="$square -q --camera 0,0,4:0,0,8 --size 64x64 --look watercolor --paper-grain 1"
for grey in 20 235; do
    perl "$TOP/tests/support/solid/make.pl" 8 grey:$grey >one$grey.ktx2
    $bare --solid one$grey.ktx2 -o bare.exr
    grey bare.exr
done >bare
is "watercolor: paper without grain" "$(tr '\n' ' ' <bare)" "1 1 "
for white in 777 fff; do
    solidgen --size 16 --set "color 0 000; color 1 $white" -o grain.ktx2
    $bare --solid grain.ktx2 -o bare.exr
    grey bare.exr
done | awk '{print ($1 > .93 && $1 < .97)}' >bare
is "watercolor: paper of dark and of light textures" "$(tr '\n' ' ' <bare)" "1 1 "

# A texture that reflects a half, in light that is 1 - tone of all, or with an ink lighter than the paper the tone.
for inks in white:black black:white grey:black,white; do
    IFS=: read -r paper ink <<END
$inks
END
    for tone in 0 .5 1; do
        $square -q --solid one.ktx2 --look plain --paper "$paper" --ink "$ink" --tone-range $tone:$tone -o square.exr
        printf '%.2f ' "$(grey square.exr)"
    done
done >plain
is "plain: a dark ink, a light one, and two" "$(cat plain)" "0.50 0.25 0.00 0.00 0.25 0.50 0.11 0.25 0.39 "
finish
