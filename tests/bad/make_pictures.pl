# Damaged PNG, JPEG and TIFF images, and false headers of other formats, for make.pl.
use strict;
use warnings;
use Compress::Zlib qw(compress crc32 deflateInit Z_FULL_FLUSH Z_OK);

my $signature = "\x89PNG\r\n\x1a\n";
my ($GREY, $RGB, $PALETTE, $RGBA) = (0, 2, 3, 6);

sub png_chunk {
    my ($type, $bytes) = @_;
    return pack('N', length $bytes) . $type . $bytes . pack 'N', crc32($type . $bytes);
}

# ihdr WIDTH, HEIGHT, DEPTH, COLOUR TYPE, COMPRESSION, FILTER, INTERLACE
sub ihdr {
    return png_chunk('IHDR', pack 'N2 C5', map { $_ // 0 } @_[0 .. 6]);
}

# An image of 8 x 8 greys, dark in the middle: a stroke, for commands that take one.
my $rows = join '', map { my $y = $_; pack 'C*', 0,
    map { my $x = $_; 255 - 4 * ($x * (7 - $x) + $y * (7 - $y)) } 0 .. 7 } 0 .. 7;
my $head = ihdr(8, 8, 8, $GREY);
my $idat = png_chunk('IDAT', compress($rows));
my $end = png_chunk('IEND', '');

# png NAME, EXPECT, WHAT, SAYS, CHUNK ...
sub png {
    my ($name, $expect, $what, $says, @chunks) = @_;
    add_input("png/$name.png", $expect, $what, $says, join '', $signature, @chunks);
}

# zeros COUNT: a zlib stream of zero bytes. Each MiB of them is flushed, so that its compressed bytes can be repeated.
sub zeros {
    my ($count) = @_;
    my $piece = 1 << 20;
    my $pack = sub {
        my ($size, $last) = @_;
        my ($stream, $status) = deflateInit(-Level => 9, -WindowBits => -15);
        my ($bytes, $rest);
        $status == Z_OK or die "deflateInit: $status\n";
        ($bytes, $status) = $stream->deflate("\0" x $size);
        ($rest, $status) = $last ? $stream->flush() : $stream->flush(Z_FULL_FLUSH);
        return $bytes . $rest;
    };
    my $whole = int $count / $piece;
    my $sum = ($count % 65521) << 16 | 1; # Adler-32
    return pack('n', 0x78da) . $pack->($piece, 0) x $whole . $pack->($count - $whole * $piece, 1) . pack 'N', $sum;
}

sub bombs {
    my $bytes = 65535 * (1 + 8192);
    my $many = 'pixels .*bytes';
    my $short = 'pixels in a file of [0-9]* bytes';
    png('bomb-65535x65535-1-bit', 'ERR', '4.3 thousand million pixels in half a megabyte, all there',
        "65535x65535 $many",
        ihdr(65535, 65535, 1, $GREY), png_chunk('IDAT', zeros($bytes)), $end);
    png('bomb-65535x65535-rgba-16', 'ERR', 'claims 34 GB in 100 bytes', "65535x65535 $many",
        ihdr(65535, 65535, 16, $RGBA), $idat, $end);
    png('claims-10000x10000', 'ERR', 'claims 400 MB in 100 bytes', "10000x10000 $short",
        ihdr(10_000, 10_000, 8, $RGBA), $idat, $end);
    png('claims-16777216x1', 'ERR', 'claims one row of 2^24 pixels', $short, ihdr(1 << 24, 1, 8, $GREY), $idat, $end);
    png('claims-1x16777217', 'ERR', 'claims 2^24 + 1 rows', '[Ii]nvalid IHDR|limit', ihdr(1, (1 << 24) + 1, 8, $GREY),
        $idat, $end);
    for (['2e31', 1 << 31], ['2e32', 0xffffffff], ['0', 0]) {
        my ($name, $side) = @$_;
        png("width-$name", 'ERR', "claims a width of $side", '[Ii]nvalid IHDR|out of range', ihdr($side, 8, 8, $GREY),
            $idat, $end);
        png("height-$name", 'ERR', "claims a height of $side", '[Ii]nvalid IHDR|out of range', ihdr(8, $side, 8, $GREY),
            $idat, $end);
    }
    my $text = zeros(50_000_000);
    png('text-50-mb', 'EITHER', 'a comment of 50 MB, packed', '-', $head, png_chunk('zTXt', "Comment\0\0" . $text),
        $idat, $end);
    png('profile-50-mb', 'EITHER', 'a colour profile of 50 MB, packed', '-', $head,
        png_chunk('iCCP', "icc\0\0" . $text), $idat, $end);
    png('comments-100000', 'EITHER', '100,000 comments', '-', $head, png_chunk('tEXt', "a\0b") x 100_000, $idat,
        $end);
}

sub headers {
    my @fields = ([8, 8, 8, 9], [8, 8, 8, 1], [8, 8, 8, 5], [8, 8, 8, 7], [8, 8, 3, $GREY], [8, 8, 0, $GREY],
        [8, 8, 32, $GREY],
        [8, 8, 16, $PALETTE], [8, 8, 4, $RGB], [8, 8, 8, $GREY, 1], [8, 8, 8, $GREY, 0, 1],
        [8, 8, 8, $GREY, 0, 0, 7]);
    for (@fields) {
        my ($width, $height, $depth, $type, $compression, $filter, $interlace) = map { $_ // 0 } @$_[0 .. 6];
        png("header-depth-$depth-type-$type-methods-$compression$filter$interlace", 'ERR',
            "depth $depth, colour type $type, methods $compression, $filter, $interlace", '[Ii]nvalid IHDR', ihdr(@$_),
            $idat, $end);
    }
    png('header-missing', 'ERR', 'no header', '-', $idat, $end);
    png('header-later', 'ERR', 'the header is the second chunk', '-', png_chunk('tEXt', "a\0b"), $head, $idat, $end);
    png('header-twice', 'ERR', 'two headers', '-', $head, ihdr(4, 4, 8, $GREY), $idat, $end);
    png('header-short', 'ERR', 'a header of 12 bytes', '-', png_chunk('IHDR', pack 'N2 C4', 8, 8, 8, $GREY), $idat,
        $end);
}

# wrong BYTES, OFFSET: inverts a bit of one byte; negative offsets count from the end
sub wrong {
    my ($bytes, $offset) = @_;
    substr $bytes, $offset, 1, chr(ord(substr $bytes, $offset, 1) ^ 1);
    return $bytes;
}

sub chunks {
    png('crc-of-the-header', 'ERR', 'the header has another checksum', 'CRC', wrong($head, -1), $idat, $end);
    png('crc-of-the-pixels', 'ERR', 'the pixels have another checksum', 'CRC', $head, wrong($idat, -1), $end);
    png('crc-of-a-comment', 'EITHER', 'a comment has another checksum', '-', $head,
        wrong(png_chunk('tEXt', "a\0b"), -1), $idat, $end);
    png('adler', 'ERR', 'the packed pixels have another checksum', '-', $head,
        png_chunk('IDAT', wrong(compress($rows), -1)), $end);
    png('deflate', 'ERR', 'the packed pixels are damaged', '-', $head, png_chunk('IDAT', wrong(compress($rows), 5)),
        $end);
    png('deflate-header', 'ERR', 'the packed pixels begin with other bytes', '-', $head,
        png_chunk('IDAT', "\0\0" . compress($rows)), $end);
    png('rows-missing', 'ERR', 'seven rows of eight', '-', $head, png_chunk('IDAT', compress(substr $rows, 0, 63)),
        $end);
    png('rows-too-many', 'EITHER', 'a thousand rows of eight', '-', $head, png_chunk('IDAT', compress($rows x 125)),
        $end);
    png('row-filter', 'ERR', 'a row with filter 9', 'filter', $head, png_chunk('IDAT',
        compress("\x09" . substr $rows, 1)), $end);
    png('pixels-missing', 'ERR', 'no pixels', '-', $head, $end);
    png('pixels-empty', 'ERR', 'a thousand chunks of no pixels', '-', $head, png_chunk('IDAT', '') x 1000, $end);
    png('end-missing', 'ERR', 'no last chunk', '-', $head, $idat);
    png('length-ffffffff', 'ERR', 'a chunk of 2^32 - 1 bytes', '-', $head, "\xff\xff\xff\xffIDAT", $end);
    png('length-7fffffff', 'ERR', 'a chunk of 2^31 - 1 bytes', '-', $head, "\x7f\xff\xff\xffIDAT", $end);
    png('chunk-unknown', 'ERR', 'an unknown chunk that readers must know', '-', $head, png_chunk('HTCH', 'x'), $idat,
        $end);
    png('chunk-name', 'ERR', 'a chunk whose name is no letters', '-', $head, png_chunk("\0\1\2\3", 'x'), $idat, $end);
    my $indexed = ihdr(8, 8, 8, $PALETTE);
    png('palette-missing', 'ERR', 'no palette', '-', $indexed, $idat, $end);
    png('palette-7-bytes', 'ERR', 'a palette of 7 bytes', '-', $indexed, png_chunk('PLTE', 'palette'), $idat, $end);
    png('palette-short', 'EITHER', 'two colours, and pixels of 256', '-', $indexed,
        png_chunk('PLTE', "\0\0\0\xff\xff\xff"), $idat, $end);
    my $whole = join '', $signature, $head, $idat, $end;
    for my $size (1, 7, 8, 20, 33, 60, length($whole) - 1) {
        add_input(sprintf('png/truncated-at-%03d.png', $size), 'ERR', "truncated after $size of " . length($whole) .
            ' bytes', '-',
            substr $whole, 0, $size);
    }
    add_input('png/empty.png', 'ERR', '0 bytes', '-', '');
    add_input('png/newlines.png', 'ERR', 'its newlines were made those of another system', '-',
        $whole =~ s/\r\n/\n/r);
    png('sound', 'OK', 'nothing: what the others are made of', '-', $head, $idat, $end);
}

sub segment {
    my ($marker, $bytes) = @_;
    return pack('C2 n', 0xff, $marker, 2 + length $bytes) . $bytes;
}

# jpeg NAME, EXPECT, WHAT, SAYS, SIDE, SCAN: a grey image of SIDE x SIDE pixels with one code per Huffman table
sub jpeg {
    my ($name, $expect, $what, $says, $side, $scan) = @_;
    add_input("foreign/$name.jpg", $expect, $what, $says, join '', "\xff\xd8",
        segment(0xe0, "JFIF\0\1\1\0\0\1\0\1\0\0"),
        segment(0xdb, "\0" . "\1" x 64), segment(0xc0, pack 'C n2 C4', 8, $side, $side, 1, 1, 0x11, 0),
        segment(0xc4, "\x00\1" . "\0" x 15 . "\0"), segment(0xc4, "\x10\1" . "\0" x 15 . "\0"), $scan);
}

sub jpegs {
    my $scan = segment(0xda, pack 'C6', 1, 1, 0, 0, 63, 0);
    my $many = 'pixels .*bytes';
    jpeg('bomb-65500x65500', 'ERR', 'claims 4.3 thousand million pixels', "65500x65500 $many", 65500,
        "$scan\0\0\xff\xd9");
    jpeg('truncated-in-the-scan', 'ERR', 'no end', 'no end', 64, "$scan\0\0");
    jpeg('truncated-before-the-scan', 'ERR', 'no scan', '-', 64, '');
    jpeg('no-scan', 'ERR', 'the end before any scan', '-', 64, "\xff\xd9");
    jpeg('side-0', 'ERR', 'no pixels', '-', 0, "$scan\0\0\xff\xd9");
    jpeg('scan-of-two-bytes', 'EITHER', '64 blocks in two bytes', '-', 64, "$scan\0\0\xff\xd9");
    add_input('foreign/start.jpg', 'ERR', 'two markers and no more', '-', "\xff\xd8\xff\xe0");
    add_input('foreign/segment-short.jpg', 'ERR', 'a segment of no length', '-', "\xff\xd8\xff\xe0\0\0\xff\xd9");
    add_input('foreign/segment-truncated.jpg', 'ERR', 'a segment that passes the end', '-',
        "\xff\xd8\xff\xe0\xff\xffJFIF");
    add_input('foreign/empty.jpg', 'ERR', '0 bytes', '0 bytes', '');
}

my ($LONG, $DEFLATE) = (4, 8);

# tiff ORDER, ENTRY ...: ORDER is '<' or '>', entries are [tag, type, count, value]
sub tiff {
    my ($letter, @entries) = @_;
    my $entry = $letter eq '<' ? 'v v V V' : 'n n N N';
    my $head = $letter eq '<' ? pack 'A2 v V v', 'II', 42, 8, scalar @entries : pack 'A2 n N n', 'MM', 42, 8,
        scalar @entries;
    return $head . join('', map { pack $entry, @$_ } @entries) . pack 'V', 0;
}

# strips COMPRESSION, CHANGE: a grey TIFF image of 64 x 64 pixels in four strips; CHANGE modifies the third one after
# compression
sub strips {
    my ($compression, $change) = @_;
    my @strips = map { my $top = 16 * $_; join '', map { my $y = $top + $_; pack 'C*',
        map { ($_ * $y + 40) & 255 } 0 .. 63 } 0 .. 15 } 0 .. 3;
    @strips = map { compress($_) } @strips if $compression == $DEFLATE;
    $strips[2] = $change->($strips[2]) if $change;
    my $table = 8 + 2 + 12 * 9 + 4;
    my ($at, @offsets) = ($table + 32);
    for (@strips) {
        push @offsets, $at;
        $at += length;
    }
    return tiff('<', [256, $LONG, 1, 64], [257, $LONG, 1, 64], [258, $LONG, 1, 8], [259, $LONG, 1, $compression],
        [262, $LONG, 1, 1],
        [273, $LONG, 4, $table], [277, $LONG, 1, 1], [278, $LONG, 1, 16], [279, $LONG, 4, $table + 16]) .
        pack('V*', @offsets, map { length } @strips) . join '', @strips;
}

sub tiffs {
    my $claims = 'claims more pixels than memory holds';
    my $many = 'pixels .*bytes';
    my @grey = ([258, $LONG, 1, 8], [259, $LONG, 1, 1], [262, $LONG, 1, 1], [273, $LONG, 1, 8], [277, $LONG, 1, 1],
        [278, $LONG, 1, 1_000_000], [279, $LONG, 1, 64]);
    my $sized = sub {
        my ($letter, $side, @more) = @_;
        return tiff($letter, [256, $LONG, 1, $side], [257, $LONG, 1, $side], @more);
    };
    add_input('foreign/bomb.tif', 'ERR', $claims, $many, $sized->('<', 1_000_000, @grey));
    add_input('foreign/bomb-big-endian.tif', 'ERR', $claims, $many, $sized->('>', 1_000_000, @grey));
    add_input('foreign/claims-4000x4000.tif', 'ERR', 'claims 16 MB in 120 bytes', '-', $sized->('<', 4000, @grey));
    for my $side (60_000, 2_000_000_000) {
        add_input("foreign/tiles-of-$side.tif", 'ERR', "64 by 64 pixels in tiles of $side by $side",
            "tiles of ${side}x$side pixels",
            $sized->('<', 64, @grey[0 .. 2], $grey[4], [322, $LONG, 1, $side], [323, $LONG, 1, $side],
            [324, $LONG, 1, 8], [325, $LONG, 1, 64]));
    }
    add_input('foreign/strips.tif', 'OK', 'nothing: what the others are made of', '-', strips($DEFLATE));
    add_input('foreign/strip-truncated.tif', 'ERR', 'half a deflated strip', '-',
        strips($DEFLATE, sub { substr $_[0], 0, length($_[0]) / 2 }));
    add_input('foreign/strip-damaged.tif', 'ERR', 'a deflated strip that is damaged', '-',
        strips($DEFLATE, sub { "\xff" x length $_[0] }));
    add_input('foreign/strip-short.tif', 'ERR', 'a strip of 100 bytes', '-', strips(1, sub { substr $_[0], 0, 100 }));
    add_input('foreign/directory-beyond.tif', 'ERR', 'its directory lies behind the end', '-', pack 'A2 v V', 'II',
        42,
        4_000_000_000);
    add_input('foreign/directory-truncated.tif', 'ERR', '65535 entries, there are none', '-', pack 'A2 v V v', 'II',
        42, 8,
        65535);
    add_input('foreign/directory-loop.tif', 'ERR', 'a directory that is followed by itself', '-',
        substr($sized->('<', 8), 0, -4) . pack 'V', 8);
}

sub others {
    my $many = 'pixels .*bytes';
    my $claims = 'claims more pixels than memory holds';
    add_input('foreign/bomb.bmp', 'ERR', $claims, $many, pack 'A2 V3 V2 l< v2 V6', 'BM', 70, 0, 54, 40, 1_000_000,
        1_000_000, 1, 24, (0) x 6);
    add_input('foreign/height-min.bmp', 'ERR', 'claims a height of -2^31', '-',
        pack 'A2 V3 V2 l< v2 V6', 'BM', 70, 0, 54, 40, 100, -2147483648, 1, 24, (0) x 6);
    add_input('foreign/truncated.bmp', 'ERR', 'claims 64 by 64 pixels and has none', '-', pack 'A2 V3 V2 l< v2 V6',
        'BM', 54,
        0, 54, 40, 64, 64, 1, 24, (0) x 6);
    add_input('foreign/bomb.gif', 'ERR', $claims, $many, pack 'A6 v2 C3', 'GIF89a', 65535, 65535, 0x80, 0, 0);
    add_input('foreign/frame-large.gif', 'ERR', 'a frame of 65535 by 65535 on a screen of 4 by 4', '-',
        pack('A6 v2 C3', 'GIF89a', 4, 4, 0x80, 0, 0) . "\0\0\0\xff\xff\xff" .
        pack('C v4 C', 0x2c, 0, 0, 65535, 65535, 0) . "\2\1\0\0;");
    add_input('foreign/bomb.tga', 'ERR', $claims, '-', pack('C3 x5 v4 C2', 0, 0, 2, 0, 0, 65535, 65535, 24, 0) .
        "\0" x 64);
    add_input('foreign/bomb.hdr', 'ERR', $claims, '-',
        "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1000000 +X 1000000\n" .
        "\2\2\0\0" x 16);
    add_input('foreign/bomb.ppm', 'ERR', $claims, '-', "P6\n1000000 1000000\n255\n" . "\0" x 64);
    add_input('foreign/text.png', 'ERR', 'a text that is called a picture', '-', "This is no picture.\n");
}

bombs();
headers();
chunks();
jpegs();
tiffs();
others();
1;
