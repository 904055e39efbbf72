# One shape, one map of 255 tones, three ways to draw it: six columns blended, as a volume, by thresholds.
# (Webb et al., "Fine Tone Control in Hardware Hatching", Figure 4.)
#
#     make -f fine-tone.mk                                     fine-tam.png fine-volume.png fine-threshold.png
#     make -f fine-tone.mk STYLE=wash COLOUR=1                 fine-volume.png alone: thresholds are grey
#     make -f fine-tone.mk SHAPE='sphere --uv whole' MODULATE=earth.jpg OPTIONS='--tone-gamma 4 --pixel-light'
#     make -f fine-tone.mk SCENE=model.glb                     a scene of yours
#
# The commands are looked for on PATH. Copy this file and change it.
SHAPE    ?= sphere
SCENE    ?=
STYLE    ?= ink
TONES    ?= 255
COLOUR   ?=
MODULATE ?=
SIZE     ?= 640x640
SEED     ?= 1
OUT      ?= .
TAM      ?=
VOLUME   ?=
BINS     ?=
OPTIONS  ?=

SHELL := /bin/bash
.SHELLFLAGS := -eo pipefail -c
.DELETE_ON_ERROR:

map   := $(OUT)/fine-$(STYLE).tam.exr
scene := $(if $(SCENE),"$(SCENE)",$(OUT)/fine.glb)
light := $(if $(MODULATE),--modulate "$(MODULATE)")
# --pixel-light is for the two that have a tone at every pixel.
wishes = $(if $(filter tam,$(1)),$(filter-out --pixel-light,$(OPTIONS)),$(OPTIONS))
draw   = render-gl $(scene) --technique $(1) --tam $(2) --size $(SIZE) $(light) $(wishes) -o $@

.PHONY: all
all: $(if $(COLOUR),,$(OUT)/fine-tam.png $(OUT)/fine-threshold.png) $(OUT)/fine-volume.png

$(OUT)/fine-tam.png: $(map) $(if $(SCENE),,$(OUT)/fine.glb)
	$(call draw,tam,$(map)) --quiet
$(OUT)/fine-volume.png: $(OUT)/fine-$(STYLE).volume.ktx2 $(if $(SCENE),,$(OUT)/fine.glb)
	$(call draw,volume,$<)
$(OUT)/fine-threshold.png: $(OUT)/fine-$(STYLE).thresholds.ktx2 $(if $(SCENE),,$(OUT)/fine.glb)
	$(call draw,threshold,$<)

%.volume.ktx2: %.tam.exr
	tamvol $(VOLUME) $< -o $@
%.thresholds.ktx2: %.tam.exr
	tamthresh $(BINS) $< -o $@
$(map):
	mkdir -p $(OUT)
	tamgen --style $(STYLE) --tones $(TONES) --seed $(SEED) $(TAM) -o $@
$(OUT)/fine.glb:
	mkdir -p $(OUT)
	meshgen $(SHAPE) -o $@
