# Draws one place of a model at four distances, each 16 times nearer than the one before, with strokes that
# keep their size: zoom-0.png to zoom-3.png. And, with FRAMES, the way in.
#
#     make -f rptam.mk                                       the teapot
#     make -f rptam.mk STYLE=pencil LAYERS=3 SEEDS=100
#     make -f rptam.mk FRAMES=48                             zoom-way-000.png ...: one octave, to be looped
#     make -f rptam.mk MODEL=horse.glb AT=0,0.1,1 FROM=1,1,6
#
# AT is a place on the surface, FROM the way from there to the first camera. The model needs texture
# coordinates; dirfield and lapped-param give it some. The commands are looked for on PATH. Copy this file
# and change it.
MODEL   ?= $(OUT)/teapot.glb
AT      ?= 0,0.1,1.02
FROM    ?= 0.9,0.7,4.4
STYLE   ?= ink
SEEDS   ?= 64
LAYERS  ?= 4
SEED    ?= 1
SIZE    ?= 480x300
FRAMES  ?= 0
OUT     ?= .
OPTIONS ?=

SHELL := /bin/bash
.SHELLFLAGS := -eo pipefail -c
.DELETE_ON_ERROR:

sets := $(OUT)/$(STYLE)-$(SEEDS)x$(LAYERS)-$(SEED).seeds
draw = render-gl --technique rptam --style $(STYLE) --seeds "$(sets)" --size $(SIZE) $(OPTIONS) \
    --camera "$$(place $(1))" -o "$(2)" "$(MODEL)"
# place SHARE: the camera at that share of the way from AT to FROM
place = place() { awk -v at=$(AT) -v from=$(FROM) -v share=$$1 'BEGIN {split(at, a, ","); split(from, f, ","); \
    for (k = 1; k < 4; k++) printf "%s%.12g", (k > 1 ? "," : ""), a[k] + share * f[k]; print ":" at}'; }

.PHONY: strip
strip: $(sets) $(MODEL)
	$(place); for step in 0 1 2 3; do \
	    $(call draw,$$(awk "BEGIN {print 16 ^ -$$step}"),$(OUT)/zoom-$$step.png) || exit 1; done
ifneq ($(FRAMES),0)
	$(place); for frame in $$(seq 0 $$(($(FRAMES) - 1))); do \
	    $(call draw,$$(awk "BEGIN {print 2 ^ -($$frame / $(FRAMES)) / 64}"),$(OUT)/zoom-way-$$(printf %03d $$frame).png) || exit 1; done
endif

$(sets):
	mkdir -p $(OUT)
	seedgen -n $(SEEDS) --layers $(LAYERS) --seed $(SEED) -o $@
$(OUT)/teapot.glb:
	mkdir -p $(OUT)
	meshgen teapot --faces 50000 -o $@
