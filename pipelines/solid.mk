# Draws a scene carved from a solid texture: one of solidgen's styles, or one made from a picture.
#
#     make -f solid.mk MESH=teapot.glb                             teapot.png, painted on paper
#     make -f solid.mk MESH=teapot.glb STYLE=stipple LOOK=binary   in dots
#     make -f solid.mk MESH=teapot.glb EXEMPLAR=bricks.jpg LOOK=plain    a texture made from a picture
#     make -f solid.mk MESH=teapot.glb TURN=90                     also once around it: teapot-000.png ... teapot-089.png
#     make -f solid.mk MESH=walk.glb FRAMES=48                     the scene's animation: walk-000.png ...
#     make -f solid.mk MESH=model.glb OPTIONS='--inks "#8a2a10,#184a7a" --ground 4'
#
# The commands are found on PATH. Copy this file and change it.
MESH     ?= $(error MESH=FILE names the mesh or scene to draw)
STYLE    ?= paper
EXEMPLAR ?=
METHOD   ?= kopf
LOOK     ?= watercolor
SOLID    ?= 128
SIZE     ?= 1280x720
TURN     ?= 0
FRAMES   ?= 0
OUT      ?= .
OPTIONS  ?=

$(if $(word 2,$(OUT)),$(error OUT=$(OUT): make cannot write into a folder whose name has a space))
$(if $(filter-out 0,$(TURN)),$(if $(filter-out 0,$(FRAMES)),$(error TURN and FRAMES: both films would have one name)))
SHELL := /bin/bash
.SHELLFLAGS := -eo pipefail -c
.DELETE_ON_ERROR:

# A word for the shell, whatever characters it has.
quoted = '$(subst ','\'',$(1))'
how := $(if $(EXEMPLAR),--exemplar $(call quoted,$(EXEMPLAR)) --method $(METHOD),--style $(STYLE)) --size $(SOLID)
# The shell computes the names, because make would split a file name at spaces.
name = name=$$(basename -- $(call quoted,$(MESH))) && name="$(OUT)/$${name%.*}" && solid="$$name.solid.ktx2"
draw = render-gl $(call quoted,$(MESH)) --technique solid --solid "$$solid" --look $(LOOK) --size $(SIZE) $(OPTIONS)

.PHONY: picture
picture:
	mkdir -p $(OUT)
	$(name) && solidgen $(how) -o "$$solid"
	$(name) && $(draw) -o "$$name.png"
ifneq ($(filter-out 0,$(TURN)),)
	$(name) && $(draw) --frames $(TURN) --turntable -o "$${name//\%/%%}-%03d.png"
endif
ifneq ($(filter-out 0,$(FRAMES)),)
	$(name) && $(draw) --frames $(FRAMES) -o "$${name//\%/%%}-%03d.png"
endif
