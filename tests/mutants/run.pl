#!/usr/bin/env perl
# run.pl FOLDER: draws N (80) random mutations of single lines of libhatch and cmd with the seed SEED (1), and tells
# for each whether a test sees it. Works in a copy of the tree in FOLDER. A mutation that does not compile, or that
# gives the same machine code, is replaced by another. A first run of all tests, with marks before the lines of the
# mutations (marks.pl), finds which tests execute a line; these run nearest first, two at a time (JOBS), and stop at the
# first failure. Those that need longer than three times what they needed in the first run, and a minute, have failed.
# Mutations are built with checks of the bounds of arrays; those of C and C++ that all tests pass go through the unit
# programs once more, built as by make check SANITIZE=1, which does not see what shaders do.
# Prints a line for each mutation; at the end those that survived, and the share of them. Mutations that only make an
# allocated array larger, or that equivalent.tsv explains, are not counted: they cannot change a result. Verdicts are
# kept in the folder, so that a run that was stopped goes on where it was, if neither code nor tests have changed.
use strict;
use warnings;
use feature qw(state);
use Cwd qw(abs_path);
use Digest::SHA qw(sha1_hex);
use File::Basename qw(dirname);
use File::Path qw(make_path remove_tree);
use List::Util qw(min);
use POSIX qw(setsid :sys_wait_h);
use Storable qw(retrieve store);
use Time::HiRes qw(time sleep);
$| = 1;

my $here = abs_path(dirname($0));
my $top = abs_path("$here/../..");
my $folder = shift or die "usage: run.pl FOLDER\n";
my ($wanted, $seed, $jobs) = ($ENV{N} || 80, $ENV{SEED} || 1, $ENV{JOBS} || 2);
my $processors = () = contents('/proc/cpuinfo') =~ /^processor\b/mg;
my @make = ('make', '-s', "-j$jobs");
my %flags = ( # by the folders of the builds
    build => ['CFLAGS=-O2 -g0 -fsanitize=bounds -fsanitize-undefined-trap-on-error'],
    marked => ['CFLAGS=-O2 -g0', 'CPPFLAGS=-include tests/mutants/marks.h', 'LDFLAGS=marked/marks.o'],
    sane => ['CFLAGS=-O1 -g0', 'SANITIZE=1'],
);
require "$here/code.pl";
require "$here/marks.pl";

sub prepare_tree {
    make_path($folder);
    $folder = abs_path($folder);
    chdir $top or die;
    # A repository, of which make dist makes its archive; files of an earlier tree, and mutations of a run that was
    # stopped, go.
    my $git = "git -C '$folder' -c user.name=hatch -c user.email=hatch";
    system("git -C '$folder' reset -q --hard") if -d "$folder/.git";
    system("git ls-files -z | xargs -0 cp --parents -p -u -t '$folder'") == 0
        or die "run.pl: the tree cannot be copied\n";
    my @kept = map { "-e /$_" } qw(marked sane tests.reached verdicts);
    system("git init -q '$folder' && git ls-files -z | $git add --pathspec-from-file=- --pathspec-file-nul && " .
        "$git commit -q --allow-empty -m copy && $git clean -fdq @kept") == 0
        or die "run.pl: git cannot take the copy\n";
    chdir $folder or die;
    delete @ENV{qw(MAKEFLAGS MAKELEVEL MFLAGS N SEED)}; # pipelines have a SEED of their own
    make_path("$folder/tmp");
    @ENV{qw(TOP TMPDIR CK_DEFAULT_TIMEOUT)} = ($folder, "$folder/tmp", 600);
    $ENV{ASAN_OPTIONS} ||= 'detect_stack_use_after_return=1:allocator_may_return_null=1';
}

# Builds targets, or options of make, in a folder, and returns whether they can be built.
sub build {
    my ($to, @targets) = @_;
    my @words = (@make, "B=$to", @{$flags{$to}}, map { /^(?:all|stage|-.*)$/ ? $_ : "$to/$_" } @targets);
    return system(join(' ', map { "'$_'" } @words) . ' >make.log 2>&1') == 0;
}

# Starts a test of a build in a session of its own and returns the process; its marks go to tmp/PROCESS.marks.
sub start {
    my ($of, $test) = @_;
    my $pid = fork // die "run.pl: fork: $!\n";
    return $pid if $pid;
    setsid();
    @ENV{qw(BUILD BIN)} = ("$folder/$of", "$folder/$of/bin");
    if ($of eq 'marked') {
        $ENV{HATCH_MARKS} = "$folder/tmp/$$.marks";
        put($ENV{HATCH_MARKS}, "\0" x 4096);
        chmod 0666, $ENV{HATCH_MARKS}; # some tests run commands as another user
    }
    open STDOUT, '>', "tmp/$$.out" or die;
    open STDERR, '>&', \*STDOUT or die;
    exec $test =~ /\.t$/ ? ('sh', $test) : ("$of/$test") or die;
}

sub passed {
    my ($pid, $status) = @_;
    rename "tmp/$pid.out", 'tmp/last.out' or return 0;
    return $status == 0 && contents('tmp/last.out') !~ /^not ok/m;
}

# Runs tests of a build, several at a time. Calls done(TEST, PASSED, SECONDS, PROCESS) after each, and ends when that
# returns true. A test has failed when it needs more seconds than $limit->{TEST}.
sub run_tests {
    my ($of, $tests, $limit, $done) = @_;
    my (@waiting, %running, $ended) = @$tests;
    while (!$ended && (@waiting || %running)) {
        while (@waiting && keys %running < $jobs) {
            my $test = shift @waiting;
            $running{start($of, $test)} = [$test, time];
        }
        for my $pid (keys %running) {
            my ($test, $since) = @{$running{$pid}};
            my $late = time - $since > ($limit->{$test} // 1e9);
            next unless $late || waitpid($pid, WNOHANG) > 0;
            delete $running{$pid} unless $late;
            $ended = $done->($test, !$late && passed($pid, $?), time - $since, $pid) || $ended;
        }
        sleep 0.02;
    }
    for my $pid (keys %running) {
        # Each case of a unit program has a process group of its own.
        system('pkill', '-KILL', '-s', $pid);
        waitpid $pid, 0;
        unlink "tmp/$pid.out";
    }
}

# Returns the first test of a build that fails, or nothing.
sub first_failure {
    my ($of, $tests, $limit) = @_;
    my $failed;
    run_tests($of, $tests, $limit, sub {
        my ($test, $passed) = @_;
        $failed //= $test unless $passed;
        return $failed;
    });
    return $failed;
}

# Returns how near a test is to a file, from its path: 2 for a test of the file's own folder, 1 for one whose name
# shares a word with the file's path, 0 for others.
sub nearness {
    my ($test, $file) = @_;
    my ($module) = $file =~ m{^(?:libhatch|cmd)/([\w-]+)};
    return 2 if $test =~ m{/\Q$module\E[/_.]} || $test =~ m{/(?:test_)?\Q$module\E\.t$};
    my %words = map { $_ => 1 } grep { length > 2 } split m{[/_.]}, $file;
    return (grep { $words{$_} } split m{[/_.-]}, $test) ? 1 : 0;
}

sub object_of { # the object file of a source, or nothing: shaders are strings of one
    my ($file) = @_;
    return $file =~ /\.(?:c|cc)$/ ? "obj/$file.o" : undef;
}

sub contents {
    my ($file) = @_;
    open my $in, '<', $file or return '';
    local $/;
    return <$in>;
}

sub end_of { # the last lines of a text
    my ($file) = @_;
    my @lines = split /^/, contents($file);
    return splice @lines, -min(20, scalar @lines);
}

sub put {
    my ($file, $text) = @_;
    open my $out, '>', $file or die "run.pl: $file: $!\n";
    print $out $text;
    close $out;
}

# Builds what the tests need. Returns the tests, unit programs and scripts, without those of the code's form.
sub build_tests {
    my @programs = map { s{\.c$}{}r } glob 'tests/{unit/*,prop,stability}/test_*.c';
    my @scripts = grep { !m{cli/examples\.t$} } glob 'tests/{cli,cli/*,prop,stability,bad,memory,golden}/*.t';
    my @all = ('stage', 'tests/bad/maps', 'tests/golden/pixels', @programs);
    build('build', @all) or die "run.pl: the unchanged tree does not build\n", end_of('make.log');
    return (\@programs, \@scripts, \@all);
}

# Builds the tests with marks for mutations.
sub build_marked {
    my ($all, @mutations) = @_;
    make_path('marked');
    system($ENV{CC} || 'cc', '-O2', '-fPIC', '-c', '-o', 'marked/marks.o', 'tests/mutants/marks.c') == 0 or die;
    my $unmark = marks_put(sub {
        my %object = map { $_ => object_of($_) } @_;
        unlink map { "marked/$_" } values %object;
        build('marked', '-k', values %object);
        return grep { !-e "marked/$object{$_}" } @_;
    }, @mutations);
    my $built = build('marked', @$all);
    $unmark->();
    die "run.pl: the tree with marks does not build\n", end_of('make.log') unless $built;
}

# Runs tests on the tree with marks, and notes the seconds of each in %$took, and its marks in %$marks. Returns those that
# fail without marks as well.
sub measure_tests {
    my ($took, $marks, @tests) = @_;
    my @failed;
    run_tests('marked', \@tests, {}, sub {
        my ($test, $passed, $seconds, $pid) = @_;
        $took->{$test} = $seconds;
        $marks->{$test} = contents("tmp/$pid.marks");
        unlink "tmp/$pid.marks";
        push @failed, $test unless $passed;
        return 0;
    });
    return grep { first_failure('build', [$_], {}) } @failed;
}

# Fills in the seconds and the marks of all tests. Keeps them in the folder, and takes from there what it has for the
# same code, the same mutations and the same tests.
sub know_tests {
    my ($took, $marks, $all, $tests, @mutations) = @_;
    my $code = join "\n", `git rev-parse HEAD:libhatch HEAD:cmd`, map { join "\t", @$_ } @mutations;
    my %now = map { $_ => scalar `git rev-parse HEAD:$_` } map { /\.t$/ ? $_ : "$_.c" } @$tests;
    my $kept = -e 'tests.reached' ? retrieve('tests.reached') : {code => ''};
    if ($kept->{code} ne $code) {
        $kept = {code => $code, took => {}, marks => {}, is => {}};
        remove_tree('marked');
    }
    my @new = grep { my $file = /\.t$/ ? $_ : "$_.c"; ($kept->{is}{$_} // '') ne $now{$file} } @$tests;
    if (@new) {
        build_marked($all, @mutations);
        my @failed = measure_tests($kept->{took}, $kept->{marks}, @new);
        $kept->{is}{$_} = $now{/\.t$/ ? $_ : "$_.c"} for @new;
        delete @{$kept->{is}}{@failed};
        store($kept, 'tests.reached');
        die "run.pl: @failed fails on the unchanged tree\n", end_of('tmp/last.out') if @failed;
    }
    %$took = %{$kept->{took}};
    %$marks = %{$kept->{marks}};
}

# Returns the tests of a kind, nearest first, among equals the fastest first.
sub in_order {
    my ($file, $took, @tests) = @_;
    return sort { nearness($b, $file) <=> nearness($a, $file) || $took->{$a} <=> $took->{$b} } @tests;
}

# Returns whether a mutation only makes an allocated array larger: a whole number in the call, one more.
sub is_larger_array {
    my ($old, $new) = @_;
    my ($begin, $was) = $old =~ /^(.*\bHATCH_(?:ALLOC|NEW)(?:_UNSET)?\()(.*)$/ ? ($1, $2) : return 0;
    while ($was =~ /\b\d+\b/g) {
        my ($before, $number, $after) = ($`, $&, $');
        return 1 if $new eq $begin . $before . ($number + 1) . $after && $before !~ /(?:\[|[-\/%] )$/;
    }
    return 0;
}

# Returns what verdicts depend on: the code and the tests, without this folder.
sub verdicts_key {
    return sha1_hex(grep { !m{\ttests/mutants$} } `git ls-tree HEAD libhatch cmd Makefile tests/`);
}

# Returns the verdicts that were kept, by "FILE:LINE TEXT" of mutations.
sub kept_verdicts {
    my ($key) = @_;
    return map { my ($of, $mutation, $said) = split /\t/; $of eq $key ? ($mutation => $said) : () }
        split /\n/, contents('verdicts');
}

sub keep_verdict {
    my (@fields) = @_;
    open my $out, '>>', 'verdicts' or die "run.pl: verdicts: $!\n";
    print $out join("\t", @fields), "\n";
    close $out;
}

# Returns the first program that fails under sanitizers, or nothing. Programs that have not run before are run on the
# unchanged file first.
#   texts  of the file: as it is, and with the mutation
sub sane_failure {
    my ($file, $programs, @texts) = @_;
    state %sound;
    my @new = grep { !$sound{$_}++ } @$programs;
    if (@new) {
        put($file, $texts[0]);
        build('sane', @new) or die "run.pl: SANITIZE=1 does not build\n", end_of('make.log');
        my $failed = first_failure('sane', \@new, {});
        die "run.pl: $failed fails under SANITIZE=1\n", end_of('tmp/last.out') if $failed;
        put($file, $texts[1]);
    }
    return @$programs && build('sane', @$programs) ? first_failure('sane', $programs, {}) : undef;
}

# Judges a mutation: "does not compile", "same code", the test that fails, or "survived". Leaves the file with it.
#   texts              of the file: as it is, and with the mutation
#   programs, scripts  the tests that execute the line
sub verdict {
    my ($file, $texts, $programs, $scripts, $took) = @_;
    my $object = object_of($file);
    my $before = $object ? contents("build/$object") : '';
    put($file, $texts->[1]);
    return 'does not compile' if $object && !build('build', $object);
    return 'same code' if $object && contents("build/$object") eq $before;
    my %limit = map { $_ => 60 + 3 * $took->{$_} } keys %$took;
    my @near = grep { nearness($_, $file) == 2 } @$programs;
    my %is_near = map { $_ => 1 } @near;
    my @other = grep { !$is_near{$_} } @$programs;
    for my $stage ([\@near, []], [[], $scripts], [\@other, []]) {
        my ($some, $others) = @$stage;
        next unless @$some || @$others;
        build('build', @$some, @$others ? 'all' : ()) or return 'does not compile';
        my $failed = first_failure('build', [in_order($file, $took, @$some, @$others)], \%limit);
        return $failed if $failed;
    }
    my $failed = $object ? sane_failure($file, [in_order($file, $took, @$programs)], @$texts) : undef;
    return $failed ? "$failed, SANITIZE=1" : 'survived';
}

prepare_tree();
my @sources = glob 'libhatch/*/*.{c,cc} libhatch/*/*/*.{c,cc} cmd/*.c cmd/*/*.c cmd/*/*/*.c cmd/render-gl/shaders/*/*';
my @drawn = map { chomp; [split /\t/] } do {
    open my $in, '-|', 'perl', "$here/draw.pl", 2 * $wanted, $seed, @sources or die;
    <$in>;
} or die "run.pl: no mutation was drawn\n";
my ($programs, $scripts, $all) = build_tests();
my ($took, $marks) = ({}, {});
know_tests($took, $marks, $all, [@$programs, @$scripts], @drawn);
my %reason = map { chomp; my ($file, $line, $after, $why) = split /\t/; ("$file\t$line\t$after" => $why) }
    split /^/, contents("$here/equivalent.tsv");
my $key = verdicts_key();
my %kept = kept_verdicts($key);
my ($counted, @survivors) = (0);
for my $index (0 .. $#drawn) {
    last if $counted == $wanted;
    my ($file, $number, $line, $after) = @{$drawn[$index]};
    my ($old, $new) = map { s/^\s+//r } $line, $after;
    my $name = "$file:$number $new";
    my $text = contents($file);
    my ($some, $others) = map { [grep { vec($marks->{$_}, $index, 8) } @$_] } $programs, $scripts;
    my @lines = split /\n/, $text, -1;
    $lines[$number - 1] = $after;
    my $since = time;
    my $said = $reason{"$file\t$old\t$new"} || is_larger_array($old, $new) ? 'equivalent'
        : $kept{$name} // verdict($file, [$text, join "\n", @lines], $some, $others, $took);
    keep_verdict($key, $name, $said) unless $kept{$name} || $said eq 'equivalent';
    put($file, $text);
    build('build', object_of($file)) if object_of($file);
    $counted++ unless $said =~ /^(?:does not compile|same code|equivalent)$/;
    push @survivors, "$file:$number: $old  ->  $new" if $said eq 'survived';
    printf "%s\t%s:%d\t%s\t%s\t%.0f s\n", $said, $file, $number, $old, $new, time - $since;
}
print "survived: $_\n" for @survivors;
printf "%d mutations, %d survived: %.1f %%\n", $counted, scalar @survivors, 100 * @survivors / ($counted || 1);
