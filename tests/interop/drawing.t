# librsvg and a browser draw a drawing of lines as render-gl draws the picture: the means over squares of 16 pixels differ
# by less than 0.15, where a line that is missing makes 0.3 and more.
. "${TOP:-.}/tests/tap.sh"

meshgen teapot --faces 5000 -o teapot.glb
meshgen torus --faces 2000 -o torus.glb
# Paper everywhere, so that the picture has the lines alone.
lines="-q -t gouraud --lines all --tone-range 0:0 --samples 16 --size 480x360"
for shape in teapot torus; do
    ok "the picture of the $shape" render-gl $lines $shape.glb -o $shape.png
    ok "the drawing of the $shape" render-gl $shape.glb --size 480x360 -o $shape.svg
done

# far_apart A B: prints the largest difference of the means over squares of 16 pixels
far_apart() {
    hatchstat diff "$1" "$2" | awk -F'\t' 'NR == 1 {for (i = 1; i <= NF; i++) if ($i == "max_box16") at = i} NR == 2 {print $at}'
}
render-gl $lines --lines none teapot.glb -o bare.png
is "missing lines are found" "$(far_apart teapot.png bare.png | awk '{print ($1 > 0.3)}')" 1

# Dots of a plane in the same places: two unlike patterns of this tone differ by .3.
meshgen plane --faces 200 | strokegen -q --levels 6 --gap 0.04 -o dots.glb
dots="-q -t traced --stroke-style stipple --lines none --size 480x360 --fov 25 --tone-range .2:.2"
render-gl $dots --camera 0,0,3.7320508:0,0,0 dots.glb --stroke-width 2.6 -o dots.png
render-gl $dots --camera 0,0,3.7320508:0,0,0 dots.glb --pen 0.688mm -o dots.svg

draw_with() { # draw_with VIEWER SHAPE
    case $1 in
    rsvg-convert) rsvg-convert --background-color white -w 480 -h 360 "$2.svg" -o "$2.drawn.png" ;;
    chromium)
        HOME=$WORK timeout 100 chromium --headless --no-sandbox --disable-gpu --hide-scrollbars --window-size=480,360 \
            --screenshot="$WORK/$2.drawn.png" "file://$WORK/$2.svg"
        ;;
    esac >/dev/null 2>&1
}
for viewer in rsvg-convert chromium; do
    for shape in teapot torus dots; do
        name="$viewer draws the $shape as the picture is"
        if command -v "$viewer" >/dev/null; then
            rm -f "$shape.drawn.png"
            draw_with "$viewer" "$shape"
            if [ "$shape" = dots ]; then
                apart=$(hatchstat frames dots.png dots.drawn.png | awk -F'\t' 'NR == 3 {print $4}')
            else
                apart=$(far_apart "$shape.png" "$shape.drawn.png")
            fi
            is "$name" "$(echo "$apart" | awk '{print ($1 > 0 && $1 < 0.15) ? "near" : $1}')" near
        else
            skip "$name" "no $viewer"
        fi
    done
done
finish
