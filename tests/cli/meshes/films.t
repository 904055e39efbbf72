# Needs of films: faces that grow need what they need at their largest, in lengths at rest.
. "${TOP:-.}/tests/tap.sh"
[ -x "$BIN/render-gl" ] || { skip "needs of films" "no render-gl"; finish; }

meshgen plane --faces 200 -o plane.glb
unpack plane.glb plane
# grow FROM [X]: prints the mesh, whose scale is FROM at rest and at 0 s, and 1 at 1 s; beside it a second one at X
grow() {
    perl -MJSON::PP -MMIME::Base64 -e '
        my ($scale, $beside) = splice @ARGV, 0, @ARGV - 1;
        local $/;
        my $s = JSON::PP->new->decode(<>);
        my ($buffer, $view, $accessor) = map {scalar @{$s->{$_}}} qw(buffers bufferViews accessors);
        my $data = encode_base64(pack("f<*", 0, 1, ($scale) x 3, (1) x 3), "");
        push @{$s->{buffers}}, {byteLength => 32, uri => "data:application/octet-stream;base64,$data"};
        push @{$s->{bufferViews}}, {buffer => $buffer, byteLength => 8},
            {buffer => $buffer, byteOffset => 8, byteLength => 24};
        push @{$s->{accessors}},
            {bufferView => $view, componentType => 5126, count => 2, type => "SCALAR", min => [0], max => [1]},
            {bufferView => $view + 1, componentType => 5126, count => 2, type => "VEC3"};
        $s->{nodes}[0]{scale} = [($scale + 0) x 3];
        $s->{animations} = [{samplers => [{input => $accessor, output => $accessor + 1}],
            channels => [{sampler => 0, target => {node => 0, path => "scale"}}]}];
        if ($beside) {
            push @{$s->{meshes}}, $s->{meshes}[0];
            push @{$s->{nodes}}, {mesh => 1, translation => [$beside, 0, 0]};
            $s->{scenes}[0]{nodes} = [0, 1];
        }
        print JSON::PP->new->canonical->encode($s)' "$@" plane.gltf
}
# most FILE: prints the most pixels per unit, of tones and of regions
most() {
    awk -F'\t' '$1 ~ /unit-px$/ && $3 > most[$1] {most[$1] = $3}
        END {printf "%.0f %.0f\n", most["unit-px"], most["region-unit-px"]}' "$1"
}
# The square of side 2 fills a square picture from this distance.
front='--camera 0,0,3.7320508:0,0,0 --fov 30 --size 300x300'
for scale in .25 0; do
    grow $scale >grows.gltf
    # shellcheck disable=SC2086 # options are words
    render-gl -q grows.gltf $front --frames 2 --rate 1 --needs -o grows.needs
    # A unit of the plane itself has 150 pixels at 1 s.
    is "a plane of scale $scale at rest, at its largest" "$(most grows.needs)" \
        "$([ $scale = 0 ] && echo 150 150 || echo 600 600)"
done
grow .25 >grows.gltf
# shellcheck disable=SC2086
render-gl -q grows.gltf $front --needs -o rest.needs
is "the scene at rest" "$(most rest.needs)" "150 150"

# A sphere that grows from a point beside another gets strokes, and keeps its shape.
meshgen sphere --faces 2000 -o plane.glb
unpack plane.glb plane
grow .001 -2.4 >grows.gltf
near='--camera -1.2,0,10:-1.2,0,0 --fov 30 --size 160x120'
# shellcheck disable=SC2086
render-gl -q grows.gltf $near --frames 2 --rate 1 --needs -o grows.needs
strokegen -q --needs grows.needs grows.gltf -o fitted.glb
strokegen -q grows.gltf -o whole.glb
for file in fitted whole; do
    # shellcheck disable=SC2086
    render-gl $file.glb $near --frames 2 --rate 1 -t traced --lines none -o $file%d.png 2>said
    is "$file: no mesh is blank" "$(cat said)" ""
done
is "it has the tone of a sphere whose strokes and faces are all there" "$(hatchstat diff fitted1.png whole1.png |
    awk 'NR == 2 {print ($3 > -.003 && $3 < .003) ? 1 : $3}')" 1

# No finer strokes can be traced where skins or morph targets, here one that makes it larger, deform a mesh.
meshgen torus --faces 800 -o plane.glb
unpack plane.glb plane
grow 1 >torus.gltf
sed 's/"POSITION":\([0-9]*\)[^}]*}/&,"targets":[{"POSITION":\1}]/; s/"path":"scale"/"path":"weights"/
    s/"input":\([0-9]*\),"output":[0-9]*/"input":\1,"output":\1/' torus.gltf >morph.gltf
for mesh in torus morph; do
    render-gl $mesh.gltf --size 80x60 --needs -o $mesh.needs
    strokegen -q --needs $mesh.needs $mesh.gltf -o $mesh.fitted.glb
    ok "$mesh: the view is drawn" render-gl -q $mesh.fitted.glb -t traced --size 80x60 -o x.png
    ok "one that is a little nearer, too" render-gl -q $mesh.fitted.glb -t traced --size 96x72 -o x.png
done
ok "finer strokes are traced on a rigid mesh" render-gl -q torus.fitted.glb -t traced --size 240x180 -o x.png
rm x.png
try render-gl -q morph.fitted.glb -t traced --size 240x180 -o x.png
refused "not on one that is deformed" 3 1
is "which is told" "$(sed 's/: [0-9.]* % of/: X of/' .err)" "render-gl: morph.fitted.glb: was made for surfaces seen from farther away: X of \
this view needs finer strokes, and none can be traced on skins and morph targets; make it again with the needs of this view"
ok "and leaves no file" test ! -e x.png
strokegen -q --levels 3 morph.gltf -o morph.plain.glb
ok "strokes that were made for any view are drawn in any" \
    render-gl -q morph.plain.glb -t traced --size 240x180 -o x.png
render-gl morph.gltf --size 240x180 --needs -o morph.needs
strokegen -q --needs morph.needs morph.gltf -o morph.fitted.glb
ok "with the needs of the view it is drawn" render-gl -q morph.fitted.glb -t traced --size 240x180 -o x.png
finish
