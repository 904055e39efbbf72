# Makefiles of pipelines, by what they would run.
. "${TOP:-.}/tests/tap.sh"
command -v make >/dev/null || {
    skip "pipelines" "no make"
    finish
}
# would FILE VARIABLE=VALUE ...: prints the commands that would run
would() {
    file=$1
    shift
    make --no-print-directory -n -f "$TOP/pipelines/$file.mk" "$@" 2>&1
}
: >m.glb
for file in engrave lapped solid strokes plan gltf plot; do
    is "$file.mk: two films of one name" "$(would $file MESH=m.glb SCENE=m.glb BUDGET=mb=1 TURN=3 FRAMES=2 | sed 's/.*\*\*\* //')" \
        "TURN and FRAMES: both films would have one name.  Stop."
done
for file in engrave lapped solid strokes gltf plot; do
    for none in 0 ""; do
        is "$file.mk: no turntable with TURN=$none" \
            "$(would $file MESH=m.glb SCENE=m.glb TURN=$none FRAMES=2 | grep -c -e --frames) \
$(would $file MESH=m.glb SCENE=m.glb TURN=$none FRAMES=2 | grep -c -e --turntable)" "1 0"
        is "$file.mk: one picture with FRAMES=$none" "$(would $file MESH=m.glb SCENE=m.glb FRAMES=$none | grep -c -e --frames)" 0
    done
done
for file in engrave lapped solid strokes gltf plot; do
    is "$file.mk: TURN is the number of frames of a turn" \
        "$(would $file MESH=m.glb SCENE=m.glb TURN=9 | grep -c -e '--frames 9 --turntable\>')" 1
done
# Maps are made anew when the image of a style's brush has changed, which lies beside the style.
mkdir -p own out fake
printf 'color .2\n brush\timage  my brush.png  # flat\n' >own/my.style
: >"own/my brush.png"
# shellcheck disable=SC2016 # for the script
printf '#!/bin/sh\nfor file; do :; done\necho made >"$file"\n' >fake/tamgen
chmod +x fake/tamgen
# map FILE: prints the name of the map of a pipeline; makes it: does so, if it is to be made
map() {
    would "$1" STYLE=own/my.style OUT=out SCENE=m.glb MESH=m.glb | sed -n 's/.*tamgen .* -o //p'
}
makes() {
    PATH=$PWD/fake:$PATH make -s -f "$TOP/pipelines/$1.mk" STYLE=own/my.style OUT=out SCENE=m.glb MESH=m.glb "$2"
}
for file in gltf lapped teapot fine-tone; do
    touch -t 202001010000 own/my.style "own/my brush.png"
    map=$(map $file)
    makes $file "$map"
    echo old >"$map"
    makes $file "$map"
    is "$file.mk: a map that is newer than its style is kept" "$(cat "$map")" old
    sleep .05 # clocks of files have ticks of several milliseconds
    touch "own/my brush.png"
    makes $file "$map"
    is "$file.mk: one that is older than the image of the brush is not" "$(cat "$map")" made
    rm "$map"
done
# Pictures of the gallery do not depend on which of them were drawn before.
for picture in scene zoom-0; do
    would gallery OUT=out out/$picture.png | grep '^ *meshgen' | grep -o 'out/[^ ]*glb' | sort -u >$picture.meshes
done
is "gallery.mk: pictures have meshes of their own" "$(wc -l <zoom-0.meshes) $(comm -12 scene.meshes zoom-0.meshes)" "1 "
finish
