#!/usr/bin/env perl
# golden.pl check FILE FIGURES: prints TAP: for each run whether the figures in FIGURES (figures.pl) are those in FILE.
# golden.pl write FIGURES ...: prints what FILE has to hold: the first figures, each with how far the others differ, if
# that is more than a check forgives. The others are of the same tree in other builds and on other machines.
#
# FILE has a line for each file of a run, as FIGURES; a figure may have its spread behind a ~. A file that has other
# numbers of figures elsewhere has a - instead.
use strict;
use warnings;

# Forgiven differences: shares of the figure, more of pictures, as OpenGL is free in details; and an absolute one.
my %RELATIVE = (picture => 1e-3, other => 2e-4);
my $ABSOLUTE = 1e-6;
my $MARGIN = 2; # forgiven spreads

# Reads lines of figures and returns {RUN}{NAME}: the figures.
sub figures {
    my ($file) = @_;
    open my $in, '<', $file or die "golden.pl: $file: $!\n";
    my %found;
    while (<$in>) {
        chomp;
        my ($run, $name, $numbers) = split /\t/;
        $found{$run}{$name} = [split / /, $numbers];
    }
    return \%found;
}

sub apart { # two figures of a file, as a share of what is forgiven without a spread
    my ($name, $a, $b) = @_;
    my $forgiven = $RELATIVE{$name =~ /^picture/ ? 'picture' : 'other'} * abs $a;
    return abs($a - $b) / ($forgiven > $ABSOLUTE ? $forgiven : $ABSOLUTE);
}

# The differences of a run, a text each.
sub differences {
    my ($want, $got) = @_;
    my @said;
    for my $name (sort keys %$want) {
        my ($now, $was) = ($got->{$name}, $want->{$name});
        if (!$now) {
            push @said, "$name: is missing";
        } elsif ("@$was" eq '-') {
            next;
        } elsif (@$now != @$was) {
            push @said, sprintf '%s: %d figures, want %d', $name, scalar @$now, scalar @$was;
        } else {
            for my $i (0 .. $#$was) {
                my ($value, $spread) = split /~/, $was->[$i];
                push @said, "$name: figure $i is $now->[$i], want $was->[$i]"
                    if apart($name, $value, $now->[$i]) > 1 && abs($value - $now->[$i]) > $MARGIN * ($spread // 0);
            }
        }
    }
    return @said, map { "$_: is new" } grep { !$want->{$_} } sort keys %$got;
}

sub check {
    my ($want, $got) = map { figures($_) } @_;
    my $number = 0;
    for my $run (sort keys %$want) {
        my @said = differences($want->{$run}, $got->{$run} // {});
        printf "%s %d - %s\n", @said ? 'not ok' : 'ok', ++$number, $run;
        print map { "# $_\n" } splice @said, 0, 5;
    }
    print "1..$number\n";
}

sub write_lines {
    my ($first, @others) = map { figures($_) } @_;
    for my $run (sort keys %$first) {
        for my $name (sort keys %{$first->{$run}}) {
            my @figures = @{$first->{$run}{$name}};
            @figures = ('-') if grep { @{$_->{$run}{$name} // []} != @figures } @others;
            for my $i (0 .. $#figures) {
                last if $figures[$i] eq '-';
                my @found = map { $_->{$run}{$name}[$i] } @others;
                my ($spread) = sort { $b <=> $a } map { abs($_ - $figures[$i]) } @found, $figures[$i];
                $figures[$i] .= sprintf '~%.2g', $spread if apart($name, $figures[$i], $figures[$i] + $spread) > 0.5;
            }
            print join("\t", $run, $name, join ' ', @figures), "\n";
        }
    }
}

my ($what, @files) = @ARGV;
if (($what // '') eq 'check' && @files == 2) {
    check(@files);
} elsif (($what // '') eq 'write' && @files) {
    write_lines(@files);
} else {
    die "usage: golden.pl check FILE FIGURES | golden.pl write FIGURES ...\n";
}
