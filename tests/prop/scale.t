# Nothing depends on units or on the lengths of vectors that are directions: a mesh 2^30 times as large or as small, and
# normals, tangents and directions of any length, give the same results to the last bit, as powers of two are exact.
. "${TOP:-.}/tests/tap.sh"

multiply() { perl "$TOP/tests/prop/multiply.pl" "$@"; }

# binary FILE: the bytes of a GLB file without its JSON
binary() { perl -0777 -ne 'print substr $_, 20 + unpack("x12 V", $_)' "$1"; }

# results FOLDER MESH: what the commands make of a mesh with directions, in a folder; SVG and reports are text
results() {
    mkdir "$1" && cd "$1" || return
    at=../$2
    dirfield -q --smooth 1 "$at" -o field.glb
    lapped-param -q "$at" -o lapped.glb
    lapped-param -q --atlas "$at" -o atlas.glb
    meshfit -q --error 2 "$at" -o fitted.glb
    strokegen -q --levels 3 "$at" -o strokes.glb
    hatchstat field "$at" >field.tsv 2>field.err
    hatchstat lapped lapped.glb >lapped.tsv 2>lapped.err
    for technique in gouraud rptam strokes solid; do
        render-gl -q "$at" -t $technique --size 160x120 -o $technique.png
    done
    render-gl -q lapped.glb -t tam --tam ../map.exr --size 160x120 -o tam.png
    render-gl -q strokes.glb -t traced --finer 0 --size 160x120 -o traced.png
    render-gl -q "$at" -t gouraud --shadows 0.03 --ground 3 --lines all --size 160x120 -o ground.png
    render-gl -q "$at" --show field --size 160x120 -o show.png
    render-gl -q "$at" -t gouraud --haloes 4 --zoom 20 --size 160x120 -o near.png
    render-gl -q "$at" -t gouraud --lines all --size 160x120 -o lines.svg
    cd ..
}

# same NAME FOLDER POWER: checks the results in a folder, of positions that are 2^POWER times as large as in `one`
same() {
    differ=
    for file in "$2"/*; do
        other=one/${file#*/}
        case $file in
        */strokes.glb) continue ;; # which have decimal numbers; traced.png shows them
        *.glb)
            multiply $((-$3)) POSITION <"$file" >back.glb
            multiply 0 POSITION <"$other" >other.glb
            binary back.glb >back && binary other.glb >other ;;
        *.tsv | *.err) sed "s/$2.glb/one.glb/; /not of length 1/d" "$file" >back && cp "$other" other ;;
        *) cp "$file" back && cp "$other" other ;;
        esac
        cmp -s back other || differ="$differ ${file#*/}"
    done
    is "$1" "$(ls "$2" | wc -l):$differ" "$(ls one | wc -l):"
}

tamgen -q --size 64 --levels 2 -o map.exr
meshgen teapot --faces 1500 --jitter 0.5 --noise 0.05 | dirfield -q >one.glb
results one one.glb
is "all results are there" "$(ls one | wc -l)" 19
for power in 30 -30; do
    multiply $power POSITION <one.glb >scaled.glb
    results scaled scaled.glb
    same "2^$power times as large: the same bytes" scaled $power
    rm -r scaled
done
multiply 5 NORMAL <one.glb | multiply -6 TANGENT | multiply 7 _HATCH_DIR >lengths.glb
results lengths lengths.glb
rm */fitted.glb # both keep the attributes of the mesh
for kept in field lapped atlas; do
    multiply -5 NORMAL <lengths/$kept.glb >back.glb && mv back.glb lengths/$kept.glb
done
multiply 6 TANGENT <lengths/field.glb >back.glb && mv back.glb lengths/field.glb
multiply -7 _HATCH_DIR <lengths/atlas.glb >back.glb && mv back.glb lengths/atlas.glb
same "normals, tangents and directions of other lengths: the same bytes" lengths 0
finish
