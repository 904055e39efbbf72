# Damaged OpenEXR files, for make.pl, derived from an image of 4 x 4 pixels ("OpenEXR File Layout"). Needs zeros() of
# make_pictures.pl.
use strict;
use warnings;
use Compress::Zlib qw(compress);

my ($UINT, $HALF, $FLOAT) = (0, 1, 2);
my ($NONE, $RLE, $ZIPS, $ZIP, $PIZ) = (0 .. 4);
my ($TILED, $DEEP, $PARTS) = (0x200, 0x800, 0x1000);
my @order = qw(channels compression dataWindow displayWindow lineOrder pixelAspectRatio screenWindowCenter
    screenWindowWidth);

sub attribute {
    my ($name, $type, $bytes) = @_;
    return "$name\0$type\0" . pack('V', length $bytes) . $bytes;
}

# channel NAME, PIXEL TYPE, X SAMPLING, Y SAMPLING
sub channel {
    my ($name, $type, $x, $y) = @_;
    return "$name\0" . pack 'V C x3 V2', $type, 0, $x // 1, $y // 1;
}

sub window {
    return pack 'l<4', @_;
}

# exr_header FLAGS, NAME => ATTRIBUTE ...: a header; attributes replace or follow the required ones, undef removes one
sub exr_header {
    my ($version, %given) = @_;
    my %all = (
        channels => attribute('channels', 'chlist', channel('Y', $HALF) . "\0"),
        compression => attribute('compression', 'compression', chr $NONE),
        dataWindow => attribute('dataWindow', 'box2i', window(0, 0, 3, 3)),
        displayWindow => attribute('displayWindow', 'box2i', window(0, 0, 3, 3)),
        lineOrder => attribute('lineOrder', 'lineOrder', "\0"),
        pixelAspectRatio => attribute('pixelAspectRatio', 'float', pack 'f<', 1),
        screenWindowCenter => attribute('screenWindowCenter', 'v2f', pack 'f<2', 0, 0),
        screenWindowWidth => attribute('screenWindowWidth', 'float', pack 'f<', 1),
    );
    my %more = (%all, %given);
    my @names = (@order, grep { !exists $all{$_} } sort keys %given);
    return pack('V2', 20000630, 2 | $version) . join('', map { $more{$_} // '' } @names) . "\0";
}

sub row {
    my ($y, $bytes) = @_;
    return pack('V2', $y, length $bytes) . $bytes;
}

# with_table HEADER, CHUNK ...: inserts the chunk offset table
sub with_table {
    my ($header, @chunks) = @_;
    my $at = length($header) + 8 * @chunks;
    my $table = '';
    for my $chunk (@chunks) {
        $table .= pack 'Q<', $at;
        $at += length $chunk;
    }
    return join '', $header, $table, @chunks;
}

# Grey levels as half floats, none of them 0 or 1.
my @halves = ([0x3800, 0x3400, 0x3a00, 0x3b00], [0x3000, 0x3800, 0x3900, 0x3600], [0x3200, 0x3300, 0x3800, 0x3700],
    [0x3a80, 0x3b80, 0x3480, 0x3800]);

sub rows {
    my (@values) = @_ ? @_ : @halves;
    return map { row($_, pack 'v*', @{$values[$_]}) } 0 .. $#values;
}

sub exr {
    my ($name, $expect, $what, $says, $bytes) = @_;
    add_input("exr/$name.exr", $expect, $what, $says, $bytes);
}

# window_of NAME, WHAT, SAYS, LOW X, LOW Y, HIGH X, HIGH Y: a file whose header has this data window
sub window_of {
    my ($name, $what, $says, @box) = @_;
    exr("window-$name", 'ERR', $what, $says, with_table(exr_header(0, dataWindow => attribute('dataWindow', 'box2i',
        window(@box)),
        displayWindow => attribute('displayWindow', 'box2i', window(@box))), rows()));
}

sub windows {
    my ($low, $high) = (-2147483648, 2147483647);
    window_of('2e32', 'its window spans all integers: the width wraps to 0', '-', $low, $low, $high, $high);
    window_of('2e31', 'a window of 2^31 by 2^31', '-', 0, 0, $high, $high);
    window_of('from-min', 'a window that begins at -2^31', '-', $low, $low, $low + 3, $low + 3);
    window_of('2e24', 'a window of 2^24 by 2^24', '16777216x16777216 pixels', 0, 0, (1 << 24) - 1, (1 << 24) - 1);
    window_of('20000', 'a window of 20,000 by 20,000',
        '20000x20000 pixels', 0, 0, 19999, 19999);
    window_of('high', 'a window of 4 by 452984833', '-', 0, 0, 3, 452984832);
    window_of('wide', 'a window of 16777216 by 4', '-', 0, 0, 16777215, 3);
    window_of('negative', 'a window that ends before it begins', '-', 3, 3, 0, 0);
    window_of('negative-far', 'a window that ends 2^31 before it begins', '-', 2147483647, 0, -2147483648, 3);
}

sub attributes {
    for my $name (@order) {
        exr("without-$name", $name eq 'displayWindow' || $name =~ /^(pixel|screen|line)/ ? 'EITHER' : 'ERR',
            "no $name", '-',
            with_table(exr_header(0, $name => undef), rows()));
    }
    for my $code (99, 255) {
        exr("compression-$code", 'ERR', "compression $code", "compression.*$code",
            with_table(exr_header(0, compression => attribute('compression', 'compression', chr $code)), rows()));
    }
    exr('compression-lossy', 'ERR', 'B44, which loses', 'compression 6 ',
        with_table(exr_header(0, compression => attribute('compression', 'compression', chr 6)), rows()));
    my %lists = (
        'none' => ['no channel', "\0"],
        'type' => ['a channel of type 7', channel('Y', 7) . "\0"],
        'sampling-2' => ['a channel of half the size', channel('Y', $HALF, 2, 2) . "\0"],
        'sampling-0' => ['a channel of sampling 0', channel('Y', $HALF, 0, 0) . "\0"],
        'sampling-negative' => ['a channel of sampling -1', channel('Y', $HALF, 0xffffffff, 0xffffffff) . "\0"],
        'twice' => ['the same channel twice', channel('Y', $HALF) x 2 . "\0"],
        '10000' => ['10,000 channels', join('', map { channel(sprintf('c%05d', $_), $HALF) } 1 .. 10_000) . "\0"],
        'name-1000' => ['a name of 1000 bytes', channel('Y' x 1000, $HALF) . "\0"],
        'unknown' => ['no colour', channel('depth', $HALF) . "\0"],
    );
    for my $name (sort keys %lists) {
        my ($what, $list) = @{$lists{$name}};
        exr("channels-$name", 'ERR', $what, '-', with_table(exr_header(0,
            channels => attribute('channels', 'chlist', $list)), rows()));
    }
    for (['ffffffff', 0xffffffff], ['7fffffff', 0x7fffffff], ['16-mb', 1 << 24]) {
        my ($name, $size) = @$_;
        exr("attribute-$name", 'ERR', "an attribute of $size bytes", '-',
            with_table(exr_header(0, zebra => "zebra\0string\0" . pack('V', $size) . 'stripes'), rows()));
    }
    exr('channels-open', 'EITHER', 'a list of channels that its size ends', '-', with_table(exr_header(0,
        channels => attribute('channels', 'chlist', channel('Y', $HALF))), rows()));
    exr('attribute-type', 'ERR', 'the window is a text', 'dataWindow',
        with_table(exr_header(0, dataWindow => attribute('dataWindow', 'string', '0 0 3 3')), rows()));
    exr('attribute-size', 'ERR', 'a window of 12 bytes', 'dataWindow',
        with_table(exr_header(0, dataWindow => attribute('dataWindow', 'box2i', "\0" x 12)), rows()));
    exr('preview-huge', 'ERR', 'a preview of 2^30 by 2^30 pixels', '-',
        with_table(exr_header(0, preview => attribute('preview', 'preview', pack('V2', 1 << 30, 1 << 30) .
        "\0" x 64)), rows()));
    exr('attributes-10000', 'EITHER', '10,000 attributes', '-',
        with_table(exr_header(0, map { my $name = sprintf 'zebra%05d',
        $_; ($name => attribute($name, 'int', pack 'V', $_)) } 1 .. 10_000), rows()));
    exr('version-9', 'ERR', 'version 9', '-', with_table(exr_header(0) =~ s/^(.{4})\x02/$1\x09/sr, rows()));
    exr('flags', 'ERR', 'flags that nobody knows', '-', with_table(exr_header(0xfff000), rows()));
}

# Wrong chunk offset tables and chunk headers, and truncated files.
sub tables {
    my $header = exr_header(0);
    my @chunks = rows();
    my $begin = length($header) + 8 * @chunks;
    my $body = join '', @chunks;
    my $size = $begin + length $body;
    my %tables = (
        'beyond' => ['points behind the end', map { $_ * 1_000_000 } 1 .. 4],
        'at-the-end' => ['points to the end', ($size) x 4],
        '2e63' => ['points to 2^63', ('9223372036854775808') x 4],
        '2e64' => ['points to 2^64 - 8', ('18446744073709551608') x 4],
        'into-the-header' => ['points into the header', (8) x 4],
        'into-itself' => ['points into the table', map { length $header } 1 .. 4],
    );
    for my $name (sort keys %tables) {
        my ($what, @entries) = @{$tables{$name}};
        exr("table-$name", 'ERR', "the chunk table $what", '-', $header . pack('Q<4', @entries) . $body);
    }
    exr('table-zero', 'EITHER', 'a chunk table of zeros, as a writer leaves that was stopped', '-', $header .
        "\0" x 32 . $body);
    exr('table-same', 'EITHER', 'all entries of the chunk table point to the first row', '-', $header .
        pack('Q<4', ($begin) x 4) . $body);
    # Chunk headers with a wrong row or size.
    for (['size-ffffffff', 0, 0xffffffff], ['size-7fffffff', 0, 0x7fffffff], ['size-0', 0, 0], ['size-9', 0, 9],
        ['number-9', 9, 8], ['number-negative', 0xfffffffe, 8]) {
        my ($name, $y, $bytes) = @$_;
        my @wrong = @chunks;
        substr $wrong[1], 0, 8, pack 'V2', $name =~ /^size/ ? 1 : $y, $bytes;
        exr("row-$name", 'ERR', "the second row has $name", '-', with_table($header, @wrong));
    }
    my $whole = $header . join('', map { pack 'Q<', $begin + 16 * $_ } 0 .. 3) . $body;
    for (['magic', 3], ['version', 6], ['attribute', 20], ['header', length($header) - 1],
        ['table', length($header) + 12], ['rows', $begin], ['row', $begin + 20], ['byte', $size - 1]) {
        my ($name, $at) = @$_;
        exr("truncated-at-$name", 'ERR', "truncated after $at of $size bytes", '-', substr $whole, 0, $at);
    }
    exr('empty', 'ERR', '0 bytes', '-', '');
    exr('sound', 'OK', 'nothing: what the others are made of', '-', $whole);
}

# zipped RAW: a ZIP chunk: even bytes before odd ones, then differences, then zlib
sub zipped {
    my ($raw) = @_;
    my @bytes = unpack 'C*', $raw;
    my @parts = (@bytes[grep { !($_ & 1) } 0 .. $#bytes], @bytes[grep { $_ & 1 } 0 .. $#bytes]);
    return compress(pack 'C*', $parts[0], map { ($parts[$_] - $parts[$_ - 1] + 128) & 255 } 1 .. $#parts);
}

sub packed {
    my @mixed = map { [map { ($_ * 40503 + 77) & 0x3bff } $_ * 64 .. $_ * 64 + 63] } 0 .. 15;
    my $raw = join '', map { pack 'v*', map { $_ & 0x3b00 } @$_ } @mixed;
    my $zip = zipped($raw);
    my $file = sub {
        my ($code, $bytes) = @_;
        my $height = $code == $RLE || $code == $ZIPS ? 1 : 16; # one chunk
        return with_table(exr_header(0, compression => attribute('compression', 'compression', chr $code),
            map { ($_ => attribute($_, 'box2i', window(0, 0, 63, $height - 1))) } qw(dataWindow displayWindow)),
            row(0, $bytes));
    };
    length($zip) < length $raw or die "ZIP chunk of the EXR files has grown\n";
    exr('zip-sound', 'OK', 'a sound ZIP chunk', '-', $file->($ZIP, $zip));
    exr('zip-damaged', 'ERR', 'a ZIP chunk with another byte', 'ZIP chunk',
        $file->($ZIP, substr($zip, 0, 20) . "\xff\xff" . substr $zip, 22));
    exr('zip-truncated', 'ERR', 'half a ZIP chunk', 'ZIP chunk',
        $file->($ZIP, substr $zip, 0, length($zip) / 2));
    exr('zip-short', 'ERR', 'a ZIP chunk of half the bytes', 'ZIP chunk',
        $file->($ZIP, zipped(substr $raw, 0, length($raw) / 2)));
    exr('zip-bomb', 'ERR', 'a ZIP chunk of 1.5 MB where 2048 bytes are wanted', '-',
        $file->($ZIP, compress("\0" x 1_500_000)));
    exr('zip-large', 'ERR', 'a ZIP chunk larger than its pixels', '-', $file->($ZIP, zeros(20_000_000)));
    exr('rle-damaged', 'ERR', 'RLE that is none', '-', $file->($RLE, "\x80" x 100));
    exr('rle-long', 'ERR', 'RLE of more bytes than pixels', '-', $file->($RLE, "\x7f\0" x 50));
    exr('piz-damaged', 'ERR', 'PIZ that is none', '-', $file->($PIZ, "\xff" x 100));
    exr('piz-table', 'ERR', 'PIZ whose Huffman table claims 2^31 bytes', '-',
        $file->($PIZ, pack('v2', 0, 1) . "\xff\xff" . pack('V', 0x7fffffff) .
        pack('V5', 0, 65536, 0x7fffffff, 0x7fffffff, 0) . "\xaa" x 60));
}

# tiled NAME, EXPECT, WHAT, WIDTH, HEIGHT OF TILES, MODE, CHUNK ...
sub tiled {
    my ($name, $expect, $what, $width, $height, $mode, @chunks) = @_;
    exr("tiles-$name", $expect, $what, '-', with_table(exr_header($TILED,
        tiles => attribute('tiles', 'tiledesc', pack 'V2 C', $width, $height, $mode)), @chunks));
}

sub tiles {
    my $pixels = join '', map { pack 'v4', @$_ } @halves;
    my $tile = sub { pack('V4 V', @_, length $pixels) . $pixels };
    my $one = $tile->(0, 0, 0, 0);
    tiled('sound', 'OK', 'a sound tile', 4, 4, 0, $one);
    tiled('0', 'ERR', 'tiles without a size', 0, 0, 0, $one);
    tiled('2e32', 'ERR', 'tiles of 2^32 - 1', 0xffffffff, 0xffffffff, 0, $one);
    tiled('2e31', 'ERR', 'tiles of 2^31 - 1', 0x7fffffff, 0x7fffffff, 0, $one);
    tiled('65536', 'EITHER', 'tiles of 65536 by 65536, one of which would take 8 GB', 65536, 65536, 0, $one);
    tiled('mode-7', 'ERR', 'levels of an unknown kind', 4, 4, 7, $one);
    tiled('mode-2', 'ERR', 'levels of each width with each height', 4, 4, 2, $one);
    tiled('levels-missing', 'ERR', 'three levels, there is one', 4, 4, 1, $one);
    tiled('place', 'ERR', 'a tile that lies elsewhere', 4, 4, 0, $tile->(7, 7, 0, 0));
    tiled('level-9', 'ERR', 'a tile of level 9', 4, 4, 0, $tile->(0, 0, 9, 9));
    exr('tiles-missing', 'ERR', 'tiled, and does not say how', '-', with_table(exr_header($TILED), $one));
    my $part = sub { my ($name, $kind) = @_; (name => attribute('name', 'string', $name),
        type => attribute('type', 'string', $kind), chunkCount => attribute('chunkCount', 'int', pack 'V', 4)) };
    my $parts = exr_header($PARTS, $part->('one', 'scanlineimage'));
    my @numbered = map { pack('V', 0) . $_ } rows();
    exr('parts-sound', 'OK', 'a file of one part', '-', with_table("$parts\0", @numbered));
    exr('parts-open', 'ERR', 'a list of parts without an end', '-', with_table($parts, @numbered));
    exr('parts-none', 'ERR', 'a list of no parts', '-', pack('V2', 20000630, 2 | $PARTS) . "\0");
    exr('parts-same-name', 'EITHER', 'two parts of one name', '-', with_table($parts . substr($parts, 8) . "\0",
        @numbered, map { pack('V', 1) . $_ } rows()));
    exr('parts-wrong-number', 'ERR', 'chunks of a part that is not there', '-',
        with_table("$parts\0", map { pack('V', 9) . $_ } rows()));
    exr('parts-chunks-2e31', 'ERR', 'a part of 2^31 - 1 chunks', 'chunk count',
        with_table($parts =~ s/(chunkCount\0int\0.{4}).{4}/$1\xff\xff\xff\x7f/sr . "\0", @numbered));
    exr('parts-10000', 'ERR', '10,000 parts and no pixels', '-', $parts . substr($parts, 8) x 9_999 . "\0");
    exr('parts-deep', 'ERR', 'deep pixels', '-', with_table(exr_header($PARTS | $DEEP,
        $part->('one', 'deepscanline')) . "\0", @numbered));
    exr('parts-kind', 'ERR', 'a part of an unknown kind', '-', with_table(exr_header($PARTS,
        $part->('one', 'hologram')) . "\0", @numbered));
}

sub pixels {
    my ($nan, $inf, $minus) = (0x7e00, 0x7c00, 0xfc00);
    exr('pixels-nan', 'WARN', 'pixels that are not numbers', '3 .*finite',
        with_table(exr_header(0), rows([$inf, $minus, $nan, 0x3c00], @halves[1 .. 3])));
    exr('pixels-nearly-all-nan', 'WARN', 'four pixels are numbers', '12 .*finite',
        with_table(exr_header(0), rows(map { [($nan) x 3, 0x3400] } 0 .. 3)));
    exr('pixels-denormal', 'OK', 'the smallest numbers that halves hold', '-',
        with_table(exr_header(0), rows(map { [1, 0x8001, 0x3ff, 0x3800] } 0 .. 3)));
    exr('pixels-largest', 'EITHER', 'the largest numbers that halves hold, below 0, too', '-',
        with_table(exr_header(0), rows(map { [0x7bff, 0xfbff, 0x3800, 0] } 0 .. 3)));
    my $floats = sub { with_table(exr_header(0, channels => attribute('channels', 'chlist', channel('Y', $_[0]) .
        "\0")), map { row($_, $_[1]) } 0 .. 3) };
    exr('pixels-nan-float', 'WARN', 'floats that are not numbers', '8 .*finite',
        $floats->($FLOAT, pack 'V4', 0x7f800001, 0xffc00000, 0x3f000000, 0x3e000000));
    exr('pixels-1e38', 'EITHER', 'floats near the largest', '-', $floats->($FLOAT, pack 'f<4', 3e38, -3e38, 0.5,
        0.25));
    exr('pixels-whole-2e32', 'ERR', 'whole numbers that no float holds', 'channel Y .*2.24',
        $floats->($UINT, pack 'V4', 4294967295, 1, 2, 3));
}

windows();
attributes();
tables();
packed();
tiles();
pixels();
1;
