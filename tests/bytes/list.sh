# The inputs and runs of runs.sh, a line each. Words that are not commands are functions of runs.sh.

# inputs: prints the inputs, each with its name and the command that makes it. No run may write to one of these names.
inputs() {
    cat <<'END'
teapot.glb meshgen teapot --faces 1200
torus.glb meshgen torus --faces 800
ball.glb meshgen sphere --faces 600 --uv whole
plane.glb meshgen plane --faces 50
true.glb meshgen ellipsoid --faces 600 --jitter 1 --noise 0.05 --field
field.glb dirfield -q torus.glb
lapped.glb lapped-param -q field.glb
teapot.lapped.glb lapped-param -q teapot.glb
bumpy.lapped.glb lapped-param -q bumpy.gltf
skinned.lapped.glb lapped-param -q skinned.gltf
morphs.lapped.glb lapped-param -q morphs.gltf
nodes.lapped.glb lapped-param -q nodes.gltf
textured.lapped.glb lapped-param -q textured.gltf
atlas.glb lapped-param -q --atlas field.glb
strokes.glb strokegen -q --levels 3 field.glb
teapot.strokes.glb strokegen -q --levels 4 teapot.glb
skinned.strokes.glb strokegen -q --levels 4 skinned.gltf
nodes.strokes.glb strokegen -q --levels 4 nodes.gltf
textured.strokes.glb strokegen -q --levels 4 --angles 0,60,30 textured.gltf
map.exr tamgen --size 64 --levels 2 --strokes map.tsv
eight.exr tamgen --size 64 --levels 1 --tones 8
two.exr tamgen --size 64 --levels 2 --tones 2 --set 'darkest 0.5'
fine.exr tamgen --size 64 --levels 2 --tones 64 --set 'darkest 1'
color.exr tamgen --size 64 --levels 2 --palette dusk
finecolor.exr tamgen --size 64 --levels 2 --tones 32 --palette sea --set 'darkest 0.8'
ids.exr tamgen --size 64 --levels 2 --tones 3 --ids
volume.ktx2 tamvol -q --tones 16 fine.exr
layers.ktx2 tamvol -q --tones 16 --layout array fine.exr
bc4.ktx2 tamvol -q --tones 16 --compress fine.exr
colors.ktx2 tamvol -q --tones 16 finecolor.exr
rgba.ktx2 tamvol -q --tones 16 --alpha --layout array finecolor.exr
bc1.ktx2 tamvol -q --tones 16 --compress finecolor.exr
bc7.ktx2 tamvol -q --tones 16 --compress --layout volume finecolor.exr
steps.ktx2 tamthresh -q fine.exr
modulated.ktx2 tamthresh -q --modulate grey.png --mask holes.png fine.exr
exact.ktx2 tamthresh --exact fine.exr
one.seeds seedgen -n 64 --seed 5
two.seeds seedgen -n 16 --layers 2
many.seeds seedgen -n 100 --layers 5 --candidates 10
ridges.ktx2 solidgen -q --style wood --size 32
dots.ktx2 solidgen -q --style stipple --size 32
two.ktx2 solidgen -q --style stipple --size 16 --set 'equalize no; contrast 9'
stroke.png tamgen --size 64 --levels 1 --tones 1 -o /dev/null --contact-sheet -
tones.ktx2 solidgen -q --exemplar texture.png --size 16
first.png render-gl teapot.glb --tam map.exr --size 96x72 -o -
second.png render-gl teapot.glb --tam map.exr --size 96x72 --from 32:20 -o -
tone.png render-gl teapot.glb -t gouraud --lines all --size 96x72 -o -
two.layers printf 'tone 0..0.6 turn 30 length 30 width 3 ink 0.6 stroke pencil\ntone 0.4..1 length 6 width 6 tile 60 stroke stroke.png\n'
hand.tsv printf 'vertex\tdx\tdy\tdz\tweight\n7\t1\t1\t0\t10\n20\t0\t1\t0\t1000\n'
own.style printf 'brush pencil\nwidth 3\nlength 0.2 0.5\nbend 10 60\ndirection 60 0 1\ncolor 0 804020\ncolor 1 000000\n'
END
    drawing='<svg viewBox="0 0 9 9"><g fill="none" stroke="red" stroke-dasharray="2 .5">'
    drawing=$drawing'<path d="m1,4q3-5,6,1m-6,2h8"/><circle cx="5" cy="4" r="3" stroke="#214"/></g></svg>'
    echo "small.svg echo '$drawing'"
}

# Runs of the other commands; list_draw.sh has those of render-gl.
list_maps() {
    for style in arcs chalk charcoal crayon drafting engraving etching ink marker pencil sketch speckle stipple \
        wash woodcut; do
        echo "tamgen-$style tamgen --size 64 --tones 4 --style $style --strokes strokes.tsv --contact-sheet sheet.png -o new.exr"
    done
    for palette in dusk earth sea; do
        echo "tamgen-palette-$palette tamgen --size 64 --tones 3 --palette $palette"
    done
    cat <<'END'
tamgen-exhaustive tamgen --size 64 --tones 2 --method exhaustive --candidates 30:10
tamgen-growth tamgen --size 128 --growth 0.4 --seed 7
tamgen-ids tamgen --size 64 --ids --tones 3 -v
tamgen-brush tamgen --size 64 --brush stroke.png --set 'width 6; direction 45 0 1'
tamgen-own-style tamgen --size 64 --style ./own.style --strokes strokes.tsv
tamgen-many tamgen --size 64 --levels 1 --tones 40 --contact-sheet sheet.png -o /dev/null
tamgen-replay tamgen --size 64 --replay small.svg --strokes strokes.tsv -v
tamgen-replay-fit tamgen --size 64 --replay hatching.svg --fit --tones 4
tamgen-replay-keep tamgen --size 64 --replay hatching.svg --keep 0.5 --tones 4
tamgen-replay-table tamgen --size 64 --replay map.tsv --palette dusk --set 'darkest 0.75' --fit
tampack-rgb tampack map.exr -o packed.ktx2
tampack-rgb-ink tampack --ink 1 ids.exr -o packed.ktx2
tampack-array tampack --layout array map.exr
tampack-array-color tampack --layout array color.exr
tampack-dds tampack --layout dds --ink 1 map.exr -v
tampack-png tampack --layout png color.exr -o packed.png
tampack-exr tampack --layout exr ids.exr -o packed.exr
tampack-refused tampack --layout rgb color.exr -o packed
tamvol-v tamvol -v fine.exr -o volume.exr
tamvol-array tamvol -v --layout array --compress --tones 8 finecolor.exr
tamvol-alpha tamvol --alpha --tones 4 color.exr
tamvol-coarse tamvol map.exr
tamthresh-v tamthresh -v fine.exr -o steps.exr
tamthresh-bins tamthresh -v --bins 3 --seed 5 fine.exr
tamthresh-bins-given tamthresh --bins 0.2,0.5,0.8 map.exr
tamthresh-exact tamthresh -v --exact map.exr
tamthresh-color tamthresh color.exr
solidgen-perlin solidgen --style perlin --size 32 --slices slices.png
solidgen-turbulence solidgen --style turbulence --size 32
solidgen-wood solidgen --style wood --size 32 --slices slices.png -v
solidgen-marble solidgen --style marble --size 32 --seed 2 -o marble.exr
solidgen-worley solidgen --style worley --size 32 --set 'distance f2-f1; jitter 0.5'
solidgen-stipple solidgen --style stipple --size 32
solidgen-strokes solidgen --style strokes --size 32
solidgen-crosshatch solidgen --style crosshatch --size 32
solidgen-paper solidgen --style paper --size 32
solidgen-kopf solidgen --exemplar tone.png --size 16 --seed 3 -v
solidgen-axes solidgen --exemplar stroke.png --size 16 --axes xz --neighborhood 6 --levels 2 --slices slices.png
solidgen-exhaustive solidgen --exemplar grey.png --size 8 --iterations 1 --exhaustive
solidgen-pyramid solidgen --exemplar tone.png --size 32 --method pyramid --seed 2 -v
hatchstat-solid solidgen --size 16 -o solid.ktx2; hatchstat solid solid.ktx2 --reference tone.png
solidgen-canvas solidgen --style canvas --size 32 --set 'equalize no; contrast 2'
seedgen seedgen -n 64 --layers 3 --candidates 50 --plot seeds.svg -v
seedgen-any seedgen -n 37 --seed 9
seedgen-euler seedgen -n 256 --method euler --candidates 20
seedgen-backtrack seedgen -n 16 --method backtrack --candidates 20
seedgen-gives-up seedgen -n 1024 --method backtrack --max-nodes 2000
hatchstat-diff hatchstat diff first.png second.png
hatchstat-diff-srgb hatchstat diff --srgb --json --max-difference 0.1 first.png tone.png
hatchstat-frames hatchstat frames first.png second.png first.png tone.png
hatchstat-ink hatchstat ink --reference tone.png --patches second.png first.png second.png
hatchstat-field hatchstat field field.glb true.glb
hatchstat-field-reference dirfield -q true.glb | hatchstat field --reference true.glb --share 0.5
hatchstat-lapped hatchstat lapped --samples 5000 lapped.glb --json
hatchstat-lapped-check hatchstat lapped --check teapot.lapped.glb
hatchstat-mesh hatchstat mesh nodes.gltf skinned.lapped.glb faulty.obj ascii.ply
hatchstat-seeds hatchstat seeds many.seeds --throws 20 --check
hatchstat-tam hatchstat tam map.exr --strokes map.tsv --check
hatchstat-tam-color hatchstat tam color.exr --json --throws 2
hatchstat-tones hatchstat tones volume.ktx2 --reference fine.exr --samples 6400
hatchstat-tones-steps hatchstat tones steps.ktx2 --reference fine.exr --samples 6400
hatchstat-tones-exact hatchstat tones exact.ktx2 --reference fine.exr --samples 6400 --json
hatchstat-tones-map hatchstat tones map.exr --reference fine.exr --samples 6400
END
}

list_meshes() {
    for shape in teapot sphere cylinder cone torus plane ellipsoid saddle wave \
        frustum monge eggbox superquadric bump helicoid catenoid; do
        echo "meshgen-$shape meshgen $shape --faces 500 -v -o new.glb; hatchstat mesh new.glb; draw new.glb --tam map.exr"
    done
    for file in ring.obj ring.off ascii.ply little.ply big.ply binary.stl text.stl far.obj faulty.obj moebius.off; do
        echo "mesh-$file mesh $file"
    done
    for scene in textured masked skinned morphs nodes cameras lamps-all glass; do
        echo "mesh-$scene.gltf mesh $scene.gltf"
    done
    for shape in sphere plane cone teapot; do
        echo "mesh-$shape meshgen $shape --faces 600 --jitter 0.5 --uv even --seed 4 -o new.glb; mesh new.glb"
    done
    cat <<'END'
meshgen-noise meshgen torus --faces 700 --jitter 0.8 --noise 0.1 --seed 3 --field
dirfield-min dirfield torus.glb --direction min --arrows arrows.ply
dirfield-turned dirfield true.glb --direction 30 --smooth 0.9
dirfield-curvature dirfield true.glb --smooth 0
dirfield-hz dirfield true.glb --method hz
dirfield-cholesky dirfield true.glb --solver cholesky -v
dirfield-radius dirfield true.glb --radius 2 --degree 2
dirfield-coarse dirfield true.glb --coarse 300
dirfield-by-hand dirfield plane.glb --constraints hand.tsv
dirfield-json dirfield nodes.gltf --report - --json -o new.glb | grep -v '_ms"'
dirfield-refused dirfield moebius.off --direction 30
lapped-param-size lapped-param field.glb --size 0.3 --curved 0 --seed 3 -v
lapped-param-fine lapped-param field.glb --size 0.15 --stretch 1.2 --turn 8 --tile 0.4
lapped-param-outline lapped-param field.glb --roughness 1 --feather 0.2 --mask-size 64
lapped-param-atlas lapped-param --atlas teapot.glb -v
lapped-param-again lapped-param lapped.glb
meshfit-teapot meshfit teapot.glb -v
meshfit-one-side meshfit teapot.glb --from 30:20 --zoom 2 --size 320x180 --error 1
meshfit-faces meshfit teapot.glb --faces 300
meshfit-skinned meshfit skinned.gltf
meshfit-morphs meshfit morphs.gltf
meshfit-nodes meshfit nodes.gltf
meshfit-textured meshfit textured.gltf
hatchplan-make hatchplan teapot.glb --techniques tam-flat --budget mb=.2 --size 96x72 --make
hatchstat-coarse hatchstat coarse teapot.glb teapot.glb
strokegen-angles strokegen field.glb --angles 0,90,-45 --levels 3 --seed 3 -v
strokegen-short strokegen field.glb --gap 0.05 --levels 2 --length 5 --hard 10
strokegen-no-field strokegen teapot.glb --levels 3 --hard 180
strokegen-again strokegen strokes.glb --levels 2
strokegen-skinned strokegen skinned.gltf --levels 3
strokegen-morphs strokegen morphs.gltf --levels 3
strokegen-nodes strokegen nodes.gltf --levels 3
strokegen-textured strokegen textured.gltf --levels 3
END
}

# The window, where Xvfb and xdotool are installed; it reports the pictures that it saves. The size of a zoom step
# depends on the last frame, so a picture is saved between any two steps.
list_windows() {
    command -v Xvfb >/dev/null && command -v xdotool >/dev/null || return 0
    cat <<'END'
window-hand open_window teapot.glb -T map.exr; shot; drag 1; shot; drag 3; shot f Left Left Up; shot shift+Down; close_window
window-drags open_window teapot.glb -T map.exr; xdotool keydown shift; drag 1; xdotool keyup shift; shot; xdotool keydown ctrl; drag 1; xdotool keyup ctrl; shot; shot f; close_window
window-techniques open_window teapot.glb -T map.exr; for key in 1 2 3 4 5 6 7 8 9 t; do shot $key; done; shot t l; shot l; close_window
window-hatch open_window lapped.glb -T map.exr --samples 1; shot bracketright bracketright; shot bracketleft; shot greater greater; shot less; shot 8 greater; close_window
window-zoom open_window teapot.glb -t rptam --zoom 3; for nearer in 1 2 3 4; do shot plus; done; drag 3; shot; shot plus; shot minus; xdotool click 4; shot Left; close_window
window-deep open_window lapped.glb -t rptam --zoom 100000 --samples 1; shot; shot plus; shot Right; shot plus; shot r; shot f; close_window
window-close open_window ball.glb -t rptam --camera 0,0,1.3:0,0,-3; shot; shot plus; shot Left; shot minus; close_window
window-params open_window teapot.glb -t rptam --stroke 20x2 --overlap 0.5; shot p period period; shot p comma; shot d; shot p p p p p comma comma comma comma comma comma; shot P comma; shot 7; close_window
window-reload open_window lapped.glb -T map.exr --shadows 0.05 --haloes 3; shot; shot r; shot 4 r; shot space; xdotool key Escape; wait "$window"
window-folder open_window ring.obj -t gouraud -o gone/shot%d.png; xdotool key s; soon $window grep -q cannot .err; close_window
window-volume open_window lapped.glb -t volume -T volume.ktx2; shot; shot p p period; shot t; shot t; shot 1; close_window
window-camera open_window cameras.gltf -t gouraud --camera 1 --shadows 0.05; shot; shot l; shot plus; shot p period period; shot p p p period; close_window
window-bare open_window bare.obj -t gouraud --haloes 3; shot 1; shot 8; shot l; close_window
window-help open_window ring.obj -t gouraud; shot question r; close_window
END
}

# Help texts and messages, which may change on purpose.
list_help() {
    for command in dirfield hatchplan hatchstat lapped-param meshfit meshgen render-gl seedgen solidgen strokegen tamgen tampack tamthresh tamvol; do
        echo "help-$command $command --help; $command --version"
        echo "help-table-$command $command --options-table"
        echo "help-usage-$command $command --nonesuch; $command -j 0; $command one two three four five"
    done
}

# The parts of the list; the environment variable PARTS selects some.
list() {
    for part in ${PARTS:-techniques pictures seeds reports solids refusals maps meshes windows help}; do
        "list_$part"
    done
}
