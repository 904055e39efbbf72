# Draws a scene with the technique that hatchplan finds to be the best within bounds: measures, makes the files that the
# technique reads, and draws. Without TOLERANCE the tone is as exact as the budget allows, with it frames are as fast as
# possible.
#
#     make -f plan.mk MESH=teapot.glb BUDGET='ms=40 mb=4 s=5'    teapot.png, in at most 40 ms, from 4 MB, made in 5 s
#     make -f plan.mk MESH=teapot.glb TOLERANCE=.03              with a tone error of at most .03
#     make -f plan.mk MESH=bunny.ply TOLERANCE=.03 TURN=90       once around it: bunny-000.png ... bunny-089.png
#     make -f plan.mk MESH=walk.glb TOLERANCE=.03 FRAMES=48      the scene's animation: walk-000.png ...
#     make -f plan.mk MESH=model.glb BUDGET=mb=1 OPTIONS='--from 40:20 --techniques tam,volume,threshold'
#
# plan.chosen.mk holds the plan, and is made again when one of these variables changes, or a file that it was made from:
# the mesh, the buffers and images of a glTF, the file of a style, files that --draw names. The commands are found on
# PATH. Copy this file and change it.
MESH      ?= $(error MESH=FILE names the mesh or scene to draw)
BUDGET    ?=
TOLERANCE ?=
SIZE      ?= 1280x720
TURN      ?= 0
FRAMES    ?= 0
OUT       ?= .
OPTIONS   ?=

$(if $(word 2,$(OUT)),$(error OUT=$(OUT): make cannot write into a folder whose name has a space))
$(if $(filter-out 0,$(TURN)),$(if $(filter-out 0,$(FRAMES)),$(error TURN and FRAMES: both films would have one name)))
$(if $(BUDGET)$(TOLERANCE),,$(error BUDGET='ms=40 mb=4' or TOLERANCE=.03 tells what to choose by))
SHELL := /bin/bash
.SHELLFLAGS := -eo pipefail -c
.DELETE_ON_ERROR:

# A word for the shell, whatever characters it has.
quoted = '$(subst ','\'',$(1))'
film := $(if $(TURN:0=),--frames $(TURN) --turntable,$(if $(FRAMES:0=),--frames $(FRAMES)))
# The shell computes the name, because make would split a file name at spaces.
name = name=$$(basename -- $(call quoted,$(MESH))) && name="$(OUT)/$${name%.*}"

.PHONY: picture always
picture:

# This file holds the variables on which the plan depends; it is rewritten when they change.
words  := $(OUT)/plan.words
wanted := $(MESH); $(BUDGET); $(TOLERANCE); $(SIZE) $(film); $(OPTIONS)
$(words): always
	@mkdir -p $(OUT)
	@printf '%s\n' $(call quoted,$(wanted)) | cmp -s - $@ || printf '%s\n' $(call quoted,$(wanted)) >$@
$(OUT)/plan.chosen.mk: $(words)
	hatchplan $(if $(BUDGET),--budget '$(BUDGET)') $(if $(TOLERANCE),--tolerance $(TOLERANCE)) --size $(SIZE) $(film) \
	    $(OPTIONS) --make -o $@ -- $(call quoted,$(MESH))
include $(OUT)/plan.chosen.mk
# The plan tells which files it was made from, and their times and sizes. It is made anew once, not for as long as they
# change.
ifeq ($(MAKE_RESTARTS),)
ifneq ($(strip $(STAMPS)),$(strip $(if $(INPUTS),$(shell stat -L -c %.9Y:%s -- $(INPUTS) 2>/dev/null))))
$(OUT)/plan.chosen.mk: always
endif
endif

# Files that the technique may read, and the scene that it draws.
file_map        := $(OUT)/plan.map.exr
file_volume     := $(OUT)/plan.volume.ktx2
file_thresholds := $(OUT)/plan.thresholds.ktx2
file_solid      := $(OUT)/plan.solid.ktx2
asset := $(file_$(READS))
scene := $(if $(filter strokes,$(READS)),$(OUT)/plan.strokes.glb,$(if $(PATCHES),$(OUT)/plan.patches.glb))
$(file_map): $(OUT)/plan.chosen.mk
	tamgen $(TAMGEN) -o $@
$(file_volume): $(file_map)
	tamvol -q $(TAMVOL) $< -o $@
$(file_thresholds): $(file_map)
	tamthresh -q $(TAMTHRESH) $< -o $@
$(file_solid): $(OUT)/plan.chosen.mk
	solidgen $(SOLIDGEN) -o $@
$(OUT)/plan.patches.glb: $(OUT)/plan.chosen.mk
	dirfield -- $(call quoted,$(MESH)) | lapped-param -o $@
$(OUT)/plan.strokes.glb: $(OUT)/plan.chosen.mk
	dirfield -- $(call quoted,$(MESH)) | strokegen $(STROKEGEN) -o $@

picture: $(asset) $(scene)
	$(name) && render-gl $(DRAW) \
	    $(if $(asset),$(if $(filter solid,$(READS)),--solid,--tam) $(asset)) \
	    -o "$(if $(film),$${name//\%/%%}-%03d,$$name).png" -- $(if $(scene),$(scene),$(call quoted,$(MESH)))
