# Draws a glTF scene with strokes: one picture, the frames of its animation, or a turntable.
#
#     make -f gltf.mk SCENE=duck.glb
#     make -f gltf.mk SCENE=walk.glb FRAMES=48 STYLE=pencil      walk-000.png ... walk-047.png
#     make -f gltf.mk SCENE=duck.glb TURN=90 STYLE=./my.style    once around it: duck-000.png ... duck-089.png
#
# The surfaces of the scene need texture coordinates, which strokes follow. The commands are found on PATH.
# Copy this file and change it.
SCENE     ?= $(error SCENE=FILE names the scene to draw)
STYLE     ?= ink
TECHNIQUE ?= tam
SIZE      ?= 1280x720
FRAMES    ?= 0
TURN      ?= 0
SEED      ?= 1
OUT       ?= .
OPTIONS   ?=

$(if $(word 2,$(OUT)),$(error OUT=$(OUT): make cannot write into a folder whose name has a space))
$(if $(filter-out 0,$(TURN)),$(if $(filter-out 0,$(FRAMES)),$(error TURN and FRAMES: both films would have one name)))
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
# The name of the map tells its style and seed, so that each has a map of its own.
map := $(OUT)/$(subst /,-,$(STYLE:./%=%))$(if $(filter-out 1,$(SEED)),-$(SEED)).tam.exr
draw = render-gl --technique $(TECHNIQUE) --tam "$(map)" --size $(SIZE) $(OPTIONS)
film := $(if $(filter-out 0,$(TURN)),--frames $(TURN) --turntable,$(if $(filter-out 0,$(FRAMES)),--frames $(FRAMES)))
# The shell computes the name, because make would split a file name at spaces.
name = name=$$(basename -- $(call quoted,$(SCENE))) && name="$(OUT)/$${name%.*}"

.PHONY: picture
picture: $(map)
ifeq ($(film),)
	$(name) && $(draw) -o "$$name.png" $(call quoted,$(SCENE))
else
	$(name) && $(draw) $(film) -o "$${name//\%/%%}-%03d.png" $(call quoted,$(SCENE))
endif

$(map): $(style) $(image)
	mkdir -p $(OUT)
	tamgen --style $(STYLE) --size 512 --seed $(SEED) -o $@
