# Draws a scene with strokes that are fitted in the picture to those of a texture, and the same strokes for a pen.
#
#     make -f strokes.mk MESH=teapot.glb                        teapot.png, by the style of --style
#     make -f strokes.mk MESH=teapot.glb STYLE=pencil OVERDRAW=12
#     make -f strokes.mk MESH=teapot.glb PAGE=a4 PEN=0.3mm      also for a plotter: teapot.svg
#     make -f strokes.mk MESH=teapot.glb TURN=90                also once around it: teapot-000.png ... teapot-089.png
#     make -f strokes.mk MESH=walk.glb FRAMES=48                the scene's animation: walk-000.png ...
#     make -f strokes.mk MESH=model.glb OPTIONS='--stroke 120x3 --from 40:20'
#
# The meshes need texture coordinates. The commands are found on PATH. Copy this file and change it.
MESH     ?= $(error MESH=FILE names the mesh or scene to draw)
STYLE    ?= ink
OVERDRAW ?= 4
SIZE     ?= 1280x720
PAGE     ?=
MARGIN   ?= 10mm
PEN      ?= 0.3mm
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
draw = render-gl $(call quoted,$(MESH)) --technique strokes --style $(STYLE) --overdraw $(OVERDRAW) --size $(SIZE) $(OPTIONS)
# The shell computes the name, because make would split a file name at spaces.
name = name=$$(basename -- $(call quoted,$(MESH))) && name="$(OUT)/$${name%.*}"

.PHONY: picture
picture:
	mkdir -p $(OUT)
	$(name) && $(draw) -o "$$name.png"
ifneq ($(PAGE),)
	$(name) && $(draw) --page $(PAGE) --margin $(MARGIN) --pen $(PEN) -o "$$name.svg"
endif
ifneq ($(filter-out 0,$(TURN)),)
	$(name) && $(draw) --frames $(TURN) --turntable -o "$${name//\%/%%}-%03d.png"
endif
ifneq ($(filter-out 0,$(FRAMES)),)
	$(name) && $(draw) --frames $(FRAMES) -o "$${name//\%/%%}-%03d.png"
endif
