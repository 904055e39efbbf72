# meshfit: what it keeps, the promise on the error, and the numbers of faces.
. "${TOP:-.}/tests/tap.sh"

# Small pictures, whose measures take little time.
small="--size 320x180"
# column NAME: the value of a column in the first row
column() {
    awk -F'\t' -v name="$1" 'NR == 1 {for (i = 1; i <= NF; i++) if ($i == name) c = i} NR == 2 {print $c}'
}
# faces FILE: the number of faces
faces() {
    hatchstat mesh -q "$1" | column faces
}
# displacement FULL COARSE [OPTION ...]: the largest displacement in pixels
displacement() {
    hatchstat coarse -q $small "$@" | column displacement_px
}
# json FILE: the JSON of a GLB file
json() {
    tail -c +21 "$1" | head -c "$(od -An -tu4 -j12 -N4 "$1" | tr -d ' ')"
}
# difference A B: how far A is from B
difference() {
    awk -v a="$1" -v b="$2" 'BEGIN {print (a > b ? a - b : b - a)}'
}
# below A B: whether A is at most B
below() {
    awk -v a="$1" -v b="$2" 'BEGIN {exit !(a <= b)}'
}

meshgen plane --faces 10000 -o plane.glb
ok "a plane" meshfit $small plane.glb -o plane.fit.glb
is "a plane of 10000 faces becomes two" "$(faces plane.fit.glb)" 2
meshfit $small <plane.glb >piped.glb
ok "from a pipe to a pipe" cmp piped.glb plane.fit.glb

meshgen teapot --faces 6000 -o teapot.glb
ok "a mesh of many parts" meshfit $small teapot.glb -o fit.glb
ok "fewer faces" test "$(faces fit.glb)" -lt 3500
ok "the displacement is at most half a pixel" below "$(displacement teapot.glb fit.glb)" 0.5
is "parts, holes and genus are as before" \
    "$(hatchstat mesh -q fit.glb | column components) $(hatchstat mesh -q fit.glb | column euler)" \
    "$(hatchstat mesh -q teapot.glb | column components) $(hatchstat mesh -q teapot.glb | column euler)"
meshfit $small -j 1 teapot.glb -o one.glb
meshfit $small -j 3 teapot.glb -o three.glb
ok "any number of threads gives the same bytes" cmp one.glb three.glb
meshfit $small --error 2 teapot.glb -o rough.glb
ok "a larger error gives fewer faces" test "$(faces rough.glb)" -lt $(($(faces fit.glb) / 2))
ok "which keeps to it" below "$(displacement teapot.glb rough.glb)" 2
ok "and uses it" below 1 "$(displacement teapot.glb rough.glb)"
meshfit --size 80x45 teapot.glb -o small.glb
ok "a quarter of the size is about four times the error" \
    test $(($(faces small.glb) * 100 / $(faces rough.glb))) -ge 97 -a $(($(faces small.glb) * 100 / $(faces rough.glb))) -le 103
meshfit --zoom 4 --size 80x45 teapot.glb -o near.glb
ok "a nearer view needs more faces" test "$(faces near.glb)" -gt "$(faces small.glb)"
meshfit $small --from 30:20 teapot.glb -o side.glb
ok "one view needs no more faces than all" test "$(faces side.glb)" -le "$(faces fit.glb)"

meshgen torus --faces 3000 -o torus.glb
printf '%s\n' ply 'format ascii 1.0' 'element vertex 4' 'property float x' 'property float y' 'property float z' \
    'element face 4' 'property list uchar int vertex_indices' end_header '0 0 0' '1 0 0' '0 1 0' '0 0 1' \
    '3 0 2 1' '3 0 1 3' '3 0 3 2' '3 1 2 3' >tetra.ply
try meshfit $small tetra.ply -o tetra.glb
is "a tetrahedron stays, with a note" "$(cat .err)" \
    "meshfit: tetra.ply: warning: no face can be left out: the meshes are as they were"
is "as four faces" "$(faces tetra.glb)" 4

meshfit $small --faces 400 torus.glb -o few.glb
is "the file tells the command" "$(strings few.glb | grep -o 'meshfit [^"]*')" "meshfit --faces 400 $small --fov 30 --zoom 1"
ok "--faces is not exceeded" test "$(faces few.glb)" -le 400
ok "and nearly reached" test "$(faces few.glb)" -ge 380
meshgen plane --faces 3000 -o flat.glb
is "a plane has no more than two" "$(meshfit $small --faces 4 flat.glb | hatchstat mesh | column faces)" 2
used=$(milliseconds 4000 meshfit $small --faces 4 flat.glb -o /dev/null)
ok "which are found in under 4 seconds ($used ms)" test "$used" -le 4000
# In these pictures, faces of a torus of 204 are so large that a tolerance of several pixels leaves none out.
meshgen torus --faces 200 -o big.glb
for count in 60 150 200; do
    is "--faces $count of a mesh that no small tolerance makes coarser is nearly reached" \
        "$(meshfit --size 4096x2304 --faces $count big.glb | hatchstat mesh -q | column faces |
            awk -v most=$count '{print ($1 <= most && $1 >= .97 * most) ? "yes" : $1}')" yes
done
meshfit $small --faces 5000 torus.glb -q -o same.glb
is "more faces than there are: all are kept" "$(faces same.glb)" "$(faces torus.glb)"
try meshfit $small --faces 4 torus.glb -o /dev/null
refused "too few faces for a torus" 3 1
is "which says how many it needs" "$(grep -c '^meshfit: torus.glb: --faces 4: the surface, with the borders of its texture coordinates, cannot have fewer than [0-9]*$' .err)" 1
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\nv 3 0 0\nv 4 0 0\nv 3 1 0\nf 5 6 7\n' >bare.obj
try meshfit --faces 4 bare.obj
is "borders only where there are some" "$(cat .err)" "meshfit: bare.obj: --faces 4: the surface cannot have fewer than 5"

# Scans have no normals, and glTF without normals is flat: a coarse mesh gets those of the full one.
awk 'BEGIN {
    n = 40
    for (i = 0; i <= n; i++)
        for (j = 0; j <= n; j++)
            print "v", i / n, 0.1 * sin(6.3 * i / n) * sin(6.3 * j / n), j / n
    for (i = 0; i < n; i++)
        for (j = 1; j <= n; j++) {
            a = i * (n + 1) + j
            print "f", a, a + 1, a + n + 2
            print "f", a, a + n + 2, a + n + 1
        }
}' >waves.obj
ok "a mesh without normals" meshfit $small --error 1 waves.obj -o waves.glb
ok "becomes coarser" test "$(faces waves.glb)" -lt 1600
is "and has normals" "$(json waves.glb | grep -c '"NORMAL"')" 1
# Scans lie far from the origin: at 10^6 floats are 1/16 apart, more than twice the width of a face.
awk '$1 == "v" {printf "v %.6f %.6f %.6f\n", $2 + 1e6, $3 - 1e6, $4 + 1e6} $1 == "f"' waves.obj >far.obj
meshfit $small --error 1 far.obj -o far.glb
ok "far from the origin it becomes as coarse" below "$(difference "$(faces far.glb)" "$(faces waves.glb)")" 10
ok "and is measured as precisely" below "$(difference "$(displacement far.obj far.glb)" "$(displacement waves.obj waves.glb)")" 0.01
meshfit $small -q --levels 2 far.obj -o far.levels.glb
ok "where figures of several nodes are those near the origin" below "$(difference \
    "$(hatchstat mesh -q far.levels.glb | column area)" "$(meshfit $small -q waves.obj | hatchstat mesh -q | column area)")" 1e-5
printf 'v %s\n' '0 0 0' '1 0 0' '1 1 0' '0 1 0' '0 0 1' '1 0 1' '1 1 1' '0 1 1' >box.obj
printf 'f %s\n' '1 4 3 2' '5 6 7 8' '1 2 6 5' '2 3 7 6' '3 4 8 7' '4 1 5 8' >>box.obj
meshfit $small -q box.obj -o box.glb
is "edges of a box stay sharp" "$(hatchstat mesh -q box.glb | column vertices)" 24

try meshfit $small -v torus.glb -o /dev/null
is "-v reports faces and errors" "$(grep -cE '^meshfit: [0-9]+ of [0-9]+ faces; displacement 0\.[0-9]+ px at most, 99\.9 % within 0\.[0-9]+ px; outlines [0-9.]+ px at most; normals [0-9.]+ degrees in the mean$' .err)" 1
try meshfit $small torus.glb -o /dev/null
is "without it, nothing is said" "$(cat .err)" ""
is "the options are in the file" "$(grep -ac '"meshfit --error 0.5 --levels 1 --size 320x180 --fov 30 --zoom 1"' fit.glb)" 1

meshfit $small --levels 3 torus.glb -o levels.glb
is "--levels writes coarser nodes that are not part of the scene" \
    "$(json levels.glb | grep -o '"scenes":.*"meshes"')" \
    '"scenes":[{"nodes":[0]}],"nodes":[{"name":"torus","children":[1]},{"mesh":0,"extensions":{"MSFT_lod":{"ids":[2,3]}},"extras":{"MSFT_screencoverage":[0.212500006,0.0531250015,0]}},{"mesh":1},{"mesh":2}],"meshes"'
# Two tetrahedra, the second a tenth as large and at the centre of the first one's box: it fills a hundredth of the picture.
cat >two.gltf <<'END'
{"asset": {"version": "2.0"}, "scenes": [{"nodes": [0, 1]}],
 "nodes": [{"mesh": 0}, {"mesh": 0, "scale": [0.1, 0.1, 0.1], "translation": [0.45, 0.45, 0.45]}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 1]},
     {"bufferView": 1, "componentType": 5121, "count": 12, "type": "SCALAR"}],
 "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
 "buffers": [{"byteLength": 60, "uri": "two.bin"}]}
END
{
    head -c 12 /dev/zero
    printf '\0\0\200\077\0\0\0\0\0\0\0\0\0\0\0\0\0\0\200\077\0\0\0\0\0\0\0\0\0\0\0\0\0\0\200\077'
    printf '\0\2\1\0\1\3\0\3\2\1\2\3'
} >two.bin
is "a small part is drawn as fine as the whole scene" \
    "$(meshfit $small -q --levels 2 two.gltf -o two.glb && json two.glb | grep -o '"MSFT_screencoverage":[^}]*' | xargs)" \
    "MSFT_screencoverage:[0.212500006,0] MSFT_screencoverage:[0.00212500012,0]"
meshfit $small -q --levels 5 two.gltf -o five.glb
is "and each further level is drawn from a quarter of the picture on" \
    "$(json five.glb | grep -o '"MSFT_screencoverage":\[[^]]*' | sed 's/.*\[//' | awk -F, '{
        for (i = 1; i < 5; i++) printf "%.4g ", $i * 4 ^ i
        print $5 }' | paste -sd';')" "0.85 0.85 0.85 0.85 0;0.0085 0.0085 0.0085 0.0085 0"
is "and names the extension" "$(json levels.glb | grep -c '"extensionsUsed":\["MSFT_lod"\]')" 1
meshfit $small torus.glb -o first.glb
is "others read the first level" "$(faces levels.glb)" "$(faces first.glb)"
counts=$(json levels.glb | grep -o '"componentType":512[35],"count":[0-9]*,"type":"SCALAR"' | sed 's/.*count"://; s/,.*//')
# shellcheck disable=SC2086
set -- $counts
ok "each level has fewer faces" test $# -eq 3 -a "$1" -gt "$2" -a "$2" -gt "$3"
for option in "--faces 400" "--levels 2" "--error 3"; do
    # shellcheck disable=SC2086 # options are words
    try meshfit $small $option levels.glb -o again.glb
    # shellcheck disable=SC2086
    meshfit $small $option first.glb -o once.glb
    is "$option of what has levels: of the first, with a warning" "$status $(numbers again.glb | md5sum) $(cat .err)" \
        "0 $(numbers once.glb | md5sum) meshfit: levels.glb: warning: 1 node has levels of detail, which are left out: meshfit --levels makes them"
done
for command in dirfield "strokegen --levels 1" lapped-param; do
    # shellcheck disable=SC2086 # with options
    try $command levels.glb -o again.glb
    is "$command works on the first level only, with a warning" "$status $(json again.glb | grep -c '"mesh":1') $(cat .err)" \
        "0 0 ${command%% *}: levels.glb: warning: 1 node has levels of detail, which are left out: meshfit --levels makes them"
done
perl -pe 's/"MSFT_lod":\{/"OTHER_lo":{/' levels.glb >undrawn.glb
for command in dirfield meshfit; do
    try $command undrawn.glb -o again.glb
    is "$command: meshes that no node draws are left out, with a warning" \
        "$status $(json again.glb | grep -c '"mesh":1') $(grep 'no node' .err)" \
        "0 0 $command: undrawn.glb: warning: 2 meshes that no node draws are left out"
done
try meshfit --faces 100 --levels 2 torus.glb
refused "--levels with --faces" 2 2
try meshfit --faces 100 --error 1 torus.glb
refused "--error with --faces" 2 2
try meshfit --levels 9 torus.glb
refused "--levels 9" 2 2

# Traced strokes lie on faces of the full mesh.
strokegen -q --levels 2 torus.glb -o strokes.glb
dirfield -q torus.glb -o field.glb
for option in "--error 3" "--faces 400" "--levels 2"; do
    # shellcheck disable=SC2086 # options are words
    try meshfit $small $option strokes.glb -o coarse.glb
    is "$option: strokes are left out, with a warning" "$status $(cat .err)" \
        "0 meshfit: strokes.glb: warning: strokes are left out where meshes became coarser; strokegen traces them anew"
    # shellcheck disable=SC2086
    meshfit $small $option field.glb -o plain.glb
    is "the rest is that of the mesh without strokes" "$(numbers coarse.glb | md5sum)" "$(numbers plain.glb | md5sum)"
done
meshfit $small --faces 5000 -q strokes.glb -o same.glb
is "strokes stay where the mesh stays" "$(numbers same.glb | wc -c)" "$(numbers strokes.glb | wc -c)"
strokegen -q --levels 1 tetra.ply | meshfit $small 2>.err >tetra.strokes.glb
is "as they do where no face can be left out" "$(cat .err) $(json tetra.strokes.glb | grep -c '"_HATCH_STROKE"')" \
    "meshfit: standard input: warning: no face can be left out: the meshes are as they were 1"

# Meshes that stay as they were are not measured, which would leave roundings, and take long where faces are large.
meshgen sphere --faces 200 | meshfit -v --zoom 200 -o near.glb 2>.err
is "a near view keeps the scene's meshes, exactly" "$(sed -n 's/^meshfit: \([0-9]*\) of \1 faces; //p' .err)" \
    "displacement 0 px at most, 99.9 % within 0 px; outlines 0 px at most; normals 0 degrees in the mean"

# Faces of which a corner is behind the camera are seen, too.
meshgen plane --faces 72 | meshfit -v --size 320x240 --zoom 8 --from 30:20 -o near.glb 2>.err
is "a plane below the camera has its outline" "$(sed -n 's/^meshfit: 2 of 72 faces.*\(outlines.*at most\);.*/\1/p' .err)" \
    "outlines 0 px at most"

for option in "--error 0" "--error nan" "--size 0x1" "--faces 3" "--zoom 0" "--fov 180"; do
    try meshfit $option torus.glb
    refused "$option" 2 2
done
finish
