#!/usr/bin/env perl
# runs.pl LIBRARY CASES: runs each case of CASES (cases.tsv) again and again in the working folder, each time with
# another allocation failing, by LIBRARY (fail_malloc.c). Each run must end with 0 and the whole result, or with 5 (in
# glibc's loader, 127), one line on standard error and no output. Prints a line for each case, separated by tabs: its
# name, the number of allocations, the runs, those that ended with 5, and what was wrong with up to five of the others.
#
# LONG=1: every allocation of every case fails once. Otherwise the first ones do, and of the later ones fewer and fewer.
# Some runs have all later allocations fail, too. ONLY, a regular expression, selects cases by name.
use strict;
use warnings;
use POSIX qw(_exit WIFEXITED WIFSIGNALED WTERMSIG WEXITSTATUS);

my $hang_s = 120; # only against hangs: a run takes less than a second
my ($library, $cases) = @ARGV;

sub content {
    my ($path) = @_;
    open my $file, '<:raw', $path or return '';
    local $/;
    return timeless(<$file> // '');
}

# timeless TEXT: a report without the times in it
sub timeless {
    my ($text) = @_;
    $text =~ s/("\w+_ms": *)[^,}\s]+/$1/g;
    my ($header, @rows) = split /\n/, $text;
    return $text unless defined $header && $header =~ /^[\w\t]*_ms\b/;
    my @name = split /\t/, $header;
    for my $row (@rows) {
        my @cell = split /\t/, $row;
        $name[$_] =~ /_ms$/ and $cell[$_] = '' for 0 .. $#name;
        $row = join "\t", @cell;
    }
    return join "\n", $header, @rows;
}

# files FOLDER: all files in it, hidden ones, too, and their content
sub files {
    my ($folder) = @_;
    opendir my $handle, $folder or die "$folder: $!\n";
    my @names = sort grep { !/^\.\.?$/ } readdir $handle;
    return map { -d $_ ? files($_) : ($_, readlink $_ || '', content($_)) } map { "$folder/$_" } @names;
}

sub remove_files {
    my ($folder) = @_;
    opendir my $handle, $folder or return;
    for my $path (map { "$folder/$_" } grep { !/^\.\.?$/ } readdir $handle) {
        -d $path ? (remove_files($path), rmdir $path) : unlink $path;
    }
}

# run COMMAND, NUMBER, FOREVER: runs it with the allocation of that number failing
sub run {
    my ($command, $number, $forever) = @_;
    remove_files('out');
    mkdir 'out/old';
    open my $old, '>', 'out/old/file' or die "out/old/file: $!\n";
    print $old "old\n";
    close $old;
    symlink 'old/file', 'out/link' or die "out/link: $!\n";
    my @before = files('out');
    open my $count, '>:raw', 'count' or die "count: $!\n";
    print $count "\0" x 8;
    close $count;
    my $child = fork // die "fork: $!\n";
    if (!$child) {
        open STDIN, '<', '/dev/null';
        open STDOUT, '>', 'stdout';
        open STDERR, '>', 'stderr';
        $ENV{FAIL_AT} = $number;
        $ENV{FAIL_COUNT} = 'count';
        $ENV{FAIL_FOREVER} = 1 if $forever;
        $ENV{LD_PRELOAD} = $library;
        exec split / /, $command or _exit(127);
    }
    my $hung = 0;
    local $SIG{ALRM} = sub { $hung = 1; kill 'KILL', $child };
    alarm $hang_s;
    waitpid $child, 0;
    my $ended = $?;
    alarm 0;
    # A command that the loader ends keeps its hidden file, which its next run removes.
    unlink grep { -f } glob 'out/.*' if !$hung && WIFEXITED($ended) && WEXITSTATUS($ended) == 127;
    my %run = (status => $hung ? 'hangs' : WIFSIGNALED($ended) ? 'signal ' . WTERMSIG($ended) : WEXITSTATUS($ended),
        output => join("\0", content('stdout'), files('out')), nothing => join("\0", '', @before),
        said => content('stderr'),
        allocations => unpack 'Q', content('count'));
    return \%run;
}

# fault RUN, WHOLE: what is wrong with a run, or ''; WHOLE: the run without failures
sub fault {
    my ($run, $whole) = @_;
    my ($status, $said) = @$run{qw(status said)};
    if ($status eq '0') {
        return 'a part of the result is missing or wrong' if $run->{output} ne $whole->{output};
        return $said eq $whole->{said} ? '' : "says: $said";
    }
    # Where its own tables do not fit, the loader ends a process that opens a plugin, without asking it.
    my $loader = $status eq '127'
        && $said =~ /^(?:out of memory|cannot allocate memory for thread-local data: ABORT)\n\z/;
    return "$status: $said" if $status ne '5' && !$loader;
    $said = substr $said, length $whole->{said} if index($said, $whole->{said}) == 0;
    return "says: $said" if $said !~ /^[^\n]+\n\z/;
    return $run->{output} eq $run->{nothing} ? '' : 'leaves files or output';
}

# numbers LAST, FIRST, GROWTH: all numbers up to FIRST, then each GROWTH times the one before
sub numbers {
    my ($last, $first, $growth) = @_;
    my @numbers;
    for (my $n = 1; $n <= $last; $n = $n < $first ? $n + 1 : int($n * $growth) + 1) {
        push @numbers, $n;
    }
    return @numbers;
}

open my $list, '<', $cases or die "$cases: $!\n";
mkdir 'out';
for (<$list>) {
    chomp;
    my ($name, $pace, $command) = split /\t/;
    next if /^#/ || $name !~ ($ENV{ONLY} // '.');
    $command =~ s/^(\S+)(?! -j)/$1 -j 1/ if $command !~ / -j /;
    my $whole = run($command, 0, 0);
    my $last = $whole->{allocations};
    my @faults = $whole->{status} eq '0' && $last ? () : ("without failures $whole->{status}: $whole->{said}");
    my @sample = $pace eq 'slow' ? (2, 4) : (16, 1.3);
    my ($runs, $limits) = (0, 0);
    for my $forever (0, 1) {
        for my $number (numbers($last, $forever ? (1, 4) : $ENV{LONG} ? ($last, 1) : @sample)) {
            my $run = run($command, $number, $forever);
            my $wrong = fault($run, $whole);
            push @faults, "allocation $number" . ($forever ? ' and all later ones' : '') . ": $wrong" if $wrong ne '';
            $runs++;
            $limits += $run->{status} eq '5';
        }
    }
    my $wrong = @faults ? @faults . ' wrong: ' . join '; ', @faults[0 .. ($#faults < 4 ? $#faults : 4)] : '';
    $wrong =~ s/[\n\t]+/ /g;
    print "$name\t$last\t$runs\t$limits\t$wrong\n";
}
