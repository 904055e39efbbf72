#!/usr/bin/env perl
# multiply.pl POWER ATTRIBUTE ... <IN >OUT: multiplies attributes of a GLB file by 2^POWER, which is exact: the first
# three components of floats. Takes off least and greatest values, which are decimal numbers.
use strict;
use warnings;
use JSON::PP;

my ($power, @names) = @ARGV;
die "usage: multiply.pl POWER ATTRIBUTE ... <IN >OUT\n" unless @names;
binmode $_ for *STDIN, *STDOUT;
my $file = do { local $/; <STDIN> };
my $length = unpack 'x12 V', $file;
my $json = JSON::PP->new->canonical;
my $scene = $json->decode(substr $file, 20, $length);
my $bytes = substr $file, 28 + $length;
my %chosen;
for my $primitive (map { @{$_->{primitives}} } @{$scene->{meshes}}) {
    $chosen{$_} = 1 for grep { defined } @{$primitive->{attributes}}{@names};
}
die "multiply.pl: no mesh has @names\n" unless %chosen;
for my $accessor (@{$scene->{accessors}}[keys %chosen]) {
    my $view = $scene->{bufferViews}[$accessor->{bufferView}];
    my $size = 4 * substr $accessor->{type}, -1;
    my $from = ($view->{byteOffset} // 0) + ($accessor->{byteOffset} // 0);
    for my $at (map { $from + $size * $_ } 0 .. $accessor->{count} - 1) {
        # The exponents of all but zeros.
        substr($bytes, $at, 12) = pack 'V3', map { $_ & 0x7fffffff ? $_ + $power * 2 ** 23 : $_ } unpack 'V3',
            substr $bytes, $at, 12;
    }
    delete @$accessor{qw(min max)};
}
my $text = $json->encode($scene);
$text .= ' ' x (-length($text) % 4);
print pack('a4 V3 a4', 'glTF', 2, 28 + length($text) + length $bytes, length $text, 'JSON'), $text,
    pack('V a4', length $bytes, "BIN\0"), $bytes;
