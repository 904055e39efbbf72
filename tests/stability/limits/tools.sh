# Functions for the entries of the table of limits. PATH has the commands and the programs of programs/. MADE is a folder
# for files that several entries use; the working folder is the entry's own.

# once FILE COMMAND ...: makes $MADE/FILE from the standard output of a command, unless it exists
once() {
    once_file=$MADE/$1
    shift
    [ -e "$once_file" ] || { "$@" >"$once_file.part" && mv "$once_file.part" "$once_file"; }
}

# render PICTURE ARGUMENT ...: draws a picture of the page's size
render() {
    render_to=$1
    shift
    render-gl --quiet --size 240x180 "$@" -o "$render_to.png"
}

# without FILE PERL: copies the shaders without a remedy, which the Perl program takes out of FILE, to the folder shaders;
# fails if the program changes nothing
without() {
    rm -rf shaders
    cp -R "$TOP/cmd/render-gl/shaders" shaders
    chmod -R u+w shaders
    perl -0pi -e "$2" "shaders/$1"
    ! cmp -s "shaders/$1" "$TOP/cmd/render-gl/shaders/$1"
}

# column NAME [ROW]: the value in a table's column, in its first row or the one that begins with ROW
column() {
    awk -F'\t' -v name="$1" -v row="${2-}" '
        NR == 1 {for (i = 1; i <= NF; i++) if ($i == name) at = i; next}
        row == "" || $1 == row {print $at; exit}'
}

# share_of FIGURE PICTURE [OPTION ...]: a figure of hatchstat ink
share_of() {
    share_name=$1
    shift
    hatchstat ink "$@" | column "$share_name"
}

# on_plane PICTURE TONE ARGUMENT ...: draws a plane in one tone that fills the picture
on_plane() {
    once plane.glb meshgen plane --faces 200
    plane_to=$1
    plane_tone=$2
    shift 2
    render "$plane_to" "$MADE/plane.glb" --camera 0,0,2.5:0,0,0 --fov 30 --lines none \
        --tone-range "$plane_tone:$plane_tone" "$@"
}
