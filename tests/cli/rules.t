# Options without effect are refused. --options-table lists what each option needs in order to have one; for each of
# these conditions the option is given with a command line that breaks it.
. "${TOP:-.}/tests/tap.sh"

# Files that do not exist: options are checked before anything is read.
cat >break.pl <<'END'
# break.pl TABLE OPERANDS: prints a line of arguments for each condition of each option, which breaks that condition.
use strict;
use warnings;
my ($path, @subjects) = @ARGV;
my (%row, @order);
open my $table, '<', $path or die "$path: $!";
chomp(my $header = <$table>);
my @columns = split /\t/, $header;
while (<$table>) {
    chomp;
    my %option;
    @option{@columns} = split /\t/, $_, -1;
    $row{$option{name}} = \%option;
    push @order, $option{name};
}

# An option with a value that it takes; a choice takes none of the values in $not.
sub with_value {
    my ($name, $not) = @_;
    my $option = $row{$name} or die "no option $name";
    my ($type, $least, $most) = @$option{qw(type minimum maximum)};
    return "--$name" if $type eq 'flag';
    if ($type eq 'choice') {
        my %not = map { $_ => 1 } split /,/, $not // '';
        my ($other) = grep { !$not{$_} } split /,/, $option->{choices};
        return defined $other ? "--$name $other" : undef;
    }
    my $middle = $least < 1 && $most > 1 ? 1 : $least;
    return "--$name $middle" . ($option->{metavariable} =~ /:/ ? ':' : 'x') . $middle if $type eq 'pair';
    return "--$name " . ($type =~ /text/ ? 'nonesuch' : $middle);
}

for my $name (@order) {
    for my $condition (split / /, $row{$name}{needs}) {
        my ($subject, @words) = ($subjects[0]);
        for my $atom (split /\|/, $condition) {
            my ($not, $other, $is, $list) = $atom =~ /^(!?)([A-Za-z-]+?)(?:(!?=)(.*))?$/ or die $atom;
            if ($other =~ /^[A-Z]/) {
                my %listed = map { $_ => 1 } split /,/, $list;
                ($subject) = grep { !$listed{$_} } @subjects;
            } elsif ($is) {
                push @words, $is eq '=' ? with_value($other, $list) : "--$other $list";
            } elsif ($not) {
                push @words, with_value($other);
            }
        }
        print "$name\t$condition\t", join(' ', $subject // '', @words, with_value($name)), "\n";
    }
}
END

for path in "$BIN"/*; do
    command=${path##*/}
    $command --options-table >table.tsv
    case $command in
    hatchstat) operands="diff field frames ink lapped mesh seeds tam tones" ;;
    *) operands='' ;;
    esac
    perl break.pl table.tsv $operands >broken.tsv
    bad=''
    while IFS='	' read -r name condition arguments; do
        try $command $arguments
        count_lines .err
        read -r first <.err
        case "$status $tap_lines $first" in
        "2 2 $command: "*"--"*) ;;
        *) bad="$bad
$command $arguments ($condition): exit $status: $first" ;;
        esac
    done <broken.tsv
    is "$command: $(wc -l <broken.tsv) conditions of options are checked" "$bad" ""
done

# The help of hatchstat begins with the subjects of an option: those that the table names.
hatchstat --options-table | awk -F'\t' '$8 == "own" {
    split($9, part, ":")
    gsub(" ", "", part[1])
    subjects = $11
    sub(/^SUBJECT=/, "", subjects)
    sub(/ .*/, "", subjects)
    if ($2 == "reference") { part[1] = "field,ink,solid,tones" } # its help tells what each subject reads
    if (part[1] != subjects) print $2 ": " part[1] " in the help, " subjects " in the table"
}' >differing
is "the help of hatchstat names the subjects of each option" "$(cat differing)" ""

# says NAME TEXT COMMAND ...: checks that COMMAND is refused as wrong usage, in words that contain TEXT
says() {
    name=$1 text=$2
    shift 2
    try "$@"
    refused "$name" 2 2
    grep -qF -e "$text" .err
    is "$name: the message contains '$text'" $? 0
}
says "patches for meshes" "mesh: --patches is for ink" hatchstat mesh m --patches x
says "a reference for meshes" "mesh: --reference is for field, ink, solid and tones" hatchstat mesh m --reference x
says "search steps without a search" "--max-nodes needs --method backtrack" seedgen --max-nodes 200000000
says "a map for strokes without one" "--tam needs --technique tam, tam-flat" render-gl m -t rptam --tam x
says "a report that is not written" "--json needs --report" dirfield --json
says "a default that is given" "--ink needs --layout" tampack --layout exr --ink 0 map.exr
says "a random seed that nothing reads" "--seed cannot be combined with --exact" tamthresh --exact --seed 1
says "a share of nothing" "--share needs --reference" hatchstat field --share 0.5 m
says "random strokes without strokes" "--throws needs --strokes" hatchstat tam --throws 9 m
says "a field of view of a camera that has its own" "--fov cannot be combined with --camera 0" \
    render-gl m -t gouraud --camera 0 --fov 30
says "the width of lines that are not drawn" "--line-width cannot be combined with --lines none" \
    render-gl m -t rptam --lines none --line-width 2
says "the width of creases that are not drawn" "--crease needs" render-gl m -t gouraud --crease 30
says "a pair with the sign of another" "--candidates: '1x1' is not two whole numbers A:B" tamgen -c 1x1
says "half a candidate" "--candidates: '1.5:2' is not two whole numbers A:B" tamgen -c 1.5:2
says "a size with a colon" "--size: '64:64' is not two whole numbers WxH" render-gl m --size 64:64
for command in "render-gl m" "meshfit m" "hatchplan m" "hatchstat coarse m m"; do
    says "$command: half a pixel" "--size: '10.5x10' is not two whole numbers WxH" $command --size 10.5x10
done

for text in '' '# only a comment' '   '; do
    printf '%s\n' "$text" >empty.style
    try tamgen --style ./empty.style --size 64
    refused "a style file with nothing but '$text'" 3 1
    grep -qF "./empty.style: empty: want at least one line with a key" .err
    is "the message says that it is empty ('$text')" $? 0
done
try tamgen --size 64 --set ' ; '
refused "--set without a key" 2 2
finish
