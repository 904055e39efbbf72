# Shadows and the light of a film: lamps near and far, wide soft edges, a ground between, exposure over all frames.
. "${TOP:-.}/tests/tap.sh"

# scene NAME 'KEY => VALUE, ...': writes NAME.gltf, a floor or ball with an optional plate above it and a lamp.
#   at     place of the lamp
#   plate  height of the plate
#   to     place to which the lamp moves within a second
#   up     height to which the floor or ball moves within a second; it is there from the start with still => 1
cat >scene.pl <<'END'
use strict;
use warnings;
use JSON::PP;
use MIME::Base64;
my %set = (at => [0, 2, 0], power => 40, turn => [-sqrt 0.5, 0, 0, sqrt 0.5], eval $ARGV[0]);
my $scene = decode_json(do { local $/; <STDIN> });
my @nodes = ({mesh => 0, rotation => $set{turn}}, {translation => $set{at},
    extensions => {KHR_lights_punctual => {light => 0}}});
$nodes[0]{translation} = [0, $set{up}, 0] if $set{still};
push @nodes, {mesh => 0, rotation => $set{turn}, translation => [0, $set{plate}, 0]} if $set{plate};
$scene->{nodes} = \@nodes;
$scene->{scenes} = [{nodes => [0 .. $#nodes]}];
$scene->{extensionsUsed} = ['KHR_lights_punctual'];
$scene->{extensions}{KHR_lights_punctual}{lights} = [{type => 'point', intensity => $set{power}}];
if ($set{to} || $set{up} && !$set{still}) {
    my @values = $set{to} ? (@{$set{at}}, @{$set{to}}) : (0, 0, 0, 0, $set{up}, 0);
    my $data = pack 'f<*', 0, 1, @values;
    push @{$scene->{buffers}}, {byteLength => length $data,
        uri => 'data:application/octet-stream;base64,' . encode_base64($data, '')};
    my $views = $scene->{bufferViews};
    push @$views, map { {buffer => $#{$scene->{buffers}}, byteOffset => $$_[0], byteLength => $$_[1]} } [0, 8], [8, 24];
    my $accessors = $scene->{accessors};
    push @$accessors, {bufferView => $#$views - 1, componentType => 5126, count => 2, type => 'SCALAR', min => [0],
        max => [1]}, {bufferView => $#$views, componentType => 5126, count => 2, type => 'VEC3'};
    $scene->{animations} = [{samplers => [{input => $#$accessors - 1, output => $#$accessors}],
        channels => [{sampler => 0, target => {node => $set{to} ? 1 : 0, path => 'translation'}}]}];
}
print encode_json($scene);
END
scene() {
    perl scene.pl "$2" <"${3:-plane}.gltf" >"$1.gltf"
}
for shape in plane sphere; do
    meshgen $shape --faces 800 -o $shape.glb
    unpack $shape.glb $shape
done
# mean SCENE OPTION ...: the mean light of a picture
mean() {
    file=$1
    shift
    render-gl -q -t gouraud --lines none --samples 1 --size 120x90 "$file.gltf" "$@" -o mean.exr
    hatchstat frames mean.exr mean.exr | awk 'NR == 2 {print $2}'
}
# near NAME GOT WANT OFF
near() {
    is "$1: $2 for $3" "$(awk -v got="$2" -v want="$3" -v off="$4" \
        'BEGIN {print (got != "" && (got - want) ^ 2 <= off ^ 2)}')" 1
}

# The floor is wholly under the plate, as wide as the soft edge may be.
scene plate 'at => [0, 0.9, 0], plate => 0.5'
under="--camera 0,0.2,3:0,0,0 --exposure .05"
dark=$(mean plate --shadows .03 $under)
for width in .1 .3 .5; do
    near "no light through a plate, edges of $width" "$(mean plate --shadows $width $under)" "$dark" .002
done
is "without shadows there is light" "$(mean plate --pixel-light $under | awk -v dark="$dark" '{print ($1 > dark + .02)}')" 1

# A ground hides the lamp under it, as it hides a sun from below.
scene below 'at => [0, -5, 0], power => 400' sphere
under="--ground 20 --from 0:10 --shadows .03"
near "no light through the ground" "$(mean below $under --exposure 1)" "$(mean below $under --light 0:-90)" .002

# The ground lies below the ball where the animation has taken it.
scene moved 'at => [3, 9, 3], up => 5, power => 900' sphere
scene still 'at => [3, 9, 3], up => 5, power => 900, still => 1' sphere
above="--ground 3 --shadows .03 --camera 0,8,8:0,5,0 --exposure .03"
near "the ground of an animated scene" "$(mean moved $above --time-s 1)" "$(mean still $above)" .0005

# The frame with the most light is exposed as it is alone, the others less.
scene coming 'at => [0, 12, 0], to => [0, 2, 0]'
alone=$(mean coming --from 0:50 --time-s 1)
render-gl -q -t gouraud --lines none --samples 1 --size 120x90 --from 0:50 --frames 3 --rate 2 coming.gltf -o film%d.exr
near "the last frame of a lamp that comes near" "$(hatchstat frames film2.exr film2.exr | awk 'NR == 2 {print $2}')" "$alone" .001
is "the first frame is darker" "$(hatchstat frames film0.exr film2.exr | awk 'NR > 1 {print $2}' | awk '
    {mean[NR] = $1} END {print (mean[1] < mean[2] - .1)}')" 1
finish
