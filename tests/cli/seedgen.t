# seedgen --plot: the drawing of seed sets.
. "${TOP:-.}/tests/tap.sh"

# Seed i of a set is its cycle of crumbs rotated left by i: crumb 2 v + u holds one binary digit of v and one of u.
cat >plot.pl <<'END'
use strict;
use warnings;
my ($seeds, $plot) = @ARGV;
open my $in, '<', $seeds or die;
my @cycles = grep { !/^#/ } map { chomp; $_ } <$in>;
open $in, '<', $plot or die;
my @panels = do { local $/; split /<g transform=/, <$in> };
shift @panels;
my @wrong = @panels == @cycles ? () : (@panels . ' panels');
for my $n (0 .. $#panels) {
    my @crumbs = split //, $cycles[$n];
    my ($x, $y) = $panels[$n] =~ /^"translate\((\d+) (\d+)\)"/;
    push @wrong, "panel $n lies at $x $y" if $x != 40 + $n % 4 * 440 || $y != 40 + 440 * int($n / 4);
    my @seeds = $panels[$n] =~ /class="seed" cx="(\S+)" cy="(\S+)" r="12\.000"/g;
    my @nested = $panels[$n] =~ /class="nested" cx="(\S+)" cy="(\S+)" r="6\.000"/g;
    push @wrong, @seeds / 2 . ' seeds and ' . @nested / 2 . ' small ones' if @seeds != 32 || @nested != 128;
    for my $i (0 .. 15) {
        my @at = (0, 0);
        for my $k (reverse 0 .. 31) {
            my $crumb = $crumbs[($i + $k) % 16];
            $at[0] = ($at[0] + $crumb % 2) / 2;
            $at[1] = ($at[1] + int($crumb / 2)) / 2;
        }
        push @wrong, "seed $i of set $n: @seeds[2 * $i, 2 * $i + 1], want " . join ' ', map { 400 * $_ } @at
            if grep { abs($seeds[2 * $i + $_] - 400 * $at[$_]) > 1e-3 } 0, 1;
        push @wrong, "seed $i of set $n has no small one in it" unless grep {
            abs($nested[2 * $_] - 400 * $at[0]) < 1e-3 && abs($nested[2 * $_ + 1] - 400 * $at[1]) < 1e-3 } 0 .. 63;
    }
}
print map { "$_\n" } @wrong;
END
seedgen -n 16 --layers 6 --plot plot.svg -o six.seeds
is "circles lie at the seeds of each set, with small ones in them" "$(perl plot.pl six.seeds plot.svg)" ""
seedgen -n 16 --layers 6 >piped.seeds
cmp -s piped.seeds six.seeds
is "a plot changes nothing in the sets" $? 0
is "nothing else is written" "$(ls | paste -sd' ')" "piped.seeds plot.pl plot.svg six.seeds"
is "points with one u have no correlation" "$(printf '111333\n' | hatchstat seeds | awk -F'\t' 'NR == 1 {for (i = 1; i <= NF; i++) if ($i == "correlation") c = i} NR == 2 {print $c}')" nan
finish
