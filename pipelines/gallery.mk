# Draws the pictures of the README with the commands on PATH.
#
#     make -f gallery.mk OUT=docs/pictures
#
# rptam.mk, fine-tone.mk and hatching.svg are taken from the folder of this file.
here := $(dir $(lastword $(MAKEFILE_LIST)))
OUT  ?= .
# Drawing for tamgen --replay; replay.png is left out if this file is missing.
DRAWING ?= $(here)hatching.svg
SIZE ?= 640x480

$(if $(word 2,$(OUT)),$(error OUT=$(OUT): make cannot write into a folder whose name has a space))
SHELL := /bin/bash
.SHELLFLAGS := -eo pipefail -c
.DELETE_ON_ERROR:

# Folder of large intermediate files; another one than OUT keeps them away from the pictures.
WORK   ?= $(OUT)
map     = $(WORK)/$(1).exr
pictures := engraving teapot torus ellipsoid stipple scratchboard grey threshold arcs speckle chalk
all: $(pictures:%=$(OUT)/%.png) $(if $(wildcard $(DRAWING)),$(OUT)/replay.png) $(OUT)/sheet.png \
    $(OUT)/zoom-0.png $(OUT)/fine-volume.png $(OUT)/scene.png $(OUT)/fitted-texture.png $(OUT)/fitted.png \
    $(OUT)/solid-watercolor.png $(OUT)/solid-binary.png $(OUT)/solid-collage.png $(OUT)/solid-hatched.png \
    $(OUT)/painted-traced.png $(OUT)/painted-rptam.png

comma := ,
draw = meshgen $(1) --faces 20000 | render-gl - --tam $(call map,$(2)) $(3) --size $(SIZE) -o $@

$(OUT)/engraving.png:
	mkdir -p $(OUT)
	meshgen teapot --faces 20000 | dirfield --smooth 1 | strokegen | render-gl - --technique traced --size 1280x720 -o $@
$(OUT)/teapot.png: SIZE := 1280x720
$(OUT)/teapot.png: $(call map,ink)
	$(call draw,teapot,ink)
$(OUT)/torus.png: $(call map,pencil)
	$(call draw,torus,pencil,--from 20:40)
$(OUT)/ellipsoid.png: $(call map,charcoal)
	$(call draw,ellipsoid,charcoal)
$(OUT)/stipple.png: $(call map,stipple)
	$(call draw,teapot,stipple)
$(OUT)/scratchboard.png: $(call map,ink)
	$(call draw,teapot,ink,--paper '#101018' --ink white)
$(OUT)/grey.png: $(call map,crayon)
	$(call draw,teapot,crayon,--paper '#a8a49c' --ink black$(comma)white)
$(OUT)/threshold.png: $(call map,ink)
	$(call draw,saddle,ink,--technique tam-threshold)

$(OUT)/arcs.png: $(call map,arcs)
	$(call draw,torus,arcs,--from 20:40)
$(OUT)/speckle.png: $(call map,speckle)
	$(call draw,teapot,speckle,--technique tam-triple)
$(OUT)/chalk.png: $(call map,chalk)
	$(call draw,ellipsoid,chalk,--paper '#b9b2a6' --ink black$(comma)white)
$(OUT)/replay.png: $(DRAWING)
	mkdir -p $(OUT)
	tamgen --replay $< --fit --quiet --size 128 --contact-sheet $@ -o /dev/null

$(OUT)/zoom-0.png:
	$(MAKE) -f "$(here)rptam.mk" OUT=$(WORK) OPTIONS='--seed-tile 160 --stroke 56x1.7'
	[ $(WORK) = $(OUT) ] || mv $(WORK)/zoom-?.png $(OUT)

$(OUT)/fitted-texture.png:
	mkdir -p $(OUT)
	meshgen teapot | render-gl - --technique rptam --size 640x400 -o $@
$(OUT)/fitted.png:
	mkdir -p $(OUT)
	meshgen teapot | render-gl - --technique strokes --overdraw 6 --size 640x400 -o $@

$(OUT)/fine-volume.png:
	$(MAKE) -f "$(here)fine-tone.mk" OUT=$(WORK) SIZE=480x480
	[ $(WORK) = $(OUT) ] || mv $(WORK)/fine-*.png $(OUT)

$(OUT)/scene.png:
	mkdir -p $(WORK) $(OUT)
	meshgen teapot -o $(WORK)/scene-teapot.glb
	meshgen cone -o $(WORK)/scene-cone.glb
	meshgen torus | dirfield | lapped-param -o $(WORK)/scene-torus.glb
	tamgen --tones 255 | tamvol -o $(WORK)/ink.volume.ktx2
	render-gl $(WORK)/scene-teapot.glb $(WORK)/scene-torus.glb $(WORK)/scene-cone.glb --ground 4 --technique volume \
	    --tam $(WORK)/ink.volume.ktx2 --shadows 0.03 --haloes 4 --light -50:40 --from 20:14 --size 960x540 -o $@

$(WORK)/%.exr:
	mkdir -p $(WORK) $(OUT)
	tamgen --style $* --size 512 -o $@
$(OUT)/sheet.png:
	mkdir -p $(OUT)
	tamgen --style ink --size 128 --contact-sheet $@ -o /dev/null

# Pictures of techniques, painted as watercolours.
$(OUT)/painted-traced.png:
	mkdir -p $(OUT)
	meshgen teapot --faces 20000 | dirfield --smooth 1 | strokegen | render-gl - --technique traced --look watercolor \
	    --ink '#4a2410' --size 640x400 -o $@
$(OUT)/painted-rptam.png:
	mkdir -p $(OUT)
	meshgen teapot | render-gl - --technique rptam --look watercolor --stroke 60x3 --ink '#8a2a10' --size 640x400 -o $@

# Shapes carved from solid textures, and a teapot from one whose slices look like hatching.
shape = $(WORK)/$(1).shape.glb
solid = $(WORK)/$(1).solid.ktx2
$(WORK)/%.shape.glb:
	mkdir -p $(WORK) $(OUT)
	meshgen $* -o $@
$(WORK)/%.solid.ktx2:
	mkdir -p $(WORK) $(OUT)
	solidgen --style $* $(if $(filter paper,$*),--size 128) -o $@
papers := canvas marble wood paper
$(OUT)/solid-watercolor.png: $(foreach s,teapot torus cone,$(call shape,$(s))) $(call solid,paper)
	render-gl $(filter %.glb,$^) --ground 4 --technique solid --solid $(call solid,paper) --look watercolor \
	    --inks '#8a2a10,#184a7a,#3a6a20,#c0a050' --shadows 0.03 --light -50:40 --from 20:14 --size 960x540 -o $@
$(OUT)/solid-binary.png: $(call shape,teapot) $(call solid,stipple)
	render-gl $< -t solid --look binary --solid $(call solid,stipple) --solid-size 66 --size 640x400 -o $@
$(OUT)/solid-collage.png: $(call shape,teapot) $(foreach s,$(papers),$(call solid,$(s)))
	render-gl $< -t solid --look collage --solid $(subst $() ,$(comma),$(filter %.ktx2,$^)) --bands 4 \
	    --paper '#c4b493' --ink '#182040' --size 640x400 -o $@
$(OUT)/solid-hatched.png: $(call shape,teapot)
	tamgen --style ink --size 128 -o $(WORK)/hatching.exr
	tampack --layout png $(WORK)/hatching.exr -o $(WORK)/columns
	cp $(WORK)/columns.003.00.png $(OUT)/solid-exemplar.png
	solidgen --exemplar $(OUT)/solid-exemplar.png --slices $(OUT)/solid-slices.png -o $(call solid,hatching)
	render-gl $< -t solid --solid $(call solid,hatching) --solid-size 90 --look binary --size 640x400 -o $@
