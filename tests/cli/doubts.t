# A mesh may hold things that are hardly ever meant: one warning per kind, with a count and what the command does about
# it.
. "${TOP:-.}/tests/tap.sh"

# A glTF of a tetrahedron, into NAME.gltf. Arguments: positions, normals, colours, texture coordinates and scale as Perl.
cat >make.pl <<'END'
use strict;
use warnings;
use MIME::Base64;
my ($name, %set) = @ARGV;
my $part = sub { my ($key, $default) = @_; [map { eval($_) } split / /, $set{$key} // $default] };
my $inside = $set{flip} ? '0 1 2 0 3 1 0 2 3 1 3 2' : '0 2 1 0 1 3 0 3 2 1 2 3';
my $s = 1 / sqrt 3;
my @at = ([POSITION => VEC3 => $part->('positions', '0 0 0 1 0 0 0 1 0 0 0 1')],
    [NORMAL => VEC3 => $part->('normals', "-$s -$s -$s 1 0 0 0 1 0 0 0 1")],
    [COLOR_0 => VEC4 => $part->('colors', '1 1 1 1 ' x 4)],
    [TEXCOORD_0 => VEC2 => $part->('texcoords', '0 0 1 0 0 1 1 1')]);
my ($bytes, @views, @accessors, @attributes) = pack 'S<12', split / /, $inside;
push @views, '{"buffer":0,"byteLength":24}';
push @accessors, '{"bufferView":0,"componentType":5123,"count":12,"type":"SCALAR"}';
for (@at) {
    my ($key, $type, $numbers) = @$_;
    push @attributes, sprintf '"%s":%d', $key, scalar @accessors;
    push @accessors, sprintf '{"bufferView":%d,"componentType":5126,"count":4,"type":"%s"}', scalar @views, $type;
    my $packed = pack 'f<*', @$numbers;
    push @views, sprintf '{"buffer":0,"byteOffset":%d,"byteLength":%d}', length $bytes, length $packed;
    $bytes .= $packed;
}
open my $out, '>', "$name.gltf" or die;
printf $out '{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"scale":[%s]}],' .
    '"meshes":[{"primitives":[{"attributes":{%s},"indices":0}]}],"accessors":[%s],"bufferViews":[%s],' .
    '"buffers":[{"byteLength":%d,"uri":"data:application/octet-stream;base64,%s"}]}',
    $set{scale} // '1,1,1', join(',', @attributes), join(',', @accessors), join(',', @views), length $bytes,
    encode_base64($bytes, '');
END

# doubt NAME COUNT TEXT KEY VALUE ...: checks that the mesh with this is warned of in one line, with COUNT and TEXT
doubt() {
    name=$1 count=$2 text=$3
    shift 3
    perl make.pl mesh "$@"
    try hatchstat mesh mesh.gltf
    [ "$(grep -c "warning: $count .*$text" .err)" = 1 ]
    is "$name: hatchstat mesh warns" "$? $status" "0 0"
    try render-gl mesh.gltf --technique gouraud --size 16x16 -o picture.png
    [ "$(grep -c "warning: $count .*$text" .err)" = 1 ]
    is "$name: render-gl warns" "$? $status" "0 0"
}
perl make.pl mesh
try hatchstat mesh mesh.gltf
is "a mesh without doubts" "$status $(cat .err)" "0 "
doubt "a colour that is NaN" 2 "read as 0" colors "'nan' 1 1 1 1 'inf' 1 1 1 1 1 1 1 1 1 1"
doubt "normals without length" 3 "replaced by those of faces" normals "0 0 0 0 0 0 0 0 0 0 0 1"
doubt "normals that are not unit vectors" 2 "only their directions are used" normals "-2 -2 -2 3 0 0 0 1 0 0 0 1"
doubt "normals that point inwards" 4 "point inwards" normals ".5774 .5774 .5774 -1 0 0 0 -1 0 0 0 -1"
doubt "a mesh that is inside out" 1 "inside out" flip 1
doubt "needles" 1 "needle" positions "0 0 0 1 0 0 0.5 .00001 0 0 0 1"
doubt "texture coordinates without extent" 1 "same texture coordinates" texcoords "1 1 1 1 1 1 1 1"
printf 'mtllib none.mtl other.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >mesh.obj
try hatchstat mesh mesh.obj
is "a missing material library" "$status $(cat .err)" \
    "0 hatchstat: mesh.obj: warning: material library none.mtl does not exist: materials of OBJ files are not used"
: >none.mtl
try hatchstat mesh mesh.obj
is "a material library that exists" "$status $(cat .err)" "0 "
mkdir far
sed "s|none.mtl other.mtl|$WORK/none.mtl|" mesh.obj >far/mesh.obj
try hatchstat mesh far/mesh.obj
is "a material library with a full path" "$status $(cat .err)" "0 "
: >'my mats.mtl'
sed 's/none.mtl other.mtl/my mats.mtl/' mesh.obj >spaced.obj
try hatchstat mesh spaced.obj
is "a material library with a space in its name" "$status $(cat .err)" "0 "
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\nf 2 4 3\n' >mesh.obj
try hatchstat mesh mesh.obj
is "texture coordinates of some faces" "$status $(cat .err)" \
    "0 hatchstat: mesh.obj: warning: 3 vertices have no texture coordinates: those of the others are not used
hatchstat: mesh.obj: warning: 2 vertices have the position of others and count as the same"
perl make.pl mesh
sed 's/data:application.octet-stream;/data:;/' mesh.gltf >untyped.gltf
try hatchstat mesh untyped.gltf
is "data without a media type" "$status $(cat .err)" "0 "
sed 's/"indices":0}\]/"indices":0,"targets":[{"NORMAL":2}]}],"weights":[0.5]/' mesh.gltf >moved.gltf
try hatchstat mesh moved.gltf
is "normals that a target at rest makes longer" "$status $(cat .err)" \
    "0 hatchstat: moved.gltf: warning: 1 mesh has morph targets that nothing moves: it stays as at rest"
sed 's/"indices":0}/"indices":0,"mode":0}/' mesh.gltf >points.gltf
try hatchstat mesh points.gltf
is "points alone" "$status $(cat .err)" "3 hatchstat: points.gltf: no faces, only 1 set of points or lines"
sed 's/"primitives":\[\(.*\)\]}\],"accessors"/"primitives":[\1,\1]}],"accessors"/' points.gltf >twice.gltf
try hatchstat mesh twice.gltf
is "points twice" "$status $(cat .err)" "3 hatchstat: twice.gltf: no faces, only 2 sets of points or lines"
perl make.pl mesh scale 1,0,1
try render-gl mesh.gltf --technique gouraud --size 16x16 -o picture.png
is "a node with a scale of 0" "$status $(grep -c 'warning: 1 node has a scale of 0: its meshes are flat' .err)" "0 1"
# Commands that write a scene again warn of what they lose.
perl make.pl mesh
perl -pe 's/"scenes":\[/"extensionsUsed":["VRM","KHR_materials_unlit","KHR_animation_pointer"],"images":[{"uri":"none.webp"},
    {"uri":"data:image\/png;base64,iVBORw0KGgoBAgM="}],$&\{},/; s/"scene":0/"scene":1/;
    s/"POSITION":1/$&,"_ID":5/;
    s/\],"bufferViews"/,{"bufferView":4,"componentType":5125,"count":4,"type":"SCALAR"}$&/' mesh.gltf >more.gltf
for command in dirfield meshfit strokegen; do
    try $command more.gltf -o copy.glb
    is "$command warns of what it loses" "$status $(grep -v -e 'no face can' -e 'principal direction' .err)" "0 \
$command: more.gltf: warning: 1 scene is left out: only the default one is read
$command: more.gltf: warning: 1 image is neither PNG nor JPEG nor WebP or could not be read, and is left out
$command: more.gltf: warning: 1 vertex attribute has integers over 16777216: they are rounded to floats
$command: more.gltf: warning: 2 extensions are left out: VRM, KHR_animation_pointer"
done
try lapped-param more.gltf -o copy.glb
is "lapped-param keeps no images" "$status $(grep -c -e 'scene is left' -e rounded -e VRM .err) $(grep -c image .err)" "0 3 0"
try hatchstat mesh more.gltf
is "hatchstat does not" "$status $(cat .err)" "0 "
for shape in teapot torus sphere saddle; do
    meshgen $shape --faces 2000 -o shape.glb
    try hatchstat mesh shape.glb
    is "$shape: no doubts" "$(grep -c -e normal -e needle -e inside -e coordinates .err)" 0
done
finish
