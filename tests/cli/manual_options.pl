#!/usr/bin/env perl
# manual_options.pl TABLE MANUAL: prints the differences between the options of a manual and the table that COMMAND
# --options-table prints, in range, default and choices. An option's line in the manual ends in range and default,
#     .It Fl -tone-gamma Ar G Pq 0.05 to 20 ; default 1
# with "each" for pairs; further words may follow the default after a comma and a space. An option without a default in
# the table has none in the manual, or one in words: "default: as noise asks". Numbers may be written 2^53, 1e9 and 4G.
# Each choice is a Cm in the option's entry or an item of the section to which it refers, and all such items are choices.
# A number given as the default in the help must be the table's.
use strict;
use warnings;

my ($table_path, $manual_path) = @ARGV;

sub number {
    my ($text) = @_;
    return 2**$1 if $text =~ /^2\^(\d+)$/;
    return $1 * 1024**(1 + index 'KMG', $2) if $text =~ /^(\d+)([KMG])$/;
    return $text =~ /^-?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/ ? $text : undef;
}

# Numbers, pairs of them, or words.
sub same {
    my ($got, $want) = @_;
    return 1 if $got eq $want;
    my @got = map { number($_) } split /[:x]/, $got;
    my @want = map { number($_) } split /[:x]/, $want;
    return 0 if @got != @want || !@got || grep { !defined } @got, @want;
    return !grep { abs($got[$_] - $want[$_]) > 1e-12 * abs $want[$_] } 0 .. $#got;
}

open my $table, '<', $table_path or die "$table_path: $!\n";
my %options;
my @columns = split /\t/, <$table> =~ s/\n//r;
while (my $line = <$table>) {
    chomp $line;
    my %row;
    @row{@columns} = split /\t/, $line, -1;
    $options{$row{name}} = \%row;
}

# The words after Pq in each option's line; the text of each option; the items of each section.
my (%claim, %text, %items, $option, $section);
open my $manual, '<', $manual_path or die "$manual_path: $!\n";
while (my $line = <$manual>) {
    chomp $line;
    $line =~ s/\\-/-/g;
    ($section, $option) = ($1, undef) if $line =~ /^\.Sh (.*)/;
    push @{$items{$section}}, $1 if $section && $line =~ /^\.It Cm (\S+)/;
    if ($line =~ /^\.It Fl (?:\S+ , Fl )?-(\S+)/) {
        $option = $1;
        $text{$option} = '';
        my $claim = $line =~ / Pq (.*)/ ? $1 : '';
        $claim =~ s/\b(Cm|No|Li|Ar) //g;
        $claim{$option} = $claim =~ s/ ([,;:])/$1/gr;
    } elsif (defined $option) {
        $text{$option} .= "$line\n";
    }
}

sub check_choices {
    my ($name, @choices) = @_;
    my %named;
    my @listed = $text{$name} =~ /^\.It Cm (\S+)/mg;
    push @listed, @{$items{$1} || []} while $text{$name} =~ /^\.Sx ([A-Z ]+\b)/mg;
    $named{$_} = 1 for @listed;
    $named{$_} = 1 for map { split ' ' } $text{$name} =~ /^\.Cm (.*)/mg;
    for my $choice (@choices) {
        print "--$name: the choice $choice is not named\n" if !$named{$choice};
    }
    for my $item (@listed) {
        print "--$name: $item is no choice\n" if !grep { $_ eq $item } @choices;
    }
}

sub check {
    my ($name) = @_;
    my %row = %{$options{$name}};
    my $claim = $claim{$name};
    my ($range, $default) = ('', '');
    $range = $1 if $claim =~ s/^([^ ]+ to .*?)(?:; |$)//;
    $default = $1 if $claim =~ s/^default (\S+?)(?:, .*)?$//;
    $claim =~ s/^default: .+// if $row{default} eq '';
    print "--$name: '$claim' is no range and no default of the table\n" if $claim ne '';
    if ($row{type} =~ /^(int|real|size|pair)$/) {
        my $each = $row{type} eq 'pair' ? ' each' : '';
        my $right = $range =~ /^(\S+) to (\S+?)$each$/ && same($1, $row{minimum}) && same($2, $row{maximum});
        print "--$name: '$range', the table has $row{minimum} to $row{maximum}$each\n" if !$right;
    } elsif ($range ne '') {
        print "--$name: '$range', the table has no range\n";
    }
    print "--$name: default '$default', the table has '$row{default}'\n"
        if $default ne $row{default} && !same($default, $row{default});
    print "--$name: the help's default is $1, the table's '$row{default}'\n"
        if $row{help} =~ /\(default (-?[\d.]+(?:[:x]-?[\d.]+)?)(?:, |[ ;:)])/ && !same($1, $row{default});
    check_choices($name, split /,/, $row{choices}) if $row{type} eq 'choice';
}

for my $name (sort keys %claim) {
    check($name) if $options{$name};
}
print "no option has a range\n" if !grep { / to / } values %claim;
