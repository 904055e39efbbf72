# Draws one place of a model at four distances, each 16 times nearer than the one before, with strokes that
# keep their size: zoom-0.png to zoom-3.png. With FRAMES also the frames of one octave of the zoom.
#
#     make -f rptam.mk                                       the teapot
#     make -f rptam.mk STYLE=pencil LAYERS=3 SEEDS=100
#     make -f rptam.mk FRAMES=48                             zoom-way-000.png ..., which can be looped
#     make -f rptam.mk FRAMES=48 OPTIONS='--animate stroke=20x1..60x2'
#     make -f rptam.mk MODEL=horse.glb CAMERA=1,1,6:0,0,0 NEAREST=1000000
#
# CAMERA is the position of the camera and the point it looks at, in the coordinates of the model; the zoom leads to the
# point of the surface in the middle of the picture. The model needs texture coordinates; dirfield and lapped-param make
# them. The commands are found on PATH. Copy this file and change it.
MODEL   ?= $(OUT)/teapot.glb
CAMERA  ?= 0.9,0.8,5.42:0,0.1,1.02
NEAREST ?= 4096
STYLE   ?= ink
SEEDS   ?= 64
LAYERS  ?= 4
SEED    ?= 1
SIZE    ?= 480x300
FRAMES  ?= 0
OUT     ?= .
OPTIONS ?=

$(if $(word 2,$(OUT)),$(error OUT=$(OUT): make cannot write into a folder whose name has a space))
SHELL := /bin/bash
.SHELLFLAGS := -eo pipefail -c
.DELETE_ON_ERROR:

# A word for the shell, whatever characters it has.
quoted = '$(subst ','\'',$(1))'
sets := $(OUT)/$(notdir $(STYLE))-$(SEEDS)x$(LAYERS)-$(SEED).seeds
draw = render-gl --technique rptam --style $(STYLE) --seeds "$(sets)" --size $(SIZE) --camera $(CAMERA) $(OPTIONS) \
    $(call quoted,$(MODEL))

.PHONY: strip
strip: $(sets) $(filter $(OUT)/teapot.glb,$(MODEL))
	$(draw) --frames 4 --animate zoom=1..$(NEAREST) -o "$(OUT)/zoom-%d.png"
ifneq ($(filter-out 0,$(FRAMES)),)
	$(draw) --frames $(FRAMES) -o "$(OUT)/zoom-way-%03d.png" \
	    --animate zoom=64..$$(awk 'BEGIN {printf "%.9g", 128 * 2 ^ (-1 / $(FRAMES))}')
endif

$(sets):
	mkdir -p $(OUT)
	seedgen -n $(SEEDS) --layers $(LAYERS) --seed $(SEED) -o $@
$(OUT)/teapot.glb:
	mkdir -p $(OUT)
	meshgen teapot --faces 50000 -o $@
