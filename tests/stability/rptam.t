# Scenes on which a plain implementation of rptam fails: zero or infinite derivatives T and G, few seed points, no
# layers. Each is drawn, with the right tone where strokes are possible.
. "${TOP:-.}/tests/tap.sh"

# tone ARGUMENT ...: draws a picture and prints its mean, linear
tone() {
    render-gl "$@" -t rptam --size 160x120 --lines none -o picture.exr 2>err || return
    hatchstat frames picture.exr picture.exr | awk 'NR == 2 {print $2}'
}

# near NAME MEAN WITHIN ARGUMENT ...: checks that a picture is drawn and has this mean, and that there is no message
# except of a blank picture and of the texture coordinates that made it blank
near() {
    name=$1 want=$2 within=$3
    shift 3
    got=$(tone "$@")
    is "$name" "$(grep -v 'the same texture coordinates everywhere' err | grep -v 'the picture is blank'
        echo "$got" | awk -v want="$want" -v within="$within" \
            '{print ($1 >= want - within && $1 <= want + within) ? "right" : $1}')" right
    is "$name: a blank picture is told" "$(grep -c 'the picture is blank' err)" "$(echo "$got" | awk '{print $1 == 1}')"
}

# square NAME U0 V0 U1 V1 U2 V2 U3 V3: a square that fills the picture, with texture coordinates
square() {
    file=$1
    shift
    printf 'v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n' >"$file"
    printf 'vt %s %s\n' "$@" >>"$file"
    printf 'f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n' >>"$file"
}
face="--camera 0,0,3:0,0,0 --fov 20 --tone-range .3:.3"
square plain.obj 0 0 1 0 1 1 0 1
near "a square" 0.7 0.03 plain.obj $face
square point.obj .5 .5 .5 .5 .5 .5 .5 .5
near "coincident texture coordinates give no strokes" 1 0 point.obj $face
# With collinear texture coordinates strokes have no width; rounding of the determinant gives specks, 0.001 of ink.
square line.obj 0 0 1 1 1 1 0 0
near "collinear texture coordinates give no strokes" 1 0.005 line.obj $face
square along.obj 0 0 1 0 1 0 0 0
near "texture coordinates along an axis give no strokes" 1 0 along.obj $face
square large.obj 0 0 1e30 0 1e30 1e30 0 1e30
near "texture coordinates of 1e30 give no strokes" 1 0 large.obj $face
square small.obj 0 0 1e-30 0 1e-30 1e-30 0 1e-30
near "texture coordinates of 1e-30 give no strokes" 1 0 small.obj $face
square mirrored.obj 1 0 0 0 0 1 1 1
near "mirrored texture coordinates have the right tone" 0.7 0.03 mirrored.obj $face
square skewed.obj 0 0 1 0 3 .1 2 .1
near "stretched and skewed texture coordinates have the right tone" 0.7 0.03 skewed.obj $face

# A ground of 1000 units that extends behind the eye and to the horizon, as two triangles.
printf 'v -500 0 -500\nv 500 0 -500\nv 500 0 500\nv -500 0 500\nvt 0 0\nvt 500 0\nvt 500 500\nvt 0 500\n' >ground.obj
printf 'f 1/1 3/3 2/2\nf 1/1 4/4 3/3\n' >>ground.obj
ground="ground.obj --tone-range .3:.3 --size 160x120"
near "a ground from behind the eye to the horizon" 0.845 0.02 $ground --camera 0,1,0:0,1,-10
near "the ground from a height of 0.01" 0.845 0.02 $ground --camera 0,0.01,0:0,0.01,-10
near "the ground from a height of 1e-7" 0.845 0.02 $ground --camera 0,1e-7,0:0,1e-7,-10
near "the ground edge on" 1 0.005 $ground --camera 0,0,0:0,0,-10

# Numbers of seed points and layers.
for count in 2 3 7 100 1000; do
    seedgen -n $count --layers 3 --candidates 20 -o sets
    near "$count seed points per layer" 0.7 0.05 plain.obj $face --seeds sets \
        --seed-tile "$(awk -v n=$count 'BEGIN {printf "%.3f", 32 * sqrt(n)}')" --stroke 20x9
done
seedgen -n 64 --layers 8 --candidates 5 -o sets
near "eight layers at a light tone" 0.95 0.01 plain.obj $face --seeds sets --tone-range .05:.05
near "no layers give blank paper" 1 0 plain.obj $face --seeds sets --seed-layers 0
near "no layers give blank paper without light" 1 0 plain.obj $face --seeds sets --seed-layers 0 --tone-range 1:1
for tile in 16 8; do
    near "a tile of $tile pixels, black when full of strokes, has the right light tone" 0.95 0.015 plain.obj $face --stroke 20x1.5 \
        --seed-tile $tile --tone-range .05:.05
done
near "strokes larger than their tile" 0.7 0.02 plain.obj $face --stroke 60x3 --seed-tile 40
finish
