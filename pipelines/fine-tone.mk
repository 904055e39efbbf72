# Draws one shape with one map of 255 tones in three ways: six columns blended, as a volume, as threshold textures.
# (Webb et al., "Fine Tone Control in Hardware Hatching", Figure 4.)
#
#     make -f fine-tone.mk                                     fine-tam.png fine-volume.png fine-threshold.png
#     make -f fine-tone.mk STYLE=wash COLOUR=1                 fine-volume.png only: threshold textures have no colour
#     make -f fine-tone.mk SHAPE='sphere --uv whole' MODULATE=earth.jpg OPTIONS='--tone-gamma 4 --pixel-light'
#     make -f fine-tone.mk SCENE=model.glb                     your own scene
#
# The commands are found on PATH. Copy this file and change it.
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

$(if $(word 2,$(OUT)),$(error OUT=$(OUT): make cannot write into a folder whose name has a space))
SHELL := /bin/bash
.SHELLFLAGS := -eo pipefail -c
.DELETE_ON_ERROR:

# A word for the shell, whatever characters it has.
quoted = '$(subst ','\'',$(1))'
# A style that is a file, and the image that its brush names, which lies beside it.
style := $(if $(findstring .,$(STYLE))$(findstring /,$(STYLE)),$(STYLE))
image := $(if $(wildcard $(style)),$(shell awk -F'\043' '{print $$1}' $(style) | \
    sed -n 's/^[[:space:]]*brush[[:space:]]\{1,\}image[[:space:]]\{1,\}//p' | \
    sed '$$!d; s/[[:space:]]*$$//; s|^[^/]|$(dir $(style))&|; s/ /\\ /g'))
base  := $(OUT)/fine-$(notdir $(STYLE))
map   := $(base).tam.exr
scene := $(if $(SCENE),$(call quoted,$(SCENE)),$(OUT)/fine.glb)
light := $(if $(MODULATE),--modulate $(call quoted,$(MODULATE)))
draw   = render-gl $(scene) --technique $(1) --tam "$(2)" --size $(SIZE) $(light) $(OPTIONS) -o $@

# This file holds the variables from which intermediate files are made, and the times and sizes of files that they name,
# such as a palette; it is rewritten when one of them changes.
words  := $(OUT)/fine.words
named  := $(wildcard $(STYLE) $(TAM))
stamps := $(if $(named),$(shell stat -L -c %.9Y:%s -- $(named)))
wanted := $(SHAPE); $(STYLE) $(TONES) $(SEED) $(TAM) $(stamps); $(VOLUME); $(BINS)

.PHONY: all always
all: $(if $(COLOUR),,$(OUT)/fine-tam.png $(OUT)/fine-threshold.png) $(OUT)/fine-volume.png

$(OUT)/fine-tam.png: $(map) $(if $(SCENE),,$(OUT)/fine.glb) always
	$(call draw,tam,$(map)) --quiet
$(OUT)/fine-volume.png: $(base).volume.ktx2 $(if $(SCENE),,$(OUT)/fine.glb) always
	$(call draw,volume,$<)
$(OUT)/fine-threshold.png: $(base).thresholds.ktx2 $(if $(SCENE),,$(OUT)/fine.glb) always
	$(call draw,threshold,$<)

%.volume.ktx2: %.tam.exr
	tamvol $(VOLUME) $< -o $@
%.thresholds.ktx2: %.tam.exr
	tamthresh $(BINS) $< -o $@
$(map): $(words) $(style) $(image)
	tamgen --style $(STYLE) --tones $(TONES) --seed $(SEED) $(TAM) -o $@
$(OUT)/fine.glb: $(words)
	meshgen $(SHAPE) -o $@
$(words): always
	@mkdir -p $(OUT)
	@printf '%s\n' $(call quoted,$(wanted)) | cmp -s - $@ || printf '%s\n' $(call quoted,$(wanted)) >$@
