# Inputs that may never end: what begins no format is refused after its first bytes; every format comes through a pipe.
# Each kind of output, as a terminal gets it.
. "${TOP:-.}/tests/tap.sh"
meshgen torus --faces 4000 -o mesh.glb
tamgen --size 64 --strokes strokes.tsv -o map.exr
tamvol -q map.exr -o volume.ktx2
render-gl mesh.glb --technique gouraud --size 400x300 -o picture.png
# large: beyond the first bytes
perl -e 'print "OFF\n8000 8000 0\n"; print "$_ 0.5 ", $_ * $_, "\n" for 1 .. 8000;
    print "3 ", $_ % 8000, " ", ($_ + 1) % 8000, " ", ($_ + 3) % 8000, "\n" for 1 .. 8000' >mesh.off
perl -e 'print "v $_ 0.5 ", $_ * $_, "\n" for 1 .. 8000; print "f ", $_, " ", $_ + 1, " ", $_ + 2, "\n" for 1 .. 7998' \
    >mesh.obj
perl -e 'print "ply\nformat binary_little_endian 1.0\nelement vertex 8000\nproperty float x\nproperty float y\n";
    print "property float z\nelement face 7998\nproperty list uchar int vertex_indices\nend_header\n";
    print pack "f<3", $_, 0.5, $_ * $_ for 1 .. 8000; print pack "C l<3", 3, $_, $_ + 1, $_ + 2 for 0 .. 7997' >mesh.ply
perl -e 'print "\0" x 80, pack "L<", 4000;
    print pack "f<12 S<", 0, 0, 1, $_, 0, 0, $_ + 1, 0, 0, $_, 1, 0, 0 for 1 .. 4000' >mesh.stl
perl -e 'print "P6\n300 300\n255\n", "\0\1\2" x 90000' >picture.ppm
perl -e 'print pack "C3 x9 v2 C2", 0, 0, 2, 300, 300, 24, 0; print "\0\1\2" x 90000' >picture.tga

endless() {
    for source in "cat /dev/zero" "cat /dev/urandom"; do
        case $source in *zero) path=/dev/zero ;; *) path=/dev/urandom ;; esac
        try "$@" $path --max-memory 64M -o out.x
        refused "$path: $*" 3 1
        grep -qF "no known format" .err
        is "$path: $*: the message says why" $? 0
        try sh -c "$source | $* - --max-memory 64M -o out.x"
        grep -v roken .err >.words
        is "$source into $*" "$status $(wc -l <.words) $(grep -c 'no known format' .words)" "3 1 1"
    done
}
endless hatchstat mesh
endless hatchstat ink
endless hatchstat tam
endless hatchstat tones --reference map.exr
endless hatchstat seeds
endless hatchstat field
endless hatchstat lapped
endless render-gl --technique gouraud
endless dirfield
endless lapped-param
endless strokegen
endless tampack --layout dds
endless tamvol
endless tamthresh
endless tamgen --size 64 --replay
endless tamgen --size 64 --style
endless tamgen --size 64 --palette
endless solidgen --size 8 --style
endless tamgen --size 64 --brush
endless render-gl mesh.glb --technique rptam --seeds
endless render-gl mesh.glb --technique rptam --layers
endless dirfield mesh.glb --constraints

# begins NAME WANT PERL: checks whether more bytes than the first 64 KiB, which a line of Perl prints, begin a format
begins() {
    perl -e "$3" | hatchstat mesh - >.words 2>&1
    is "$1: $2" "$(grep -q 'no known format' .words && echo none || echo known)" "$2"
}
while read -r map type bits want; do # bytes that are no numbers of a mesh surround those of a TGA file
    begins "TGA of types $map $type, $bits bits" "$want" \
        "print pack('C3', 255, $map, $type), qq(\xff) x 13, chr $bits, qq(\xff) x 70000"
done <<END
0 1 1 known
1 3 32 known
1 9 24 known
0 11 8 known
2 1 8 none
0 0 8 none
0 4 8 none
0 12 8 none
0 1 0 none
0 1 33 none
END
begins "text with tabs and line ends of Windows" known 'print qq(a) x 200, qq(\t\x0b\x0c \r\n) x 20000'
begins "text with a control character below them" none 'print qq(a) x 65535, qq(\x08) x 9'
begins "text with a control character above them" none 'print qq(a) x 65535, qq(\x0e) x 9'
begins "text before a control character" known 'print qq(a) x 65536, qq(\x0e) x 9'
for triangle in "9.9e14 known" "1e15 none"; do
    begins "STL with a coordinate of ${triangle% *} in its 100th triangle" "${triangle#* }" \
        "print qq(\xff) x 80, pack 'L<', 2000; print pack 'f<12 S<', (0) x 11, \$_ == 100 ? ${triangle% *} : -1, 0 for 1 .. 2000"
done

# through COMMAND ... FILE: the file and its bytes through a pipe give the same output
through() {
    for file; do :; done
    "$@" >by_name 2>.err
    set -- $(printf '%s ' "$@" | sed "s| $file \$| -|")
    cat "$file" | "$@" >by_pipe 2>.err
    is "$file through a pipe" "$(wc -c <by_pipe | awk '{print ($1 > 0)}') $(cmp by_name by_pipe)" "1 "
}
for file in mesh.glb mesh.off mesh.obj mesh.ply; do
    through hatchstat mesh $file
done
through hatchstat ink picture.png
through hatchstat tam map.exr
through hatchstat tones --samples 640 --reference map.exr volume.ktx2
through tamgen --size 64 --replay strokes.tsv
# Formats that are known by the ending of the name.
for line in "mesh mesh.stl" "ink picture.ppm" "ink picture.tga"; do
    set -- $line
    mkfifo "fifo.${2##*.}"
    cat "$2" >"fifo.${2##*.}" &
    hatchstat "$1" "$2" >by_name
    hatchstat "$1" "fifo.${2##*.}" >by_pipe
    is "$2 through a FIFO" "$(wc -c <by_pipe | awk '{print ($1 > 0)}') $(cmp by_name by_pipe)" "1 "
done
# Normals of STL files may be anything.
perl -0777 -pe 'substr $_, 84, 12, pack "f<3", ("nan") x 3' mesh.stl >normals.stl
is "an STL file whose first normal is NaN, through a pipe" "$(hatchstat -q mesh - <normals.stl | cksum)" \
    "$(hatchstat -q mesh normals.stl | cksum)"
# The header of a binary STL file may be blank, and the number of faces look like the beginning of a JSON text.
for blank in 0 32; do
    perl -e 'print chr($ARGV[0]) x 80, pack "L<", 123;
        print pack "f<12 S<", 0, 0, 1, $_, 0, 0, $_ + 1, 0, 0, $_, 1, 0, 0 for 1 .. 123' $blank >blank.stl
    is "123 faces after a header of bytes $blank" "$(hatchstat -q mesh blank.stl | tail -n 1 | cut -f 2)" 123
    is "and through a pipe" "$(hatchstat -q mesh - <blank.stl | tail -n 1 | cut -f 2)" 123
done
{ echo '# a comment'; cat mesh.off; } >comment.off
is "an OFF file that begins with a comment, through a pipe" "$(hatchstat -q mesh - <comment.off | cksum)" \
    "$(hatchstat -q mesh mesh.off | cksum)"

# on_terminal COMMAND: prints a command's status and the first line that a terminal shows of it
on_terminal() {
    script -qec "$1" typed </dev/null >shown
    echo "$? $(head -1 shown | tr -d '\r' | cut -c1-60)"
}
meshgen plane --faces 2 -o plane.glb
if script -qec true typed </dev/null >/dev/null 2>&1; then
    for command in "meshgen plane" "tamgen --size 64" "tamgen --size 64 -o a.exr --contact-sheet -" "dirfield plane.glb" \
        "lapped-param plane.glb" "strokegen plane.glb"; do
        is "$command: a terminal gets no binary data" "$(on_terminal "$command")" \
            "$(echo "2 ${command%% *}: binary data is not written to a terminal: use -o FILE" | cut -c1-62)"
    done
    is "the table of strokes on a terminal" "$(on_terminal 'tamgen --size 64 -o a.exr --strokes -' | cut -f1-3)" \
        "$(printf '0 x\ty\tlength')"
    is "seed sets on a terminal" "$(on_terminal 'seedgen -n 4' | cut -c1-21)" "0 # seedgen --count 4"
    is "a plot on a terminal" "$(on_terminal 'seedgen -n 4 -o a.seeds --plot -' | cut -c1-6)" "0 <svg"
    is "a report on a terminal" "$(on_terminal 'hatchstat mesh plane.glb' | cut -c1-10)" "0 vertices"
    # A scene that comes late: work that takes over a second tells how far it is, in a line that is gone at the end.
    mkfifo late
    for seconds in 1.5 6 30; do # longer where the command is slow to start
        { sleep $seconds; cat plane.glb; } >late &
        script -qec 'render-gl - -t gouraud --size 8x8 -o late.png <late' typed </dev/null >shown
        [ ! -s shown ] || break
    done
    ok "progress on a terminal" perl -0777 -ne \
        'exit !/\A(?:\rrender-gl: drawing \d+ %)+\r\e\[K\z/' shown
else
    skip "what a terminal gets" "no script(1), or no terminals for it"
fi
finish
