<<<<<<< HEAD
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
=======
# The demo: a shape, a tonal art map, a picture. Copy this file and change it:
#     make -f pipelines/teapot.mk STYLE=pencil SHAPE=torus
# The commands are taken from PATH, or from the build folder where there is one.
SHAPE := teapot
STYLE := ink
SIZE := 1280x720
RENDER := --samples 16 --anisotropy 8
OUT := build/demo

export PATH := $(CURDIR)/build/bin:$(PATH)
SHELL := /bin/bash
.SHELLFLAGS := -e -o pipefail -c
.DELETE_ON_ERROR:

$(OUT)/$(SHAPE).png: $(OUT)/$(SHAPE).glb $(OUT)/$(STYLE).tam.exr
	render-gl $< --tam $(OUT)/$(STYLE).tam.exr --size $(SIZE) $(RENDER) -o $@

$(OUT)/$(SHAPE).glb: | $(OUT)
	meshgen $(SHAPE) --uv even --faces 60000 -o $@

$(OUT)/%.tam.exr: | $(OUT)
	tamgen --style $* --size 512 -o $@

$(OUT):
	mkdir -p $@
>>>>>>> 05f9350 (make: demo, bench, chart; pipelines: the teapot, any glTF scene)
