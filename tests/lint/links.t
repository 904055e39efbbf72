# Links of the Markdown files lead to files, and to headings that are there.
. "${TOP:-.}/tests/tap.sh"
cd "$TOP" || exit 1
is "no link leads nowhere" "$(find . \( -path ./build -o -path ./.git \) -prune -o -name '*.md' -print | sort | xargs perl -e '
    use File::Basename qw(dirname);
    sub text { open my $in, "<", $_[0] or return; local $/; return scalar <$in> }
    sub anchors { return map { s/[^\w -]//gr =~ tr/ /-/r } map { lc } $_[0] =~ /^#+ +(.*?) *$/mg }
    for my $file (@ARGV) {
        for my $link (text($file) =~ /\]\(([^)\s]+)\)/g) {
            next if $link =~ m{^https?:};
            my ($path, $anchor) = split /#/, $link;
            my $to = length $path ? dirname($file) . "/$path" : $file;
            my $found = -e $to && (!defined $anchor || grep { $_ eq $anchor } anchors(text($to)));
            print "$file: $link\n" unless $found;
        }
    }')" ""
finish
