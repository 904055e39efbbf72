# make.pl SIZE PATTERN [FORMAT]: writes a KTX2 file with one level to standard output: a solid texture if SIZE is a power
# of two.
#   SIZE     32, texels along a side, or 32x16x8; a depth of 0 makes a 2D texture
#   PATTERN  waves:6    24 waves of random directions, with about 6 periods along a side
#            checker:4  black and white cubes of 4 texels
#            grey:128   one value
#   FORMAT   r8 (default), rg8, rgb8, rgba8 or r32ui; further channels are the first, moved along x by 5 texels each
use strict;
use warnings;

my ($size, $pattern, $format) = @ARGV;
my ($width, $height, $depth) = $size =~ /x/ ? split(/x/, $size) : ($size) x 3;
my ($vk, $channels, $code) = @{{r8 => [9, 1, 'C'], rg8 => [16, 2, 'C'], rgb8 => [23, 3, 'C'], rgba8 => [37, 4, 'C'],
    r32ui => [98, 1, 'V']}->{$format // 'r8'}};
my ($kind, $number) = split /:/, $pattern;
my $state = 1;

sub random {
    $state = ($state * 1103515245 + 12345) % 2**31;
    return $state / 2**31;
}

my (@waves, @cosines);
for (my $left = $kind eq 'waves' ? 24 : 0; $left > 0;) {
    my @wave = map { int(3 * $number * random() - 1.5 * $number + 0.5) } 1 .. 3;
    my $length = sqrt($wave[0]**2 + $wave[1]**2 + $wave[2]**2);
    next if abs($length - $number) > 0.15 * $number;
    push @waves, [@wave, int($width * random())];
    $left--;
}
@cosines = map { cos(2 * 3.14159265358979 * $_ / $width) } 0 .. $width - 1;

sub value {
    my ($x, $y, $z) = @_;
    return $number if $kind eq 'grey';
    return 255 * ((int($x / $number) + int($y / $number) + int($z / $number)) % 2) if $kind eq 'checker';
    my $sum = 0;
    $sum += $cosines[($_->[0] * $x + $_->[1] * $y + $_->[2] * $z + $_->[3]) % $width] for @waves;
    my $grey = 127.5 + 18.4 * $sum; # two standard deviations from ink to paper
    return $grey < 0 ? 0 : $grey > 255 ? 255 : int($grey + 0.5);
}

my $texels = '';
for my $z (0 .. ($depth || 1) - 1) {
    for my $y (0 .. $height - 1) {
        my @row = map { value($_, $y, $z) } 0 .. $width - 1;
        $texels .= pack "$code*", map { my $x = $_; map { $row[($x + 5 * $_) % $width] } 0 .. $channels - 1 }
            0 .. $width - 1;
    }
}

my $samples = join '', map { pack 'vCCVVV', 8 * $_, 7, $_, 0, 0, 255 } 0 .. $channels - 1;
my $block = pack('Vvv C12', 0, 2, 24 + length $samples, 1, 1, 1, 0, 0, 0, 0, 0, $channels, 0, 0, 0)
    . pack('V', 0) . $samples;
my $description = pack('V', 4 + length $block) . $block;
my $begin = 80 + 24 + length $description;
my $padding = "\0" x (-$begin % 12);
binmode STDOUT;
print "\xabKTX 20\xbb\r\n\x1a\n", pack('V9', $vk, $code eq 'V' ? 4 : 1, $width, $height, $depth, 0, 1, 1, 0),
    pack('V4 Q<2', 104, length $description, 0, 0, 0, 0),
    pack('Q<3', $begin + length $padding, length $texels, length $texels), $description, $padding, $texels;
