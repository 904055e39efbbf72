# dirfield: directions, constraints, reports, arrows and refusals.
. "${TOP:-.}/tests/tap.sh"
command -v dirfield >/dev/null || { skip "direction fields" "no dirfield"; finish; }

# column NAME [ROW] <TABLE: prints a value of a table, of the first row by default
column() {
    awk -F'\t' -v name="$1" -v row="${2:-1}" '
        NR == 1 {for (i = 1; i <= NF; i++) if ($i == name) c = i}
        NR == row + 1 {print $c}'
}

# angle A B: prints the median angle between two fields, rounded to degrees
angle() {
    hatchstat field "$1" --reference "$2" | column deg_p50 | awk '{printf "%.0f\n", $1}'
}

meshgen torus --faces 1000 --field -o true.glb
meshgen torus --faces 1000 -o torus.glb
meshgen plane --faces 200 -o plane.glb
dirfield torus.glb -o max.glb
dirfield torus.glb --direction min -o min.glb
dirfield torus.glb --direction 30 -o turned.glb
dirfield torus.glb --direction -60 -o other.glb
is "the field of a torus is its true field" "$(angle max.glb true.glb | awk '{print ($1 < 3)}')" 1
is "--direction min is orthogonal to max" "$(angle min.glb max.glb)" 90
is "--direction 30 is 30 degrees from max" "$(angle turned.glb max.glb)" 30
for turn in -360 360; do
    dirfield torus.glb --direction $turn -o whole.glb
    is "--direction $turn is max" "$(angle whole.glb max.glb)" 0
done
try dirfield torus.glb --direction 360.1 -o whole.glb
refused "--direction 360.1" 2 2
is "--direction 30 and -60 are at a right angle" "$(angle turned.glb other.glb)" 90
for how in '--method hz' '--solver cholesky' '--radius 2 --degree 2' '--coarse 500' '--smooth 0'; do
    try dirfield torus.glb $how -o how.glb
    is "$how: within a few degrees of the default" \
        "$status $(hatchstat field how.glb --reference max.glb | column deg_p50 | awk '{print ($1 < 8)}')" "0 1"
done

for radius in 0.5 0.7 1; do
    dirfield torus.glb --radius $radius -o how.glb
    is "--radius $radius, which holds too few points, is enlarged" "$(angle how.glb true.glb | awk '{print ($1 < 1)}')" 1
done
# With --coarse, too, a mesh is repaired first: here, every second face is the other way round.
awk 'BEGIN {
    print "OFF\n5000 10000 0"
    for (i = 0; i < 100; i++) for (j = 0; j < 50; j++) {
        u = 6.2831853 * i / 100; v = 6.2831853 * j / 50
        print (1 + .4 * cos(v)) * cos(u), (1 + .4 * cos(v)) * sin(u), .4 * sin(v)
    }
    for (i = 0; i < 100; i++) for (j = 0; j < 50; j++) {
        a = 50 * i + j; b = 50 * ((i + 1) % 100) + j; c = 50 * ((i + 1) % 100) + (j + 1) % 50; d = 50 * i + (j + 1) % 50
        print 3, a, b, c "\n" 3, a, c, d
    }}' >large.off
awk 'NF == 4 && $1 == 3 && ++n % 2 {print 3, $2, $4, $3; next} {print}' large.off >turned.off
dirfield -q large.off --coarse 500 -o large.glb
dirfield -q turned.off --coarse 500 -o mended.glb
is "the same field where faces disagree" "$(angle mended.glb large.glb | awk '{print ($1 < 1)}')" 1

meshgen ellipsoid --jitter 1 --noise 0.1 -o noisy.glb
dirfield -q noisy.glb >here.glb
GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-AVX,-FMA4,-AVX2_Usable,-FMA_Usable dirfield -q noisy.glb >there.glb
cmp -s here.glb there.glb
is "the same bytes with an older processor's libm" $? 0

# energy METHOD SMOOTH: prints the energy of the solution
energy() {
    dirfield -q noisy.glb --method "$1" --smooth "$2" --report - -o field.glb | column energy
}
for smooth in 0.1 0.3 0.6 0.9; do
    is "--smooth $smooth: linear has no more energy than hz" \
        "$(awk -v a="$(energy linear $smooth)" -v b="$(energy hz $smooth)" 'BEGIN {print (a + 0 > 0 && a <= b)}')" 1
done

try dirfield plane.glb -o flat.glb
is "a plane without a principal direction is warned of" "$status $(grep -c '100 % of the faces.*without a principal direction' .err)" "0 1"
is "directions of a plane have no confidence" "$(hatchstat field flat.glb | column confidence_p75)" 0
is "directions of a plane are smooth" "$(hatchstat field flat.glb | column smoothness | awk '{print ($1 < 1e-6)}')" 1

# given HEADER ROW ...: runs dirfield on the plane with these constraints
given() {
    printf '%b\n' "$@" >hand.tsv
    try dirfield plane.glb --constraints hand.tsv -o hand.glb
}
towards() { # DX DY: a plane with this true field
    printf 'x\ty\tz\tdx\tdy\tdz\tweight\n' >all.tsv
    printf '%s\n' "0 0 0" "1 1 0" "-1 1 0" "1 -1 0" "-1 -1 0" |
        while read -r x y z; do printf '%s\t%s\t%s\t%s\t%s\t0\t1000\n' $x $y $z "$1" "$2"; done >>all.tsv
    dirfield -q plane.glb --constraints all.tsv -o towards.glb
}
towards 1 1
given 'vertex\tdx\tdy\tdz\tweight' '7\t1\t1\t0\t1'
is "one constraint at a vertex sets the field of a plane" "$status $(wc -c <.err) $(angle hand.glb towards.glb)" "0 0 0"
given '# towards the viewer as well' 'weight\tz\ty\tx\tdz\tdy\tdx' '' '1\t5\t0.1\t0.1\t3\t2\t-2'
is "so does one constraint at the point nearest to a position" "$status $(angle hand.glb towards.glb)" "0 90"
try dirfield -q plane.glb --constraints all.tsv --direction min -o hand.glb
is "--direction does not rotate constraints" "$status $(angle hand.glb towards.glb)" "0 0"
given 'vertex\tdx\tdy\tdz\tweight' '7\t1\t0\t0\t1' '7\t1\t1\t0\t1'
is "the last of several constraints at a point counts" "$status $(angle hand.glb towards.glb)" "0 0"

# Two squares of 2 x 2; a node rotates the second by a quarter turn about z, scales it by 2 and moves it to x = 10.
# floats NUMBER ...: ones, minus ones and zeros
floats() {
    for number; do
        case $number in
            1) printf '\000\000\200\077' ;;
            -1) printf '\000\000\200\277' ;;
            *) printf '\000\000\000\000' ;;
        esac
    done
}
square=$({
    floats -1 -1 0 1 -1 0 1 1 0 -1 1 0
    printf '\000\000\001\000\002\000\000\000\002\000\003\000'
} | base64 | tr -d '\n')
mesh='{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}'
cat >posed.gltf <<EOF
{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],
"nodes":[{"mesh":0},{"mesh":1,"translation":[10,0,0],"rotation":[0,0,0.70710678,0.70710678],"scale":[2,2,2]}],
"meshes":[$mesh,$mesh],
"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[-1,-1,0],"max":[1,1,0]},
{"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"}],
"bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":12}],
"buffers":[{"byteLength":60,"uri":"data:application/octet-stream;base64,$square"}]}
EOF
printf 'x\ty\tz\tdx\tdy\tdz\tweight\n0\t0\t0\t1\t1\t0\t9\n10\t0\t0\t1\t0\t0\t9\n' >hand.tsv
try dirfield -q posed.gltf --constraints hand.tsv -o hand.glb
printf 'vertex\tdx\tdy\tdz\tweight\n0\t1\t1\t0\t9\n4\t0\t1\t0\t9\n' >own.tsv
dirfield -q posed.gltf --constraints own.tsv -o own.glb
is "constraints by position are in scene coordinates, by vertex in the mesh's" \
    "$status $(hatchstat field hand.glb --reference own.glb | column deg_max | awk '{print ($1 < 0.01)}')" "0 1"
# Vertices are numbered as in the file, also behind a mesh without an area: its indices are 0, 0 and 1.
sed 's/"meshes":\[/&{"primitives":[{"attributes":{"POSITION":0},"indices":2}]},/; s/{"mesh":1,/{"mesh":2,/
    s/{"mesh":0}/{"mesh":1}/; s/"count":6,"type":"SCALAR"}/&,{"bufferView":1,"componentType":5121,"count":3,"type":"SCALAR"}/
    s/"nodes":\[0,1\]/"nodes":[0,1,2]/; s/^"nodes":\[/&{"mesh":0},/' posed.gltf >behind.gltf
printf 'vertex\tdx\tdy\tdz\tweight\n4\t1\t1\t0\t9\n8\t0\t1\t0\t9\n' >behind.tsv
try dirfield -q behind.gltf --constraints behind.tsv -o behind.glb
is "vertices behind a mesh that is left out" \
    "$status $(hatchstat field behind.glb --reference own.glb | column deg_max | awk '{print ($1 < 0.01)}')" "0 1"
printf 'vertex\tdx\tdy\tdz\tweight\n1\t1\t1\t0\t9\n' >behind.tsv
try dirfield -q behind.gltf --constraints behind.tsv -o behind.glb
is "a vertex of that mesh" "$status $(cat .err)" "3 dirfield: behind.tsv: line 2: no face uses vertex 1"
for row in "2 no face uses vertex 2" "12 vertex 12, want a whole number from 0 to 11"; do
    printf 'vertex\tdx\tdy\tdz\tweight\n%s\t1\t1\t0\t9\n' "${row%% *}" >behind.tsv
    try dirfield -q behind.gltf --constraints behind.tsv -o behind.glb
    is "vertex ${row%% *}, of which the file has another number in each mesh" "$status $(cat .err)" \
        "3 dirfield: behind.tsv: line 2: ${row#* }"
done

# Small squares in a plane, a row from (6, 0.5) on along x and one from (3, 1.5) on along y. A node turns the plane by a
# half right angle about x and then stretches it tenfold along y: (i, j) is at (i, 7.07 j, 0.707 j) in the scene. A position
# at (3, 0.5) in the plane is nearest to the second row there, and to the first square, which has vertex 0, in the scene:
# the search must not end within the half of the plane in which it begins. The direction is (1, 0, 0) and the normal in the
# scene.
awk 'function square(x, y) {
        v = v sprintf("%g %g 0\n%g %g 0\n", x - .1, y - .1, x + .1, y - .1)
        v = v sprintf("%g %g 0\n%g %g 0\n", x + .1, y + .1, x - .1, y + .1)
        f = f sprintf("3 %d %d %d\n3 %d %d %d\n", n, n + 1, n + 2, n, n + 2, n + 3)
        n += 4
    }
    BEGIN {
        for (i = 0; i < 8; i++) square(6 + 2 * i, .5)
        for (i = 0; i < 24; i++) square(3, 1.5 + .3 * i)
        printf "OFF\n%d %d 0\n%s%s", n, n / 2, v, f }' >squares.off
dirfield -q squares.off -o squares.glb
unpack squares.glb squares
sed 's/"nodes":\[{[^]]*"mesh":0[^]]*}\]/"nodes":[{"scale":[1,10,1],"children":[1]},{"mesh":0,"rotation":[0.3826834,0,0,0.9238795]}]/' \
    squares.gltf >stretched.gltf
printf 'x\ty\tz\tdx\tdy\tdz\tweight\n3\t3.54\t0.354\t1\t-0.1\t1\t9\n' >hand.tsv
printf 'vertex\tdx\tdy\tdz\tweight\n0\t1\t0\t0\t9\n' >own.tsv
try dirfield -q stretched.gltf --constraints hand.tsv --report report.tsv -o hand.glb
dirfield -q stretched.gltf --constraints own.tsv -o own.glb
is "the nearest point of a stretched node, and the direction that is tangent there" \
    "$status $(awk -F'\t' '
        NR == 1 {for (i = 1; i <= NF; i++) if ($i == "confidence_p50") c = i}
        $1 == "component" {first = n++ ? first : $c; sum += $c}
        END {printf "%.1f of %.1f in %d ", first, sum, n}' report.tsv)$(hatchstat field hand.glb --reference own.glb |
        column deg_max | awk '{print ($1 < 0.01)}')" "0 1.0 of 1.0 in 32 1"

# A cube: its surface is cut at all edges, and three sides meet at vertex 0. The direction is given to those sides that it
# runs along, and the others keep their confidence of 0.
printf 'OFF\n8 6 0\n-1 -1 -1\n1 -1 -1\n1 1 -1\n-1 1 -1\n-1 -1 1\n1 -1 1\n1 1 1\n-1 1 1\n%s' \
    '4 0 3 2 1
4 4 5 6 7
4 0 1 5 4
4 2 3 7 6
4 0 4 7 3
4 1 2 6 5
' >cube.off
for row in '0 0 1 2' '0 1 0 2' '1 0 0 2' '0 1 1 1' '1 1 1 3'; do
    given=$(echo "${row% *}" | tr ' ' '\t')
    printf 'vertex\tdx\tdy\tdz\tweight\n0\t%s\t9\n' "$given" >hand.tsv
    printf 'x\ty\tz\tdx\tdy\tdz\tweight\n-1.1\t-1.1\t-1.1\t%s\t9\n' "$given" >near.tsv
    try dirfield -q cube.off --constraints hand.tsv --report report.tsv -o hand.glb
    is "sides that a direction at their corner runs along, direction ${row% *}" "$status $(awk -F'\t' '
        NR == 1 {for (i = 1; i <= NF; i++) if ($i == "confidence_p50") c = i}
        $1 == "component" {n += $c > 0.99} END {print n}' report.tsv)" "0 ${row##* }"
    dirfield -q cube.off --constraints near.tsv -o near.glb
    ok "the same at the vertex as at its position" cmp hand.glb near.glb
done

# Vertices have the file's numbers, however they are read: corners of OBJ and PLY with texture coordinates of their own,
# and corners of glTF with flat normals, which are all vertices of their own where they move.
printf 'v %s 0\n' '0 0' '1 0' '1 1' '0 1' '5 0' '6 0' '6 1' '5 1' >corners.obj
printf 'vt %s\n' '0 0' '1 0' '1 1' '0 1' >>corners.obj
printf 'f %s\n' '8/1 5/2 6/3 7/4' '1/1 2/2 3/3 4/4' >>corners.obj
{
    printf 'ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\nelement face 2\n'
    printf 'property list uchar int vertex_indices\nproperty list uchar float texcoord\nend_header\n'
    sed -n 's/^v //p' corners.obj
    printf '4 %s 8 0 0 1 0 1 1 0 1\n' '7 4 5 6' '0 1 2 3'
} >corners.ply
perl -MMIME::Base64 -e '
    my @at = (-1,-1,-1, 1,-1,-1, 1,1,-1, -1,1,-1, -1,-1,1, 1,-1,1, 1,1,1, -1,1,1);
    my @corners = map {my @c = @$_; @c[0, 1, 2, 0, 2, 3]} [0,3,2,1], [4,5,6,7], [0,1,5,4], [2,3,7,6], [0,4,7,3], [1,2,6,5];
    my $bytes = encode_base64(pack("f<24 S<36 f<24", @at, @corners, map {$_ / 10} @at), "");
    for my $moves (0, 1) {
        my ($node, $shown, $targets) = $moves ? (qq~,{"mesh":0,"weights":[0.5]}~, ",1", qq~,"targets":[{"POSITION":2}]~) : ("") x 3;
        open my $out, ">", ("cube", "moving")[$moves] . ".gltf" or die;
        print {$out} qq~{"asset":{"version":"2.0"},"nodes":[{"mesh":0}$node],"scenes":[{"nodes":[0$shown]}],
            "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1$targets}]}],
            "accessors":[{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3","min":[-1,-1,-1],"max":[1,1,1]},
            {"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"},
            {"bufferView":2,"componentType":5126,"count":8,"type":"VEC3","min":[-0.1,-0.1,-0.1],"max":[0.1,0.1,0.1]}],
            "bufferViews":[{"buffer":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":72},
            {"buffer":0,"byteOffset":168,"byteLength":96}],
            "buffers":[{"byteLength":264,"uri":"data:application/octet-stream;base64,$bytes"}]}~;
    }'
for line in 'corners.obj 0 0 0 0 1 0' 'corners.obj 5 6 0 0 1 0' 'corners.ply 0 0 0 0 1 0' 'corners.ply 5 6 0 0 1 0' \
    'cube.gltf 0 -1 -1 -1 1 1' 'cube.gltf 6 1 1 1 0 1' 'moving.gltf 0 -1 -1 -1 1 1' 'moving.gltf 6 1 1 1 0 1'; do
    # shellcheck disable=SC2086
    set -- $line
    printf 'vertex\tdx\tdy\tdz\tweight\n%s\t1\t%s\t%s\t9\n' "$2" "$6" "$7" >own.tsv
    printf 'x\ty\tz\tdx\tdy\tdz\tweight\n%s\t%s\t%s\t1\t%s\t%s\t9\n' "$3" "$4" "$5" "$6" "$7" >near.tsv
    rm own.glb near.glb
    dirfield -q "$1" --constraints own.tsv -o own.glb
    dirfield -q "$1" --constraints near.tsv -o near.glb
    ok "vertex $2 of $1 is at its position" cmp own.glb near.glb
done

# Four squares, of which the second and the last are given twice, the second time for their backs. The second shares
# its material with the first, which has no back: it gets a copy. That of the third has a back already.
sides=$({
    floats -1 -1 0 1 -1 0 1 1 0 -1 1 0
    printf '\000\000\001\000\002\000\000\000\002\000\003\000\002\000\001\000\000\000\003\000\002\000\000\000'
} | base64 | tr -d '\n')
cat >sides.gltf <<EOF
{"asset":{"version":"2.0"},"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0},
{"attributes":{"POSITION":0},"indices":2,"material":0},{"attributes":{"POSITION":0},"indices":1,"material":1},
{"attributes":{"POSITION":0},"indices":2,"material":2}]}],"materials":[{"name":"leaf"},{"name":"bark","doubleSided":true},{"name":"petal"}],
"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[-1,-1,0],"max":[1,1,0]},
{"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"},
{"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}],
"bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}],
"buffers":[{"byteLength":72,"uri":"data:application/octet-stream;base64,$sides"}]}
EOF
for command in dirfield lapped-param "strokegen --levels 2"; do
    $command sides.gltf -o sides.glb 2>.err
    unpack sides.glb sides.made
    is "faces given for both sides stay visible from both, $command" "$(grep -o '"material":[0-9]' sides.made.gltf |
        paste -sd' ') $(grep -o '"materials":.*' sides.made.gltf | grep -oE 'leaf|bark|petal|doubleSided' | paste -sd' ') $(
        grep -c '4 faces given twice left out, 2 meshes whose faces are given for both sides made double-sided' .err)" \
        '"material":0 "material":3 "material":1 "material":2 leaf bark doubleSided petal doubleSided leaf doubleSided 1'
done
dirfield -q sides.gltf | dirfield -o again.glb 2>.err
is "a mesh that is double-sided already is not changed" "$(grep -c 'double-sided' .err)" 0

# bad_row SENTENCE HEADER ROW ...: checks that these constraints are refused with this message
bad_row() {
    sentence=$1
    shift
    given "$@"
    refused "refused: $sentence" 3 1
    is "the message is: $sentence" "$(cat .err)" "dirfield: hand.tsv: $sentence"
}
head='vertex\tdx\tdy\tdz\tweight'
bad_row "line 3: weight 'x' is not a number" "$head" '1\t1\t0\t0\t1' '1\t1\t0\t0\tx'
bad_row "line 2: dx 'nan' is not a number" "$head" '1\tnan\t0\t0\t1'
bad_row "line 2: 4 fields, want 5" "$head" '1\t1\t0\t0'
bad_row "line 2: vertex 99999, want a whole number from 0 to $(($(hatchstat mesh plane.glb | column vertices) - 1))" \
    "$head" '99999\t1\t0\t0\t1'
bad_row "line 2: weight 0, want over 0 and at most 1e+06" "$head" '1\t1\t0\t0\t0'
bad_row "line 2: weight 1e+06, want over 0 and at most 1e+06" "$head" '1\t1\t0\t0\t1000000.1'
given "$head" '7\t1\t1\t0\t1000000'
is "a weight of a million" "$status $(angle hand.glb towards.glb)" "0 0"
bad_row "line 2: the direction dx dy dz must not be zero" "$head" '1\t0\t0\t0\t1'
bad_row "line 2: y -1e+300, want at most 3.40282e+38, the largest coordinate of a mesh" \
    'x\ty\tz\tdx\tdy\tdz\tweight' '0\t-1e300\t0\t1\t0\t0\t1'
for length in 1e200 1e-200 4e-320; do
    given "$head" "7\t$length\t$length\t0\t1"
    is "a direction of length $length" "$status $(angle hand.glb towards.glb)" "0 0"
done
bad_row "line 2: the direction is perpendicular to the surface" "$head" '1\t0\t0\t5\t1'
bad_row "header: 'wait' is not a column; want vertex, or x y z, and dx dy dz weight" 'vertex\twait' '1\t1'
bad_row "header: 'dx' appears twice" 'vertex\tdx\tdx' '1\t1'
bad_row "header: no column 'weight'; want vertex, or x y z, and dx dy dz weight" 'vertex\tdx\tdy\tdz' '1'
bad_row "header: 'vertex' cannot be combined with 'y'; want vertex, or x y z, and dx dy dz weight" "$head\ty" '1'
bad_row "no header line; want vertex, or x y z, and dx dy dz weight" ''
try dirfield plane.glb --constraints nonesuch.tsv -o out.glb
refused "a missing file of constraints" 4 1

# A bracket of boxes that share faces' planes: each plane has one direction, along its longest edges.
printf 'OFF\n12 8 0\n0 0 0\n4 0 0\n4 1 0\n1 1 0\n1 3 0\n0 3 0\n0 0 2\n4 0 2\n4 1 2\n1 1 2\n1 3 2\n0 3 2\n%s' \
    '6 5 4 3 2 1 0
6 6 7 8 9 10 11
4 0 1 7 6
4 1 2 8 7
4 2 3 9 8
4 3 4 10 9
4 4 5 11 10
4 5 0 6 11
' >bracket.off
dirfield -q bracket.off -o bracket.glb
is "the planes of a bracket are straight" \
    "$(hatchstat field -q bracket.glb | tee figures.tsv | column singularities) $(column smoothness <figures.tsv | awk '{print ($1 < 1e-6)}') $(column components <figures.tsv)" \
    "0 1 8"

dirfield torus.glb --report report.tsv -o again.glb
cmp -s again.glb max.glb
is "a report changes nothing in the mesh" $? 0
is "a report has rows for each mesh, each component and all" "$(cut -f1 report.tsv | paste -sd' ')" "kind mesh component all"
is "faces, index and Euler characteristic of a torus" \
    "$(column faces 2 <report.tsv) $(column index_sum 2 <report.tsv) $(column euler 2 <report.tsv)" \
    "$(hatchstat mesh torus.glb | column faces) 0 0"
meshgen ellipsoid --faces 2000 | dirfield --json --report report.json >ellipsoid.glb
is "the report of an ellipsoid has four singularities of index 1/2" \
    "$(grep -c '"kind": "singularity".*"index": 0.5' report.json) $(grep -c '"index_sum": 2' report.json)" "4 2"
is "hatchstat finds the same four singularities" "$(hatchstat field ellipsoid.glb | column singularities)" 4

dirfield torus.glb --arrows arrows.ply >piped.glb
is "--arrows writes a rhombus for each point" "$(hatchstat mesh -q arrows.ply | cut -f1,2)" \
    "$(printf 'vertices\tfaces\n%d\t%d' $((4 * $(column points 1 <report.tsv))) $((2 * $(column points 1 <report.tsv))))"
cmp -s piped.glb max.glb
is "arrows change nothing in the mesh" $? 0

# A square of 2 x 2 units in the plane z = 0. Corners 0 and 2 of a rhombus are 0.8 edges apart, 1 and 3 across them 0.14,
# and its middle is 0.04 above a vertex.
{
    for y in 0 1 2; do printf "v %d $y 0\n" 0 1 2; done
    for v in 1 2 4 5; do echo "f $v $((v + 1)) $((v + 4)) $((v + 3))"; done
} >square.obj
dirfield -q square.obj --arrows square.ply -o square.glb
cat >rhombi.pl <<'END'
local $/;
my ($data) = <> =~ /end_header\n(.*)/s;
my (@middles, @wrong);
for my $n (0 .. 8) {
    my @at = map { [unpack 'f<3', substr $data, 60 * $n + 15 * $_, 12] } 0 .. 3;
    my @long = map { $at[0][$_] - $at[2][$_] } 0 .. 2;
    my @wide = map { $at[1][$_] - $at[3][$_] } 0 .. 2;
    my ($length, $width) = map { sqrt($_->[0] ** 2 + $_->[1] ** 2) } \@long, \@wide;
    push @wrong, "$n: $length x $width" unless $length >= 0.8 && $length <= 1 && abs($width / $length - 0.175) < 1e-5;
    push @wrong, "$n: askew" unless abs($long[0] * $wide[0] + $long[1] * $wide[1]) < 1e-6;
    push @wrong, "$n: at $_->[2]" for grep { abs($_->[2] - 0.05 * $length) > 1e-6 } @at;
    push @middles, join ',', map { sprintf '%.0f', 1000 * ($at[0][$_] + $at[2][$_]) / 2 } 0, 1;
}
print join(' ', sort @middles), join('; ', '', @wrong), "\n";
END
is "rhombi lie over the vertices" "$(perl rhombi.pl square.ply)" \
    "0,0 0,1000 0,2000 1000,0 1000,1000 1000,2000 2000,0 2000,1000 2000,2000"
try dirfield torus.glb --arrows arrows.obj -o out.glb
refused "--arrows to another format than PLY" 2 2
try dirfield torus.glb --report /dev/full -o full.glb
refused "a report on a full disk" 4 1
is "no mesh is left when the report cannot be written" "$(ls full.glb .full* 2>/dev/null)" ""
try dirfield torus.glb --report report.tsv --arrows report.tsv -o out.glb
refused "two outputs to one file" "2 4" 2

try dirfield --constraints - <torus.glb
refused "two inputs from one pipe" 2 2
try dirfield torus.glb --direction up
refused "an unknown direction" 2 2
try dirfield torus.glb --direction 400
refused "a direction of more than a full turn" 2 2
try dirfield torus.glb --method hz --solver cholesky
refused "a solver that the method does not have" 2 2
try dirfield torus.glb --coarse 100 --radius 3
refused "--radius with --coarse" 2 2

lapped-param -q torus.glb -o patches.glb
try dirfield patches.glb -o out.glb
refused "a file that is lapped" 3 1
is "the message names the file and what to do" "$(cat .err)" \
    "dirfield: patches.glb: is lapped already: use the file that it was made from"

# A Moebius strip of ten quads.
awk 'BEGIN {
    for (i = 0; i < 10; i++) for (side = -1; side < 2; side += 2) {
        a = i * 6.283185307179586 / 10; r = 1 + side * .3 * cos(a / 2)
        printf "v %.9f %.9f %.9f\n", r * cos(a), r * sin(a), side * .3 * sin(a / 2)
    }
    for (i = 0; i < 10; i++) {
        a = 2 * i + 1; b = a + 1; c = i < 9 ? a + 2 : 2; d = i < 9 ? a + 3 : 1
        printf "f %d %d %d\nf %d %d %d\n", a, c, d, a, d, b
    }
}' >moebius.obj
try dirfield moebius.obj --direction 45 -o out.glb
grep -q 'one-sided surface' .err
is "a one-sided surface refuses a rotation by 45 degrees" "$status $? $(wc -l <.err)" "3 0 1"
try dirfield moebius.obj --direction min -o out.glb
is "a one-sided surface accepts a rotation by a right angle" "$status $(hatchstat field -q out.glb | column index_sum)" "0 0"

# Working memory of 256 threads for 10,000 points would be 84 MB; with one thread, 4 MB are not
# enough, and 6 are.
meshgen torus --faces 20000 -o many.glb
for memory in 4M 6M 60M; do
    for threads in 1 4 256; do
        try dirfield -q many.glb --threads $threads --max-memory $memory -o "many.$threads.glb"
        echo "$status"
    done | sort -u >statuses
    is "the exit status does not depend on threads, with $memory" "$(wc -l <statuses)" 1
done
ok "nor does the field" cmp many.1.glb many.256.glb

# If each of 12,000 rows went through all faces, they would take .14 ms each, 1700 in all.
meshgen plane --faces 100000 -o fine.glb
awk 'BEGIN {print "vertex\tdx\tdy\tdz\tweight"; for (i = 0; i < 12000; i++) print i "\t1\t1\t0\t1"}' >rows.tsv
[ -z "$SANITIZE" ] && ms=$(milliseconds 800 dirfield -q fine.glb --constraints rows.tsv -o hand.glb) || ms=0
ok "thousands of constraints on a plane take little time ($ms ms)" test "$ms" -le 800

# A bent sheet, of which one edge has a third vertex beside it: the needle between them has an area in the file, but none
# where coordinates are seen from the middle of the sheet.
awk 'BEGIN {
    for (j = 0; j < 13; j++) for (i = 0; i < 13; i++) print "v", i - 2, j - 2, .05 * (i - 4) ^ 2
    print "v 1e-17 2.5 .2"
    for (j = 0; j < 12; j++) for (i = 0; i < 12; i++) {
        a = 13 * j + i + 1; b = a + 1; d = a + 13; c = d + 1
        if (i == 2 && j == 4) printf "f %d 170 %d\nf %d %d 170\nf 170 %d %d\nf 170 %d %d\n", a, d, a, b, b, c, c, d
        else printf "f %d %d %d\nf %d %d %d\n", a, b, c, a, c, d
    }
}' >needle.obj
for solver in multigrid cholesky; do
    try dirfield -q needle.obj --solver $solver -o needle.glb
    is "a needle that rounding leaves no area, $solver" "$status $(hatchstat field -q needle.glb | column smoothness |
        awk '{print ($1 >= 0 && $1 < .001)}')" "0 1"
done

# The phases follow each other, so that their times add up to less than the run took.
meshgen torus --faces 20000 -o torus.glb
begin=$(date +%s%N)
dirfield -q torus.glb -r report.tsv -o field.glb
end=$(date +%s%N)
is "times of phases are positive and not above the run's" "$(awk -v ms=$(((end - begin) / 1000000)) -F'\t' '
    NR == 1 {for (i = 1; i <= NF; i++) if ($i ~ /_ms$/) timed[i] = 1}
    $1 == "all" {for (i in timed) {sum += $i; bad += !($i > 0)} print bad + 0, (sum > 1 && sum <= ms + 1)}' report.tsv)" "0 1"
finish
