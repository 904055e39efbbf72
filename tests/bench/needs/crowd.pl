# crowd.pl FILE.glb: prints a glTF with nine nodes that draw the file's mesh, in a square, each turned otherwise; its
# data is embedded.
use strict;
use warnings;
use JSON::PP;
use MIME::Base64;
local $/;
open my $file, '<:raw', $ARGV[0] or die "$ARGV[0]: $!";
my $glb = <$file>;
my $size = unpack 'V', substr $glb, 12, 4;
my $scene = decode_json substr $glb, 20, $size;
my $data = substr $glb, 28 + $size;
$scene->{buffers}[0]{uri} = 'data:application/octet-stream;base64,' . encode_base64($data, '');
$scene->{nodes} = [map {
    my $half = 0.35 * $_;
    {mesh => 0, translation => [3 * ($_ % 3), 0.5 * ($_ % 2), 3 * int($_ / 3)], rotation => [sin $half, 0, 0, cos $half]}
} 0 .. 8];
$scene->{scenes} = [{nodes => [0 .. 8]}];
print JSON::PP->new->canonical->encode($scene);
