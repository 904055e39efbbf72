# marks.pl, for run.pl: puts marks into sources, by which a test tells the mutated lines that it executes. A mark is a
# statement that sets a byte (marks.h); gcov, which counts all lines, takes the tests two to three times as long.
use strict;
use warnings;

# Where the texts of shaders are found, and how files are named there.
my $SHADERS = 'cmd/render-gl/shaders/';
my $FINDER = 'cmd/render-gl/gpu/program.c';

# Returns the number of the first line of the function that has a line, or nothing. Numbers of lines count from 0.
sub function_begin {
    my ($code, $line) = @_;
    for (my $i = $line - 1; $i >= 0; $i--) {
        return $i + 1 if $code->[$i] eq '{';
        return if $code->[$i] =~ /^\}/;
    }
    return;
}

# Returns the line at which the statement begins that a line of a function is in, or one around it.
sub statement_begin {
    my ($code, $line) = @_;
    my $first = function_begin($code, $line) // return;
    my ($found, $before) = ($first, ';');
    for my $i ($first .. $line) {
        my $text = $code->[$i] =~ s/[\s\x01]+$//r;
        my $begins = $before =~ /[;}]$|(?:\)|else|do) \{$|^\s*(?:case\b.*|default):$/;
        $found = $i if $begins && $text =~ /\S/ && $text !~ /^\s*(?:[{}#]|(?:else|case|default)\b)/;
        $before = $text if $text =~ /[^\s\x01]/;
    }
    return $found;
}

# Returns the lines of functions that use the constant or the table outside functions that a line defines.
sub uses_of {
    my ($code, $line) = @_;
    $line-- while $line > 0 && $code->[$line] !~ /^[^\s}]/;
    my ($name) = $code->[$line] =~ /^#define (\w+)/ ? $1 : $code->[$line] =~ /(\w+)(?:\[[^\]]*\])* = / or return;
    return grep { $code->[$_] =~ /\b$name\b/ && defined function_begin($code, $_) } 0 .. $#$code;
}

# Returns the text of a source with marks.
#   marks  pairs: the number of a line from 1, and that of its mark
#   whole  whether to mark the functions of the lines instead of their statements
sub marked {
    my ($text, $marks, $whole) = @_;
    my @lines = split /\n/, $text, -1;
    my @code = code_of($text);
    my $end = '';
    for (@$marks) {
        my ($line, $number) = ($_->[0] - 1, $_->[1]);
        my @reached = defined function_begin(\@code, $line) ? ($line) : uses_of(\@code, $line);
        for my $at (map { $whole ? function_begin(\@code, $_) : statement_begin(\@code, $_) } @reached) {
            $lines[$at] =~ s/^/hatch_marks[$number] = 1; /;
        }
        # All programs that have the file.
        $end .= "__attribute__((constructor)) static void mark_$number(void)\n{\n    hatch_marks[$number] = 1;\n}\n"
            unless @reached;
    }
    return join("\n", @lines) . $end;
}

# Returns the sources that get marks, for mutations as draw.pl prints them: {FILE}: pairs as for marked(). Shaders are
# marked where their text is found: the third element is their name.
sub marks_by_file {
    my (@mutations) = @_;
    my %marks;
    for my $number (0 .. $#mutations) {
        my ($file, $line) = @{$mutations[$number]};
        push @{$marks{$file}}, [$line, $number] if $file =~ /\.(?:c|cc)$/;
        push @{$marks{$FINDER}}, [0, $number, $1] if $file =~ /^\Q$SHADERS\E(.*)/;
    }
    return %marks;
}

# Puts marks into the sources of a tree.
#   failing  function of files: returns those of them that do not compile
# Returns a function that takes the marks out again, and leaves the files as old as they were.
sub marks_put {
    my ($failing, @mutations) = @_;
    my %marks = marks_by_file(@mutations);
    my %text = map { $_ => contents($_) } keys %marks;
    my %age = map { $_ => (stat $_)[9] } keys %marks;
    my @files = sort keys %marks;
    for my $whole (0, 1) {
        for my $file (@files) {
            my @lines = grep { @$_ == 2 } @{$marks{$file}};
            my $finds = join '', map { qq{if (strcmp(name, "$_->[2]") == 0) hatch_marks[$_->[1]] = 1; } }
                grep { @$_ == 3 } @{$marks{$file}};
            my $marked = marked($text{$file}, \@lines, $whole);
            die "marks.pl: $file has no find_text\n"
                unless $finds eq '' || $marked =~ s/\bfind_text\([^;{]*\)\n\{\n\K/$finds/;
            put($file, $marked);
        }
        @files = $failing->(@files) or last;
    }
    die "marks.pl: @files cannot be marked\n" if @files;
    return sub {
        for my $file (keys %text) {
            put($file, $text{$file});
            utime $age{$file}, $age{$file}, $file;
        }
    };
}

1;
