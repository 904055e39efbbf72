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
stroke.png tamgen --size 64 --levels 1 --tones 1 -o /dev/null --contact-sheet -
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

# Every technique with every kind of scene and option.
list_techniques() {
    for technique in tam tam-flat tam-face tam-gouraud tam-triple tam-threshold gouraud rptam volume threshold \
        threshold-soft; do
        how="-t $technique"
        case $technique in
        gouraud | rptam) ;;
        volume) how="$how -T volume.ktx2" ;;
        threshold*) how="$how -T steps.ktx2" ;;
        *) how="$how -T map.exr" ;;
        esac
        cat <<END
plain-$technique draw teapot.glb $how
lapped-$technique draw lapped.glb $how --from -60:10 --hatch-turn 20
two-inks-$technique draw teapot.glb $how --paper grey --ink black,white --lines none --samples 1
light-ink-$technique draw lamps-point.gltf $how --paper '#203040' --ink cream --specular 0.5:20
shadows-$technique draw lamps-all.gltf $how --shadows 0.05 --ground 2 --haloes 3
lapped-shadows-$technique draw teapot.lapped.glb $how --shadows 0.1 --haloes 2 --light 60:20 --samples 1
holes-$technique draw masked.gltf $how --shadows 0.03 --texture-tone
texture-tone-$technique draw textured.gltf $how --texture-tone
modulate-$technique draw ball.glb $how --modulate texture.png --tone-range 0:0.8
skinned-$technique draw skinned.gltf $how --time-s 0.4
lapped-skinned-$technique draw skinned.lapped.glb $how --time-s 0.7 --samples 1
nodes-$technique draw nodes.gltf $how --specular 1:8 --tone-gamma 1.4
row-$technique draw teapot.glb lapped.glb skinned.gltf $how --size 300x90
END
        case $technique in
        tam-flat | tam-face | tam-gouraud | tam-triple) continue ;;
        esac
        cat <<END
pixel-light-$technique draw bumpy.gltf $how --pixel-light
lapped-pixel-light-$technique draw bumpy.lapped.glb $how --pixel-light --specular 0.6:12
END
    done
}

list_pictures() {
    cat <<'END'
traced-haloes draw teapot.strokes.glb -t traced --haloes 4
traced-shadows draw teapot.strokes.glb -t traced --stroke-style etching --shadows 0.1 --ground 2
traced-inks draw teapot.strokes.glb -t traced --stroke-style sketch --paper grey --ink black,white --samples 1
traced-skinned film skinned.strokes.glb -t traced --rate 4
traced-nodes draw nodes.strokes.glb -t traced --stroke-style woodcut --specular 1:8
traced-dots draw teapot.strokes.glb -t traced --stroke-style stipple
traced-textured draw textured.strokes.glb -t traced --stroke-style pencil --texture-tone --pixel-light
lines-none draw ring.obj --tam map.exr --lines none
lines-silhouettes draw ring.obj --tam map.exr --lines silhouettes --line-width 3
lines-creases draw moebius.off -t gouraud --lines creases --crease 10
lines-boundaries draw masked.gltf --tam map.exr --lines boundaries,creases --line-color red
lines-gouraud draw teapot.glb -t gouraud --lines all --line-width 0.5
lines-wide draw teapot.glb --tam map.exr --line-width 9 --line-color '#204080' --size 300x225
lines-nodes draw nodes.gltf --tam map.exr --samples 1
lines-fine sh -c 'meshgen saddle --faces 9000 | render-gl -t rptam --size 320x240 -o picture.png'
lines-loose draw loose.gltf --tam map.exr
drawing render-gl teapot.glb --size 320x240 -o drawing.svg
drawing-dashed render-gl nodes.gltf --size 320x240 --page a5 --pen 0.2 --hidden dash --sort nearest -o drawing.svg
drawing-script render-gl teapot.strokes.glb -t traced --size 320x240 -o drawing.tsv
lines-loose-rptam draw loose.gltf -t rptam --pixel-light
lines-orthographic draw cameras.gltf -t rptam --camera 1 --lines silhouettes,boundaries
haloes-teapot draw teapot.glb --tam map.exr --haloes 5 --size 240x180
haloes-lapped draw teapot.lapped.glb -t rptam --haloes 32
haloes-alone draw nodes.gltf -t gouraud --haloes 0.5 --lines none --samples 1
haloes-orthographic draw cameras.gltf -t rptam --camera 1 --haloes 4 --samples 9
shadows-point draw lamps-point.gltf --tam map.exr --shadows 0.02 --ground 3
shadows-spot draw lamps-spot.gltf -t rptam --shadows 0.2
shadows-sun draw lamps-sun.gltf -t gouraud --shadows 0.001 --texture-tone
shadows-far draw lamps-far.gltf --tam map.exr --shadows 0.05 --ground 2
shadows-row draw ball.glb lapped.glb --tam map.exr --shadows 0.05 --ground 2
shadows-many draw lamps-many.gltf -t gouraud --shadows 0.05
shadows-pixel draw bumpy.gltf --tam map.exr --shadows 0.05 --pixel-light --ground 1
shadows-pose film skinned.gltf -t gouraud --shadows 0.05 --ground 2 --rate 4
shadows-mirrored draw nodes.lapped.glb --tam map.exr --shadows 0.04
light-many draw lamps-many.gltf --tam map.exr
light-spot draw lamps-spot.gltf -t volume --tam volume.ktx2 --pixel-light
light-own draw lamps-all.gltf --tam map.exr --light 80:10 --exposure 0.6
light-exposure draw lamps-all.gltf -t gouraud --exposure 0.02
tone-range draw teapot.glb --tam map.exr --tone-range 0.3:0.7 --tone-gamma 0.5
tone-lighten draw teapot.glb -t gouraud --paper black --ink white --tone-range 0.1:0.9
tone-same draw teapot.glb --tam map.exr --ink white
texture-large render-gl plane.glb -t gouraud --size 20000x4 --samples 1 -o wide.png; draw ball.glb -t gouraud --modulate wide.png
texture-pixel draw textured.gltf --tam map.exr --texture-tone --pixel-light
texture-lapped draw textured.lapped.glb -t gouraud --texture-tone
texture-holes draw masked.gltf -t rptam --modulate grey.png --pixel-light
texture-glass draw glass.gltf -t gouraud
texture-baked draw lapped.glb -t threshold --tam modulated.ktx2
texture-baked-ball draw ball.glb -t threshold-soft --tam modulated.ktx2 --uv-scale 1
map-eight draw teapot.glb --tam eight.exr
map-eight-triple draw teapot.glb --tam eight.exr -t tam-triple
map-two draw teapot.glb --tam two.exr
map-two-face draw teapot.glb --tam two.exr -t tam-face
map-color draw teapot.glb --tam color.exr
map-color-triple draw teapot.glb --tam color.exr -t tam-triple
map-color-flat draw lapped.glb --tam color.exr -t tam-flat --ink blue
map-color-gouraud draw lapped.glb --tam color.exr -t tam-gouraud --paper sepia --ink cream
map-ids draw teapot.glb --tam ids.exr
strokes draw teapot.glb -t strokes
strokes-map draw teapot.glb -t strokes --tam ids.exr
strokes-lapped draw lapped.glb -t strokes
strokes-scribble draw teapot.glb -t strokes --style scribble
traced-scribble draw teapot.strokes.glb -t traced --stroke-style scribble
map-atlas draw atlas.glb --tam map.exr --uv-scale 9
hatch-turn draw teapot.glb --tam map.exr --hatch-turn 33 --hatch-scale 1.7
hatch-lapped draw lapped.glb -t threshold --tam exact.ktx2 --hatch-turn -70 --hatch-scale 0.6
hatch-uv-scale draw teapot.glb --tam map.exr --uv-scale 2.5
hatch-uv-scale-lapped draw lapped.glb -t tam-triple --tam map.exr --uv-scale 1
hatch-anisotropy draw plane.glb --tam map.exr --anisotropy 8 --from 70:5
hatch-anisotropy-array draw plane.glb -t tam-face --tam map.exr --anisotropy 16 --from 70:5
hatch-far draw plane.glb --tam map.exr --uv-scale 65536 --from 0:0
samples-1 draw teapot.glb --tam map.exr --samples 1
samples-9 draw teapot.glb -t rptam --samples 9
samples-16 draw lapped.glb --tam map.exr --samples 16
samples-64 draw ring.obj -t gouraud --samples 64 --size 64x48
tile-wide draw teapot.glb --tam map.exr --size 2100x40 --haloes 4
tile-high draw teapot.glb -t rptam --size 40x2100 --haloes 20
tile-lapped draw lapped.glb -t tam-triple --tam map.exr --size 2100x30 --shadows 0.05
tile-near draw teapot.glb -t rptam --size 2100x40 --zoom 1048576
tile-field draw field.glb --show field --size 2100x24
tile-both draw ball.glb -t gouraud --size 1100x1100 --samples 16
camera-first draw cameras.gltf --tam map.exr
camera-orthographic draw cameras.gltf --tam map.exr --camera 1
camera-frame draw cameras.gltf --tam map.exr --camera frame --fov 60
camera-from draw teapot.glb --tam map.exr --from 200:-35
camera-above draw teapot.glb --tam map.exr --from 20:90
camera-below draw teapot.glb -t rptam --camera 0,-5,0:0,0,0
camera-place draw teapot.glb --tam map.exr --camera 1,2,6
camera-places draw teapot.glb -t rptam --camera 0.31,0.22,1.9:0.3,0.2,0 --fov 50
camera-moves film cameras.gltf -t gouraud --rate 3
output-exr draw teapot.glb --tam map.exr -o picture.exr
output-exr-color draw lapped.glb --tam color.exr -t tam-triple -o picture.EXR
output-stdin sh -c 'render-gl - -t rptam --size 64x48 <teapot.glb'
output-one-thread draw teapot.glb --tam map.exr -j 1 --shadows 0.05
output-shader-dir with_shaders draw teapot.glb --tam map.exr --shader-dir shaders
frames-turntable film teapot.glb --tam map.exr --turntable
frames-turntable-lapped film lapped.glb -t rptam --turntable --zoom 2
frames-skinned film skinned.gltf --tam map.exr --rate 3
frames-second film skinned.gltf -t rptam --animation 1 --rate 2.5
frames-morphs film morphs.gltf --tam map.exr --rate 3 --time-s 0.1
frames-lapped film skinned.lapped.glb -t tam-face --tam map.exr --rate 3
frames-pixel film skinned.gltf -t gouraud --pixel-light --rate 3 --animation 0
frames-row film skinned.gltf morphs.lapped.glb cameras.gltf -t rptam --rate 3 --size 160x60
frames-still film teapot.glb -t gouraud
frames-exr film morphs.lapped.glb --tam map.exr -o picture%02d.exr
END
}

list_seeds() {
    cat <<'END'
animate-stroke film teapot.glb -t rptam --animate stroke=10x1..40x4
animate-stroke-ink film teapot.glb -t rptam --animate stroke-ink=1..0.5
animate-stroke-turn film lapped.glb -t rptam --animate stroke-turn=0..40
animate-seed-tile film teapot.glb -t rptam --animate seed-tile=64..256
animate-seed-layers film teapot.glb -t rptam --animate seed-layers=1..3 --tone-range 0:1
animate-overlap film teapot.glb -t rptam --animate overlap=0..0.5 --fade weighted
animate-hatch-turn film teapot.glb --tam map.exr --animate hatch-turn=-30..30
animate-hatch-scale film lapped.glb -t rptam --animate hatch-scale=0.8..1.8
animate-tone-range film teapot.glb -t rptam --animate tone-range=0:0.2..0.2:0.4
animate-tone-gamma film teapot.glb --tam map.exr --animate tone-gamma=0.5..2
animate-light film teapot.glb -t gouraud --animate light=-80:0..80:40 --shadows 0.05
animate-shadows film teapot.glb -t rptam --animate shadows=0.01..0.3 --ground 2
animate-exposure film lamps-all.gltf --tam map.exr --animate exposure=0.01..0.1
animate-haloes film teapot.glb --tam map.exr --animate haloes=1..9
animate-line-width film teapot.glb --tam map.exr --animate line-width=1..4
animate-from film teapot.glb --tam map.exr --animate from=-20:0..40:40
animate-fov film teapot.glb --tam map.exr --animate fov=10..50 --camera 1,2,6:0,0,0
animate-zoom film teapot.glb -t rptam --animate zoom=1..65536
animate-several film teapot.glb -t rptam --turntable --animate zoom=1..4 --animate overlap=0..1 --animate light=0:0..9:9
zoom-out draw teapot.glb -t rptam --zoom 0.2
zoom-tam draw teapot.glb --tam map.exr --zoom 40
zoom-gouraud draw lapped.glb -t gouraud --zoom 1048576 --lines all
zoom-10 draw teapot.glb -t rptam --zoom 1024
zoom-20 draw teapot.glb -t rptam --zoom 1048576 --size 240x180 --from 10:60
zoom-30 draw teapot.glb -t rptam --zoom 1073741824
zoom-40 draw plane.glb -t rptam --zoom 1099511627776 --samples 1
zoom-lapped-10 draw lapped.glb -t rptam --zoom 1024 --from -60:10
zoom-lapped-30 draw lapped.glb -t rptam --zoom 1073741824
zoom-skinned draw skinned.gltf -t rptam --zoom 65536 --time-s 0.4
zoom-lapped-skinned draw skinned.lapped.glb -t rptam --zoom 1e6 --time-s 0.4
zoom-turned draw teapot.glb -t rptam --zoom 1e7 --hatch-turn 25 --hatch-scale 1.5
zoom-orthographic draw cameras.gltf -t rptam --camera 1 --zoom 1e6
zoom-camera draw ball.glb -t rptam --camera 0.0001,0.0002,1.0000001:0,0,0
zoom-shadows draw teapot.glb -t rptam --zoom 4096 --shadows 0.05 --pixel-light --haloes 3
zoom-holes draw masked.gltf -t rptam --zoom 3000 --texture-tone --from 0:0
zoom-modulate draw ball.glb -t rptam --zoom 100000 --modulate texture.png --from 0:0
zoom-strokes draw teapot.glb -t strokes --zoom 1048576 --size 240x180
zoom-strokes-lapped draw lapped.glb -t strokes --zoom 1024 --from -60:10
zoom-edge draw plane.glb -t rptam --camera 1.000003,0,0.00001:1,0,0 --haloes 3
zoom-nodes draw nodes.gltf -t rptam --camera 0.5,0.3,8:0,0.2,0 --zoom 30000 --samples 1
zoom-nodes-lapped draw nodes.lapped.glb -t rptam --camera 0.5,0.3,8:0,0.2,0 --zoom 30000 --seed-loop brute --size 64x48
rptam-seeds draw teapot.glb -t rptam --seeds many.seeds
rptam-layers draw teapot.glb -t rptam --layers two.layers
rptam-layers-seeds draw lapped.glb -t rptam --layers two.layers --seeds two.seeds --seed-layers 1
rptam-stroke draw teapot.glb -t rptam --stroke 40x5 --stroke-ink 0.6 --stroke-turn 15
rptam-tile draw teapot.glb -t rptam --seed-tile 90 --seed-layers 2
rptam-none draw teapot.glb -t rptam --seed-layers 0
rptam-brute draw teapot.glb -t rptam --seed-loop brute
rptam-brute-lapped draw lapped.glb -t rptam --seed-loop brute --style crayon --fade paper
rptam-turned draw lapped.glb -t rptam --hatch-turn 40 --hatch-scale 0.7
rptam-inks draw lapped.glb -t rptam --style crayon --paper grey --ink black,white
rptam-tone draw teapot.glb -t rptam --tone-range 0.2:1 --tone-gamma 2
refused-rptam-map draw teapot.glb -t rptam --tam map.exr
refused-rptam-volume draw teapot.glb -t rptam --tam volume.ktx2
rptam-own-style draw teapot.glb -t rptam --style ./own.style
END
    for fade in even weighted paper; do
        for by in opacity size; do
            echo "rptam-fade-$fade-by-$by draw teapot.glb -t rptam --fade $fade --fade-by $by --overlap 0.6 --zoom 1.4"
        done
    done
    for style in pencil crayon charcoal stipple chalk; do
        echo "rptam-style-$style draw lapped.glb -t rptam --style $style --overlap 1"
    done
}

list_reports() {
    for map in layers bc4 colors rgba bc1 bc7; do
        echo "volume-$map draw ball.glb -t volume --tam $map.ktx2 --anisotropy 4"
    done
    cat <<'END'
volume-color-lapped draw lapped.glb -t volume --tam bc7.ktx2 --paper cream --shadows 0.05
volume-bc1-inks draw teapot.glb -t volume --tam bc1.ktx2 --paper grey --ink black,white
volume-modulate draw ball.glb -t volume --tam bc4.ktx2 --modulate texture.png --pixel-light
exact draw teapot.glb -t threshold --tam exact.ktx2
exact-soft draw teapot.glb -t threshold-soft --tam exact.ktx2 --anisotropy 8
exact-pixel draw bumpy.gltf -t threshold --tam exact.ktx2 --pixel-light --shadows 0.05
exact-modulate draw masked.gltf -t threshold --tam exact.ktx2 --texture-tone --samples 1
show-patches draw lapped.glb --show patches
show-patches-skinned draw skinned.lapped.glb --show patches --time-s 0.5 --lines all
show-patches-nodes draw nodes.lapped.glb --show patches --shadows 0.05
show-field draw field.glb --show field
show-field-skinned draw skinned.lapped.glb --show field --time-s 0.5
show-field-nodes draw nodes.lapped.glb --show field --texture-tone
show-field-near draw true.glb --show field --zoom 3
probe render-gl teapot.glb --tam map.exr --size 160x120 --probe
probe-json render-gl textured.gltf --tam map.exr --size 160x120 --probe --json
probe-lapped render-gl lapped.glb --tam map.exr --size 160x120 --probe --texture-tone -o probe.tsv
probe-holes render-gl masked.gltf --tam map.exr --size 160x120 --probe --anisotropy 4
probe-nodes render-gl nodes.gltf lamps-all.gltf --tam eight.exr --size 160x120 --probe --samples 1
needs render-gl teapot.glb --size 160x120 --needs
needs-frames render-gl skinned.gltf --size 160x120 --needs --frames 3 --tolerance 0.1 --ink black,white --json
needs-lapped render-gl lapped.glb --size 160x120 --needs --texture-tone --pixel-light
probe-triple render-gl teapot.glb -t tam-triple --tam color.exr --size 160x120 --probe
time render-gl teapot.glb --tam map.exr --size 96x72 --time 2 | without_ms
times render-gl teapot.glb --tam map.exr --size 96x72 --times - -o /dev/null | without_ms
time-triple render-gl lapped.glb -t tam-triple --tam map.exr --size 96x72 --time 2 --shadows 0.05 --haloes 3 | without_ms
time-rptam render-gl teapot.glb -t rptam --size 96x72 --time 1 --lines none --zoom 4096 | without_ms
time-json render-gl lapped.glb -t volume --tam volume.ktx2 --size 96x72 --time 2 --json | grep -oE '"(technique|span)": "[^"]*"'
time-tile render-gl ball.glb -t gouraud --size 2100x16 --time 1 | without_ms
time-field render-gl field.glb --show field --size 96x72 --time 1 | without_ms
END
}

# Scenes and options that render-gl refuses, or draws with a warning.
list_refusals() {
    cat <<'END'
refused-no-map draw teapot.glb
refused-no-file draw gone.glb --tam map.exr
refused-no-scene draw map.exr --tam map.exr
refused-texcoords draw bare.obj --tam map.exr
refused-patches draw teapot.glb --show patches
refused-field draw teapot.glb --show field
refused-show-technique draw field.glb --show field -t tam
refused-show-probe draw field.glb --show field --probe
refused-camera draw cameras.gltf --tam map.exr --camera 2
refused-camera-word draw cameras.gltf --tam map.exr --camera 1,2
refused-camera-from draw cameras.gltf --tam map.exr --camera 1 --from 3:4
refused-camera-flat sed 's/"camera":0/"scale":[0,0,0],&/' cameras.gltf >bad.gltf; draw bad.gltf --tam map.exr
refused-camera-on-it draw teapot.glb --tam map.exr --camera 0,1,2:0,1,2
refused-animation draw skinned.gltf --tam map.exr --animation 2
refused-ink draw teapot.glb --tam map.exr --ink blak
refused-paper draw teapot.glb --tam map.exr --paper '#12345'
refused-lines draw teapot.glb --tam map.exr --lines edges
refused-uv-scale draw teapot.glb --tam map.exr --uv-scale 0
refused-samples draw teapot.glb --tam map.exr --samples 5
refused-size draw teapot.glb --tam map.exr --size 32.5x24
refused-specular draw teapot.glb --tam map.exr --specular 11:3
refused-shadows draw teapot.glb --tam map.exr --shadows 0
refused-haloes draw teapot.glb --tam map.exr --haloes 33
refused-frames draw teapot.glb --tam map.exr --frames 2
refused-turntable draw teapot.glb --tam map.exr --turntable
refused-pattern film teapot.glb --tam map.exr -o '%s%d.png'
refused-ending draw teapot.glb --tam map.exr -o picture.jpg
refused-folder draw teapot.glb --tam map.exr -o gone/picture.png
refused-animate-word film teapot.glb -t rptam --animate zoom=2
refused-animate-name film teapot.glb -t rptam --animate nib=1..2
refused-animate-range film teapot.glb -t rptam --animate overlap=0..2
refused-animate-pair film teapot.glb -t rptam --animate stroke=9x1..9
refused-animate-factor film teapot.glb -t rptam --animate exposure=0..2
refused-animate-twice film teapot.glb -t rptam --animate fov=9..20 --animate fov=20..9
refused-animate-seeds film teapot.glb --tam map.exr --animate overlap=0..1
refused-animate-strokes film teapot.glb -t gouraud --animate hatch-turn=0..9
refused-animate-lines film teapot.glb -t gouraud --animate line-width=1..2
refused-animate-one draw teapot.glb -t rptam --animate zoom=1..2
refused-seeds-option draw teapot.glb --tam map.exr --style pencil
refused-pixel-light draw teapot.glb -t tam-flat --tam map.exr --pixel-light
refused-modulate draw teapot.glb --tam map.exr --modulate texture.png --texture-tone
refused-modulate-file draw teapot.glb --tam map.exr --modulate map.tsv
refused-probe draw teapot.glb -t rptam --probe
refused-probe-volume draw teapot.glb --tam volume.ktx2 -t volume --probe
refused-probe-time draw teapot.glb --tam map.exr --probe --time 2
refused-json draw teapot.glb --tam map.exr --json
refused-volume-map draw teapot.glb -t volume --tam map.exr
refused-volume-exact draw teapot.glb -t volume --tam exact.ktx2
refused-threshold-volume draw teapot.glb -t threshold --tam volume.ktx2
refused-tam-volume draw teapot.glb --tam volume.ktx2
refused-volume-texture tampack -q --layout array map.exr -o array.ktx2; draw teapot.glb -t volume --tam array.ktx2
refused-map-cut head -c 3000 map.exr >cut.exr; draw teapot.glb --tam cut.exr
refused-volume-cut head -c 3000 exact.ktx2 >cut.ktx2; draw teapot.glb -t threshold --tam cut.ktx2
refused-style draw teapot.glb -t rptam --style gone
refused-seeds draw teapot.glb -t rptam --seeds map.tsv
refused-layers-seeds draw teapot.glb -t rptam --layers two.layers --seeds one.seeds
refused-no-seeds draw teapot.glb -t rptam --seeds /dev/null
refused-many-seeds seedgen -n 4 --layers 65 -o new.seeds; draw teapot.glb -t rptam --seeds new.seeds
refused-layers printf 'nib 3\n' >bad.layers; draw teapot.glb -t rptam --layers bad.layers
refused-long draw teapot.glb -t rptam --stroke 900x2 --seed-tile 100
refused-memory draw teapot.glb --tam map.exr --size 65536x65536 --max-memory 100M
refused-shaders draw teapot.glb --tam map.exr --shader-dir gone
refused-shader with_shaders sh -c "sed -i 's/void main()/void main(/' \$(find shaders -name tam.frag); render-gl --shader-dir shaders -T map.exr teapot.glb"
refused-driver MESA_GL_VERSION_OVERRIDE=3.3 draw teapot.glb --tam map.exr
refused-display unset DISPLAY WAYLAND_DISPLAY; draw teapot.glb --tam map.exr --window
refused-texture sed 's/ridges.png/map.tsv/' bumpy.gltf >bad.gltf; draw bad.gltf -t gouraud --pixel-light
refused-texture-grey sed 's/ridges.png/grey.png/' bumpy.gltf >bad.gltf; draw bad.gltf -t gouraud --pixel-light
warned-texture sed 's/ridges.png/gone.png/' bumpy.gltf >bad.gltf; draw bad.gltf -t gouraud --pixel-light
warned-empty draw empty.gltf -t gouraud
warned-faulty draw faulty.obj -t gouraud --lines all
warned-far draw far.obj -t gouraud --lines all
END
}

# The other commands.
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
strokegen-lapped strokegen lapped.glb --levels 3
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
    for part in ${PARTS:-techniques pictures seeds reports refusals maps meshes windows help}; do
        "list_$part"
    done
}
