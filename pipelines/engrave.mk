# Draws any surface with strokes traced on it, as an engraver would, and the same strokes for a pen.
#
#     make -f engrave.mk MESH=bunny.ply                       bunny.png
#     make -f engrave.mk MESH=bunny.ply PAGE=a4 PEN=0.3mm     also for a plotter: bunny.svg
#     make -f engrave.mk MESH=bunny.ply TURN=90               also once around it: bunny-000.png ... bunny-089.png
#     make -f engrave.mk MESH=walk.glb FRAMES=48              the scene's animation: walk-000.png ...
#     make -f engrave.mk MESH=model.glb STROKES='--angles 0,90 --levels 7' WIDTH=2 OPTIONS='--from 40:20'
#
# dirfield computes the directions, strokegen traces strokes along them, render-gl draws. The commands are found on PATH.
# Copy this file and change it.
MESH    ?= $(error MESH=FILE names the mesh or scene to draw)
SIZE    ?= 1280x720
WIDTH   ?=
PAGE    ?=
MARGIN  ?= 10mm
PEN     ?= 0.3mm
TURN    ?= 0
FRAMES  ?= 0
OUT     ?= .
FIELD   ?=
STROKES ?=
OPTIONS ?=

$(if $(word 2,$(OUT)),$(error OUT=$(OUT): make cannot write into a folder whose name has a space))
$(if $(filter-out 0,$(TURN)),$(if $(filter-out 0,$(FRAMES)),$(error TURN and FRAMES: both films would have one name)))
SHELL := /bin/bash
.SHELLFLAGS := -eo pipefail -c
.DELETE_ON_ERROR:

# A word for the shell, whatever characters it has.
quoted = '$(subst ','\'',$(1))'
draw = render-gl --technique traced --size $(SIZE) $(OPTIONS)
# WIDTH is that of the strokes of pictures, in pixels; drawings have that of PEN.
wide = $(if $(WIDTH),--stroke-width $(WIDTH))
# The shell computes the name, because make would split a file name at spaces.
name = name=$$(basename -- $(call quoted,$(MESH))) && name="$(OUT)/$${name%.*}"

.PHONY: picture
picture:
	mkdir -p $(OUT)
	$(name) && dirfield $(FIELD) $(call quoted,$(MESH)) | strokegen $(STROKES) -o "$$name.strokes.glb"
	$(name) && $(draw) $(wide) -o "$$name.png" "$$name.strokes.glb"
ifneq ($(PAGE),)
	$(name) && $(draw) --page $(PAGE) --margin $(MARGIN) --pen $(PEN) -o "$$name.svg" "$$name.strokes.glb"
endif
ifneq ($(filter-out 0,$(TURN)),)
	$(name) && $(draw) $(wide) --frames $(TURN) --turntable -o "$${name//\%/%%}-%03d.png" "$$name.strokes.glb"
endif
ifneq ($(filter-out 0,$(FRAMES)),)
	$(name) && $(draw) $(wide) --frames $(FRAMES) -o "$${name//\%/%%}-%03d.png" "$$name.strokes.glb"
endif
