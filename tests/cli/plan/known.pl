#!/usr/bin/env perl
# In place of render-gl, for search.t: draws pictures of one tone in times that are known.
#   $KNOWN  a file with a line for each candidate, as in "rptam 20x1 | 50 .08 | 48,52 .07": its time in ms and error of
#           tone in small pictures, and in full ones. Of several times, each run takes the next; "-": it cannot be drawn;
#           "limit": a limit is reached
#   $RUNS   a file to which each run appends: small or full, the candidate, how often each picture is drawn, and of a
#           film the pictures and their rate
use strict;
use warnings;

# A plain frame takes 10 ms in full pictures and 4 in small ones, in which all processors together work 20 and 16.
my %plain = (full => {wall => 10, work => 20}, small => {wall => 4, work => 16});
my $TONE = 0.5;

my %given;
while (@ARGV) {
    my $option = shift;
    $given{$option} = $option eq '-q' ? 1 : shift;
}
my ($width, $height) = split /x/, $given{'--size'};
my $size = $width < 320 ? 'small' : 'full';
my $name = join ' ', grep { defined } @given{qw(--technique --stroke --aggregate)};

open my $known, '<', $ENV{KNOWN} or die;
my ($row) = grep { $_->[0] eq $name } map { [split /\s*\|\s*|\s*\n/] } <$known>;
die "render-gl: $name is not known\n" unless $row || $name eq 'gouraud';
my ($times, $error) = $row ? split / /, $row->[$size eq 'small' ? 1 : 2] : (0, 0);
my @times = split /,/, $times;

open my $runs, '+>>', $ENV{RUNS} or die;
seek $runs, 0, 0;
my $before = grep { /^$size \Q$name\E \d/ } <$runs>;
print $runs join(' ', $size, $name, grep { defined } @given{qw(--draws --frames --rate)}), "\n";
my $ms = $times[$before < @times ? $before : -1];
my %failures = ('-' => 3, limit => 5);
if (my $status = $failures{$ms}) {
    print STDERR "render-gl: $name cannot be drawn\n";
    exit $status;
}

sub attribute {
    my ($name, $type, $bytes) = @_;
    return "$name\0$type\0" . pack('V', length $bytes) . $bytes;
}

# picture LIGHT: an OpenEXR file of one grey level
sub picture {
    my ($light) = @_;
    my $window = pack 'l<4', 0, 0, $width - 1, $height - 1;
    my $channel = "Y\0" . pack 'V4', 2, 0, 1, 1; # floats
    my $header = pack('V2', 20000630, 2) . attribute('channels', 'chlist', "$channel\0") .
        attribute('compression', 'compression', "\0") . attribute('dataWindow', 'box2i', $window) .
        attribute('displayWindow', 'box2i', $window) . attribute('lineOrder', 'lineOrder', "\0") .
        attribute('pixelAspectRatio', 'float', pack 'f<', 1) .
        attribute('screenWindowCenter', 'v2f', pack 'f<2', 0, 0) .
        attribute('screenWindowWidth', 'float', pack 'f<', 1) . "\0";
    my $row = pack('f<', $light) x $width;
    my ($first, $bytes) = (length($header) + 8 * $height, 8 + length $row);
    return join '', $header, (map { pack 'Q<', $first + $bytes * $_ } 0 .. $height - 1),
        map { pack('V2', $_, length $row) . $row } 0 .. $height - 1;
}

sub put {
    my ($path, $bytes) = @_;
    open my $file, '>:raw', $path or die;
    print $file $bytes;
    close $file or die;
}

# The work of a candidate is as many times that of a plain frame as its time is that of one in full pictures.
my $work = ($row ? $ms / $plain{full}{wall} : 1) * $plain{$size}{work};
my $wall = $row ? 1 : $plain{$size}{wall};
my $table = "frame\tdraws\tleast\twall_ms\tcpu_ms\tdevice\n";
for my $frame (0 .. ($given{'--frames'} // 1) - 1) {
    $table .= "$frame\t1\t0\t$wall\t$work\tllvmpipe\n";
    put($given{'-o'} =~ s/%d/$frame/r, picture(1 - $TONE - $error));
}
put($given{'--times'}, $table);
