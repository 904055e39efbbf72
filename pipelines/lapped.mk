# Draws any surface with strokes that follow its form, such as a scan or a model without texture coordinates.
#
#     make -f lapped.mk MESH=bunny.ply                        bunny.png
#     make -f lapped.mk MESH=bunny.ply STYLE=pencil TURN=90   also once around it: bunny-000.png ... bunny-089.png
#     make -f lapped.mk MESH=walk.glb FRAMES=48               the scene's animation: walk-000.png ...
#     make -f lapped.mk MESH=bunny.ply STYLE=./my.style       your own style
#     make -f lapped.mk MESH=scan.ply OPTIONS='--up z'        a scan whose z axis points up
#     make -f lapped.mk MESHES='bunny.ply horse.ply'          both in one picture: row.png
#     make -f lapped.mk MESH=bunny.ply FIELD='--direction min' LAPPED='--size .2' OPTIONS='--hatch-turn 30'
#
#     make -f lapped.mk MESH=scan.ply TURN=90 NEEDS=.01       patches no finer than these pictures, and only where they
#                                                             show the surface; OPTIONS must suit render-gl --needs
#
# dirfield computes the directions, lapped-param covers the surface with patches along them, render-gl draws.
# SHOW=1 also draws pictures of the directions and of the patches. The commands are found on PATH. Copy this
# file and change it.
MESH      ?= $(error MESH=FILE names the mesh to draw)
MESHES    ?=
STYLE     ?= ink
TECHNIQUE ?= tam
SIZE      ?= 1280x720
TURN      ?= 0
FRAMES    ?= 0
SHOW      ?=
SEED      ?= 1
OUT       ?= .
FIELD     ?=
LAPPED    ?=
NEEDS     ?=
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
# Needs of the views are measured before the patches are made.
$(if $(MESHES),$(if $(NEEDS)$(TURN:0=)$(FRAMES:0=)$(SHOW),$(error NEEDS, TURN, FRAMES and SHOW are for one MESH)))
views = $(if $(filter-out 0,$(TURN)),--turntable --frames $(TURN),$(if $(filter-out 0,$(FRAMES)),--frames $(FRAMES)))
measure = $(if $(NEEDS),render-gl --size $(SIZE) $(OPTIONS) $(views) --needs --tolerance $(NEEDS) \
    -o "$$name.needs" $(call quoted,$(1)) &&)
fit = $(if $(NEEDS),--needs "$$name.needs")
cover = $(measure) dirfield $(fit) $(FIELD) $(call quoted,$(1)) | lapped-param $(fit) --seed $(SEED) $(LAPPED)
# The shell computes the name, because make would split a file name at spaces.
name = name=$$(basename -- $(call quoted,$(1))) && name="$(OUT)/$${name%.*}"

.PHONY: all picture row
all: $(if $(MESHES),row,picture)

picture: $(map)
ifeq ($(TURN)$(FRAMES)$(SHOW),00)
	$(call name,$(MESH)) && $(call cover,$(MESH)) | $(draw) -o "$$name.png"
else
	$(call name,$(MESH)) && $(call cover,$(MESH)) -o "$$name.lapped.glb" && $(draw) -o "$$name.png" "$$name.lapped.glb"
ifneq ($(filter-out 0,$(TURN)),)
	$(call name,$(MESH)) && $(draw) --frames $(TURN) --turntable -o "$${name//\%/%%}-%03d.png" "$$name.lapped.glb"
endif
ifneq ($(filter-out 0,$(FRAMES)),)
	$(call name,$(MESH)) && $(draw) --frames $(FRAMES) -o "$${name//\%/%%}-%03d.png" "$$name.lapped.glb"
endif
ifneq ($(SHOW),)
	$(call name,$(MESH)) && for what in field patches; do \
	    render-gl --show $$what --size $(SIZE) $(OPTIONS) -o "$$name-$$what.png" "$$name.lapped.glb" || exit 1; done
endif
endif

# Several meshes are drawn side by side, all as large as the first.
lapped := $(foreach m,$(MESHES),$(OUT)/$(basename $(notdir $(m))).lapped.glb)
row: $(map) $(lapped)
	$(draw) -o "$(OUT)/row.png" $(lapped)
$(if $(filter-out $(words $(lapped)),$(words $(sort $(lapped)))),$(error MESHES=$(MESHES): two have one name))
# They are made anew, since the options may be others than the last time.
.PHONY: again
define lapped_rule
$(OUT)/$(basename $(notdir $(1))).lapped.glb: $(1) again
	mkdir -p $(OUT)
	$$(call cover,$(1)) -o $$@
endef
$(foreach m,$(MESHES),$(eval $(call lapped_rule,$(m))))

$(map): $(style) $(image)
	mkdir -p $(OUT)
	tamgen --style $(STYLE) --size 512 --seed $(SEED) -o $@
