# A torus damaged as scanners, exporters and programs damage meshes keeps its field; surfaces with few or no principal
# directions get a valid one.
. "${TOP:-.}/tests/tap.sh"
command -v dirfield >/dev/null || { skip "damaged meshes" "no dirfield"; finish; }

# column NAME <TABLE
column() {
    awk -F'\t' -v name="$1" 'NR == 1 {for (i = 1; i <= NF; i++) if ($i == name) c = i} NR == 2 {print $c}'
}

# torus SCALE OFFSET: prints an irregular torus as OBJ
torus() {
    awk -v scale="$1" -v offset="$2" '
    function random() { x = (x * 1103 + 12345) % 1048576; return x / 1048576 } # the rand() of awks differs
    BEGIN {
        pi = 3.14159265358979; n = 60; m = 30; x = 1
        for (i = 0; i < n; i++) for (j = 0; j < m; j++) {
            a = 2 * pi * (i + .4 * random()) / n; b = 2 * pi * (j + .4 * random()) / m
            r = 1 + .4 * cos(b)
            printf "v %.17g %.17g %.17g\n", scale * r * cos(a) + offset, scale * .4 * sin(b) + offset,
                -scale * r * sin(a) + offset
        }
        for (i = 0; i < n; i++) for (j = 0; j < m; j++) {
            a = i * m + j + 1; b = (i + 1) % n * m + j + 1
            c = (i + 1) % n * m + (j + 1) % m + 1; d = i * m + (j + 1) % m + 1
            printf "f %d %d %d\nf %d %d %d\n", a, b, c, a, c, d
        }
    }'
}

# same NAME FILE [LIMIT]: checks that the field of FILE is that of the torus at all points, to within LIMIT degrees
same() {
    try dirfield -q "$2" -o out.glb
    hatchstat field -q out.glb --reference torus.glb >figures.tsv 2>.err
    is "$1: the same field" \
        "$status $(column compared <figures.tsv | awk '{print ($1 >= 1700)}') $(column deg_max <figures.tsv | awk -v limit="${3:-0.01}" '{print ($1 <= limit) ? "within" : $1}')" \
        "0 1 within"
}

torus 1 0 >torus.obj
dirfield -q torus.obj -o torus.glb
is "a torus has no singularity" "$(hatchstat field torus.glb | column singularities)" 0
awk '/^v/ {v[++n] = $0} /^f/ {for (i = 2; i < 5; i++) print v[$i]; print "f -3 -2 -1"}' torus.obj >soup.obj
same "every triangle with vertices of its own" soup.obj
awk '/^f/ && NR % 3 == 0 {print $1, $3, $2, $4; next} {print}' torus.obj >mixed.obj
same "every third face turned over" mixed.obj
awk '/^f/ {print $1, $2, $4, $3; next} {print}' torus.obj >inside.obj
same "all faces turned over" inside.obj 2
is "and is the same but where it is uncertain" "$(column deg_p75 <figures.tsv | awk '{print ($1 < 0.02)}')" 1
awk '{print} /^f/ && NR % 7 == 0 {print; print $1, $2, $4, $3; print $1, $2, $3, $3}
    END {print "v 5 5 5\nv 0 0 0"}' torus.obj >double.obj
same "faces twice, faces without area, vertices that no face uses" double.obj
awk '/^v/ {print; n++} /^f/ {print} END {for (i = 0; i < 50; i++) {
    printf "v %d 9 0\nv %d.1 9 0\nv %d 9.1 0\n", i, i, i
    printf "f %d %d %d\n", n + 3 * i + 1, n + 3 * i + 2, n + 3 * i + 3}}' torus.obj >crumbs.obj
same "crumbs beside it" crumbs.obj
awk '/^f/ && !done {print "v 0 3 0"; print "f", $2, $3, -1; done = 1} {print}' torus.obj >fin.obj
dirfield -q fin.obj -o out.glb
is "a fin on an edge: the same field away from it" \
    "$(hatchstat field -q out.glb --reference torus.glb | column deg_p95 | awk '{print ($1 < 1)}')" 1
for scale in 1e-3 1e20 1e-20; do
    torus $scale 0 >scaled.obj
    same "scaled by $scale" scaled.obj
done
torus 1e5 1e6 >moved.obj
same "moved by ten times its size" moved.obj 2
is "a moved torus has no singularity" "$(hatchstat field -q out.glb | column singularities)" 0

# has_field NAME FILE: checks that FILE gets a field without NaN whose indices sum to the Euler characteristic
has_field() {
    try dirfield -q "$2" -o out.glb
    hatchstat field -q out.glb >figures.tsv 2>.err
    is "$1: a field" "$status $(column index_sum <figures.tsv) $(column smoothness <figures.tsv | grep -c nan)" \
        "0 $(column euler <figures.tsv) 0"
}
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >one.obj
has_field "one triangle" one.obj
awk 'BEGIN {for (i = 0; i < 20; i++) printf "v %d 0 %g\nv %d 1 %g\n", i, i * i / 40, i, i * i / 40
    for (i = 1; i < 39; i += 2) printf "f %d %d %d\nf %d %d %d\n", i, i + 2, i + 3, i, i + 3, i + 1}' >strip.obj
has_field "a strip one face wide" strip.obj
printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1
f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n' >cube.obj
has_field "a cube of twelve faces" cube.obj
meshgen sphere --faces 2000 -o sphere.glb
has_field "a sphere with poles" sphere.glb
is "directions of a sphere have no confidence" "$(column confidence_p75 <figures.tsv)" 0
awk '/^v/ {print $1, $2, $3 * 1e-4, $4; next} {print}' torus.obj >flat.obj
has_field "a torus pressed flat, of slivers" flat.obj
awk '/^v/ {print $1, $2, $3 * 1000, $4; next} {print}' torus.obj >long.obj
has_field "a torus drawn out, of needles" long.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv -1 0 0.2\nv 0 -1 0\nf 1 2 3\nf 1 4 5\n' >bow.obj
has_field "two triangles at one point" bow.obj
awk 'BEGIN {pi = 3.14159265358979; n = 24; m = 12
    for (i = 0; i < n; i++) for (j = 0; j < m; j++) {
        u = 2 * pi * i / n; v = 2 * pi * j / m; r = 3 + cos(u / 2) * sin(v) - sin(u / 2) * sin(2 * v)
        printf "v %.9f %.9f %.9f\n", r * cos(u), r * sin(u), sin(u / 2) * sin(v) + cos(u / 2) * sin(2 * v)}
    for (i = 0; i < n; i++) for (j = 0; j < m; j++) {
        k = j + 1; a = i * m + j; b = i * m + k % m
        c = i + 1 < n ? a + m : (m - j) % m; d = i + 1 < n ? b + m : (m - k) % m
        printf "f %d %d %d\nf %d %d %d\n", a + 1, c + 1, d + 1, a + 1, d + 1, b + 1}}' >klein.obj
has_field "a Klein bottle" klein.obj
awk 'BEGIN {pi = 3.14159265358979; n = 40; m = 5
    for (i = 0; i < n; i++) for (j = 0; j < m; j++) {
        u = 2 * pi * i / n; v = j / (m - 1) - .5
        printf "v %.9f %.9f %.9f\n", (2 + v * cos(u / 2)) * cos(u), (2 + v * cos(u / 2)) * sin(u), v * sin(u / 2)}
    for (i = 0; i < n; i++) for (j = 0; j < m - 1; j++) {
        a = i * m + j; b = a + 1; c = i + 1 < n ? a + m : m - 1 - j; d = i + 1 < n ? b + m : m - 2 - j
        printf "f %d %d %d\nf %d %d %d\n", a + 1, c + 1, d + 1, a + 1, d + 1, b + 1}}' >moebius.obj
has_field "a Moebius strip" moebius.obj
is "a Moebius strip has no singularity" "$(column singularities <figures.tsv)" 0
meshgen cylinder --faces 1000 --jitter 1 --field -o open.glb
has_field "a surface with open borders" open.glb
is "directions at open borders are the true ones" \
    "$(hatchstat field -q out.glb --reference open.glb | column deg_max | awk '{print ($1 < 0.2)}')" 1
meshgen ellipsoid --faces 100000 --jitter 1 --noise 0.2 --seed 7 -o folded.glb
has_field "overlapping slivers around a noisy pole" folded.glb
is "overlapping slivers add no singularity" "$(column singularities <figures.tsv)" 4
awk '/^v/ && ++n == 500 {print "v 1 nan 0"; next} {print}' torus.obj >nan.obj
try dirfield nan.obj -o nan.glb
refused "a vertex with NaN" 3 1
finish
