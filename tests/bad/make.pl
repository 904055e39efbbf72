#!/usr/bin/env perl
# make.pl FOLDER: generates malformed, hostile and unusual input files, always the same, and MANIFEST.tsv, a table
# with a line for each input:
#   path     relative to the folder; files without a line are companions of those that have one
#   tier     core: tested with every command that reads such files; more: with one of these commands
#   expect   ERR     exit status 3 or 5, one line on standard error that names the file, no output
#            WARN    exit status 0, usable output, and a warning
#            OK      exit status 0, correct output (legal but unusual)
#            EITHER  any of these, but no crash, no hang and no NaN
#   what     what is wrong or unusual
#   says     extended regular expression that the message must match, without the command's and the file's name;
#            dots stand for blanks, "-" for any message. It tells a file that is refused for the intended reason
#            from one that is refused for another.
#   figures  columns of `hatchstat mesh`, NAME=NUMBER,...; "-" for none
use strict;
use warnings;
use File::Basename qw(dirname);
use File::Path qw(make_path);
use File::Spec::Functions qw(rel2abs);

my %core = map { $_ => 1 } split ' ', do { local $/; <DATA> };
our $folder = shift // die "usage: make.pl FOLDER\n";
my $here = rel2abs(dirname(__FILE__));
my @manifest = (join "\t", qw(path tier expect what says figures));
my %written;

# add_file PATH, BYTES
sub add_file {
    my ($path, $bytes) = @_;
    make_path(dirname("$folder/$path"));
    die "$path is made twice\n" if $written{$path}++;
    open my $file, '>:raw', "$folder/$path" or die "$path: $!\n";
    print $file $bytes;
    close $file or die "$path: $!\n";
}

# add_entry PATH, EXPECT, WHAT, SAYS, FIGURES: adds a line to the manifest
sub add_entry {
    my ($path, $expect, $what, $says, $figures) = @_;
    s/ /./g for $says //= '-';
    die "$path: $says: characters that xargs interprets\n" if $says =~ /['"\\\s]/;
    push @manifest, join "\t", $path, delete $core{$path} ? 'core' : 'more', $expect, $what, $says, $figures // '-';
}

# add_input PATH, EXPECT, WHAT, SAYS, BYTES, FIGURES: writes a file and its line of the manifest
sub add_input {
    my ($path, $expect, $what, $says, $bytes, $figures) = @_;
    add_file($path, $bytes);
    add_entry($path, $expect, $what, $says, $figures);
}

require "$here/make_gltf.pl";
require "$here/make_meshes.pl";
require "$here/make_shapes.pl";
require "$here/make_pictures.pl";
require "$here/make_exr.pl";

make_path("$folder/odd/directory.obj");
add_entry('odd/directory.obj', 'ERR', 'a directory', 'is a directory');
add_input('odd/nested-100k.json', 'ERR', '100,000 nested arrays in no format that is read',
    'not a GLB|unknown|line 1',
    '[' x 100_000 . ']' x 100_000);
add_input('odd/random.bin', 'ERR', 'bytes of no format', 'not a',
    pack 'C*', map { my $i = $_; ($i * $i * 31 + ($i >> 3) * 7 + 13) & 255 } 0 .. 4095);

die "no input is called ", join(', ', sort keys %core), "\n" if %core;
open my $file, '>', "$folder/MANIFEST.tsv" or die "MANIFEST.tsv: $!\n";
print $file "$_\n" for @manifest;
close $file or die "MANIFEST.tsv: $!\n";

# The inputs of tier core.
__DATA__
glb/truncated-behind-the-word.glb glb/truncated-behind-the-header.glb glb/truncated-behind-the-json-header.glb
glb/truncated-behind-the-json.glb glb/truncated-before-the-last-byte.glb glb/bin-too-long.glb glb/empty.glb
glb/json-length-ffffffff.glb glb/length-13.glb glb/magic-wrong.glb glb/version-3.glb
gltf/nested-100k.gltf gltf/nested-200k.gltf gltf/accessor-count-1e9.gltf gltf/no-view-count-max.gltf
gltf/offset-overflow.gltf gltf/view-length-1e300.gltf gltf/draco-required.gltf gltf/uri-climbs.gltf
gltf/companion-missing.gltf gltf/node-loop-self.glb gltf/node-loop-behind-a-mesh.glb gltf/node-chain-100k.glb
gltf/instance-bomb-2e39.glb gltf/instances-1e9-no-view.glb gltf/mirror.glb gltf/scale-overflow.glb
gltf/position-nan.glb gltf/position-all-infinite.glb gltf/index-oob-5123.glb gltf/index-restart-5121.glb
gltf/sparse-oob.glb gltf/no-position.glb gltf/animation-negative.glb gltf/mode-lines.gltf
obj/index-zero.obj obj/index-oob-2e9.obj obj/coordinate-nan.obj obj/coordinate--inf.obj obj/empty.obj
obj/crlf-tabs-continued.obj obj/polygon-20000.obj obj/degenerate-faces.obj obj/non-manifold.obj
ply/vertex-1e9-ascii.ply ply/vertex-4294967295.ply ply/list-length-2e9.ply ply/truncated-at-face.ply
ply/big-endian-double.ply ply/strips.ply ply/header-garbage.ply ply/no-faces.ply
off/counts-1e9.off off/counts-1e12.off off/zero-faces.off stl/count-ffffffff.stl stl/header-says-solid.stl
shape/moebius.obj shape/klein.obj shape/single-triangle.obj shape/isolated-vertices.obj shape/duplicate-faces.obj
shape/inconsistent.obj shape/unwelded.obj shape/scale-1e30.obj shape/scale-1e-30.obj shape/zero-area.obj
shape/all-collinear.obj shape/book-5-pages.obj shape/bow-tie.obj shape/components-10000.ply
shape/valence-20000.ply shape/edge-of-20000.ply shape/sphere.obj
png/bomb-65535x65535-1-bit.png png/header-depth-8-type-9-methods-000.png png/crc-of-the-pixels.png
png/length-ffffffff.png png/empty.png png/sound.png foreign/bomb-65500x65500.jpg
exr/window-2e32.exr exr/compression-255.exr exr/tiles-2e31.exr exr/table-beyond.exr exr/truncated-at-row.exr
exr/channels-10000.exr exr/attribute-7fffffff.exr exr/pixels-nan.exr exr/pixels-nan-float.exr exr/sound.exr
odd/directory.obj odd/nested-100k.json
