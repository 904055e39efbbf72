#!/usr/bin/env perl
# scenes.pl: writes small scenes and meshes into the working folder for runs.sh, with features of glTF and other formats
# that meshgen does not write.
use strict;
use warnings;
use Compress::Zlib;
use JSON::PP;

my $json = JSON::PP->new->canonical;
my $pi = 4 * atan2 1, 1;

sub write_file {
    my ($name, @parts) = @_;
    open my $file, '>:raw', $name or die "$name: $!\n";
    print $file @parts;
    close $file or die "$name: $!\n";
}

# png WIDTH HEIGHT CHANNELS TEXEL: the bytes of a PNG; TEXEL returns the channels at x and y
sub png {
    my ($wide, $high, $channels, $texel) = @_;
    my $rows = '';
    for my $y (0 .. $high - 1) {
        $rows .= "\0" . join '', map { pack 'C*', map { int } $texel->($_, $y) } 0 .. $wide - 1;
    }
    my $chunk = sub { pack('N', length $_[1]) . $_[0] . $_[1] . pack 'N', crc32($_[0] . $_[1]) };
    my $kind = {1 => 0, 2 => 4, 3 => 2, 4 => 6}->{$channels};
    return "\x89PNG\r\n\x1a\n" . $chunk->('IHDR', pack 'N2C5', $wide, $high, 8, $kind, 0, 0, 0)
        . $chunk->('IDAT', compress($rows)) . $chunk->('IEND', '');
}

# Buffer views and accessors of the scenes; their data are in scenes.bin.
my $bytes = '';
my (@views, @accessors);
my %width = (SCALAR => 1, VEC2 => 2, VEC3 => 3, VEC4 => 4, MAT4 => 16);
my %component = ('f<' => 5126, 'S<' => 5123, 's<' => 5122, 'C' => 5121, 'c' => 5120);

# put TYPE CODE NUMBER ...: adds an accessor with these numbers; CODE is a template of pack
sub put {
    my ($type, $code, @numbers) = @_;
    my $data = pack "$code*", @numbers;
    push @views, {buffer => 0, byteOffset => length $bytes, byteLength => length $data};
    $bytes .= $data . "\0" x (-length($data) % 4);
    push @accessors, {bufferView => $#views, componentType => $component{$code}, type => $type,
        count => @numbers / $width{$type}};
    return $#accessors;
}

sub unit {
    my $length = sqrt($_[0]**2 + $_[1]**2 + $_[2]**2) || 1;
    return map { $_ / $length } @_;
}

# grid WIDE HIGH PLACE: points, normals, texture coordinates and corners of a surface over the unit square
sub grid {
    my ($wide, $high, $place) = @_;
    my %grid = (points => [], normals => [], texcoords => [], corners => []);
    for my $j (0 .. $high) {
        for my $i (0 .. $wide) {
            my ($u, $v) = ($i / $wide, $j / $high);
            my @at = $place->($u, $v);
            my @du = map { ($place->($u + 1e-3, $v))[$_] - $at[$_] } 0 .. 2;
            my @dv = map { ($place->($u, $v + 1e-3))[$_] - $at[$_] } 0 .. 2;
            push @{$grid{points}}, @at;
            push @{$grid{normals}}, unit(map { $du[($_ + 1) % 3] * $dv[($_ + 2) % 3]
                    - $du[($_ + 2) % 3] * $dv[($_ + 1) % 3] } 0 .. 2);
            push @{$grid{texcoords}}, $u, $v;
            next if $i == $wide || $j == $high;
            my $first = $j * ($wide + 1) + $i;
            push @{$grid{corners}}, $first, $first + 1, $first + $wide + 2, $first, $first + $wide + 2,
                $first + $wide + 1;
        }
    }
    return \%grid;
}
sub hill { return (2 * $_[0] - 1, 2 * $_[1] - 1, 0.35 * cos(3 * $_[0] - 1) * cos(4 * $_[1] - 2)) }
sub tube {
    my ($turn, $thick) = (2 * $pi * $_[0], 0.4 + 0.1 * cos(9 * $_[1]));
    return ($thick * sin $turn, 3 * $_[1] - 1.5, $thick * cos $turn);
}
my $hill = grid(14, 12, \&hill);
my $tube = grid(20, 16, \&tube);

# primitive GRID MATERIAL ATTRIBUTE ...
sub primitive {
    my ($grid, $material, %more) = @_;
    $grid->{accessors} ||= {POSITION => put('VEC3', 'f<', @{$grid->{points}}),
        NORMAL => put('VEC3', 'f<', @{$grid->{normals}}), TEXCOORD_0 => put('VEC2', 'f<', @{$grid->{texcoords}})};
    $grid->{indices} ||= put('SCALAR', 'S<', @{$grid->{corners}});
    return {attributes => {%{$grid->{accessors}}, %more}, indices => $grid->{indices},
        defined $material ? (material => $material) : ()};
}

my @scenes;
# scene NAME NODES MORE ...: writes a scene; its roots are the nodes that are no node's child
sub scene {
    my ($name, $nodes, %more) = @_;
    my %child = map { $_ => 1 } map { @{$_->{children} || []} } @$nodes;
    push @scenes, [$name, {asset => {version => '2.0'}, scene => 0, nodes => $nodes,
        scenes => [{nodes => [grep { !$child{$_} } 0 .. $#$nodes]}], %more}];
}
sub mesh { return {primitives => [@_]} }

# A colour texture, one with holes, and a normal map, all asymmetric so that their orientation shows.
write_file('texture.png', png(48, 32, 3, sub {
    my ($x, $y) = @_;
    return (255 * $x / 47, (($x >> 3) + ($y >> 3)) % 2 ? 230 : 60, 255 * $y / 31);
}));
write_file('holes.png', png(32, 32, 4, sub {
    my ($x, $y) = @_;
    return (200, 120 + 4 * $y, 90, 127.5 + 127 * sin($x * $pi / 4) * sin($y * $pi / 5));
}));
write_file('ridges.png', png(64, 8, 3, sub { return (127.5 + 90 * sin($_[0] * $pi / 8), 128, 218) }));
write_file('grey.png', png(16, 16, 1, sub { return 16 * ($_[0] ^ $_[1]) }));
my @images = (images => [map { {uri => "$_.png"} } qw(texture holes ridges)],
    samplers => [{wrapS => 33648, wrapT => 33071}],
    textures => [{source => 0}, {source => 1}, {source => 2}, {source => 0, sampler => 0}]);
sub colored {
    my ($texture, %more) = @_;
    return {pbrMetallicRoughness => {baseColorTexture => {index => $texture}, %more}};
}

scene('textured', [{mesh => 0}, {mesh => 1, translation => [2.2, 0, 0]}, {mesh => 2, translation => [-2.2, 0, 0]}],
    meshes => [map { mesh(primitive($hill, $_)) } 0 .. 2], @images, materials => [
        colored(0, baseColorFactor => [1, 0.8, 0.9, 1]), {doubleSided => JSON::PP::true,
            pbrMetallicRoughness => {baseColorFactor => [0.5, 0.4, 0.2, 1]}},
        {pbrMetallicRoughness => {baseColorTexture => {index => 3, extensions => {KHR_texture_transform =>
            {scale => [3, 2], rotation => 0.4, offset => [0.1, 0.2]}}}}}]);
scene('masked', [{mesh => 0, translation => [0, 0, 1]}, {mesh => 1}, {mesh => 2, translation => [1.2, 0, 0.3]}],
    meshes => [mesh(primitive($hill, 0)), mesh(primitive($tube, 1)), mesh(primitive($hill, 2))], @images,
    materials => [{%{colored(1)}, alphaMode => 'MASK', alphaCutoff => 0.4, doubleSided => JSON::PP::true},
        colored(0), {%{colored(1, baseColorFactor => [1, 1, 1, 0.9])}, alphaMode => 'BLEND'}]);
scene('glass', [{mesh => 0}, {mesh => 1, translation => [0, 0, -1]}], meshes => [mesh(primitive($hill, 0)),
        mesh(primitive($tube, 1))], materials => [{alphaMode => 'BLEND', pbrMetallicRoughness =>
            {baseColorFactor => [1, 1, 1, 0.3]}}, {}]);
scene('bumpy', [{mesh => 0}, {mesh => 1, translation => [2, 0, 0], rotation => [0, 0.38268343, 0, 0.92387953]}],
    meshes => [mesh(primitive($hill, 0)), mesh(primitive($tube, 1, TANGENT => put('VEC4', 'f<',
        map { (unit(cos 2 * $pi * $_, 0, -sin 2 * $pi * $_), 1) } map { $tube->{texcoords}[2 * $_] }
        0 .. @{$tube->{texcoords}} / 2 - 1)))], @images, materials => [{normalTexture => {index => 2, scale => 0.7,
            extensions => {KHR_texture_transform => {scale => [2, 1], rotation => 0.3}}}},
        {%{colored(0)}, normalTexture => {index => 2}}]);

# A tube bent by three joints, one for each kind of interpolation, with a normal map.
my @heights = map { $tube->{texcoords}[2 * $_ + 1] } 0 .. @{$tube->{texcoords}} / 2 - 1;
my $bent = primitive($tube, 0, JOINTS_0 => put('VEC4', 'C', map { (0, 1, 2, 0) } @heights),
    WEIGHTS_0 => put('VEC4', 'f<', map { !$_ ? (0) x 4 : $_ < 0.5 ? (1 - 2 * $_, 2 * $_, 0, 0)
        : (0, 2 - 2 * $_, 2 * $_ - 1, 0) } @heights));
my @bind = map { (1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, $_, 0, 1) } 1.5, 0, -1.5;
my $times = put('SCALAR', 'f<', 0, 0.5, 1);
my @turns = map { (0, 0, sin $_, cos $_) } 0, 0.4, -0.2;
scene('skinned', [{mesh => 0, skin => 0}, {children => [2], translation => [0, -1.5, 0]},
        {children => [3], translation => [0, 1.5, 0]}, {translation => [0, 1.5, 0]}],
    meshes => [mesh($bent)], skins => [{joints => [1, 2, 3], inverseBindMatrices => put('MAT4', 'f<', @bind)}],
    materials => [{%{colored(0)}, normalTexture => {index => 2}}], @images, animations => [{channels => [
            {sampler => 0, target => {node => 2, path => 'rotation'}},
            {sampler => 1, target => {node => 3, path => 'translation'}},
            {sampler => 2, target => {node => 1, path => 'scale'}}], samplers => [
            {input => $times, output => put('VEC4', 'f<', @turns)},
            {input => $times, interpolation => 'CUBICSPLINE', output => put('VEC3', 'f<',
                map { (0, 0, 0, @$_, 1, 0, 0) } [0, 1.5, 0], [0.4, 1.7, 0.2], [0, 1.2, -0.3])},
            {input => $times, interpolation => 'STEP', output => put('VEC3', 'f<', (1) x 3, (1.1) x 3, (0.9) x 3)}]},
        {channels => [{sampler => 0, target => {node => 0, path => 'translation'}}],
            samplers => [{input => $times, output => put('VEC3', 'f<', 0, 0, 0, 1, 0, 0, 0, 1, 0)}]}]);

# A hill shaped by two morph targets, at rest and animated.
my @count = 0 .. @{$hill->{points}} / 3 - 1;
my $shaped = {%{primitive($hill)}, targets => [{POSITION => put('VEC3', 'f<', map { (0, 0, sin $_ / 9) } @count),
        NORMAL => put('VEC3', 'f<', map { (0.2 * cos($_ / 9), 0, 0) } @count)},
    {POSITION => put('VEC3', 'f<', map { (0, 0.3 * cos($_ / 40), 0) } @count)}]};
scene('morphs', [{mesh => 0}, {mesh => 0, translation => [2.3, 0, 0], weights => [0.2, 1]}],
    meshes => [{primitives => [$shaped], weights => [0.7, 0.1]}], animations => [{
        channels => [{sampler => 0, target => {node => 0, path => 'weights'}}],
        samplers => [{input => $times, output => put('SCALAR', 'f<', 0, 0, 1, 0.5, 0, 1)}]}]);

# Nodes that mirror, with a matrix, with parents, and with shared meshes; normalised integers; strips.
my @places = (put('VEC3', 'f<', -2, 0, 0, 2, 0, 1, 0, 2, 0),
    put('VEC4', 'f<', 0, 0, 0, 1, 0, 0.6, 0, 0.8, 0.6, 0, 0, 0.8));
my $small = {attributes => {POSITION => put('VEC3', 's<', -900, -900, 0, 900, -900, 300, -900, 900, 300, 900, 900, 0),
        NORMAL => put('VEC3', 'f<', (0, 0, 1) x 4), TEXCOORD_0 => put('VEC2', 'S<', 0, 65535, 65535, 65535, 0, 0,
            65535, 0)}, mode => 5, material => 0};
$accessors[$small->{attributes}{POSITION}]{normalized} = JSON::PP::false;
$accessors[$small->{attributes}{TEXCOORD_0}]{normalized} = JSON::PP::true;
scene('nodes', [{mesh => 0, scale => [-1, 1, 1]}, {mesh => 0, children => [2], matrix => [0.6, 0, 0.8, 0, 0, 1, 0, 0,
            -0.8, 0, 0.6, 0, 3, 0, 0, 1]}, {mesh => 1, translation => [0, 1, 0.5], scale => [0.5, 0.7, -0.5]},
        {mesh => 2, scale => [0.001, 0.001, 0.001], translation => [-3, 0, 0]},
        {mesh => 1, translation => [0, -4, 0], extensions => {EXT_mesh_gpu_instancing => {attributes =>
            {TRANSLATION => $places[0], ROTATION => $places[1]}}}}, {mesh => 3, rotation => [0, 1, 0, 0],
            translation => [6, 0, 0]}],
    meshes => [mesh(primitive($tube, 1), primitive($hill, 0)), mesh(primitive($tube)), mesh($small),
        mesh(primitive($hill, 1))], materials => [{doubleSided => JSON::PP::true}, {}],
    extensionsUsed => ['EXT_mesh_gpu_instancing', 'KHR_mesh_quantization']);

# Cameras, one of which moves; lamps alone, together, and more than the limit.
scene('cameras', [{mesh => 0}, {mesh => 1, translation => [0.5, 0, -2]}, {camera => 0, translation => [0.3, 0.2, 4]},
        {camera => 1, translation => [1, 0.5, 3], rotation => [-0.05, 0.15, 0, 0.9873]}],
    meshes => [mesh(primitive($tube)), mesh(primitive($hill))], cameras => [
        {type => 'perspective', perspective => {yfov => 0.6, aspectRatio => 1.6, znear => 0.1, zfar => 40}},
        {type => 'orthographic', orthographic => {xmag => 2, ymag => 1.8, znear => 0.1, zfar => 20}}],
    animations => [{channels => [{sampler => 0, target => {node => 2, path => 'translation'}}],
        samplers => [{input => $times, output => put('VEC3', 'f<', 0.3, 0.2, 4, 1, 0.4, 3.5, -1, 0, 3)}]}]);
my %lamp = (
    sun => {type => 'directional', intensity => 3, color => [1, 0.9, 0.7]},
    point => {type => 'point', intensity => 40, range => 9},
    spot => {type => 'spot', intensity => 90, spot => {innerConeAngle => 0.2, outerConeAngle => 0.5}});
my %lamps = (sun => ['sun'], point => ['point'], spot => ['spot'], all => [qw(sun point spot)],
    far => [qw(sun point)], many => [('point', 'spot') x 35]);
for my $name (sort keys %lamps) {
    my @lit = @{$lamps{$name}};
    my @nodes = ({mesh => 0}, {mesh => 1, translation => [0, 0, -1]});
    for my $i (0 .. $#lit) { # lamps above the tube at different places
        my ($across, $up, $away) = $name eq 'far' ? (0, -sqrt 0.5, 1e8) : (0.2 * cos $i, -0.21, 1);
        push @nodes, {translation => [2 * cos $i, (1.5 + 0.01 * $i) * $away, 3 + sin $i],
            rotation => [$up, $across, 0, sqrt 1 - $up**2 - $across**2],
            extensions => {KHR_lights_punctual => {light => $i}}};
    }
    scene("lamps-$name", \@nodes, meshes => [mesh(primitive($tube)), mesh(primitive($hill))],
        extensionsUsed => ['KHR_lights_punctual'], extensions => {KHR_lights_punctual => {lights => [@lamp{@lit}]}});
}
# Defects of modelling programs: unwelded faces, T-junctions, edges inside other faces, constant texture coordinates.
my @loose = ([0, 0, 0], [0, 2, 0], [-2, 1, 0.5], [0, 0, 0], [2, 0.5, 0], [0, 1, 0], [0, 1, 0], [2, 1.5, 0.5], [0, 2, 0],
    [0, 3, 0], [1, 3, 0], [0.5, 4, 0], [0, 3, 0], [1, 2.5, 0], [1, 3.6, 0], [1, 3, 0], [0, 3.5, 0], [0, 2.6, 0]);
my %loose = (POSITION => put('VEC3', 'f<', map { @$_ } @loose));
scene('loose', [{mesh => 0}, {mesh => 1, translation => [0, 0, -2]}], meshes => [
    mesh({attributes => {%loose, TEXCOORD_0 => put('VEC2', 'f<', map { @$_[0, 1] } @loose)}}),
    mesh({attributes => {%loose, TEXCOORD_0 => put('VEC2', 'f<', map { (0.5, 0.5) } @loose)}})]);
scene('empty', [{translation => [0, 0, 0]}]);

write_file('scenes.bin', $bytes);
for (@scenes) {
    my ($name, $made) = @$_;
    write_file("$name.gltf", $json->encode({%$made, buffers => [{uri => 'scenes.bin', byteLength => length $bytes}],
        bufferViews => \@views, accessors => \@accessors}));
}

# A ring of quadrangles, closed in one direction, in each mesh format.
my $ring = grid(9, 4, sub { return tube(@_) });
my @points = map { [@{$ring->{points}}[3 * $_ .. 3 * $_ + 2]] } 0 .. @{$ring->{points}} / 3 - 1;
my @faces = map { my $i = $_; [map { $ring->{corners}[3 * $i + $_] } 0 .. 2] } 0 .. @{$ring->{corners}} / 3 - 1;
my @quads = map { [@{$faces[2 * $_]}, $faces[2 * $_ + 1][2]] } 0 .. @faces / 2 - 1;
my ($points, $faces, $quads) = map { scalar @$_ } \@points, \@faces, \@quads;
my $rows = sub { join '', map { join(' ', @$_) . "\n" } @_ };
write_file('ring.obj', (map { "v @$_\n" } @points), (map { my $i = 2 * $_; "vt @{$ring->{texcoords}}[$i, $i + 1]\n" }
        0 .. $points - 1), (map { my $i = 3 * $_; "vn @{$ring->{normals}}[$i .. $i + 2]\n" } 0 .. $points - 1),
    "g one\n", map { 'f ' . join(' ', map { my $n = $_ + 1; "$n/$n/$n" } @$_) . "\n" } @quads);
write_file('bare.obj', (map { "v @$_\n" } @points), map { 'f ' . join(' ', map { $_ - $points } @$_) . "\n" } @faces);
write_file('ring.off', "OFF\n$points $quads 0\n", $rows->(@points), $rows->(map { [4, @$_] } @quads));
my $head = sub { "ply\nformat $_[0] 1.0\ncomment a ring\nelement vertex $points\nproperty float x\nproperty float y\n"
    . "property float z\nproperty uchar red\nelement face $quads\nproperty list uchar int vertex_indices\n"
    . "end_header\n" };
write_file('ascii.ply', $head->('ascii'), $rows->(map { [@$_, 9] } @points), $rows->(map { [4, @$_] } @quads));
for (['little', '<'], ['big', '>']) {
    my ($end, $way) = @$_;
    write_file("$end.ply", $head->("binary_${end}_endian"), (map { pack "f${way}3C", @$_, 9 } @points),
        map { pack "CL${way}4", 4, @$_ } @quads);
}
write_file('binary.stl', pack('A80V', 'a ring', $faces),
    map { pack 'f<12S<', 0, 0, 1, (map { @{$points[$_]} } @$_), 0 } @faces);
write_file('text.stl', "solid ring\n", (map { ("facet normal 0 0 1\nouter loop\n",
    (map { "vertex @{$points[$_]}\n" } @$_), "endloop\nendfacet\n") } @faces), "endsolid ring\n");
# Meshes far from the origin, with every fault at once, and one-sided.
write_file('far.obj', (map { "v " . join(' ', $_->[0] + 1e6, $_->[1] - 3e6, $_->[2]) . "\n" } @points),
    map { 'f ' . join(' ', map { $_ + 1 } @$_) . "\n" } @quads);
write_file('faulty.obj', (map { "v @$_\n" } @points), "v 9 9 9\n", (map { 'f ' . join(' ', map { $_ + 1 }
    $_ % 5 ? @{$faces[$_]} : reverse @{$faces[$_]}) . "\n" } 0 .. $faces - 1), "f 1 2 2\nf 1 2 12\n",
    "f 1 2 40\nf 1 2 30\n");
my @strip = map { my $t = $pi * $_ / 12; map { [(2 + $_ * cos $t) * cos(2 * $t), (2 + $_ * cos $t) * sin(2 * $t),
    $_ * sin $t] } -0.5, 0.5 } 0 .. 11;
write_file('moebius.off', "OFF\n24 12 0\n", $rows->(@strip), $rows->(map { my $i = 2 * $_;
    $_ < 11 ? [4, $i, $i + 2, $i + 3, $i + 1] : [4, 22, 1, 0, 23] } 0 .. 11));
