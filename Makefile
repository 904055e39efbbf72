# make            everything into build/
# make check      all tests         make bench chart   measurements and their charts
# make demo       build/demo/teapot.png
# make install    PREFIX, DESTDIR   make lint          structure, warnings, manuals
CC ?= gcc
CXX ?= g++
CFLAGS ?= -O2 -g
CXXFLAGS ?= $(CFLAGS)
PREFIX ?= /usr/local
B := build

WARN := -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wvla
BASE := -D_POSIX_C_SOURCE=200809L -Ilibhatch -Icmd -ffp-contract=off -pthread -MMD -MP
ifdef SANITIZE
B := build/sanitize
BASE += -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer -DHATCH_ARENA_SEPARATE
LDFLAGS += -fsanitize=address,undefined
endif
pkg = $(shell pkg-config $(1) $(2))

# libhatch.a is C alone; each package has an archive of its own, and a command links only those that
# its line names.
CORE_SRC := $(wildcard libhatch/base/*.c libhatch/math/*.c libhatch/image/*.c libhatch/filter/*.c \
            libhatch/mesh/*.c libhatch/stroke/*.c libhatch/tam/*.c libhatch/measure/*.c) \
            $(wildcard libhatch/io/mesh_*.c libhatch/io/container*.c libhatch/io/glb_*.c)
EXR_SRC  := $(wildcard libhatch/io/exr*.c)
PNG_SRC  := $(wildcard libhatch/io/png*.c)
FOREIGN_SRC := libhatch/io/foreign.c
GLTF_SRC := $(wildcard libhatch/io/gltf*.cc libhatch/io/gltf*.c)
CMD_SRC  := $(wildcard cmd/cmd*.c)
RENDER_SRC := $(wildcard cmd/render-gl/*.c)

EXR_LIBS := -lOpenEXRCore-3_1 -ldeflate
PNG_LIBS := -lpng16
GLTF_LIBS := -ltinygltf
GL_LIBS := $(call pkg,--libs,epoxy egl glfw3)

# command: archives and packages
LINK_meshgen   :=
LINK_tamgen    := exr png foreign
LINK_tampack   := exr png
LINK_hatchstat := exr png foreign gltf
LINK_render-gl := exr png foreign gltf
COMMANDS := $(foreach c,meshgen tamgen tampack hatchstat render-gl,$(if $(wildcard cmd/$(c).c cmd/$(c)/main.c),$(c)))

obj = $(patsubst %,$(B)/obj/%.o,$(1))
ar_exr := $(B)/lib/libhatch-exr.a
ar_png := $(B)/lib/libhatch-png.a
ar_foreign := $(B)/lib/libhatch-foreign.a
ar_gltf := $(B)/lib/libhatch-gltf.a
ar_core := $(B)/lib/libhatch.a
ar_cmd := $(B)/lib/libcmd.a
libs_exr := $(EXR_LIBS)
libs_png := $(PNG_LIBS)
libs_foreign := -ldl
libs_gltf := $(GLTF_LIBS) -lstdc++

all: $(COMMANDS:%=$(B)/bin/%) $(B)/lib/hatch-oiio.so

$(ar_core): $(call obj,$(CORE_SRC))
$(ar_exr): $(call obj,$(EXR_SRC))
$(ar_png): $(call obj,$(PNG_SRC))
$(ar_foreign): $(call obj,$(FOREIGN_SRC))
$(ar_gltf): $(call obj,$(GLTF_SRC))
$(ar_cmd): $(call obj,$(CMD_SRC))
$(B)/lib/%.a:
	@mkdir -p $(@D)
	@rm -f $@
	ar rcsD $@ $^

$(B)/obj/%.c.o: %.c
	@mkdir -p $(@D)
	$(CC) -std=c11 $(BASE) $(WARN) $(CFLAGS) $(CPPFLAGS) -c -o $@ $<
$(B)/obj/%.cc.o: %.cc
	@mkdir -p $(@D)
	$(CXX) -std=c++17 $(BASE) -Wall -Wextra -Wshadow $(CXXFLAGS) $(CPPFLAGS) -c -o $@ $<

archives = $(foreach a,$(LINK_$(1)),$(ar_$(a)))
.SECONDEXPANSION:
$(filter-out %/render-gl,$(COMMANDS:%=$(B)/bin/%)): $(B)/bin/%: $(B)/obj/cmd/%.c.o $(ar_cmd) $$(call archives,$$*) $(ar_core)
	@mkdir -p $(@D)
	$(CC) $(LDFLAGS) -o $@ $^ $(foreach a,$(LINK_$*),$(libs_$(a))) -lm -pthread

-include $(shell find $(B)/obj -name '*.d' 2>/dev/null)
clean:
	rm -rf build
.PHONY: all clean
