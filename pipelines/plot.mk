# Draws a mesh or a scene for a pen plotter: an SVG drawing of its feature lines on a page.
#
#     make -f plot.mk SCENE=bunny.ply                                bunny.svg on A4 paper
#     make -f plot.mk SCENE=engine.glb PAGE=a3 PEN=0.5mm HIDDEN=dash
#     make -f plot.mk SCENE=walk.glb FRAMES=12 OUT=film              film/walk-000.svg ... film/walk-011.svg
#     make -f plot.mk SCENE=bunny.ply TURN=12                        once around it: bunny-000.svg ... bunny-011.svg
#     make -f plot.mk SCENE=bunny.ply OPTIONS='--from 60:10 --crease 60'
#
# Editors show each pen as a layer. The commands are found on PATH. Copy this file and change it.
SCENE   ?= $(error SCENE=FILE names the mesh or scene to draw)
PAGE    ?= a4
MARGIN  ?= 10mm
PEN     ?= 0.3mm
HIDDEN  ?= remove
SIZE    ?= 1280x960
FRAMES  ?= 0
TURN    ?= 0
OUT     ?= .
OPTIONS ?=

$(if $(word 2,$(OUT)),$(error OUT=$(OUT): make cannot write into a folder whose name has a space))
$(if $(filter-out 0,$(TURN)),$(if $(filter-out 0,$(FRAMES)),$(error TURN and FRAMES: both films would have one name)))
SHELL := /bin/bash
.SHELLFLAGS := -eo pipefail -c
.DELETE_ON_ERROR:

# A word for the shell, whatever characters it has.
quoted = '$(subst ','\'',$(1))'
draw = render-gl --page $(PAGE) --margin $(MARGIN) --pen $(PEN) --hidden $(HIDDEN) --size $(SIZE) $(OPTIONS)
film := $(if $(filter-out 0,$(TURN)),--frames $(TURN) --turntable,$(if $(filter-out 0,$(FRAMES)),--frames $(FRAMES)))
# The shell computes the name, because make would split a file name at spaces.
name = name=$$(basename -- $(call quoted,$(SCENE))) && name="$(OUT)/$${name%.*}"

.PHONY: drawing
drawing:
	mkdir -p $(OUT)
ifeq ($(film),)
	$(name) && $(draw) -o "$$name.svg" $(call quoted,$(SCENE))
else
	$(name) && $(draw) $(film) -o "$${name//\%/%%}-%03d.svg" $(call quoted,$(SCENE))
endif
