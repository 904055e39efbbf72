# code.pl, for draw.pl and marks.pl: the code of sources.
use strict;
use warnings;

# Returns the code of a text by lines, with comments and strings blanked, so that places agree with the text.
sub code_of {
    my ($text) = @_;
    $text =~ s{(/\*.*?\*/|//[^\n]*|"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)+')}{$1 =~ s/[^\n]/\x01/gr}gse;
    return split /\n/, $text, -1;
}

1;
