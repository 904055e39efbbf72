# reach.pl, for run.pl: which tests execute which lines, as gcov counts them in a build with --coverage.
#
# Lines are bits of strings: $known{FILE} has those that gcov counts, $executed{FILE}{TEST} those that a test executes,
# for the files whose objects are linked into a program that the test runs. $functions{FILE} has pairs: the first and the
# last line of a function.
use strict;
use warnings;
use File::Find qw(find);

my (%known, %executed, %functions);

# Notes what a test has executed, whose GCOV_PREFIX was the folder counts.
sub reach_read {
    my ($test, $counts) = @_;
    my @files;
    find({no_chdir => 1, wanted => sub {
        return unless /^\Q$counts\E(.*)\.gcda$/;
        symlink "$1.gcno", s/gcda$/gcno/r or die "reach.pl: $_: $!\n"; # gcov expects the two side by side
        push @files, $_;
    }}, $counts) if -d $counts;
    while (my @some = splice @files, 0, 200) {
        open my $in, '-|', 'gcov', '-j', '-t', @some or die "reach.pl: gcov: $!\n";
        while (my $json = <$in>) {
            $json =~ s/"demangled_name": "[^"]*"//g; # may have braces
            $json =~ /"files": \[/g or next;
            read_file($test, $1) while $json =~ /\G,? ?\{((?:[^{}]++|\{[^{}]*+\})*+)\}/g;
        }
    }
}

# Notes the lines of one file, from the part of gcov's JSON that is about it.
sub read_file {
    my ($test, $json) = @_;
    my ($file) = $json =~ /"file": "([^"]*)"/ or return;
    my $first = !exists $functions{$file};
    $executed{$file}{$test} //= '';
    while ($json =~ /\{([^{}]*)\}/g) {
        my %value = $1 =~ /"(\w+)": (\d+)/g;
        if (exists $value{line_number}) {
            vec($known{$file}, $value{line_number}, 1) = 1;
            vec($executed{$file}{$test}, $value{line_number}, 1) = 1 if $value{count};
        } elsif ($first && exists $value{start_line}) {
            push @{$functions{$file}}, [@value{qw(start_line end_line)}];
        }
    }
}

# Returns a copy of all that was noted.
sub reach_all {
    return {known => {%known}, executed => {%executed}, functions => {%functions}};
}

# Takes what reach_all has returned.
sub reach_take {
    my ($all) = @_;
    %known = %{$all->{known}};
    %executed = %{$all->{executed}};
    %functions = %{$all->{functions}};
}

# Whether a test may see a change of a line: it executes the line, or, where gcov does not count the line, its function;
# outside functions, where it runs a program that has the file. Files without counts are seen by all tests.
sub reaches {
    my ($test, $file, $line) = @_;
    return 1 unless exists $executed{$file};
    my $lines = $executed{$file}{$test} // return 0;
    return vec($lines, $line, 1) if vec($known{$file}, $line, 1);
    my ($function) = grep { $_->[0] <= $line && $line <= $_->[1] } @{$functions{$file}} or return 1;
    return !!grep { vec($lines, $_, 1) } $function->[0] .. $function->[1];
}

1;
