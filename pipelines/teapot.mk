# Draws the teapot with strokes: makes the shape and a tonal art map from a style, then the picture.
#
#     make -f teapot.mk                           teapot.png, in ink
#     make -f teapot.mk STYLE=charcoal OUT=/tmp   another style, in another folder
#
# The commands are found on PATH. Copy this file and change it.
STYLE     ?= ink
TECHNIQUE ?= tam
SIZE      ?= 1280x720
SEED      ?= 1
OUT       ?= .

$(if $(word 2,$(OUT)),$(error OUT=$(OUT): make cannot write into a folder whose name has a space))
SHELL := /bin/bash
.SHELLFLAGS := -eo pipefail -c
.DELETE_ON_ERROR:

# A style that is a file, and the image that its brush names, which lies beside it.
style := $(if $(findstring .,$(STYLE))$(findstring /,$(STYLE)),$(STYLE))
image := $(if $(wildcard $(style)),$(shell awk -F'\043' '{print $$1}' $(style) | \
    sed -n 's/^[[:space:]]*brush[[:space:]]\{1,\}image[[:space:]]\{1,\}//p' | \
    sed '$$!d; s/[[:space:]]*$$//; s|^[^/]|$(dir $(style))&|; s/ /\\ /g'))
# The name of the map tells its style and seed, so that each has a map of its own.
map := $(OUT)/$(subst /,-,$(STYLE:./%=%))$(if $(filter-out 1,$(SEED)),-$(SEED)).tam.exr

.PHONY: picture
picture: $(OUT)/teapot.glb $(map)
	render-gl --technique $(TECHNIQUE) --tam "$(map)" --size $(SIZE) -o $(OUT)/teapot.png $<

$(OUT)/teapot.glb:
	mkdir -p $(OUT)
	meshgen teapot --faces 20000 -o $@

$(map): $(style) $(image)
	mkdir -p $(OUT)
	tamgen --style $(STYLE) --size 512 --seed $(SEED) -o $@
