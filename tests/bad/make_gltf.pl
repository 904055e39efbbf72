# Damaged GLB containers and glTF scenes, for make.pl.
use strict;
use warnings;
use JSON::PP ();
use MIME::Base64 qw(encode_base64);

my $U16 = 5123;
my $U32 = 5125;
my $FLOAT = 5126;
my $tetrahedron = 'faces=4,points=4,components=1,boundary_loops=0,euler=2,genus=0,contrary_edges=0';

# All inputs derive from a tetrahedron. Its buffer has 72 bytes: four positions and twelve 16-bit indices.
my @positions = (0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1);
my @corners = (0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3);

sub buffer {
    my ($positions, $corners) = @_;
    return pack('f<*', @{$positions // \@positions}) . pack('v*', @{$corners // \@corners});
}

sub scene {
    return {
        asset => {version => '2.0'},
        scene => 0,
        scenes => [{nodes => [0]}],
        nodes => [{mesh => 0}],
        meshes => [{primitives => [{attributes => {POSITION => 0}, indices => 1}]}],
        accessors => [
            {bufferView => 0, componentType => $FLOAT, count => 4, type => 'VEC3', min => [0, 0, 0],
                max => [1, 1, 1]},
            {bufferView => 1, componentType => $U16, count => 12, type => 'SCALAR'},
        ],
        bufferViews => [
            {buffer => 0, byteOffset => 0, byteLength => 48},
            {buffer => 0, byteOffset => 48, byteLength => 24},
        ],
        buffers => [{byteLength => 72}],
    };
}

# Encodes a scene; values that are references to strings are inserted as they are.
sub json {
    my ($scene) = @_;
    my %long = map { ref $scene->{$_} eq 'SCALAR' ? ($_ => ${$scene->{$_}}) : () } keys %$scene;
    my $text = JSON::PP->new->canonical->encode({%$scene, map { $_ => "<$_>" } keys %long});
    $text =~ s/"<$_>"/$long{$_}/ for keys %long;
    return $text;
}

sub chunk {
    my ($type, $bytes) = @_;
    $bytes .= ($type eq 'JSON' ? ' ' : "\0") x (-length($bytes) % 4);
    return pack('V', length $bytes) . $type . $bytes;
}

sub container {
    my $chunks = join '', @_;
    return 'glTF' . pack('VV', 2, 12 + length $chunks) . $chunks;
}

# glb NAME, EXPECT, WHAT, SAYS, SCENE, BUFFER, FIGURES
sub glb {
    my ($name, $expect, $what, $says, $scene, $buffer, $figures) = @_;
    my $bytes = container(chunk('JSON', json($scene)), chunk("BIN\0", $buffer // buffer()));
    add_input("gltf/$name.glb", $expect, $what, $says, $bytes, $figures);
}

# changed NAME, EXPECT, WHAT, SAYS, CHANGE, BUFFER, FIGURES: a GLB; CHANGE modifies the tetrahedron's scene in $_
sub changed {
    my ($name, $expect, $what, $says, $change, $buffer, $figures) = @_;
    local $_ = scene();
    $change->();
    glb($name, $expect, $what, $says, $_, $buffer, $figures);
}

# text SCENE, FROM => TO ...: a scene as text, with the buffer as a data URI; replaces FROM by TO in the text
sub text {
    my ($scene, %replaced) = @_;
    $scene->{buffers}[0]{uri} //= 'data:application/octet-stream;base64,' . encode_base64(buffer(), '');
    my $text = json($scene);
    for my $from (keys %replaced) {
        $text =~ s/\Q$from\E/$replaced{$from}/ or die "no $from in the scene\n";
    }
    return $text;
}

sub containers {
    my $json = chunk('JSON', json(scene()));
    my $bin = chunk("BIN\0", buffer());
    my $whole = container($json, $bin);
    my ($size, $json_end) = (length $whole, 12 + length $json);
    my @cuts = (['in-the-word', 1], ['behind-the-word', 4], ['in-the-header', 11], ['behind-the-header', 12],
        ['in-the-json-header', 16], ['behind-the-json-header', 20], ['behind-a-byte-of-json', 21],
        ['in-the-json', int $json_end / 2], ['behind-the-json', $json_end], ['in-the-bin-header', $json_end + 4],
        ['behind-the-bin-header', $json_end + 8], ['in-the-bin', $size - 30], ['before-the-last-byte', $size - 1]);
    for (@cuts) {
        my ($name, $at) = @$_;
        my $says = $at < 4 ? '-' : $at < 12 ? 'header' : "$size bytes.* $at";
        add_input("glb/truncated-$name.glb", 'ERR', "truncated after $at of $size bytes", $says, substr $whole, 0,
            $at);
        next if $at < 12;
        my $fitting = substr $whole, 0, $at;
        substr $fitting, 8, 4, pack 'V', $at;
        add_input("glb/truncated-$name-fitting.glb", 'ERR',
            "truncated after $at of $size bytes, as its header says",
            $at == $json_end ? '-' : 'chunk', $fitting);
    }
    # patched NAME, WHAT, SAYS, OFFSET, BYTES: the valid file with BYTES written at OFFSET
    my $patched = sub {
        my ($name, $what, $says, $offset, $bytes) = @_;
        my $file = $whole;
        substr $file, $offset, length $bytes, $bytes;
        add_input("glb/$name.glb", 'ERR', $what, $says, $file);
    };
    $patched->('magic-wrong', 'magic word glTG', '-', 3, 'G');
    $patched->("version-$_", "version $_", "glTF version $_, want 2", 4, pack 'V', $_) for 0, 1, 3, 4294967295;
    $patched->("length-$_", "the header says $_ bytes", "$_ bytes.* $size", 8, pack 'V', $_) for 0, 10, 13, 4294967295;
    $patched->('json-length-ffffffff', 'a JSON chunk of 2^32 - 1 bytes', 'chunk of 4294967295 bytes', 12, "\xff" x 4);
    $patched->('json-length-fffffffc', 'a JSON chunk of 2^32 - 4 bytes: with its place it wraps around',
        'chunk of 4294967292 bytes', 12, "\xfc\xff\xff\xff");
    $patched->('json-length-0', 'an empty JSON chunk', '-', 12, pack 'V', 0);
    $patched->('bin-length-fffffffc', 'a BIN chunk of 2^32 - 4 bytes', 'chunk of 4294967292 bytes', $json_end,
        "\xfc\xff\xff\xff");
    $patched->('bin-too-long', 'a BIN chunk that passes the end by four bytes', 'chunk of 76 bytes.* 72 ',
        $json_end, pack 'V', 76);
    $patched->('bin-too-short', 'a BIN chunk with a tail', '-', $json_end, pack 'V', 40);
    $patched->('bin-first', 'the first chunk is BIN', 'the first chunk is not JSON', 16, "BIN\0");
    $patched->('json-zero-bytes', 'zero bytes in the JSON', '-', 40, "\0" x 8);
    $patched->('json-not-utf8', 'bytes in a key that are not UTF-8', '-', 24, "\xff\xfe\xc0");
    add_input('glb/bin-twice.glb', 'ERR', 'two BIN chunks', 'BIN chunk', container($json, $bin, $bin));
    add_input('glb/no-chunks.glb', 'ERR', 'a correct header, and no chunk', 'chunk', container());
    add_input('glb/unknown-chunk.glb', 'OK', 'a chunk of an unknown type, which readers skip', '-',
        container($json, $bin, chunk('HTCH', 'anything')), $tetrahedron);
    add_input('glb/empty.glb', 'ERR', '0 bytes', 'empty', '');
    add_input('gltf/empty.gltf', 'ERR', '0 bytes', 'empty', '');
}

sub texts {
    my %whole = (
        'nested-100k' => ['100,000 nested arrays in extras', '"extras":' . '[' x 100_000 . ']' x 100_000,
            'nested'],
        'nested-200k' => ['200,000 nested objects in extras', '"extras":' . '{"a":' x 200_000 . '0' . '}' x 200_000,
            'nested'],
        'nested-open' => ['200,000 arrays that nothing closes', '"extras":' . '[' x 200_000, 'nested'],
    );
    for my $name (sort keys %whole) {
        my ($what, $extras, $says) = @{$whole{$name}};
        add_input("gltf/$name.gltf", 'EITHER', $what, $says, text({%{scene()}, asset => {version => '2.0', x => 0}},
            '"x":0' => $extras));
    }
    add_input('gltf/array.gltf', 'ERR', 'an array in place of an object', '-', '[{"asset":{"version":"2.0"}}]');
    add_input('gltf/brace.gltf', 'ERR', 'a lone brace', '-', '{');
    add_input('gltf/truncated.gltf', 'ERR', 'truncated in the middle', '-', substr text(scene()), 0, 300);
    add_input('gltf/string-open.gltf', 'ERR', 'a string without an end', '-', '{"asset":{"version":"2.0');
    add_input('gltf/only-asset.gltf', 'EITHER', 'nothing but the asset', 'no face', '{"asset":{"version":"2.0"}}');
    add_input('gltf/no-asset.gltf', 'ERR', 'no asset', 'asset', text({%{scene()}, asset => {}}));
    add_input('gltf/version-1.gltf', 'ERR', 'of glTF 1.0', 'glTF version 1.0',
        text({%{scene()}, asset => {version => '1.0'}}));
    # Counts of the positions, as text.
    for (['1e9', '1000000000', '1000000000 elements'], ['0', '0', 'count 0, want 1 to 2147483647'],
        ['negative', '-4', 'count is -4'], ['fraction', '4.5', 'count is 4.5'], ['1e300', '1e300', 'count is 1e300'],
        ['text', '"4"', 'count is .4'], ['2e9', '2147483647', '2147483647 elements']) {
        my ($name, $count, $says) = @$_;
        add_input("gltf/accessor-count-$name.gltf", 'ERR', "$count positions in 48 bytes", $says,
            text(scene(), '"count":4' => "\"count\":$count"));
    }
    for (['max', '4294967295'], ['2e9', '2147483647']) {
        my ($name, $count) = @$_;
        my $scene = scene();
        delete $scene->{accessors}[0]{bufferView};
        add_input("gltf/no-view-count-$name.gltf", 'ERR',
            "$count positions without a bufferView: zeros, as many as that",
            $name eq 'max' ? 'count is 4294967295' : '2147483647|memory|allowed|limit',
            text($scene, '"count":4' => "\"count\":$count"));
    }
    for (['offset-overflow', '"byteOffset":0', '"byteOffset":18446744073709551612',
        'byteOffset is 18446744073709551612'],
        ['offset-beyond', '"byteOffset":48', '"byteOffset":4096', '-'],
        ['view-length-1e300', '"byteLength":48', '"byteLength":1e300', 'byteLength is 1e300'],
        ['view-length-2e53', '"byteLength":48', '"byteLength":9007199254740992', '-'],
        ['view-beyond', '"byteLength":24', '"byteLength":25', '-'],
        ['buffer-length-2e53', '"byteLength":72', '"byteLength":9007199254740992', '-'],
        ['buffer-number', '"buffer":0', '"buffer":7', '-'],
        ['stride-too-small', '"byteLength":48', '"byteLength":48,"byteStride":4',
        'byteStride 4 is less than an element'],
        ['stride-huge', '"byteLength":48', '"byteLength":48,"byteStride":2147483644', '-'],
        ['component-type', '"componentType":5126', '"componentType":9999', '-'],
        ['type-unknown', '"type":"VEC3"', '"type":"VEC9"', '-'],
        ['position-vec2', '"type":"VEC3"', '"type":"VEC2"', 'POSITION'],
        ['position-u16', '"componentType":5126', '"componentType":5123', '-'],
        ['mode-99', '"indices":1', '"indices":1,"mode":99', 'mode 99'],
        ['mode-lines', '"indices":1', '"indices":1,"mode":1', 'no (visible )?faces'],
        ['mesh-number', '"nodes":[{"mesh":0}]', '"nodes":[{"mesh":9}]', 'mesh 9'],
        ['node-number', '"scenes":[{"nodes":[0]}]', '"scenes":[{"nodes":[3]}]', 'node 3'],
        ['scene-number', '"scene":0', '"scene":4', 'scene.* 4'],
        ['material-number', '"indices":1', '"indices":1,"material":2', 'material 2'],
        ['indices-number', '"indices":1', '"indices":11', 'accessor'],
        ['draco-required', '"asset":', '"extensionsRequired":["KHR_draco_mesh_compression"],"asset":',
            'KHR_draco_mesh_compression'],
        ['unknown-required', '"asset":', '"extensionsRequired":["HATCH_nowhere"],"asset":',
        'HATCH_nowhere'],
    ) {
        my ($name, $from, $to, $says) = @$_;
        my $expect = $name =~ /^(position-u16|mode-lines)$/ ? 'EITHER' : 'ERR';
        add_input("gltf/$name.gltf", $expect, "$to in place of $from", $says, text(scene(), $from => $to));
    }
}

sub companions {
    # one NAME, URI, WHAT, SAYS: a scene whose buffer has this URI
    my $one = sub {
        my ($name, $uri, $what, $says) = @_;
        my $scene = scene();
        $scene->{buffers}[0]{uri} = $uri;
        add_input("gltf/$name.gltf", 'ERR', $what, $says, json($scene));
    };
    my $leaves = "a buffer's URI leaves the folder: it must not be read";
    my $local = 'uri .*folder';
    $one->('uri-climbs', '../../../../../../../../etc/passwd', $leaves, $local);
    $one->('uri-climbs-later', 'data/../../outside.bin', $leaves, $local);
    $one->('uri-climbs-escaped', '%2e%2e/outside.bin', $leaves, "$local|outside.bin");
    $one->('uri-absolute', '/etc/passwd', $leaves, $local);
    $one->('uri-file', 'file:///etc/passwd', $leaves, $local);
    $one->('uri-network', 'http://example.org/outside.bin', "a buffer's URI leaves this machine", $local);
    $one->('uri-backslash', '..\\outside.bin', $leaves, $local);
    $one->('uri-empty', '', 'an empty URI', '-');
    $one->('uri-directory', 'folder.bin', 'the buffer is a directory', 'folder.bin: .*directory');
    $one->('companion-missing', 'missing.bin', 'the file of the buffer is missing',
        'missing.bin: .*no such file');
    $one->('companion-truncated', 'short.bin', 'the file of the buffer is a byte short',
        'short.bin .*71 .*72');
    $one->('companion-empty', 'empty.bin', 'the file of the buffer is empty', 'empty.bin .*0 ');
    $one->('data-uri-truncated', 'data:application/octet-stream;base64,AAAA', 'a data URI of three bytes', '-');
    $one->('data-uri-not-base64', 'data:application/octet-stream;base64,' . '%' x 96,
        'a data URI that is not base 64', '-');
    add_file('outside.bin', buffer());
    add_file('gltf/short.bin', substr buffer(), 0, 71);
    add_file('gltf/empty.bin', '');
    make_path("$main::folder/gltf/folder.bin");
}

sub nodes {
    my %lists = (
        'loop-self' => [{children => [0]}],
        'loop-two' => [{children => [1]}, {children => [0]}],
        'loop-behind-a-mesh' => [{mesh => 0, children => [1]}, {children => [2]}, {children => [3]},
        {children => [1]}],
        'two-parents' => [{children => [1, 2]}, {children => [3]}, {children => [3]}, {mesh => 0}],
        'child-twice' => [{children => [1, 1]}, {mesh => 0}],
        'child-number' => [{mesh => 0, children => [7]}],
        'child-number-2e9' => [{mesh => 0, children => [2_147_483_647]}],
    );
    for my $name (sort keys %lists) {
        changed("node-$name", 'ERR', 'nodes that are no tree', 'node|child', sub { $_->{nodes} = $lists{$name} });
    }
    changed('node-chain-100k', 'EITHER', '100,000 nodes, each the child of the one before', '-', sub {
        $_->{nodes} = \('[' . join('', map { "{\"children\":[$_]}," } 1 .. 99_999) . '{"mesh":0}]');
    }, undef, $tetrahedron);
    changed('node-flat-100k', 'OK', '100,000 empty nodes beside the mesh', '-', sub {
        $_->{nodes} = \('[{"mesh":0}' . ',{}' x 99_999 . ']');
        $_->{scenes} = \('[{"nodes":[' . join(',', 0 .. 99_999) . ']}]');
    }, undef, $tetrahedron);
    changed('instance-bomb-2e39', 'ERR', '40 nodes, each twice the child of the one before: 2^39 instances',
        'two parents', sub {
        $_->{nodes} = [(map { {children => [$_, $_]} } 1 .. 39), {mesh => 0}];
    });
    for (['no-view', {componentType => $FLOAT, count => 1_000_000_000, type => 'VEC3'}, '-'],
        ['count', {bufferView => 0, componentType => $FLOAT, count => 1_000_000_000, type => 'VEC3'},
        '1000000000 elements']) {
        my ($name, $accessor, $says) = @$_;
        changed("instances-1e9-$name", 'ERR', 'EXT_mesh_gpu_instancing of a thousand million', $says, sub {
            push @{$_->{accessors}}, $accessor;
            $_->{extensionsUsed} = ['EXT_mesh_gpu_instancing'];
            $_->{nodes}[0]{extensions} = {EXT_mesh_gpu_instancing => {attributes => {TRANSLATION => 2}}};
        });
    }
    changed('mirror', 'OK', 'a mirrored node: faces must be turned, so that normals point outwards', '-',
        sub { $_->{nodes}[0]{scale} = [-1, 1, 1] }, undef, "$tetrahedron,low_x=-1,high_x=0");
    glb('mirrored', 'OK', 'nothing: what a mirrored node is compared with', '-', scene(),
        buffer([map { $_ % 3 ? $positions[$_] : -$positions[$_] } 0 .. $#positions], [reverse @corners]),
        "$tetrahedron,low_x=-1,high_x=0");
    glb('sound', 'OK', 'nothing: what the others are made of', '-', scene(), undef, $tetrahedron);
    changed('scale-0', 'EITHER', 'a node that has no extent', '-', sub { $_->{nodes}[0]{scale} = [0, 0, 0] });
    changed('scale-overflow', 'ERR', 'eight nodes that each scale by 1e30: nothing finite is left',
        'node 1: .*finite', sub {
        $_->{nodes} = [(map { {children => [$_], scale => [1e30, 1e30, 1e30]} } 1 .. 8), {mesh => 0}];
    });
    changed('matrix-and-scale', 'EITHER', 'a node with a matrix and a scale', '-', sub {
        $_->{nodes}[0] = {mesh => 0, scale => [2, 2, 2], matrix => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]};
    });
    changed('matrix-short', 'ERR', 'a matrix of seven numbers', '-', sub { $_->{nodes}[0]{matrix} = [1 .. 7] });
}

sub numbers {
    my ($nan, $inf) = map { unpack 'f<', pack 'V', $_ } 0x7fc00000, 0x7f800000;
    for (['nan', 5, $nan], ['infinite', 0, $inf], ['minus-infinite', 11, -$inf]) {
        my ($name, $place, $value) = @$_;
        my @moved = @positions;
        $moved[$place] = $value;
        glb("position-$name", 'ERR', "a position that is $name", 'POSITION: element [0-9] .*finite', scene(),
            buffer(\@moved));
    }
    glb('position-all-infinite', 'ERR', 'every position is infinite', 'POSITION: element 0 .*finite', scene(),
        buffer([($inf) x 12]));
    for ([5121, 'C', 4, 255], [$U16, 'v', 4, 65535], [$U32, 'V', 4, 4294967295]) {
        my ($type, $letter, $beyond, $restart) = @$_;
        for (['oob', $beyond, "index $beyond .*4 vertices"], ['restart', $restart, 'primitive restart'],
            ['huge', $restart - 1, 'index ' . ($restart - 1) . ' .*4 vertices']) {
            my ($name, $index, $says) = @$_;
            changed("index-$name-$type", 'ERR', "index $index, four vertices, numbers of type $type", $says, sub {
                $_->{accessors}[1]{componentType} = $type;
                $_->{bufferViews}[1]{byteLength} = 12 * length pack $letter, 0;
                $_->{buffers}[0]{byteLength} = 48 + $_->{bufferViews}[1]{byteLength};
            }, pack('f<*', @positions) . pack("$letter*", @corners[0 .. 10], $index));
        }
    }
    changed('index-float', 'ERR', 'indices that are floats', '-', sub {
        $_->{accessors}[1] = {bufferView => 0, componentType => $FLOAT, count => 12, type => 'SCALAR'};
    });
    changed('index-count-11', 'ERR', 'eleven indices', '11 corners', sub { $_->{accessors}[1]{count} = 11 });
    for (['oob', [1, 9], 2, 2, 'sparse index 9 does not exist, there are 4 elements'],
        ['max', [1, 4294967295], 2, 2, 'sparse index 4294967295 does not exist, there are 4 elements'],
        ['count', [1, 2], 1_000_000_000, 2, 'sparse count 1000000000, want 1 to 4'], ['short', [1, 2], 4, 2, 'sparse'],
        ['view', [1, 2], 2, 17, '-']) {
        my ($name, $indices, $count, $view, $says) = @$_;
        changed("sparse-$name", 'ERR', "sparse positions: $name", $says, sub {
            push @{$_->{bufferViews}}, {buffer => 0, byteOffset => 72, byteLength => 8};
            $_->{buffers}[0]{byteLength} = 80;
            $_->{accessors}[0]{sparse} = {count => $count, indices => {bufferView => $view, componentType => $U32},
                values => {bufferView => 0}};
        }, buffer() . pack('V2', @$indices));
    }
    changed('no-position', 'ERR', 'a primitive with normals and no positions', 'no POSITION',
        sub { $_->{meshes}[0]{primitives}[0]{attributes} = {NORMAL => 0} });
    changed('normals-fewer', 'ERR', 'three normals of four vertices', '3 elements.* 4', sub {
        push @{$_->{accessors}}, {bufferView => 0, componentType => $FLOAT, count => 3, type => 'VEC3'};
        $_->{meshes}[0]{primitives}[0]{attributes}{NORMAL} = 2;
    });
    my $fewer = sub {
        push @{$_->{accessors}}, {bufferView => 0, componentType => $FLOAT, count => 3, type => 'VEC3'};
        $_->{meshes}[0]{primitives}[0]{targets} = [{POSITION => 2}];
    };
    changed('morph-fewer', 'ERR', 'a morph target of three vertices, which counts', '3 elements.* 4',
        sub { $fewer->(); $_->{meshes}[0]{weights} = [1] });
    changed('morph-unused', 'WARN', 'a morph target of three vertices, which does not count',
        'morph targets', $fewer);
    changed('skin-joint', 'ERR', "a skin whose joint is no node", '-', sub {
        $_->{skins} = [{joints => [5]}];
        $_->{nodes}[0]{skin} = 0;
    });
}

# Animated scale of a node, with invalid times or values.
sub animations {
    my $nan = unpack 'f<', pack 'V', 0x7fc00000;
    for (['negative', [-1, 0, 1, 2], 4, 'time 0 '],
        ['falling', [0, 2, 1, 3], 4, 'time 2 '],
        ['nan', [0, $nan, 1, 2], 4, 'time|finite'], ['fewer-values', [0, 1, 2, 3], 3, '-'],
        ['values-1e9', [0, 1, 2, 3], 1e9, '1000000000 elements']) {
        my ($name, $times, $values, $says) = @$_;
        changed("animation-$name", 'ERR', "key times or values: $name", $says, sub {
            push @{$_->{bufferViews}}, {buffer => 0, byteOffset => 72, byteLength => 16};
            $_->{buffers}[0]{byteLength} = 88;
            push @{$_->{accessors}}, {bufferView => 2, componentType => $FLOAT, count => 4, type => 'SCALAR'},
                {bufferView => 0, componentType => $FLOAT, count => $values, type => 'VEC3'};
            $_->{animations} = [{samplers => [{input => 2, output => 3}],
                channels => [{sampler => 0, target => {node => 0, path => 'scale'}}]}];
        }, buffer() . pack 'f<4', @$times);
    }
}

containers();
texts();
companions();
nodes();
numbers();
animations();
1;
