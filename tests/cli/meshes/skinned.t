# The units of a mesh are not those of its scene where a skin poses it: figures are in centimetres under a root in
# metres. Commands see what is drawn.
. "${TOP:-.}/tests/tap.sh"

# A glTF of a sphere with the skin of one joint, under a root with a scale, by which its mesh is divided: the world's
# sphere is the same, exactly with powers of two. Arguments: name, scale.
cat >make.pl <<'END_OF_SCRIPT'
use strict;
use warnings;
use MIME::Base64;
my ($name, $scale) = @ARGV;
my ($rows, $columns, $pi) = (40, 80, atan2(0, -1));
my (@at, @normals, @faces);
for my $row (0 .. $rows) {
    for my $column (0 .. $columns) {
        my ($u, $v) = (2 * $pi * $column / $columns, $pi * $row / $rows);
        my @normal = (sin($v) * cos $u, cos $v, -sin($v) * sin $u);
        push @normals, @normal;
        push @at, map { $_ / $scale } @normal;
        next if $row == $rows || $column == $columns;
        my $from = $row * ($columns + 1) + $column;
        my ($next, $below) = ($from + 1, $from + $columns + 1);
        push @faces, $from, $below, $next if $row > 0;
        push @faces, $next, $below, $below + 1 if $row < $rows - 1;
    }
}
my $count = @at / 3;
my ($bytes, @views, @accessors) = ('');
for (['VEC3', 5126, pack 'f<*', @at], ['VEC3', 5126, pack 'f<*', @normals], ['VEC4', 5121, "\0\0\0\0" x $count],
    ['VEC4', 5126, pack('f<4', 1, 0, 0, 0) x $count], ['SCALAR', 5125, pack 'V*', @faces]) {
    my ($type, $component, $packed) = @$_;
    push @accessors, sprintf '{"bufferView":%d,"componentType":%d,"count":%d,"type":"%s"}', scalar @views, $component,
        $type eq 'SCALAR' ? scalar @faces : $count, $type;
    push @views, sprintf '{"buffer":0,"byteOffset":%d,"byteLength":%d}', length $bytes, length $packed;
    $bytes .= $packed;
}
open my $out, '>', "$name.gltf" or die;
printf $out '{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],' .
    '"nodes":[{"children":[1,2],"scale":[%s]},{"mesh":0,"skin":0},{}],"skins":[{"joints":[2]}],' .
    '"meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1,"JOINTS_0":2,"WEIGHTS_0":3},"indices":4}]}],' .
    '"accessors":[%s],"bufferViews":[%s],' .
    '"buffers":[{"byteLength":%d,"uri":"data:application/octet-stream;base64,%s"}]}',
    join(',', ($scale) x 3), join(',', @accessors), join(',', @views), length $bytes, encode_base64($bytes, '');
END_OF_SCRIPT

below() {
    awk -v a="$1" -v b="$2" 'BEGIN {exit !(a <= b)}'
}
# faces SCALE: the faces that meshfit keeps of the sphere
faces() {
    meshfit -q --size 160x120 "$1.gltf" -o "$1.glb"
    hatchstat mesh -q "$1.glb" | awk -F'\t' 'NR == 1 {for (i = 1; i <= NF; i++) at[$i] = i} NR == 2 {print $at["faces"]}'
}
# displacement SCALE: what hatchstat measures of the sphere of scale 1 that meshfit has made, in pixels
displacement() {
    hatchstat coarse -q --size 160x120 "$1.gltf" "1.glb" | awk -F'\t' 'NR == 2 {printf "%.3f\n", $1}'
}
for scale in 1 0.0078125 128; do
    perl make.pl $scale $scale
done
kept=$(faces 1)
ok "meshfit makes a skinned sphere coarser" [ "$kept" -lt 3000 ]
moved=$(displacement 1)
for scale in 0.0078125 128; do
    is "as coarse where the root scales by $scale" "$(faces $scale)" "$kept"
    is "and hatchstat coarse measures it as it is drawn" "$(displacement $scale)" "$moved"
done

for scale in 1 0.0078125 128; do
    strokegen -q $scale.gltf -o strokes.glb
    render-gl -q strokes.glb -t traced --size 160x120 -o $scale.png
done
for scale in 0.0078125 128; do
    ok "its strokes are drawn the same where the root scales by $scale" \
        below "$(hatchstat diff -q 1.png $scale.png | awk 'NR == 2 {print $2}')" 1e-4
done
finish
