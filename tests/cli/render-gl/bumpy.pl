# bumpy.pl: copies a GLB from standard input to standard output, with a material whose normal map has ridges along v
use strict; use warnings; use Compress::Zlib; use MIME::Base64;
binmode STDIN; binmode STDOUT; local $/; my $glb = <STDIN>;
my ($length) = unpack 'x12V', $glb; my $json = substr $glb, 20, $length; my $rest = substr $glb, 20 + $length;
my $rows = join '', map { "\0" . join '', map { pack 'C3', 127.5 + 90 * sin($_ * 3.14159265 / 8), 128, 218 } 0 .. 63 } 0 .. 7;
my $chunk = sub { pack('N', length $_[1]) . $_[0] . $_[1] . pack 'N', crc32($_[0] . $_[1]) };
my $png = "\x89PNG\r\n\x1a\n" . $chunk->('IHDR', pack 'N2C5', 64, 8, 8, 2, 0, 0, 0) . $chunk->('IDAT', compress($rows)) . $chunk->('IEND', '');
my $looks = '"materials":[{"normalTexture":{"index":0}}],"textures":[{"source":0}],"images":[{"uri":"data:image/png;base64,'
    . encode_base64($png, '') . '"}],';
$json =~ s/^\{/{$looks/; $json =~ s/("indices":\d+)/$1,"material":0/;
$json .= ' ' while length($json) % 4;
print pack('a4V2', 'glTF', 2, 20 + length($json) + length $rest), pack('Va4', length $json, 'JSON'), $json, $rest;
