# From damaged meshes to pictures in one pipe: the first command warns of each fault once; patches cover every face,
# flip none and have no NaN; the picture shows the surface.
. "${TOP:-.}/tests/tap.sh"
for command in dirfield lapped-param render-gl; do
    command -v $command >/dev/null || { skip "from mesh to picture" "no $command"; finish; }
done
tamgen --size 64 --levels 2 --tones 2 -o map.exr

# figures NAME: checks that lapped.glb is covered completely and that all its figures are numbers
figures() {
    hatchstat lapped --samples 3000 lapped.glb >figures.tsv 2>.err || { fail "$1: covered" "$(cat .err)"; return; }
    is "$1: all faces are covered, none is flipped" "$(awk -F'\t' '
        NR == 1 {for (i = 1; i <= NF; i++) at[$i] = i}
        NR == 2 {print $at["covered"], $at["flipped"], ($0 ~ /nan|inf/) ? "no number" : "numbers"}' figures.tsv)" \
        "1 0 numbers"
}

# draws NAME FILE OPTIONS [PATTERN ...]: runs the pipe, with OPTIONS for lapped-param, and checks that there is one
# warning for each pattern; '*' allows any warnings
draws() {
    name=$1
    file=$2
    options=$3
    shift 3
    rm -f ./*.rc lapped.glb picture.png
    { dirfield "$file" 2>1.err; echo $? >1.rc; } |
        { lapped-param $options 2>2.err; echo $? >2.rc; } | tee lapped.glb |
        { render-gl - --tam map.exr --size 48x48 -o picture.png 2>3.err; echo $? >3.rc; }
    is "$name: a picture is drawn" "$(cat 1.rc 2.rc 3.rc | tr '\n' ' ')$(
        hatchstat frames picture.png picture.png | awk 'NR == 2 {print $2 < 0.995 ? "not blank" : "blank"}')" \
        "0 0 0 not blank"
    cat 1.err 2.err 3.err >said
    problem=
    [ "$(wc -l <said)" -eq $# ] || problem="not $# lines: "
    for pattern in "$@"; do
        grep -q "^dirfield: .*warning: .*$pattern" said || problem="$problem no '$pattern': "
    done
    [ "${1-}" = '*' ] || is "$name: each fault gives one warning" "${problem:+$problem$(cat said)}" ""
    figures "$name"
}
undirected="without a principal direction"

# torus SCALE OFFSET [N M]: prints a torus of N x M squares as OBJ
torus() {
    awk -v scale="$1" -v offset="$2" -v n="${3:-30}" -v m="${4:-15}" 'BEGIN {
        pi = 3.14159265358979
        for (i = 0; i < n; i++) for (j = 0; j < m; j++) {
            a = 2 * pi * (i + j / 7) / n; b = 2 * pi * j / m; r = 1 + .4 * cos(b)
            printf "v %.17g %.17g %.17g\n", scale * r * cos(a) + offset, scale * .4 * sin(b) + offset,
                -scale * r * sin(a) + offset
        }
        for (i = 0; i < n; i++) for (j = 0; j < m; j++) {
            k = (j + 1) % m; wrap = j + 1 == m ? 1 + int((m - 1) / 7) : 0
            a = i * m + j + 1; b = (i + 1) % n * m + j + 1
            c = (i + 1) % n * m + k + 1; d = i * m + k + 1
            printf "f %d %d %d\nf %d %d %d\n", a, b, c, a, c, d
        }
    }'
}
torus 1 0 >torus.obj
draws "a torus" torus.obj ""

awk '/^v/ {v[++n] = $0} /^f/ {for (i = 2; i < 5; i++) print v[$i]; print "f -3 -2 -1"}' torus.obj >soup.obj
draws "every triangle with vertices of its own" soup.obj "" "2250 vertices welded"
awk '/^f/ && NR % 3 == 0 {print $1, $3, $2, $4; next} {print}' torus.obj >mixed.obj
draws "every third face turned over" mixed.obj "" "300 faces flipped"
awk '{print} /^f/ && NR % 7 == 0 {print; print $1, $2, $4, $3}' torus.obj >twice.obj
draws "faces given twice and three times" twice.obj "" "256 faces given twice"
awk '{print} /^f/ && NR % 5 == 0 {print $1, $2, $3, $3} END {print "v 5 5 5\nv 0 0 0"}' torus.obj >waste.obj
draws "faces without area, vertices without faces" waste.obj "" \
    "2 vertices that no face uses left out, 180 faces without an area left out"
awk '/^f/ && !done {print "v 0 3 0"; print "f", $2, $3, -1; done = 1} {print}' torus.obj >fin.obj
draws "a fin on an edge" fin.obj "" "1 edge of more than two faces" "$undirected"
awk '/^v/ {print; n++} /^f/ {print} END {for (i = 0; i < 30; i++) {
    printf "v %g 1 0\nv %g 1 0\nv %g 1.02 0\n", i / 20, i / 20 + .02, i / 20
    printf "f %d %d %d\n", n + 3 * i + 1, n + 3 * i + 2, n + 3 * i + 3}}' torus.obj >crumbs.obj
draws "crumbs beside it" crumbs.obj "" "$undirected"
awk '/^f/ && NR % 30 < 10 {next} {print}' torus.obj >open.obj
draws "open borders" open.obj "" "90 vertices that no face uses"
awk '/^v/ {print $1, $2, $3 * 1e-4, $4; next} {print}' torus.obj >flat.obj
draws "slivers: pressed flat" flat.obj "" '*'
awk '/^v/ {print $1, $2, $3 * 300, $4; next} {print}' torus.obj >long.obj
draws "needles: drawn out" long.obj ""
for scale in 1e-20 1e-3 1e20; do
    torus $scale 0 >scaled.obj
    draws "scaled by $scale" scaled.obj ""
done
torus 1e5 1e6 >moved.obj
draws "an offset of ten times its size" moved.obj ""

# Where noise is larger than faces, only patches of a few faces are possible. That is detected once instead of by
# solving a large patch for every face, which took 29 solutions here, and more with more faces.
meshgen ellipsoid --faces 20000 --jitter 1 --noise 0.1 | dirfield -q -o crumpled.glb
is "crumpled poles do not cost each face a large patch" "$(lapped-param -v crumpled.glb -o crumpled.lapped.glb 2>&1 |
    awk '/times per face$/ {print ($(NF - 3) > 0 && $(NF - 3) < 12)}')" 1

meshgen sphere --faces 600 -o sphere.glb
draws "a sphere with poles, without a direction" sphere.glb "" "$undirected"
printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv .3 .6 0\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n' >plane.obj
draws "a plane" plane.obj "" "$undirected"
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >one.obj
draws "one triangle" one.obj "" "$undirected"
awk 'BEGIN {for (i = 0; i < 20; i++) printf "v %g 0 %g\nv %g 1 %g\n", sin(i / 9), cos(i / 9), sin(i / 9), cos(i / 9)
    for (i = 1; i < 39; i += 2) printf "f %d %d %d\nf %d %d %d\n", i, i + 2, i + 3, i, i + 3, i + 1}' >strip.obj
draws "a strip one face wide, too narrow to be seen to bend" strip.obj "" "$undirected"
printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1
f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n' >cube.obj
draws "a cube" cube.obj "" "$undirected"
draws "a cube with faces larger than a patch" cube.obj "--size 0.05" "$undirected"
torus 1 0 9 8 >coarse.obj
draws "a torus with faces larger than a patch" coarse.obj "--size 0.02"
draws "patches as large as the torus" torus.obj "--size 1 --curved 0 --stretch 10 --turn 90"
awk 'BEGIN {for (i = 0; i <= 40; i++) for (j = 0; j < 6; j++)
        printf "v %g %g %g\n", .03 * cos(j * 1.0471975512), i / 20, .03 * sin(j * 1.0471975512)
    for (i = 0; i < 40; i++) for (j = 0; j < 6; j++) {
        a = 6 * i + j + 1; b = 6 * i + (j + 1) % 6 + 1
        printf "f %d %d %d\nf %d %d %d\n", a, a + 6, b, b, a + 6, b + 6}}' >leg.obj
draws "patches wider than a leg" leg.obj "--size 0.3 --curved 0"

# A plate with a handle on two of its squares, much smaller than a patch.
awk 'BEGIN {n = 24; R = 2
    for (i = 0; i <= n; i++) for (j = 0; j <= n; j++) printf "v %d %d %.9g\n", i, j, .02 * (i - 12) ^ 2
    for (i = 0; i < n; i++) for (j = 0; j < n; j++) {
        if (j == 12 && (i == 9 || i == 13)) continue
        a = i * (n + 1) + j + 1; b = a + n + 1
        printf "f %d %d %d\nf %d %d %d\n", a, b, b + 1, a, b + 1, a + 1}
    split("9 12 9 13 10 13 10 12", f, " "); split("14 12 14 13 13 13 13 12", l, " ")
    for (k = 0; k < 4; k++) {first[k] = f[2 * k + 1] * (n + 1) + f[2 * k + 2] + 1
        last[k] = l[2 * k + 1] * (n + 1) + l[2 * k + 2] + 1}
    split(".5 .5 -.5 -.5", out, " "); split("-.5 .5 .5 -.5", side, " "); m = (n + 1) ^ 2
    for (s = 1; s < 6; s++) for (k = 0; k < 4; k++) {t = 3.14159265 * s / 6; r = R + out[k + 1]
        printf "v %.9g %.9g %.9g\n", 11.5 - r * cos(t), 12.5 + side[k + 1], .1 + r * sin(t)
        ring[s, k] = ++m}
    for (k = 0; k < 4; k++) {ring[0, k] = first[k]; ring[6, k] = last[k]}
    for (s = 0; s < 6; s++) for (k = 0; k < 4; k++) {a = ring[s, k]; b = ring[s, (k + 1) % 4]
        c = ring[s + 1, k]; d = ring[s + 1, (k + 1) % 4]
        printf "f %d %d %d\nf %d %d %d\n", a, d, b, a, c, d}}' >handle.obj
is "a plate with a handle" "$(hatchstat mesh handle.obj | awk -F'\t' '
    NR == 1 {for (i = 1; i <= NF; i++) at[$i] = i} NR == 2 {print $at["euler"], $at["contrary_edges"]}')" "-1 0"
draws "a handle smaller than a patch" handle.obj "--size 0.5"

printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nv -1 0 0\nv 0 0 -1
f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\nf 1 6 5\nf 1 5 7\nf 5 6 7\nf 6 1 7\n' >bow.obj
draws "a bow-tie" bow.obj "" "1 point split" "$undirected"
awk 'BEGIN {print "v 0 0 0\nv 0 0 1"
    for (i = 0; i < 5; i++) printf "v %.9g %.9g 0\nf 1 2 -1\n", cos(i * 1.2566), sin(i * 1.2566)}' >book.obj
draws "five pages of a book" book.obj "" "1 edge of more than two faces" "$undirected" "stand along z"
awk 'BEGIN {n = 40
    for (i = 0; i < n; i++) for (k = -1; k <= 1; k++) {a = 6.283185307 * i / n; r = 1 + .3 * k * sin(a / 2)
        printf "v %.9g %.9g %.9g\n", r * cos(a), .3 * k * cos(a / 2), r * sin(a)}
    for (i = 0; i < n; i++) for (k = 0; k < 2; k++) {
        a = 3 * i + k + 1; b = i + 1 < n ? a + 3 : 3 - k; c = i + 1 < n ? a + 4 : 2 - k
        printf "f %d %d %d\nf %d %d %d\n", a, a + 1, b, a + 1, c, b}}' >moebius.obj
draws "a Moebius strip" moebius.obj "" "2 edges where a one-sided surface turns over"
awk 'BEGIN {pi = 3.14159265358979; n = 30; m = 16
    for (i = 0; i < n; i++) for (j = 0; j < m; j++) {
        u = 2 * pi * i / n; v = 2 * pi * (j + .5) / m; r = 3 + cos(u / 2) * sin(v) - sin(u / 2) * sin(2 * v)
        printf "v %.9f %.9f %.9f\n", r * cos(u), r * sin(u), sin(u / 2) * sin(v) + cos(u / 2) * sin(2 * v)}
    for (i = 0; i < n; i++) for (j = 0; j < m; j++) {
        k = (j + 1) % m; a = i * m + j; b = i * m + k
        c = i + 1 < n ? a + m : m - 1 - j; d = i + 1 < n ? b + m : m - 1 - k
        printf "f %d %d %d\nf %d %d %d\n", a + 1, c + 1, d + 1, a + 1, d + 1, b + 1}}' >klein.obj
draws "a Klein bottle" klein.obj "" "16 edges where a one-sided surface turns over"

# within NAME FILE: coverage, overlap, stretch and angles are what hatchstat(1) asks for
within() {
    dirfield -q "$2" | lapped-param -q -o lapped.glb
    is "$1: within the bars" "$(hatchstat lapped --check --samples 3000 lapped.glb 2>&1 >figures.tsv; echo $?)" 0
}

# Faces as long as their part, side by side: a patch that is just large enough for one would hold it
# and its neighbours, and those again be in the next; overlap was 2.3, and 1.6 with the ends.
awk 'BEGIN {n = 400; for (i = 0; i < n; i++) {a = 6.283185307 * i / n
        printf "v %.9g 0 %.9g\nv %.9g 2 %.9g\n", cos(a), -sin(a), cos(a), -sin(a)}
    for (i = 0; i < n; i++) {a = 2 * i + 1; b = 2 * ((i + 1) % n) + 1
        printf "f %d %d %d\nf %d %d %d\n", a, b, b + 1, a, b + 1, a + 1}}' >tube.obj
within "a tube one face high" tube.obj
awk 'BEGIN {n = 64; for (i = 0; i < n; i++) {a = 6.283185307 * i / n
        printf "v %.9g 0 %.9g\nv %.9g 3 %.9g\n", cos(a), -sin(a), cos(a), -sin(a)}
    print "v 0 0 0\nv 0 3 0"; for (i = 0; i < n; i++) {a = 2 * i + 1; b = 2 * ((i + 1) % n) + 1
        printf "f %d %d %d\nf %d %d %d\nf %d %d %d\nf %d %d %d\n", a, b, b + 1, a, b + 1, a + 1,
            b, a, 2 * n + 1, a + 1, b + 1, 2 * n + 2}}' >can.obj
within "a can" can.obj

# Rows of long faces: with patches of as many faces as elsewhere 1.87.
awk 'BEGIN {n = 140; m = 8; for (i = 0; i < n; i++) for (j = 0; j <= m; j++) {a = 6.283185307 * i / n
        printf "v %.9g %.9g %.9g\n", cos(a), 3 * j / m, -sin(a)}
    for (i = 0; i < n; i++) for (j = 0; j < m; j++) {a = i * (m + 1) + j + 1; b = (i + 1) % n * (m + 1) + j + 1
        printf "f %d %d %d\nf %d %d %d\n", a, b, b + 1, a, b + 1, a + 1}}' >rows.obj
within "a tube of long faces" rows.obj

# Patches of few faces, all beside creases: one face in twenty was 8.5 and 9.5 degrees off the field.
awk 'BEGIN {n = 24; split("0 .8 .2 .8 .35 1 .65 1", p, " "); m = 4 * n
    for (i = 0; i < m; i++) {a = 6.283185307 * (int(i / 4) + p[2 * (i % 4) + 1]) / n; r = p[2 * (i % 4) + 2]
        for (k = 0; k < 4; k++) {q = k > 1 ? .3 : r; printf "v %.9g %g %.9g\n", q * cos(a), .3 * (k % 3 > 0), -q * sin(a)}}
    for (i = 0; i < m; i++) for (k = 0; k < 4; k++) {a = 4 * i; b = 4 * ((i + 1) % m); l = (k + 1) % 4
        printf "f %d %d %d\nf %d %d %d\n", a + k + 1, b + k + 1, b + l + 1, a + k + 1, b + l + 1, a + l + 1}}' >gear.obj
within "a gear" gear.obj
awk 'BEGIN {n = 100; for (i = 0; i < n; i++) {t = i / n; for (j = 0; j < 3; j++) {a = 2.0943951 * j
        printf "v %.9g %.9g %.9g\n", 2 * t, .2 * sin(9 * t) + .02 * cos(a), .2 * cos(7 * t) + .02 * sin(a)}}
    for (i = 0; i + 1 < n; i++) for (j = 0; j < 3; j++) {a = 3 * i + j + 1; b = 3 * i + (j + 1) % 3 + 1
        printf "f %d %d %d\nf %d %d %d\n", a, b + 3, a + 3, a, b, b + 3}}' >wire.obj
within "a wire of three sides" wire.obj

# One patch of a star, whose long faces lie across each other: factors within an envelope would take 4 GB.
awk 'BEGIN {n = 20000; for (i = 0; i < n; i++) {a = 6.283185307 * i / n; r = i % 2 ? .5 : 1
        printf "v %.6f %.6f 0\n", r * cos(a), r * sin(a)}
    printf "f"; for (i = 0; i < n; i++) printf " %d", i + 1; print ""}' >star.obj
ok "a star of 20,000 corners in one patch" lapped-param -q --size 1 --max-memory 100M -o lapped.glb star.obj
figures "a star in one patch"
if [ -z "$SANITIZE" ]; then
    ms=$(milliseconds 4000 lapped-param -q --size 1 -o lapped.glb star.obj)
    ok "it takes $ms ms of processor time, at most 4000" test "$ms" -le 4000
fi

# Faces larger than the wanted patches; a scan with such faces, if there is a folder shared/data beside the source.
torus 1 0 8 6 >coarse.obj
draws "a coarse torus at a tenth of its diagonal" coarse.obj "--size 0.1"
rocker=$TOP/../shared/data/meshes/rocker-arm.obj
[ ! -e "$rocker" ] || draws "the rocker arm at a tenth of its diagonal" "$rocker" "--size 0.1"

printf 'v 0 0 0\nv 1 0 0\nv 0 nan 0\nf 1 2 3\n' >nan.obj
for command in dirfield lapped-param; do
    try $command nan.obj
    refused "$command refuses NaN" 3 1
done
finish
