# circles.pl FILE...: each circle of units, one a line. A unit is a header with the source of the same name; one unit
# leads to another where a file of it includes the other's header. Tarjan's algorithm for strongly connected components.
use strict;
use warnings;
no warnings 'recursion';

my (%unit, %leads, %index, %low, %open, @stack);
my $next = 0;

sub unit_of { $_[0] =~ s/\.(c|h|cc)$//r }

# Includes are written from libhatch, cmd or the top.
for my $file (@ARGV) {
    $unit{$file =~ s{^(libhatch|cmd)/}{}r} = unit_of($file) if $file =~ /\.h$/;
}
for my $file (@ARGV) {
    my $from = unit_of($file);
    $leads{$from} //= {};
    open my $in, '<', $file or die "$file: $!\n";
    while (<$in>) {
        my ($header) = /^#\s*include "([^"]+)"/ or next;
        my $to = $unit{$header} // next;
        $leads{$from}{$to} = 1 if $to ne $from;
    }
}

sub visit {
    my ($at) = @_;
    $index{$at} = $low{$at} = $next++;
    $open{$at} = 1;
    push @stack, $at;
    for my $to (sort keys %{$leads{$at}}) {
        visit($to) unless exists $index{$to};
        $low{$at} = $low{$to} if $open{$to} && $low{$to} < $low{$at};
    }
    return if $low{$at} != $index{$at};
    my @circle;
    do {
        push @circle, pop @stack;
        $open{$circle[-1]} = 0;
    } while ($circle[-1] ne $at);
    print join(' ', sort @circle), "\n" if @circle > 1;
}
for my $unit (sort keys %leads) {
    visit($unit) unless exists $index{$unit};
}
