# contract.sh command NAME, contract.sh line N: checks one command, or one line of commands.tsv, for contract.t.
# FIXTURES is the folder of inputs.
. "${TOP:-.}/tests/tap.sh"

table=$TOP/tests/cli/commands.tsv
tab=$(printf '\t')

check_help() {
    try "$1" --help
    count_lines .out
    [ $status -eq 0 ] && [ ! -s .err ] && [ "$tap_lines" -le 40 ]
    is "$1 --help: standard output, exit 0, at most 40 lines" $? 0
    [ "$(sed '1,/^examples:/d' .out | grep -c -w -e "$1")" -ge 2 ]
    is "$1 --help: two examples or more" $? 0
    try "$1" -h
    "$1" --help | cmp -s - .out
    is "$1 -h is --help" $? 0
    try sh -c "$1 --help >/dev/full"
    is "$1 --help on a full disk" $status 4
    try "$1" --version
    is "$1 --version" "$(cut -d' ' -f1,2 .out) $status" "$1 (hatch) 0"
    if [ -z "$SANITIZE" ]; then
        ms=$(milliseconds 10 "$1" --version)
        [ "$ms" -le 10 ]
        is "$1 --version within 10 ms of a processor ($ms)" $? 0
    fi
}

# refused_option COMMAND NAME: whether the last try was refused in two lines, the first of which names that option
refused_option() {
    count_lines .err
    read -r first <.err
    [ $status -eq 2 ] && [ "$tap_lines" -eq 2 ] && [ ! -s .out ] || return 1
    case $first in "$1: --$2: "*) ;; *) return 1 ;; esac
}

# Values that every numeric option refuses; --options-table lists the numeric options, which alone have a range.
check_values() {
    "$1" --options-table >options.tsv
    awk -F'\t' 'NR > 1 && $3 ~ /^(int|real|size|pair)$/ {
        printf "%s %s %.17g %.17g\n", $2, $3, $5 * 2 + 1, $4 - 1}' options.tsv >numeric
    is "$1 lists no range for other options" "$(awk -F'\t' '
        NR > 1 && $3 !~ /^(int|real|size|pair)$/ && ($4 != 0 || $5 != 0) {print $2}' options.tsv)" ""
    command=$1
    [ -s numeric ] || fail "$1 has numeric options, --threads for one"
    bad=""
    while read -r name type beyond below; do
        [ "$type" = pair ] && set -- nan:nan 12x 1: :1 "$beyond:$beyond" "$below:$below" ||
            set -- nan NaN inf 12x 0x10 ' 1' '1 ' "$beyond" "$below"
        for value in "$@" ''; do
            try "$command" "--$name=$value"
            refused_option "$command" "$name" || bad="$bad --$name=$value($status)"
        done
    done <numeric
    set -- "$command"
    is "$1 refuses NaN, 12x and what is out of range" "$bad" ""
    bad=""
    for name in $(tail -n +2 options.tsv | awk -F'\t' '$3 == "choice" {print $2}'); do
        try "$1" "--$name=nonesuch"
        refused_option "$1" "$name" || bad="$bad --$name"
    done
    is "$1 refuses unknown choices" "$bad" ""
    for word in --nonesuch -% --hel --help=yes; do
        try "$1" "$word"
        refused "$1 $word" 2 2
        grep -qF -e " ${word%=*}" .err
        is "$1 $word: the message names it" $? 0
    done
}

# The printed SYNOPSIS equals the usage line; the manual's OPTIONS and --options-table list the same options.
check_manual() {
    manual=$TOP/man/man1/$1.1
    mandoc -Tascii -Owidth=1000 "$manual" 2>/dev/null | sed 's/.\x08//g' >manual.txt
    synopsis=$(sed -n '/^SYNOPSIS/,/^[A-Z]/p' manual.txt | sed '/^[A-Z]/d' | tr -s ' \n' '  ')
    usage=$("$1" --help | sed -n '1{s/usage://;p;};2,${/^       /!q;p;}' | tr -s ' \n' '  ')
    is "$1's usage is its manual's synopsis" "$usage" "$synopsis"
    "$1" --help | sed '/^examples:/,$d' >help.txt
    is "$1 --help names each option once, with its value" "$(tail -n +2 options.tsv | perl -F'\t' -ane '
        BEGIN {open my $file, "<", "help.txt"; local $/; $help = <$file>}
        my $names = ($F[0] ? "-$F[0], " : "") . "--$F[1]" . ($F[5] ? " $F[5]" : "");
        my $count = () = $help =~ /(?:^ {2,6}| {3})\Q$names\E(?= |$)/mg;
        print "$names: $count\n" if $F[1] && $count != ($F[1] ne "options-table")')" ""
    tail -n +2 options.tsv | awk -F'\t' '
        {printf "%s--%s%s%s\n", $1 == "" ? "" : "-" $1 " ", $2, $6 == "" ? "" : " ", $6}' |
        sort >program.list
    grep '^\.It Fl' "$manual" 2>/dev/null | sed 's/\\-/-/g' | awk '
        {
            letter = name = variable = ""
            for (i = 2; i <= NF; i++) {
                if ($i == "Fl" && $(i + 1) ~ /^-/) name = $(i + 1)
                else if ($i == "Fl") letter = $(i + 1)
                else if ($i == "Ar") variable = $(i + 1)
            }
            printf "%s-%s%s%s\n", letter == "" ? "" : "-" letter " ", name,
                   variable == "" ? "" : " ", variable
        }' | sort >manual.list
    is "$1's manual lists no other option" "$(comm -13 program.list manual.list)" ""
    tail -n +2 options.tsv | awk -F'\t' '$8 == "own" {print "--" $2}' | sort >own.list
    grep -o -e '--[a-z0-9-]*' manual.list | sort >named.list
    is "$1's manual lists every option of its own" "$(comm -23 own.list named.list)" ""
    is "$1's manual has the table's ranges, defaults and choices" \
        "$(perl "$TOP/tests/cli/manual_options.pl" options.tsv "$manual" 2>&1)" ""
    is "hatch(7) has the ranges, defaults and choices of common options" \
        "$(perl "$TOP/tests/cli/manual_options.pl" options.tsv "$TOP/man/man7/hatch.7" 2>&1)" ""
}

# run OUTPUT [OPTION ...]: runs the command of the line on $input
run() {
    output=$1
    shift
    with_input "$arguments" "$@" -o "$output"
}

# with_input ARGUMENTS [OPTION ...]: runs the command with $input, which may have spaces, in place of IN; $through is
# put before the command
with_input() {
    words=$1
    shift
    for word in $words; do
        [ "$word" = IN ] && set -- "$@" "$input" || set -- "$@" "$word"
    done
    ${through:-} "$command" "$@"
}

# content FILE: prints it without the lines that tell which files a plan was made from
content() {
    case $command in
    *hatchplan) grep -v -e '^INPUTS ' -e '^STAMPS ' "$1" ;;
    *) cat "$1" ;;
    esac
}

same() {
    content reference >reference.content
    content "$2" | cmp -s reference.content - && pass "$1" || fail "$1" "the bytes differ" "$(cat .err)"
}

check_output() {
    try run reference
    is "$label works" "$status $(wc -c <.out)" "0 0"
    [ -s reference ] || return 1
    try with_input "$arguments"
    same "$label: the same bytes to standard output" .out
    try run again
    same "$label: the same bytes again" again
    try run "n e w" -j 1
    same "$label: the same bytes with one thread, into a name with spaces" "n e w"
    try run again -j 2
    same "$label: the same bytes with two threads" again
    locale=$(locale -a | grep -i -m1 'de_DE.utf' || echo C.UTF-8)
    try env LC_ALL="$locale" TZ=Asia/Tokyo HOME=/nowhere POSIXLY_CORRECT=1 \
        sh -c 'command=$1 arguments=$2 input=$3; shift 3
            for word in $arguments; do
                [ "$word" = IN ] && set -- "$@" "$input" || set -- "$@" "$word"
            done
            "$command" "$@" -o again' sh "$command" "$arguments" "$input"
    same "$label: the same bytes in locale $locale and another time zone" again
    mkdir -p other
    (cd other && try run ../again && exit $status)
    same "$label: the same bytes from another folder" again
    echo old >kept
    chmod 640 kept
    try run kept
    is "$label: replaces a file and keeps its mode" "$(stat -c %a kept)" 640
    same "$label: replaces a file" kept
    ln -sf kept link
    try run link
    [ -L link ]
    is "$label: writes through a symbolic link" $? 0
}

check_refused_output() {
    try run /dev/full
    refused "$label -o /dev/full" 4 1
    with_input "$arguments" >/dev/full 2>.err
    is "$label >/dev/full" "$? $(wc -l <.err)" "4 1"
    (ulimit -f 0; try run small; exit $status)
    is "$label: a file size limit" "$? $(ls -A | grep -c -e small -e '^\.hatch')" "4 0"
    try run movie.mp4
    refused "$label: the ending of another format" 2 2
    try run missing/folder/x
    refused "$label: missing output folder" 4 1
    try run "$WORK"
    refused "$label: a folder as output" 4 1
    if [ -z "$SANITIZE" ]; then
        slow=${slow_arguments:-$arguments}
        ms=$(through='milliseconds 50' && with_input "$slow" -o missing/folder/x)
        [ "$ms" -le 50 ]
        is "$label: missing output folder noticed within 50 ms ($ms)" $? 0
    fi
    if unprivileged test -x "$BIN/$command" 2>/dev/null; then
        mkdir -p readonly
        chmod 555 readonly
        try unprivileged "$command" $(printf '%s' "$arguments" | sed "s|IN|$input|g") -o readonly/x
        refused "$label: read-only output folder" 4 1
    fi
    (trap '' PIPE; with_input "$arguments" 2>.err; echo $? >.status) | true
    is "$label: a closed pipe gives no message" "$(cat .err | grep -vc 'broken pipe')" 0
    with_input "$arguments" 2>.err | head -c 1 >/dev/null
    is "$label: a reader that stops early gives no message" "$(cat .err)" ""
}

# refused_input NAME STATUS: checks that $input is refused and that an existing output stays as it was
refused_input() {
    echo old >kept
    try run kept
    refused "$label: $1" "$2" 1
    grep -qF "$(basename "$input")" .err
    is "$label: $1: the message names the file" $? 0
    is "$label: $1: the old output stays" "$(cat kept)" old
}

check_input() {
    good=$input
    try with_input "$(printf '%s' "$arguments" | sed 's/IN/-/')" <"$good"
    same "$label: from standard input" .out
    cat "$good" | with_input "$(printf '%s' "$arguments" | sed 's/IN/-/')" >.out 2>.err
    same "$label: from a pipe" .out
    cp "$good" "in  put.${good##*.}"
    input="in  put.${good##*.}"
    try run again
    same "$label: an input with spaces in its name" again
    rm -f fifo
    mkfifo fifo
    input=fifo
    case $arguments in
    *IN*IN*) ;;
    *)
        cat "$good" >fifo &
        try run again
        same "$label: from a FIFO" again
        ;;
    esac
    input=nonesuch.${good##*.}
    refused_input "missing file" 4
    mkdir -p "folder.${good##*.}"
    input=folder.${good##*.}
    refused_input "a folder" 3
    input=empty.${good##*.}
    : >"$input"
    refused_input "an empty file" 3
    input=cut.${good##*.}
    size=$(wc -c <"$good")
    bad=""
    for part in 1 2 5 10 20 30 40 50 60 70 80 90 95 98; do
        head -c $((size * part / 100)) "$good" >"$input"
        try run cut.out
        case $status in 3 | 5) ;; *) bad="$bad $part%:$status" ;; esac
        count_lines .err
        [ ! -e cut.out ] && [ "$tap_lines" -eq 1 ] || bad="$bad $part%:left"
    done
    is "$label: a truncated file" "$bad" ""
    head -c $((size / 2)) "$good" >"$input"
    refused_input "half a file" 3
    input=secret.${good##*.}
    cp "$good" "$input"
    chmod 0 "$input"
    if unprivileged test -x "$BIN/$command" 2>/dev/null && ! unprivileged cat "$input" 2>/dev/null
    then
        chmod 777 . # another user writes here
        try unprivileged "$command" $(printf '%s' "$arguments" | sed "s|IN|$input|g")
        refused "$label: an unreadable file" 4 1
    fi
    input=$good
}

# no_litter: whether the folder signals holds nothing but kept
no_litter() {
    set -- signals/* signals/.[!.]*
    [ "$*" = 'signals/kept signals/.[!.]*' ]
}

# Interrupts the command at six moments over its duration and a little beyond, twenty with LONG=1, the same ones in every
# run of the test.
check_signals() {
    slow=${slow_arguments:-$arguments}
    [ -z "$SANITIZE${GCOV_PREFIX:-}" ] || slow=$arguments # instrumented programs are slow enough
    mkdir -p signals
    try with_input "$slow" -o signals/whole
    [ $status -eq 0 ] || return
    mv signals/whole whole
    from=$(date +%s%N)
    try with_input "$slow" -o whole
    length_ms=$((($(date +%s%N) - from) / 1000000))
    bad=""
    moments=6
    [ -z "${LONG:-}" ] || moments=20
    for moment in $(awk -v length_ms=$length_ms -v moments=$moments 'BEGIN {
            srand(7); for (i = 0; i < moments; i++) printf "%.4f ", rand() * 1.1e-3 * length_ms }'); do
        for signal in INT TERM; do
            echo old >signals/kept
            (through="timeout -s $signal $moment" && with_input "$slow" -o signals/kept) 2>.err
            read -r first <signals/kept
            [ "$first" = old ] || cmp -s signals/kept whole || bad="$bad $signal@$moment:output"
            no_litter || {
                bad="$bad $signal@$moment:litter"
                rm -f signals/.??*
            }
            [ ! -s .err ] || bad="$bad $signal@$moment:words"
        done
    done
    is "$label: SIGINT and SIGTERM at $moments moments of $length_ms ms" "$bad" ""
}

case $1 in
command)
    check_help "$2"
    check_values "$2"
    check_manual "$2"
    grep -q "^$2$tab" "$table"
    is "$2 has a line in commands.tsv" $? 0
    ;;
line)
    grep -v '^#' "$table" | sed -n "$2p" >line.tsv
    IFS=$tab read -r command input arguments slow_arguments <line.tsv
    label="$command $arguments"
    [ "$input" = - ] || input=$FIXTURES/$input
    if check_output; then
        check_refused_output
        [ "$input" = - ] || check_input
        check_signals
    fi
    ;;
esac
finish
