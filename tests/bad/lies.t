# Headers that promise more than the file holds are refused within 50 ms and 16 MiB: with so much
# address space beside what the command itself needs, it says the same as with plenty.
. "${TOP:-.}/tests/tap.sh"
bad=$TOP/../shared/bad
[ -z "$SANITIZE" ] || { skip "lying headers" "sanitizers take memory and time of their own"; finish; }
[ -e "$bad/MANIFEST.tsv" ] || { skip "lying headers" "no folder shared/bad beside the source"; finish; }

. "$TOP/tests/bad/lie.sh"
for file in ply_vertex_1e9_ascii.ply ply_vertex_4294967295_bin.ply ply_list_len_2e9.ply \
    off_counts_1e9.off stl_count_ffffffff.stl glb_accessor_count_1e9.glb \
    glb_json_length_ffffffff.glb gltf_no_bufferview_count_max.gltf gltf_instance_bomb_2e39.gltf; do
    lie "$bad"/synth/$file hatchstat mesh -j1
    lie "$bad"/synth/$file render-gl --technique=gouraud -j1 -o picture.png
done
for file in synth/png_bomb_65535x65535_1bit.png synth/exr_datawindow_2e31.exr \
    real/openexr-damaged/memory_DOS_1.exr real/openexr-damaged/oom.exr; do
    lie "$bad/$file" hatchstat diff -j1 "$bad/$file"
    lie "$bad/$file" tampack -j1 -o packed
    lie "$bad/$file" tamvol -j1 -o volume
    lie "$bad/$file" tamthresh -j1 -o thresholds
done
lie "$bad"/real/oiio/bomb-65500x65500.jpg hatchstat diff -j1 "$bad/real/oiio/bomb-65500x65500.jpg"
finish
