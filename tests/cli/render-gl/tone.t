# Every technique reproduces the given tone within its tolerance, on a square of one tone and on a lit teapot, compared
# with gouraud. Techniques are those of --options-table; one without a case below fails.
. "${TOP:-.}/tests/tap.sh"

tamgen --size 128 --tones 6 --set 'darkest 1' -o map.exr
tamgen --size 128 --tones 64 --set 'darkest 1' -o fine.exr
tamvol -q fine.exr -o volume.ktx2
tamthresh -q fine.exr -o thresholds.ktx2
tamthresh -q --exact fine.exr -o exact.ktx2
meshgen plane --faces 200 -o plane.glb
meshgen teapot --faces 10000 -o teapot.glb
meshgen plane --faces 200 | strokegen -q --levels 6 --gap 0.04 -o plane.strokes.glb
strokegen -q --levels 6 teapot.glb -o teapot.strokes.glb

# draw OPTION ...: draws with $technique and $asset and prints the mean darkness
draw() {
    # shellcheck disable=SC2086 # the options are words
    render-gl -q -t "$technique" ${asset:+-T $asset} $options --lines none -o picture.exr "$@" &&
        hatchstat frames picture.exr picture.exr | awk 'NR == 2 {print 1 - $2}'
}
# The square fills the picture, and strokes, whose ends taper, end outside of it.
square() {
    draw plane${strokes:+.strokes}.glb --size 256x256 --camera 0,0,3.7320508:0,0,0 --fov "$([ "$strokes" ] && echo 25 || echo 30)" --tone-range "$1:$1"
}
teapot() {
    darkest=$1
    shift
    draw teapot${strokes:+.strokes}.glb --size 640x480 --tone-range "0:$darkest" "$@"
}
# off NAME GOT WANT BELOW ABOVE: checks that GOT lies between WANT - BELOW and WANT + ABOVE
off() {
    is "$1: $2 for $3" "$(awk -v got="$2" -v want="$3" -v below="$4" -v above="$5" \
        'BEGIN {print (got != "" && got >= want - below && got <= want + above)}')" 1
}
# squares BELOW ABOVE TONE ...: checks squares of these tones, which may have BELOW less and ABOVE more ink
squares() {
    below=$1 above=$2
    shift 2
    for tone in "$@"; do
        off "$technique $asset" "$(square "$tone")" "$tone" "$below" "$above"
    done
}
# lit BELOW ABOVE [DARKEST]: checks the teapot likewise, with tones up to DARKEST
lit() {
    off "$technique $asset, a teapot" "$(teapot "${3:-1}")" "$(cat "lit.${3:-1}")" "$1" "$2"
}
technique=gouraud asset= options=
for darkest in 1 .6; do
    teapot $darkest >lit.$darkest
done

ends="0 1"
columns=".16666667 .5 .83333333" # tones of columns of the map
between=".04 .25 .6 .9"
# shellcheck disable=SC2086 # tones are words
for technique in $(render-gl --options-table | awk -F'\t' '$2 == "technique" {gsub(",", " ", $7); print $7}'); do
    asset='' strokes='' options=
    case $technique in
    gouraud) # the tone itself, stored as half floats
        squares .001 .001 $ends $columns $between
        ;;
    tam | tam-face | tam-triple) # blends two columns, each within 0.003 of its tone, as hatchstat tam allows
        asset=map.exr
        squares .005 .005 $ends $columns $between
        lit .005 .005
        ;;
    tam-flat | tam-gouraud) # the nearest column: an error up to half of a sixth, less on average over all tones
        asset=map.exr
        squares .005 .005 $ends $columns
        squares .089 .089 $between
        lit .01 .01
        ;;
    tam-threshold) # black or white: up to a column too light below tone .5, too dark above
        asset=map.exr
        squares .001 .001 $ends
        squares .167 .005 .16666667 .04 .25 .4
        squares .005 .167 .83333333 .6 .75 .9
        lit .05 .05
        ;;
    rptam) # the default layers have tones up to 0.65
        squares .01 .01 0 .04 .16666667 .25 .5 .6
        squares .35 0 1
        lit .01 .01 .6
        ;;
    strokes) # as wide as the strokes of rptam
        squares .01 .01 0 .04 .16666667 .25 .5 .6
        squares .35 0 1
        lit .02 .02 .6
        ;;
    volume) # has a slice for each of the 64 tones
        asset=volume.ktx2
        squares .005 .005 $ends $columns $between
        lit .005 .005
        ;;
    threshold) # seven steps, with errors of tone up to 0.031 according to hatchstat; exact runs have all steps
        asset=thresholds.ktx2
        squares .035 .035 $ends $columns $between
        lit .005 .005
        asset=exact.ktx2
        squares .005 .005 $ends $columns $between
        lit .005 .005
        ;;
    threshold-soft) # a single threshold per texel is always too light
        asset=thresholds.ktx2
        squares .2 0.001 $ends $columns $between
        lit .06 0
        ;;
    solid) # binary: ranks cover what the tone asks for in space, a plane is a sample of it
        options="--solid stipple --look binary"
        squares .01 .01 $ends $columns $between
        lit .003 .003
        ;;
    traced) # the response of the style corrects what strokes leave out and cover twice
        strokes=yes
        squares .01 .01 0 .05 $columns $between
        squares .06 0 1
        lit .02 .02
        ;;
    *) fail "$technique has its tone" "no case for it: add its tolerances" ;;
    esac
done

# The modulation of a threshold texture darkens as --modulate does, with light ink and with two inks, too.
render-gl -q plane.glb -t gouraud --lines none --tone-range 0:0 --camera 0,0,1:0,0,0 --paper '#bcbcbc' --size 8x8 -o grey.png
tamthresh -q fine.exr --modulate grey.png -o modulated.ktx2
strokes=''
for options in "--ink black" "--ink white --paper black" "--ink black,white --paper grey"; do
    for technique in threshold threshold-soft; do
        asset=thresholds.ktx2
        want=$(teapot 1 --modulate grey.png)
        asset=modulated.ktx2
        off "$technique modulated, $options" "$(teapot 1)" "$want" .002 .002
    done
done
finish
