# Draws the teapot with strokes, from nothing: shape, style, tonal art map, picture.
#
#     make -f teapot.mk                           teapot.png, in ink
#     make -f teapot.mk STYLE=charcoal OUT=/tmp   another style, elsewhere
#
# The commands are looked for on PATH. Copy this file and change it.
STYLE     ?= ink
TECHNIQUE ?= tam
SIZE      ?= 1280x720
SEED      ?= 1
OUT       ?= .

SHELL := /bin/bash
.SHELLFLAGS := -eo pipefail -c
.DELETE_ON_ERROR:

$(OUT)/teapot.png: $(OUT)/teapot.glb $(OUT)/$(STYLE).tam.exr
	render-gl --technique $(TECHNIQUE) --tam $(OUT)/$(STYLE).tam.exr --size $(SIZE) -o $@ $<

$(OUT)/teapot.glb:
	mkdir -p $(OUT)
	meshgen teapot --faces 20000 -o $@

$(OUT)/%.tam.exr:
	mkdir -p $(OUT)
	tamgen --style $* --size 512 --seed $(SEED) -o $@
