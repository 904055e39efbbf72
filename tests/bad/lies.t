# Headers that promise more than the file holds are refused within 50 ms and 16 MiB: with so much
# address space beside what the command itself needs, it says the same as with plenty.
. "${TOP:-.}/tests/tap.sh"
[ -z "$SANITIZE" ] || { skip "lying headers" "sanitizers take memory and time of their own"; finish; }
. "$TOP/tests/bad/lie.sh"
ok "inputs are generated" perl "$TOP/tests/bad/make.pl" own

# meshes FOLDER FILE ...
meshes() {
    folder=$1
    shift
    for file in "$@"; do
        lie "$folder/$file" hatchstat mesh -j1
        lie "$folder/$file" render-gl --technique=gouraud -j1 -o picture.png
    done
}
# pictures FOLDER FILE ...
pictures() {
    folder=$1
    shift
    for file in "$@"; do
        lie "$folder/$file" hatchstat diff -j1 "$folder/$file"
        case $file in *.jpg | *.tif | *.gif | *.bmp) continue ;; esac
        lie "$folder/$file" tampack -j1 -o packed
        lie "$folder/$file" tamvol -j1 -o volume
        lie "$folder/$file" tamthresh -j1 -o thresholds
    done
}

meshes own ply/vertex-1e9-ascii.ply ply/vertex-4294967295.ply ply/face-4294967295.ply ply/list-length-2e9.ply \
    off/counts-1e9.off off/counts-1e12.off stl/count-ffffffff.stl glb/json-length-ffffffff.glb \
    gltf/accessor-count-1e9.gltf gltf/no-view-count-max.gltf gltf/no-view-count-2e9.gltf gltf/instance-bomb-2e39.glb \
    gltf/instances-1e9-no-view.glb
pictures own png/bomb-65535x65535-1-bit.png png/claims-10000x10000.png exr/window-2e32.exr exr/window-20000.exr \
    exr/window-high.exr exr/tiles-2e31.exr exr/attribute-7fffffff.exr foreign/bomb-65500x65500.jpg foreign/bomb.tif \
    foreign/bomb.gif foreign/bomb.bmp

bad=$TOP/../shared/bad
[ -e "$bad/MANIFEST.tsv" ] || finish
meshes "$bad/synth" ply_vertex_1e9_ascii.ply ply_vertex_4294967295_bin.ply ply_list_len_2e9.ply \
    off_counts_1e9.off stl_count_ffffffff.stl glb_accessor_count_1e9.glb \
    glb_json_length_ffffffff.glb gltf_no_bufferview_count_max.gltf gltf_instance_bomb_2e39.gltf
pictures "$bad" synth/png_bomb_65535x65535_1bit.png synth/exr_datawindow_2e31.exr \
    real/openexr-damaged/memory_DOS_1.exr real/openexr-damaged/oom.exr real/oiio/bomb-65500x65500.jpg
finish
