# Surfaces so near the eye that floats cannot place their faces, drawn by techniques whose maps are not magnified.
. "${TOP:-.}/tests/tap.sh"
awk 'BEGIN {
    for (i = 0; i < 8; i++)
        print "v", i % 2 * 2 - 1, int(i / 2) % 2 * 2 - 1, int(i / 4) * 2 - 1
    print "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1"
    split("1 3 4 2  5 6 8 7  1 2 6 5  3 7 8 4  1 5 7 3  2 4 8 6", corner)
    for (f = 0; f < 6; f++) {
        printf "f"
        for (k = 1; k <= 4; k++)
            printf " %d/%d", corner[4 * f + k], k
        print ""
    }
}' >box.obj
tamgen -q --size 64 --tones 6 --levels 2 -o map.exr
tamgen -q --size 64 --tones 16 --levels 2 -o tones.exr
tamvol -q tones.exr -o volume.ktx2
tamthresh -q tones.exr -o thresholds.ktx2
view='--size 45x30 --camera 3,2,5:0.1,0.2,1 --lines none'
# same NAME OPTION ...: checks that a face which fills the picture does so from nearer by, too, in the same tone
same() {
    same_name=$1
    shift
    rm -f at-*.png
    for zoom in 1e4 1e7 1e10; do
        render-gl -q box.obj $view --zoom $zoom "$@" -o at-$zoom.png
    done
    is "$same_name" "$(for zoom in 1e7 1e10; do
        hatchstat diff at-1e4.png at-$zoom.png | awk 'NR == 2 {print ($2 <= 3 / 255)}'
    done | tr '\n' ' ')" "1 1 "
}
same "a face from very near" -t gouraud
same "a face with light per pixel" -t gouraud --pixel-light
# A picture of the face, which is as light as the face everywhere, multiplies its light.
render-gl -q box.obj $view --zoom 1e4 -t gouraud -o light.png
for texture in "" "--modulate light.png"; do
    render-gl -q box.obj $view --zoom 1e7 -t gouraud $texture -o face.exr
    hatchstat frames face.exr face.exr | awk 'NR == 2 {print $2}'
done >lights
is "a face whose light a texture multiplies" "$(awk '{light[NR] = $1}
    END {print (light[1] > .2 && light[1] < .9 && (light[2] - light[1] ^ 2) ^ 2 < .01 ^ 2)}' lights)" 1
same "a face with strokes of a map" -t tam -T map.exr
same "a face with two inks" -t gouraud --ink '#222,#eee' --paper '#999'
same "a face with a volume" -t volume -T volume.ktx2
same "a face with thresholds" -t threshold -T thresholds.ktx2
finish
