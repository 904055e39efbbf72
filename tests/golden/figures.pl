#!/usr/bin/env perl
# figures.pl PIXELS FOLDER: prints figures of all files of the runs in FOLDER, which runs.sh has kept: a line for each
# file, its run, its name and its figures, separated by tabs. The figures tell whether a file is as it was but for
# rounding:
#   pictures, maps and textures: as the program PIXELS prints them;
#   glTF: of each accessor the number of components, their mean, their root mean square and their mean change from one
#   element to the next; then the numbers of the JSON, as of text;
#   text: its numbers, up to 150 of them; of more, their count, and as for an accessor the mean, the root mean square and
#   the mean change of the numbers on a logarithmic scale;
#   other files: of the bytes, as of an accessor.
use strict;
use warnings;
use JSON::PP;

my $MOST_NUMBERS = 150;

my ($pixels, $folder) = @ARGV;
die "usage: figures.pl PIXELS FOLDER\n" unless defined $folder;
my $json = JSON::PP->new->utf8->allow_bignum(0);

# The mean, the root mean square and the mean change from one element to the next of values.
sub moments {
    my ($stride, @values) = @_;
    my ($sum, $squares, $change) = (0, 0, 0);
    for my $i (0 .. $#values) {
        $sum += $values[$i];
        $squares += $values[$i] ** 2;
        $change += abs($values[$i] - $values[$i - $stride]) if $i >= $stride;
    }
    my $count = @values || 1;
    return map { sprintf '%.5g', $_ } $sum / $count, sqrt($squares / $count), $change / $count;
}

sub of_numbers {
    my @numbers = @_;
    return map { sprintf '%.5g', $_ } @numbers if @numbers <= $MOST_NUMBERS;
    return (scalar @numbers, moments(1, map { ($_ < 0 ? -1 : 1) * log(1 + 1e3 * abs $_) } @numbers));
}

sub of_text {
    my ($text) = @_;
    return of_numbers($text =~ /(?<![\w.])-?\d+(?:\.\d*)?(?:e[-+]?\d+)?|(?<=[A-Za-z])-?\d+\.\d+/g);
}

# The numbers of a JSON value, in the order of its keys.
sub numbers_in {
    my ($value) = @_;
    return map { numbers_in($_) } @$value if ref $value eq 'ARRAY';
    return map { numbers_in($value->{$_}) } sort keys %$value if ref $value eq 'HASH';
    return defined $value && !ref $value && $value =~ /^-?\d+(?:\.\d+)?(?:e[-+]?\d+)?$/i ? $value : ();
}

# The components of the Nth accessor.
sub components {
    my ($scene, $bytes, $accessor) = @_;
    my %kinds = (5120 => ['c', 1], 5121 => ['C', 1], 5122 => ['s<', 2], 5123 => ['S<', 2], 5125 => ['L<', 4], 5126 => ['f<', 4]);
    my %counts = (SCALAR => 1, VEC2 => 2, VEC3 => 3, VEC4 => 4, MAT4 => 16);
    my ($code, $size) = @{$kinds{$accessor->{componentType}}};
    my $each = $counts{$accessor->{type}};
    my $view = defined $accessor->{bufferView} ? $scene->{bufferViews}[$accessor->{bufferView}] : return ($each);
    my $stride = $view->{byteStride} // $each * $size;
    my $from = ($view->{byteOffset} // 0) + ($accessor->{byteOffset} // 0);
    return ($each, map { unpack "(${code})$each", substr $bytes, $from + $_ * $stride, $each * $size }
        0 .. $accessor->{count} - 1);
}

sub of_glb {
    my ($file) = @_;
    my $length = unpack 'x12 V', $file;
    my $scene = $json->decode(substr $file, 20, $length);
    my $bytes = substr $file, 28 + $length;
    my @figures;
    for my $accessor (@{$scene->{accessors} // []}) {
        my ($each, @values) = components($scene, $bytes, $accessor);
        push @figures, scalar @values, moments($each, @values);
        delete @$accessor{qw(min max)};
    }
    delete @$scene{qw(bufferViews buffers)};
    return (@figures, of_numbers(numbers_in($scene)));
}

my (@pictures, %figures);
for my $path (sort glob "$folder/runs/*/files/{.out,.err,*}") {
    open my $in, '<:raw', $path or die "figures.pl: $path: $!\n";
    my $file = do { local $/; <$in> } // next;
    if ($file =~ /^(?:\x89PNG|\x76\x2f\x31\x01|\xabKTX 20)/) {
        push @pictures, $path;
    } elsif ($file =~ /^glTF/) {
        $figures{$path} = join ' ', of_glb($file);
    } elsif ($file =~ /[^\t\n\r\x20-\x7e]/ && $file =~ /[\x00-\x08]/) {
        $figures{$path} = join ' ', length $file, moments(1, unpack 'C*', $file);
    } else {
        $figures{$path} = join ' ', of_text($file);
    }
}
while (my @some = splice @pictures, 0, 500) {
    open my $in, '-|', $pixels, @some or die "figures.pl: $pixels: $!\n";
    while (<$in>) {
        chomp;
        my ($path, $found) = split /\t /;
        $figures{$path} = $found;
    }
    close $in or die "figures.pl: $pixels has failed\n";
}
for my $path (sort keys %figures) {
    my ($run, $name) = $path =~ m{/runs/([^/]+)/files/(.*)$};
    print "$run\t$name\t$figures{$path}\n" if length $figures{$path};
}
