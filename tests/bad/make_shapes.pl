# Meshes with unusual topology or coordinates in well-formed files, for make.pl.
use strict;
use warnings;

my $pi = 4 * atan2 1, 1;

# mesh NAME, EXPECT, WHAT, SAYS, VERTICES, FACES, FIGURES: an OBJ file
#   VERTICES  array of [x, y, z]
#   FACES     array of arrays of vertex indices, from 0
sub mesh {
    my ($name, $expect, $what, $says, $vertices, $faces, $figures) = @_;
    my $text = join '', map({ 'v ' . join(' ', map { sprintf '%.9g', $_ } @$_) . "\n" } @$vertices),
        map { 'f ' . join(' ', map { $_ + 1 } @$_) . "\n" } @$faces;
    add_input("shape/$name.obj", $expect, $what, $says, $text, $figures);
}

# sphere COLUMNS, ROWS: vertices and outward facing triangles of a unit sphere
sub sphere {
    my ($columns, $rows) = @_;
    my (@vertices, @faces);
    push @vertices, [0, 1, 0];
    for my $row (1 .. $rows - 1) {
        my ($height, $radius) = (cos $pi * $row / $rows, sin $pi * $row / $rows);
        push @vertices, map { [$radius * cos 2 * $pi * $_ / $columns, $height,
            -$radius * sin 2 * $pi * $_ / $columns] } 0 .. $columns - 1;
    }
    push @vertices, [0, -1, 0];
    for my $column (0 .. $columns - 1) {
        my $next = ($column + 1) % $columns;
        push @faces, [0, 1 + $column, 1 + $next];
        for my $row (0 .. $rows - 3) {
            my ($above, $below) = (1 + $row * $columns, 1 + ($row + 1) * $columns);
            push @faces, [$above + $column, $below + $column, $below + $next],
                [$above + $column, $below + $next, $above + $next];
        }
        my $last = 1 + ($rows - 2) * $columns;
        push @faces, [$last + $column, $#vertices, $last + $next];
    }
    return (\@vertices, \@faces);
}

# band COLUMNS, ROWS, TWISTED, CLOSED, PLACE: a grid of triangles that closes around its columns; mirrored where it
# closes if TWISTED, also closed around its rows if CLOSED. PLACE maps (0 .. 2 pi, 0 .. 1) to a position.
sub band {
    my ($columns, $rows, $twisted, $closed, $place) = @_;
    my $lines = $closed ? $rows : $rows + 1;
    my (@vertices, @faces);
    for my $i (0 .. $columns - 1) {
        push @vertices, map { [$place->(2 * $pi * $i / $columns, $_ / $rows)] } 0 .. $lines - 1;
    }
    for my $i (0 .. $columns - 1) {
        for my $j (0 .. $rows - 1) {
            my $up = ($j + 1) % $lines;
            my @next = $i + 1 < $columns ? (($i + 1) * $lines + $j, ($i + 1) * $lines + $up)
                : map { $twisted ? $closed ? -$_ % $lines : $rows - $_ : $_ } $j, $up;
            push @faces, [$i * $lines + $j, $next[0], $next[1]], [$i * $lines + $j, $next[1], $i * $lines + $up];
        }
    }
    return (\@vertices, \@faces);
}

# A strip with half a turn.
sub moebius_place {
    my ($around, $across) = @_;
    my ($side, $half) = (0.6 * $across - 0.3, $around / 2);
    my $radius = 1 + $side * cos $half;
    return ($radius * cos $around, $side * sin $half, $radius * sin $around);
}

# A figure eight with half a turn. It intersects itself, but not at vertices.
sub klein_place {
    my ($around, $across) = @_;
    my ($t, $half) = (2 * $pi * ($across + 0.5 / 31), $around / 2);
    my $radius = 2 + cos($half) * sin($t) - sin($half) * sin(2 * $t);
    return ($radius * cos $around, sin($half) * sin($t) + cos($half) * sin(2 * $t), $radius * sin $around);
}

sub twisted {
    mesh('moebius', 'WARN', 'a Moebius strip: one side, one border', 'the surface has.* one side',
        band(96, 6, 1, 0, \&moebius_place),
        'faces=1152,points=672,components=1,boundary_loops=1,euler=0,nonmanifold_edges=0');
    mesh('klein', 'WARN', 'a Klein bottle: one side, no border', 'the surface has.* one side',
        band(80, 31, 1, 1, \&klein_place),
        'faces=4960,points=2480,components=1,boundary_loops=0,euler=0,nonmanifold_edges=0');
}

sub spheres {
    my ($vertices, $faces) = sphere(40, 20);
    my ($count, $closed) = (scalar @$faces,
        'points=762,components=1,boundary_loops=0,euler=2,nonmanifold_edges=0,contrary_edges=0');
    my $figures = "faces=$count,$closed";
    mesh('sphere', 'OK', 'nothing: what the others are compared with', '-', $vertices, $faces, $figures);
    for my $scale ('1e30', '1e-30') {
        mesh("scale-$scale", 'OK', "coordinates of $scale, whose squares no float holds", '-',
            [map { [map { $_ * $scale } @$_] } @$vertices], $faces, $figures);
    }
    mesh('isolated-vertices', 'WARN', 'three vertices of no face, one of them far away',
        '3 vertices',
        [@$vertices, [0, 0, 0], [0, 0.5, 0], [1e6, 1e6, 1e6]], $faces,
        "unused=3,points=765,components=1,euler=2,high_x=1");
    mesh('duplicate-faces', 'WARN', '200 faces given twice', '200 faces', $vertices,
        [@$faces, @$faces[map { 7 * $_ } 0 .. 199]], "faces=" . ($count + 200) . ",duplicates=200,points=762");
    mesh('opposite-faces', 'WARN', 'every face again, looking inwards', '-', $vertices,
        [@$faces, map { [reverse @$_] } @$faces]);
    mesh('inconsistent', 'WARN', 'every third face is turned over', '507 faces .*neighbours',
        $vertices,
        [map { $_ % 3 ? $faces->[$_] : [reverse @{$faces->[$_]}] } 0 .. $#$faces],
        $figures =~ s/,contrary_edges=0//r);
    mesh('inside-out', 'OK', 'every face is turned over', '-', $vertices, [map { [reverse @$_] } @$faces], $figures);
    mesh('unwelded', 'WARN', 'every corner has a vertex of its own', '3798 vertices',
        [map { @$vertices[@$_] } @$faces],
        [map { [3 * $_ .. 3 * $_ + 2] } 0 .. $#$faces], $figures);
    mesh('zero-area', 'WARN', 'two faces without an area', '2 faces',
        [@$vertices, $vertices->[300]],
        [@$faces, [300, 301, 762], [300, 762, 301]], 'faces=' . ($count + 2) . ',degenerate=2,points=762');
    mesh('needles', 'EITHER', 'faces a millionth as high as wide', '-',
        [map { [$_->[0], 1e-6 * $_->[1], $_->[2]] } @$vertices], $faces);
    mesh('far-away', 'EITHER', 'a sphere of radius 1 at 1e7: floats there are 1 apart', '-',
        [map { [1e7 + $_->[0], @$_[1, 2]] } @$vertices], $faces);
    mesh('far-apart', 'EITHER', 'one vertex of 1e38, the others near 1', '-',
        [[0, 3e38, 0], @$vertices[1 .. $#$vertices]], $faces);
}

sub joined {
    mesh('single-triangle', 'OK', 'one triangle', '-', [[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]],
        'faces=1,points=3,components=1,boundary_loops=1,euler=1,area=0.5');
    mesh('all-collinear', 'ERR', 'every face lies on one line', 'area',
        [map { [$_, 2 * $_, 0] } 0 .. 8],
        [map { [$_, $_ + 1, $_ + 2] } 0 .. 6]);
    mesh('all-one-point', 'ERR', 'every vertex at one place', 'area', [([1, 2, 3]) x 9],
        [map { [$_, $_ + 1, $_ + 2] } 0 .. 6]);
    my (@vertices, @faces) = ([0, 0, -1], [0, 0, 1]);
    for my $page (0 .. 4) {
        my ($x, $y) = (cos $page * $pi / 5, sin $page * $pi / 5);
        push @vertices, [$x, $y, -1], [$x, $y, 1];
        push @faces, [0, 2 + 2 * $page, 3 + 2 * $page], [0, 3 + 2 * $page, 1];
    }
    mesh('book-5-pages', 'WARN', 'an edge of five faces', '1 edge .*two faces', \@vertices, \@faces,
        'faces=10,points=12,components=1,nonmanifold_edges=1');
    my @corners = ([1, 0, 0], [0, 1, 0], [0, 0, 1]);
    my @tip = ([0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]);
    mesh('bow-tie', 'WARN', 'two tetrahedra that share a vertex', '1 point ',
        [[0, 0, 0], @corners, map { [map { -$_ } @$_] } @corners],
        [@tip, map { [map { $_ ? $_ + 3 : 0 } reverse @$_] } @tip],
        'faces=8,points=7,nonmanifold_points=1,nonmanifold_edges=0');
}

sub many {
    my ($bytes, $count) = ('', 10_000);
    my $header = sub {
        my ($vertices, $faces) = @_;
        return "ply\nformat binary_little_endian 1.0\nelement vertex $vertices\n" .
            join('', map { "property float $_\n" } qw(x y z)) .
            "element face $faces\nproperty list uchar int vertex_indices\nend_header\n";
    };
    for my $i (0 .. $count - 1) {
        my ($x, $y, $z) = ($i % 25, int($i / 25) % 20, int $i / 500);
        $bytes .= pack 'f<9', $x, $y, $z, $x + 0.5, $y, $z, $x, $y + 0.5, $z + 0.1;
    }
    $bytes .= pack '(C l<3)*', map { (3, 3 * $_, 3 * $_ + 1, 3 * $_ + 2) } 0 .. $count - 1;
    add_input('shape/components-10000.ply', 'OK', '10,000 loose triangles', '-', $header->(3 * $count, $count) .
        $bytes,
        'faces=10000,points=30000,components=10000,boundary_loops=10000');
    $count = 20_000;
    $bytes = pack 'f<3', 0, 0, 0.2;
    $bytes .= pack 'f<3', cos 2 * $pi * $_ / $count, sin 2 * $pi * $_ / $count, 0 for 0 .. $count - 1;
    $bytes .= pack '(C l<3)*', map { (3, 0, 1 + $_, 1 + ($_ + 1) % $count) } 0 .. $count - 1;
    add_input('shape/valence-20000.ply', 'OK', 'a vertex of 20,000 faces', '-', $header->($count + 1, $count) .
        $bytes,
        'faces=20000,points=20001,components=1,boundary_loops=1,euler=1');
    $bytes = pack 'f<3', 0, 0, 0;
    for my $i (0 .. $count - 1) {
        my ($x, $y) = (cos 2 * $pi * $i / $count, sin 2 * $pi * $i / $count);
        $bytes .= pack 'f<6', $x, $y, $i % 97, 1.001 * $x, $y, 1 + $i % 97;
    }
    $bytes .= pack '(C l<3)*', map { (3, 0, 1 + 2 * $_, 2 + 2 * $_) } 0 .. $count - 1;
    add_input('shape/point-of-20000.ply', 'WARN', 'a point where 20,000 triangles meet that share no edge',
        '1 point ',
        $header->(2 * $count + 1, $count) . $bytes, 'faces=20000,points=40001,nonmanifold_points=1');
    $bytes = pack 'f<6', 0, 0, 0, 0, 0, 1;
    $bytes .= pack 'f<3', cos 2 * $pi * $_ / $count, sin 2 * $pi * $_ / $count, 0.5 for 0 .. $count - 1;
    $bytes .= pack '(C l<3)*', map { (3, 0, 1, 2 + $_) } 0 .. $count - 1;
    add_input('shape/edge-of-20000.ply', 'WARN', 'an edge of 20,000 faces', '1 edge .*two faces',
        $header->($count + 2, $count) . $bytes,
        'faces=20000,nonmanifold_edges=1');
}

# Shapes whose faces are long or meet in great numbers at one point.
sub crowded {
    my $count = 20_000;
    my $ply = sub {
        my ($name, $expect, $what, $vertices, $faces) = @_;
        add_input("shape/$name.ply", $expect, $what, '-', "ply\nformat binary_little_endian 1.0\nelement vertex " .
            @$vertices . "\n" . join('', map { "property float $_\n" } qw(x y z)) . 'element face ' . @$faces .
            "\nproperty list int int vertex_indices\nend_header\n" . pack('f<*', map { @$_ } @$vertices) .
            pack('l<*', map { (scalar @$_, @$_) } @$faces));
    };
    my @rim = map { [cos 2 * $pi * $_ / $count, sin 2 * $pi * $_ / $count, 0] } 0 .. $count - 1;
    $ply->("comb-$count", 'OK', "one polygon, a comb of $count corners",
        [(map { [$_ / $count, $_ % 2, 0] } 0 .. $count - 3), [1, -0.1, 0], [0, -0.1, 0]], [[reverse 0 .. $count - 1]]);
    $ply->("star-$count", 'OK', "one polygon, a star of $count corners",
        [map { my $i = $_; [map { $_ * ($i % 2 ? 1 : 0.1) } @{$rim[$i]}] } 0 .. $count - 1], [[0 .. $count - 1]]);
    $ply->("double-cone-$count", 'OK', "two points of $count faces each", [[0, 0, 1], [0, 0, -1], @rim],
        [map { my ($a, $b) = (2 + $_, 2 + ($_ + 1) % $count); ([0, $a, $b], [1, $b, $a]) } 0 .. $count - 1]);
    $ply->('needles-strip', 'EITHER', 'a strip of 20,000 needles, side by side',
        [map { ([$_ * 1e-6, 0, 0], [$_ * 1e-6, 1, 0]) } 0 .. $count / 2],
        [map { ([2 * $_, 2 * $_ + 2, 2 * $_ + 1], [2 * $_ + 1, 2 * $_ + 2, 2 * $_ + 3]) } 0 .. $count / 2 - 1]);
    $ply->('triangle-20000-times', 'EITHER', 'one triangle, given 20,000 times', [[0, 0, 0], [1, 0, 0], [0, 1, 0]],
        [([0, 1, 2]) x $count]);
}

twisted();
crowded();
spheres();
joined();
many();
1;
