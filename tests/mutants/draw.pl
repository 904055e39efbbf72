#!/usr/bin/env perl
# draw.pl COUNT SEED FILE ...: draws random mutations of single lines of C, C++ and GLSL. Prints a line for each: the
# file, the number of the line, the line before and after, separated by tabs. Each line of code is as likely as any other,
# and each mutation of a line as any other of it. The same seed draws the same mutations on all machines.
use strict;
use warnings;
use FindBin qw($Bin);
require "$Bin/code.pl";

# Binary operators have spaces around them (clang-format sees to it), so that a pointer's * is not one.
my %swapped = (
    '+' => '-', '-' => '+', '*' => '+', '/' => '*', '%' => '/', '<' => '<=', '<=' => '<', '>' => '>=', '>=' => '>',
    '==' => '!=', '!=' => '==', '&&' => '||', '||' => '&&', '+=' => '-=', '-=' => '+=', '*=' => '/=', '/=' => '*=',
    '|' => '&', '&' => '|', '|=' => '&=', '&=' => '|=', '<<' => '>>', '>>' => '<<',
);
my %word = (
    true => 'false', false => 'true', fmin => 'fmax', fmax => 'fmin', fminf => 'fmaxf', fmaxf => 'fminf', min => 'max',
    max => 'min', sin => 'cos', cos => 'sin', floor => 'ceil', ceil => 'floor', break => 'continue', continue => 'break',
);

# Returns the mutations of a line of code: [place, length, replacement].
sub mutations {
    my ($code) = @_;
    my @found;
    # Preprocessor lines other than constants, assertions, and sizes of arrays: one more changes nothing.
    return () if ($code =~ /^\s*#/ && $code !~ /^\s*#define \w+ /) || $code =~ /\bassert(?:_\w+)?\(/;
    $code =~ s/(?<=\[)(\d+)(?=\])/"\x01" x length $1/ge if $code =~ /^\s*(?:(?:static|const|struct|enum) )*\w+ \*?\w+\[/;
    # Nor does it change the sizes of parameters.
    $code =~ s/(\b(?:double|float|u?int\w*) \w+\[)(\d+)(?=\])/$1 . "\x01" x length $2/ge;
    while ($code =~ /(?<= )(\S{1,2})(?= )/g) {
        push @found, [$-[1], length $1, $swapped{$1}] if exists $swapped{$1};
    }
    while ($code =~ /\b(\w+)\b/g) {
        push @found, [$-[1], length $1, $word{$1}] if exists $word{$1};
    }
    push @found, [$-[1], 2, $1 eq '++' ? '--' : '++'] while $code =~ /(\+\+|--)/g;
    push @found, [$-[0], 1, ''] while $code =~ /!(?=[\w(])/g;
    while ($code =~ /(?<![\w.])(\d+)(u?)(?![\w.])/g) { # whole numbers: one more
        push @found, [$-[0], length "$1$2", $1 + 1 . $2];
    }
    while ($code =~ /(?<![\w.])(\d+\.\d*(?:[eE][-+]?\d+)?)(f?)(?!\w)/g) { # others: twice, and 1 for 0
        push @found, [$-[1], length $1, $1 == 0 ? '1.0' : sprintf '(2 * %s)', $1];
    }
    if ($code =~ /\bif \((.*)\)( \{)?\s*$/) {
        push @found, [$-[1], length $1, "!($1)"];
    }
    # A statement that is left out: a call or an assignment on a line of its own.
    if ($code =~ /^\s+((?:[a-z_]\w*|\*)[\w.\[\]>*()-]*(?: [-+*\/|&]?= .*|\(.*\));)\s*$/ && $code !~ /^\s*return\b/) {
        push @found, [$-[1], length $1, ';'];
    }
    return grep { $code !~ /\x01/ || substr($code, $_->[0], $_->[1]) !~ /\x01/ } @found;
}

my ($count, $seed, @files) = @ARGV;
die "usage: draw.pl COUNT SEED FILE ...\n" unless @files;
my @places;
for my $file (sort @files) {
    open my $in, '<', $file or die "draw.pl: $file: $!\n";
    my $text = do { local $/; <$in> };
    my @lines = split /\n/, $text, -1;
    my @code = code_of($text);
    for my $i (0 .. $#lines) {
        my @found = mutations($code[$i]);
        push @places, [$file, $i + 1, $lines[$i], \@found] if @found;
    }
}
srand $seed;
while ($count > 0 && @places) {
    my ($file, $number, $line, $found) = @{splice @places, rand @places, 1};
    my ($place, $length, $new) = @{$found->[rand @$found]};
    my $after = $line;
    substr($after, $place, $length) = $new;
    print join("\t", $file, $number, $line, $after), "\n";
    $count--;
}
