# Damaged OBJ, PLY, OFF and STL files, for make.pl.
use strict;
use warnings;

# Vertices and outward facing quadrangles of the unit cube.
my @cube = map { my $i = $_; [map { ($i >> $_) & 1 } 2, 1, 0] } 0 .. 7;
my @sides = ([0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]);
my $cube = 'faces=12,points=8,components=1,boundary_loops=0,euler=2,contrary_edges=0,area=6';
my $inf = 9**9**9;
my $nan = unpack 'f<', pack 'V', 0x7fc00000;

sub obj {
    my ($name, $expect, $what, $says, $text, $figures) = @_;
    add_input("obj/$name.obj", $expect, $what, $says, $text, $figures);
}

sub vertices {
    return join '', map { "v @$_\n" } @cube;
}

sub faces {
    return join '', map { 'f ' . join(' ', map { $_ + 1 } @$_) . "\n" } @_;
}

sub objs {
    for (['zero', 0], ['oob', 9], ['oob-2e9', 2_000_000_000], ['oob-2e32', 4_294_967_297],
        ['oob-1e30', '1' . '0' x 30],
        ['before-the-first', -9], ['fraction', 1.5], ['word', 'one']) {
        my ($name, $index) = @$_;
        obj("index-$name", 'ERR', "a face of vertex $index, there are eight",
            "line 15: corner $index: vertex $index .*8",
            vertices() . faces(@sides) . "f 1 2 $index\n");
    }
    obj('index-texture', 'ERR', 'a texture coordinate that is not there', 'corner 2/3: texture coordinate 3 ',
        vertices() . "vt 0 0\nf 1/1 2/3 3/1\n");
    obj('index-normal', 'ERR', 'a normal that is not there', 'corner 2//7: normal 7 ', vertices() .
        "vn 0 0 1\nf 1//1 2//7 3//1\n");
    obj('four-parts', 'ERR', 'a corner of four indices', '1/1/1/1.* three', vertices() .
        "vt 0 0\nvn 0 0 1\nf 1/1/1/1 2/1/1/1 3/1/1/1\n");
    for my $word (split " ", "nan -nan NaN inf -inf +Inf Infinity 1e999 -1e39 0x10 1,5 --1 1e") {
        my $name = $word =~ tr/,+/cp/r;
        obj("coordinate-$name", 'ERR', "a coordinate is $word", 'line 3: v: ',
            "v 0 0 0\nv 1 0 0\nv 0 $word 0\nf 1 2 3\n");
    }
    obj('coordinates-two', 'ERR', 'a vertex of two coordinates', 'line 2: v',
        "v 0 0 0\nv 1 0\nv 0 1 0\nf 1 2 3\n");
    obj('no-corners', 'ERR', 'a face without a corner', 'line 4: .*corners',
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf\n");
    obj('two-corners', 'EITHER', 'a face of two corners beside one of three', '-',
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\nf 1 2 3\n");
    obj('no-faces', 'ERR', 'vertices alone', 'no faces.* 8 ', vertices());
    obj('no-vertices', 'ERR', 'a face and no vertices', 'line 1: corner 1: vertex 1 ', "f 1 2 3\n");
    obj('empty', 'ERR', '0 bytes', 'empty', '');
    obj('comment', 'ERR', 'a comment alone', 'no faces', "# a comment\n");
    obj('one-newline', 'ERR', 'a newline alone', 'no faces', "\n");
    obj('unknown-word', 'ERR', 'a line of another format', 'line 9: .*curve', vertices() .
        "curve 1 2 3\nf 1 2 3\n");
    obj('free-form', 'WARN', 'a free-form curve beside a cube', '1 free-form curve', vertices() .
        "cstype bspline\ncurv2 1 2 3\nend\n" . faces(@sides), $cube);
    obj('zero-bytes', 'ERR', 'a thousand zero bytes', '-', "\0" x 1000);
    obj('binary', 'ERR', 'bytes that are no text', '-', pack 'C*', map { ($_ * $_ * 13 + 128) & 255 } 0 .. 999);
    obj('long-word', 'ERR', 'a word of a million bytes', 'line 1', 'x' x 1_000_000);
    obj('truncated-in-a-corner', 'EITHER', 'truncated after a slash', '-', vertices() . "f 1 2 3\nf 1 2 7/");
    obj('mtllib-climbs', 'OK', 'a material library outside of the folder, which is not read', '-',
        "mtllib ../../../../../../etc/passwd\n" . vertices() . faces(@sides), $cube);
    obj('crlf-tabs-continued', 'OK', 'CRLF, tabs, continued lines, no newline at the end', '-', continued(), $cube);
    obj('negative-indices', 'OK', 'indices that count back from the last vertex', '-',
        vertices() . join('', map { 'f ' . join(' ', map { $_ - 8 } @$_) . "\n" } @sides), $cube);
    obj('polygon-20000', 'OK', 'one convex polygon of 20,000 corners, on one line', '-', polygon(20_000),
        'faces=19998,points=20000,components=1,boundary_loops=1,euler=1');
    obj('polygon-8000-star', 'OK', 'one star of 4,000 points', '-', polygon(8000, sub { $_ % 2 ? 1 : 0.5 }),
        'faces=7998,points=8000,components=1,boundary_loops=1,euler=1');
    obj('polygon-20000-crossing', 'EITHER', 'one polygon of 20,000 corners that crosses itself', '-',
        polygon(20_000, sub { ($_ * 7919 % 20_000) / 20_000 }));
    obj('polygon-20000-same', 'ERR', 'one polygon of 20,000 times the same corner', 'area',
        vertices() . 'f' . ' 1' x 20_000 . "\n");
    obj('degenerate-faces', 'WARN', 'two faces that name a corner twice, beside a cube', '2 faces without an area',
        vertices() . faces(@sides) . "f 1 1 2\nf 3 4 3\n", $cube =~ s/faces=12/faces=14,degenerate=2/r);
    obj('non-manifold', 'WARN', 'a cube with a fin: an edge of three faces', '1 edge .*two faces',
        vertices() . "v -1 -1 0\n" . faces(@sides) . "f 1 2 9\n", 'faces=13,nonmanifold_edges=1');
}

sub continued {
    my $text = join '', map { "v\t@$_  \r\n" } @cube;
    my ($first, @rest) = map { [map { $_ + 1 } @$_] } @sides;
    $text .= "f\t$first->[0] \\\r\n $first->[1]\\\r\n\t$first->[2] $first->[3]\r\n";
    $text .= "  f @$_\t\r\n" for @rest;
    return substr $text, 0, -3;
}

# polygon COUNT, RADIUS: one face of COUNT corners around the origin; RADIUS returns the distance of corner $_
sub polygon {
    my ($count, $radius) = @_;
    my $turn = 8 * atan2(1, 1) / $count;
    $radius //= sub { 1 };
    return join('', map { my $r = $radius->(); sprintf "v %.9f %.9f 0\n", $r * cos $turn * $_,
        $r * sin $turn * $_ } 0 .. $count - 1) .
        "f @{[1 .. $count]}\n";
}

my @corners = ([0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]);
my @triangles = ([0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]);
my $tetrahedron = 'faces=4,points=4,components=1,boundary_loops=0,euler=2,contrary_edges=0';

# header FORMAT, VERTICES, FACES, LIST: a PLY header with these counts; LIST is the type of the property of faces
sub header {
    my ($format, $vertices, $faces, $list) = @_;
    $list //= 'list uchar int vertex_indices';
    return "ply\nformat $format 1.0\ncomment made for a test\nelement vertex $vertices\n" .
        join('', map { "property float $_\n" } qw(x y z)) .
        (defined $faces ? "element face $faces\nproperty $list\n" : '') . "end_header\n";
}

sub ply {
    my ($name, $expect, $what, $says, $bytes, $figures) = @_;
    add_input("ply/$name.ply", $expect, $what, $says, $bytes, $figures);
}

sub plys {
    my ($ascii, $little) = ('ascii', 'binary_little_endian');
    my $rows = join '', map { "@$_\n" } @corners;
    my $lists = join '', map { "3 @$_\n" } @triangles;
    my $floats = join '', map { pack 'f<3', @$_ } @corners;
    my $packed = join '', map { pack 'C l<3', 3, @$_ } @triangles;
    my $claims = "claims more than it holds";
    ply('vertex-1e9-ascii', 'ERR', $claims, 'vertex: 1000000000 ', header($ascii, 1_000_000_000, 4) .
        $rows . $lists);
    ply('vertex-4294967295', 'ERR', $claims, 'vertex: 4294967295 ', header($little, 4294967295, 4) .
        $floats . $packed);
    ply('vertex-2e63', 'ERR', $claims, 'vertex', header($little, '9223372036854775807', 4) . $floats . $packed);
    ply('vertex-1e30', 'ERR', $claims, 'count', header($little, '1' . '0' x 30, 4) . $floats . $packed);
    ply('vertex-negative', 'ERR', 'minus one vertices', '-1 .*count', header($little, -1, 4) . $floats . $packed);
    ply('face-4294967295', 'ERR', $claims, 'face: 4294967295 ', header($little, 4, 4294967295) . $floats .
        $packed);
    ply('face-1e9-ascii', 'ERR', $claims, 'face: 1000000000 ', header($ascii, 4, 1_000_000_000) . $rows .
        $lists);
    ply('other-1e18', 'ERR', 'an element that nobody knows, a million million million times', '-',
        header($little, 4, 4) =~ s/element vertex/element other 1000000000000000000\nproperty int a\nelement vertex/r .
        $floats . $packed);
    ply('other-without-properties', 'EITHER', 'an element without properties, a million million million times', '-',
        header($little, 4, 4) =~ s/element vertex/element other 1000000000000000000\nelement vertex/r . $floats .
        $packed);
    my $wide = 'list int int vertex_indices';
    for (['2e9', 2147483647], ['negative', -1], ['1e6', 1_000_000]) {
        my ($name, $length) = @$_;
        ply("list-length-$name", 'ERR', "a face of $length corners", 'face 0: .*list',
            header($little, 4, 1, $wide) . $floats . pack 'l<4', $length, 0, 1, 2);
        ply("list-length-$name-ascii", 'ERR', "a face of $length corners", 'face 0: .*list',
            header($ascii, 4, 1) . "$rows$length 0 1 2\n");
    }
    ply('list-length-float', 'ERR', 'the length of a list is a float', 'unknown type',
        header($little, 4, 1, 'list float int vertex_indices') . $floats . pack 'f< l<3', 3, 0, 1, 2);
    my $whole = header($little, 4, 4) . $floats . $packed;
    my ($size, $at) = (length $whole, length header($little, 4, 4));
    for (['last-byte', $size - 1], ['face', $size - 20], ['vertex', $at + 30], ['body', $at], ['end_header', $at - 1],
        ['header', $at - 40], ['word', 2]) {
        my ($name, $end) = @$_;
        ply("truncated-at-$name", 'ERR', 'truncated', '-', substr $whole, 0, $end);
    }
    ply('truncated-ascii', 'ERR', 'truncated in the third face', 'face 2: ', header($ascii, 4, 4) . $rows .
        "3 0 2 1\n3 0 1 3\n3 0 3");
    for (['oob', 4], ['oob-2e9', 2147483647], ['negative', -1]) {
        my ($name, $index) = @$_;
        ply("index-$name", 'ERR', "index $index of four vertices",
            "face 3: vertex index $index, want a whole number below 4",
            header($little, 4, 4) . $floats . substr($packed, 0, -4) . pack 'l<', $index);
    }
    for (['nan', $nan], ['infinite', $inf]) {
        my ($name, $value) = @$_;
        ply("coordinate-$name", 'ERR', "a coordinate is $name", 'vertex 3: .*finite',
            header($little, 4, 4) . substr($floats, 0, -4) . pack('f<', $value) . $packed);
    }
    ply('coordinate-overflow', 'ERR', 'a double that no float holds', 'vertex 0: .*finite',
        header($little, 4, 4) =~ s/float/double/gr . pack('d<*', (1e300) x 12) . $packed);
    ply('coordinate-nan-ascii', 'ERR', 'a coordinate is nan', 'vertex 2', header($ascii, 4, 4) .
        "0 0 0\n1 0 0\n0 nan 0\n0 0 1\n$lists");
    ply('no-faces', 'ERR', 'a cloud of points', 'no faces.* 4 ', header($little, 4) . $floats);
    ply('zero-faces', 'ERR', 'no faces, and it says so', 'no faces', header($little, 4, 0) . $floats);
    ply('zero-vertices', 'ERR', 'faces of no vertices', '-', header($little, 0, 4) . $packed);
    ply('no-z', 'ERR', 'vertices without z', 'x, y and z', $whole =~ s/property float z\n//r);
    ply('empty', 'ERR', '0 bytes', 'empty', '');
    ply('format-unknown', 'ERR', 'of a format that is none', 'binary_middle_endian',
        $whole =~ s/little/middle/r);
    ply('format-missing', 'ERR', 'without a format', 'no format', $whole =~ s/format \S+ 1.0\n//r);
    ply('header-garbage', 'ERR', 'a header that turns into bytes', 'line [67]: ',
        substr($whole, 0, 100) . pack 'C*', map { ($_ * 37) & 255 } 0 .. 200);
    ply('header-word', 'ERR', 'an unknown word in the header', 'elephant',
        $whole =~ s/comment/elephant/r);
    ply('header-properties', 'ERR', '10,000 properties', 'more than', header($little, 4, 4) =~
        s/element face/'property float p' x 0 . join('', map { "property float p$_\n" } 1 .. 10_000) .
            'element face'/er . $floats);
    ply('header-elements', 'ERR', '10,000 elements', 'more than', header($little, 4, 4) =~
        s/end_header/join('', map { "element e$_ 0\n" } 1 .. 10_000) . 'end_header'/er . $floats);
    ply('property-first', 'ERR', 'a property before any element', 'before any element',
        "ply\nformat ascii 1.0\nproperty float x\nend_header\n");
    ply('vertices-twice', 'ERR', 'vertices for the second time', 'vertex 0: .*vert', header($ascii, 4, 0) =~
        s/element face/element vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face/r .
            $rows . $rows);
    plys_legal($rows);
}

sub plys_legal {
    my ($rows) = @_;
    my $big = header('binary_big_endian', 4, 4, 'list uint ushort vertex_index') =~ s/float/double/gr;
    ply('big-endian-double', 'OK', 'big-endian doubles, lists of short indices', '-', $big .
        join('', map { pack 'd>3', @$_ } @corners) . join('', map { pack 'N n3', 3, @$_ } @triangles), $tetrahedron);
    my $strips = header('ascii', 4, 1, 'list int int vertex_indices') =~ s/element face/element tristrips/r;
    ply('strips', 'EITHER', 'triangles as strips: two of them', '-', "$strips${rows}7 0 1 2 -1 1 3 2\n",
        'faces=2,points=4');
    ply('strips-oob', 'ERR', 'a strip of a vertex that is not there', 'vertex index 9, want a whole number below 4',
        "$strips${rows}5 0 1 2 9 -1\n");
    ply('strips-below', 'ERR', 'a strip that ends with -2', 'vertex index -2, want a whole number below 4',
        "$strips${rows}5 0 1 2 3 -2\n");
}

sub offs {
    my $rows = join '', map { "@$_\n" } @corners;
    my $lists = join '', map { "3 @$_\n" } @triangles;
    # off NAME, WHAT, SAYS, COUNTS, ROWS, LISTS: the lines of vertices and faces default to the tetrahedron
    my $off = sub {
        my ($name, $what, $says, $counts, $own_rows, $own_lists) = @_;
        add_input("off/$name.off", 'ERR', $what, $says, "OFF\n$counts\n" . ($own_rows // $rows) .
            ($own_lists // $lists));
    };
    $off->('counts-1e9', 'claims 1e9 vertices and faces', '1000000000 vertices',
        '1000000000 1000000000 0');
    $off->('counts-1e12', 'claims 987654321012 vertices', '987654321012 vertices', '987654321012 4 0');
    $off->('counts-1e30', 'claims 1e30 vertices', 'line 2: 1000000', '1' . '0' x 30 . ' 4 0');
    $off->('counts-4e18', 'claims 4e18 vertices', 'line 2: 4000000000000000000 ',
        '4000000000000000000 4 0');
    $off->('counts-faces-1e9', 'claims 1e9 faces', '1000000000 faces', '4 1000000000 0');
    $off->('counts-negative', 'claims -4 vertices', 'line 2: -4 ', '-4 4 0');
    $off->('counts-missing', 'counts that are not there', '-', '');
    $off->('vertices-missing', 'five vertices, there are four', '-', '5 4 0');
    $off->('faces-missing', 'five faces, there are four', '4 of 5 faces', '4 5 0');
    $off->('zero-faces', 'no faces', 'no faces.* 4 ', '4 0 0', undef, '');
    $off->('zero', 'nothing at all', 'no faces', '0 0 0', '', '');
    $off->('index-oob', 'vertex 4 of four', 'line 7: .* 4 ', '4 4 0', undef, "3 0 1 4\n$lists");
    $off->('index-missing', 'a face of three corners with two', 'line 7: a face of 3 corners ends after 2', '4 4 0', undef,
        "3 0 1\n$lists");
    $off->('index-negative', 'vertex -1', 'line 7: .* -1', '4 4 0', undef, "3 0 1 -1\n$lists");
    $off->('list-length-2e9', 'a face of 2147483647 corners', 'line 7: ', '4 4 0', undef,
        "2147483647 0 1 2\n$lists");
    $off->('list-length-0', 'a face of no corners', 'line 7: .* 0 corners', '4 4 0', undef, "0\n$lists");
    $off->('coordinate-nan', 'a coordinate is nan', 'line 4: vertex', '4 4 0', "0 0 0\nnan 0 0\n0 1 0\n0 0 1\n");
    $off->('coordinate-inf', 'a coordinate is inf', 'line 4: vertex', '4 4 0', "0 0 0\n1 -inf 0\n0 1 0\n0 0 1\n");
    add_input('off/word-alone.off', 'ERR', 'the word OFF alone', '-', 'OFF');
    add_input('off/empty.off', 'ERR', '0 bytes', 'empty', '');
}

# binary BEGIN, COUNT, TRIANGLE ...: a binary STL file; BEGIN is its 80 byte header, COUNT what it claims
sub binary {
    my ($begin, $count, @facets) = @_;
    return pack('A80 V', $begin, $count) . join '', map { pack 'f<12 v', 0, 0, 0, (map { @$_ } @$_), 0 } @facets;
}

sub stls {
    my @facets = map { [@corners[@$_]] } @triangles;
    my $holds = ', the file holds 4 ';
    # stl NAME, EXPECT, WHAT, SAYS, BYTES, FIGURES
    my $stl = sub {
        my ($name, $expect, $what, $says, $bytes, $figures) = @_;
        add_input("stl/$name.stl", $expect, $what, $says, $bytes, $figures);
    };
    $stl->('count-ffffffff', 'ERR', 'claims 2^32 - 1 triangles', "4294967295 triangles$holds",
        binary('made', 4294967295, @facets));
    $stl->('count-85899346', 'ERR', 'claims 85899346 triangles: fifty times that wraps around',
        "85899346 triangles$holds",
        binary('made', 85_899_346, @facets));
    $stl->('count-5', 'ERR', 'claims a triangle more', "5 triangles$holds", binary('made', 5, @facets));
    $stl->('count-0', 'ERR', 'claims no triangle', 'no faces', binary('made', 0));
    $stl->('truncated', 'ERR', 'one byte short', 'the header counts 4 triangles, the file holds 3 ',
        substr binary('made', 4, @facets), 0, -1);
    $stl->('truncated-in-the-header', 'ERR', 'truncated in the header', '-', substr binary('made', 4, @facets), 0,
        60);
    $stl->('coordinate-nan', 'ERR', 'a position is nan', 'triangle 4: .*finite',
        binary('made', 5, @facets, [[$nan, 0, 0], [0, 1, 0], [1, 0, 0]]));
    $stl->('coordinate-infinite', 'ERR', 'a position is infinite', 'triangle 4: .*finite',
        binary('made', 5, @facets, [[0, 0, 0], [0, -$inf, 0], [1, 0, 0]]));
    $stl->('empty', 'ERR', '0 bytes', 'empty', '');
    my $text = join '', "solid made\n", map({ ("facet normal 0 0 0\nouter loop\n", map({ "vertex @$_\n" } @$_),
        "endloop\nendfacet\n") } @facets),
        "endsolid made\n";
    $stl->('text-truncated', 'ERR', 'text without its end', 'endsolid', $text =~ s/endsolid made\n//r);
    $stl->('text-two-corners', 'ERR', 'a facet of two corners', 'line 7: .* 2 corners', $text =~ s/vertex 0 0 0\n//r);
    $stl->('text-nan', 'ERR', 'a coordinate is nan', 'line 4: vertex', $text =~ s/vertex 0 0 0/vertex 0 nan 0/r);
    $stl->('text-word', 'ERR', 'an unknown word', 'line 3: .*polygon', $text =~ s/outer/polygon/r);
    $stl->('text-no-facets', 'ERR', 'no facets', 'no faces', "solid made\nendsolid made\n");
    $stl->('header-says-solid', 'OK', 'binary, though it begins with solid', '8 vertices',
        binary('solid made as bytes', 4, @facets), $tetrahedron);
    $stl->('header-says-solid-truncated', 'ERR', 'binary, begins with solid, ten bytes short', '-',
        substr binary('solid made as bytes', 4, @facets), 0, -10);
}

objs();
plys();
offs();
stls();
1;
