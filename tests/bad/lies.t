# Headers that promise more than the file holds are refused within 50 ms and 16 MiB: with so much
# address space beside what the command itself needs, it says the same as with plenty.
. "${TOP:-.}/tests/tap.sh"
bad=$TOP/../shared/bad
[ -z "$SANITIZE" ] || { skip "lying headers" "sanitizers take memory and time of their own"; finish; }
[ -e "$bad/MANIFEST.tsv" ] || { skip "lying headers" "no folder shared/bad beside the source"; finish; }

# within KIB COMMAND ...
within() {
    (ulimit -v "$1" && shift && exec "$@")
}

# The address space that a command takes for itself, in KiB.
own_space() {
    kib=8192
    while ! within $kib "$1" --version >/dev/null 2>&1; do
        kib=$((kib + 1024))
    done
    echo $kib
}

# lie FILE COMMAND ...
lie() {
    name="$2 ${3#--}: $1"
    lying=$bad/$1
    shift
    space=$(own_space "$1")
    "$@" "$lying" >plenty 2>&1
    status=$?
    within $((space + 16384)) "$@" "$lying" >little 2>&1
    is "$name: refused within 16 MiB" "$? $(cat little)" "$status $(cat plenty)"
    case $status in 3 | 5) ;; *) fail "$name: refused" "exit $status" ;; esac
    ms=$(milliseconds 50 "$@" "$lying")
    [ "$ms" -le 50 ]
    is "$name: refused within 50 ms ($ms)" $? 0
}

for file in ply_vertex_1e9_ascii.ply ply_vertex_4294967295_bin.ply ply_list_len_2e9.ply \
    off_counts_1e9.off stl_count_ffffffff.stl glb_accessor_count_1e9.glb \
    glb_json_length_ffffffff.glb gltf_no_bufferview_count_max.gltf gltf_instance_bomb_2e39.gltf; do
    lie synth/$file hatchstat mesh -j1
    lie synth/$file render-gl --technique=gouraud -j1 -o picture.png
done
for file in synth/png_bomb_65535x65535_1bit.png synth/exr_datawindow_2e31.exr \
    real/openexr-damaged/memory_DOS_1.exr real/openexr-damaged/oom.exr; do
    lie $file hatchstat diff -j1 "$bad/$file"
    lie $file tampack -j1 -o packed
    lie $file tamvol -j1 -o volume
    lie $file tamthresh -j1 -o thresholds
done
lie real/oiio/bomb-65500x65500.jpg hatchstat diff -j1 "$bad/real/oiio/bomb-65500x65500.jpg"
finish
