# Runs of render-gl for list.sh.

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

# Solid textures, and pictures painted in watercolour.
list_solids() {
    cat <<'END'
solid-plain draw teapot.glb -t solid --solid ridges.ktx2
solid-plain-light-ink draw torus.glb -t solid --solid ridges.ktx2 --paper black --ink white --lines none
solid-plain-inks draw torus.glb -t solid --solid ridges.ktx2 --paper grey --ink black,white --samples 1
solid-color draw ball.glb -t solid --solid tones.ktx2 --solid-size 30 --solid-turn 20,40,60
solid-blend draw teapot.glb -t solid --solid ridges.ktx2 --blend linear --solid-size 20
solid-binary draw teapot.glb -t solid --solid dots.ktx2 --look binary
solid-binary-few draw plane.glb -t solid --solid two.ktx2 --look binary --from 40:30
solid-binary-picture draw ball.glb -t solid --solid grey.png --look binary
solid-lapped draw lapped.glb -t solid --solid grey.png --look binary --from -60:10
solid-watercolor draw teapot.glb torus.glb -t solid --solid ridges.ktx2 --look watercolor --ink '#205080' --size 240x90
solid-watercolor-cyan draw torus.glb -t solid --solid dots.ktx2 --look watercolor --ink '#00ffff' --paper-grain 1
solid-collage draw teapot.glb -t solid --solid ridges.ktx2,dots.ktx2,two.ktx2 --look collage --bands 3 --ink '#203040'
solid-skinned film skinned.gltf -t solid --solid ridges.ktx2 --rate 4
solid-nodes draw nodes.gltf -t solid --solid dots.ktx2 --look binary --specular 1:8
solid-shadows draw lamps-all.gltf -t solid --solid ridges.ktx2 --shadows 0.05 --ground 2
solid-zoom film teapot.glb -t solid --solid ridges.ktx2 --animate zoom=1..4096
solid-animate film torus.glb -t solid --solid ridges.ktx2 --look watercolor --animate solid-size=20..40
painted-rptam draw teapot.glb -t rptam --look watercolor --ink '#8a2a10'
painted-gouraud draw torus.glb -t gouraud --look watercolor --ink '#ffff00' --lines none
painted-wide draw torus.glb -t gouraud --look watercolor --size 1100x40
END
}
