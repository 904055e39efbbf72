# Looks of solid textures: haloes beside watercolours, and the borders of collages.
. "${TOP:-.}/tests/tap.sh"

perl "$TOP/tests/support/solid/make.pl" 16 waves:4 >waves.ktx2
draw="render-gl --size 96x72 --solid waves.ktx2 -t solid"

# The bare paper beside an object is no surface: haloes lie on surfaces alone.
meshgen sphere --faces 500 -o sphere.glb
for look in plain binary watercolor collage; do
    $draw sphere.glb --look $look -o bare.png
    $draw sphere.glb --look $look --haloes 8 -o haloes.png
    ok "$look: a single object has no halo" cmp bare.png haloes.png
done
$draw sphere.glb --ground 4 --look watercolor -o bare.png
$draw sphere.glb --ground 4 --look watercolor --haloes 8 -o haloes.png
is "watercolor: an object before the ground has one" "$(cmp -s bare.png haloes.png; echo $?)" 1
finish
