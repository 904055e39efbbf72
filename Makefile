# make              everything into build/       make demo         build/demo/teapot.png
# make check        all tests                    make lint         structure, warnings, manuals
# make bench chart  measurements, their charts   make install      PREFIX, DESTDIR
# make dist         a reproducible source tar    make fuzz         fuzzers, with clang
# make mutants      random mutations of the code that no test sees: N=80 of them, drawn with SEED=1
# make check-interop  other projects' readers, from npm, on our files      make limits: docs/limits.md
# SANITIZE=1 builds and tests under AddressSanitizer and UBSan, in build/sanitize.
CC := $(if $(filter default,$(origin CC)),gcc,$(CC))
CXX := $(if $(filter default,$(origin CXX)),g++,$(CXX))
CFLAGS ?= -O3 -g
CXXFLAGS ?= $(CFLAGS)
PREFIX ?= /usr/local
VERSION := $(shell sed -n 's/^.define HATCH_VERSION "\(.*\)"/\1/p' cmd/shared/cmd.h)

WARN := -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wvla
BASE := -D_POSIX_C_SOURCE=200809L -Ilibhatch -Icmd -ffp-contract=off -pthread -MMD -MP
B := build
ifdef SANITIZE
B := build/sanitize
SANITIZERS := -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer
BASE += $(SANITIZERS) -DHATCH_ARENA_SEPARATE
endif
# The fuzzers are a build of their own.
ifneq ($(filter fuzz check-long,$(MAKECMDGOALS)),)
B := build/fuzz
CC := clang
CXX := clang++
SANITIZERS := -fsanitize=address,undefined,fuzzer-no-link -fno-sanitize-recover=undefined
BASE += $(SANITIZERS) -DHATCH_ARENA_SEPARATE
endif

# command: the package archives and packages that it links
LINK_solidgen  := exr png foreign texture
LINK_tamgen    := exr png foreign svg
LINK_tampack   := exr png texture
LINK_tamvol    := exr texture
LINK_tamthresh := exr png foreign texture
LINK_hatchstat := exr png foreign gltf cxx texture
LINK_render-gl := exr png foreign gltf cxx texture svg gl
LINK_dirfield  := gltf openmesh cxx cholmod
LINK_lapped-param := gltf cxx png cholmod
LINK_strokegen := gltf cxx cholmod
LINK_meshfit   := gltf cxx
LINK_hatchplan := exr png foreign gltf cxx
libs_exr       := -lOpenEXRCore -ldeflate
libs_png       := -lpng16
libs_foreign   := -ldl
libs_gltf      := -ltinygltf -lmeshoptimizer -lstdc++
libs_openmesh  := -lOpenMeshTools -lOpenMeshCore -lstdc++
libs_texture   := -lzstd
libs_cholmod   := -lcholmod
libs_svg       := -lexpat
libs_gl        := -lepoxy -lglfw

# A package's archive holds its folder of libhatch; all else of libhatch is C alone and one archive.
PACKAGES := exr png foreign gltf openmesh cxx texture cholmod svg
SRC := $(wildcard libhatch/*/*.c libhatch/*/*/*.c libhatch/*/*/*.cc)
PLUGIN_SRC := libhatch/io/foreign/oiio_plugin.cc
FOLDER_cholmod := libhatch/sparse
src_of = $(filter $(or $(FOLDER_$(1)),libhatch/io/$(1))/%,$(filter-out $(PLUGIN_SRC),$(SRC)))
$(foreach p,$(PACKAGES),$(eval SRC_$(p) := $(call src_of,$(p))))
SRC_core := $(filter-out $(PLUGIN_SRC) $(foreach p,$(PACKAGES),$(SRC_$(p))),$(SRC))
obj = $(patsubst %,$(B)/obj/%.o,$(1))
archive = $(patsubst %,$(B)/lib/libhatch-%.a,$(1))

# A command is cmd/NAME.c, or a folder cmd/NAME whose main.c holds main.
FOLDERS := $(patsubst cmd/%/main.c,%,$(wildcard cmd/*/main.c))
COMMANDS := $(patsubst cmd/%.c,%,$(wildcard cmd/*.c)) $(FOLDERS)
SRC_cmd := $(wildcard cmd/shared/*.c cmd/shared/*/*.c)
SHADERS := $(wildcard cmd/render-gl/shaders/*/*)
$(foreach f,$(FOLDERS),$(eval SRC_$(f) := $(filter-out %/main.c,$(wildcard cmd/$(f)/*.c cmd/$(f)/*/*.c cmd/$(f)/*/*/*.c))))

BINARIES := $(COMMANDS:%=$(B)/bin/%)
PLUGIN := $(B)/lib/hatch/hatch-oiio.so
# All but binaries lies in share as it will be installed, so that commands find it in both places.
copies = $(foreach f,$(wildcard $(1)/$(3)),$(B)/share/$(2)/$(f:$(1)/%=%))
SHARED := $(call copies,styles,hatch/styles,*) $(call copies,man,man,man*/*) \
          $(call copies,cmd/render-gl/shaders,hatch/shaders,*/*) $(call copies,pipelines,hatch/pipelines,*)
COMPLETED := bash-completion/completions/% zsh/site-functions/_% fish/vendor_completions.d/%.fish
COMPLETIONS := $(foreach c,$(COMPLETED),$(COMMANDS:%=$(B)/share/$(c)))
INSTALLED := $(BINARIES) $(PLUGIN) $(SHARED) $(COMPLETIONS)
all: $(INSTALLED)
# V=1 prints the commands in full.
say = $(if $(V),,@echo "  $(1)" && )
# Objects are made again when the flags change.
FLAGS := $(CC) $(CXX) $(BASE) $(CFLAGS) $(CXXFLAGS) $(CPPFLAGS) $(LDFLAGS)
ifneq ($(FLAGS),$(file <$(B)/flags))
$(shell mkdir -p $(B))
$(file >$(B)/flags,$(FLAGS))
endif
$(B)/obj/%.c.o: %.c $(B)/flags
	@mkdir -p $(@D)
	$(call say,cc $<)$(CC) -std=c11 $(BASE) $(WARN) $(CFLAGS) $(CPPFLAGS) -c -o $@ $<
$(B)/obj/%.cc.o: %.cc $(B)/flags
	@mkdir -p $(@D)
	$(call say,c++ $<)$(CXX) -std=c++17 -fPIC $(BASE) -Wall -Wextra -Wshadow $(CXXFLAGS) $(CPPFLAGS) -c -o $@ $<
-include $(shell find $(B)/obj -name '*.d' 2>/dev/null)

define archive_rule
$(call archive,$(1)): $(call obj,$(SRC_$(1))) $(2)
	@mkdir -p $$(@D)
	@rm -f $$@
	$$(call say,ar $$@)$(AR) rcsD $$@ $$^
endef
$(foreach a,core cmd $(PACKAGES) $(filter-out render-gl,$(FOLDERS)),$(eval $(call archive_rule,$(a))))
$(eval $(call archive_rule,render-gl,$(B)/obj/gen/shader_files.o))

# cmd/render-gl/gpu/shader_files.h declares the generated table.
$(B)/gen/shader_files.c: $(SHADERS) cmd/render-gl/gpu/bindings.h cmd/render-gl/gpu/embed.sh
	@mkdir -p $(@D)
	sh cmd/render-gl/gpu/embed.sh cmd/render-gl/gpu/bindings.h cmd/render-gl/shaders $(SHADERS) >$@.part && mv $@.part $@
$(B)/obj/gen/%.o: $(B)/gen/%.c
	@mkdir -p $(@D)
	$(call say,cc $<)$(CC) -std=c11 $(BASE) $(WARN) $(CFLAGS) $(CPPFLAGS) -c -o $@ $<

LINK = $(CC) $(CFLAGS) $(SANITIZERS) $(LDFLAGS) -o $@
define command_rule
$(B)/bin/$(1): $(call obj,$(wildcard cmd/$(1).c cmd/$(1)/main.c)) \
               $(call archive,$(filter $(1),$(FOLDERS)) cmd $(filter $(PACKAGES),$(LINK_$(1))) core)
	@mkdir -p $$(@D)
	$$(call say,link $$@)$$(LINK) $$(filter %.o,$$^) -Wl,--start-group $$(filter %.a,$$^) -Wl,--end-group \
	    $(foreach a,$(LINK_$(1)),$(libs_$(a))) -lm -pthread
endef
$(foreach c,$(COMMANDS),$(eval $(call command_rule,$(c))))

$(B)/lib/hatch/hatch-oiio.so: $(call obj,$(PLUGIN_SRC))
	@mkdir -p $(@D)
	$(call say,link $@)$(CXX) $(CXXFLAGS) $(SANITIZERS) $(LDFLAGS) -shared -o $@ $^ -lOpenImageIO -lOpenImageIO_Util
define copy_rule
$(B)/share/$(2)/%: $(1)/%
	@mkdir -p $$(@D)
	@cp $$< $$@
endef
$(foreach f,styles pipelines cmd/render-gl/shaders,$(eval $(call copy_rule,$(f),hatch/$(notdir $(f)))))
$(eval $(call copy_rule,man,man))
define completion_rule
$(B)/share/$(2): $(B)/bin/% cmd/completions.sh
	@mkdir -p $$(@D)
	@$$< --options-table | sh cmd/completions.sh $(1) $$* >$$@
endef
$(foreach c,$(COMPLETED),$(eval $(call completion_rule,$(firstword $(subst -, ,$(subst /, ,$(c)))),$(c))))

# Drawn anew each time: a pipeline does not know that the commands have changed.
demo: all
	@rm -rf $(B)/demo
	PATH="$(abspath $(B))/bin:$$PATH" $(MAKE) -f pipelines/teapot.mk OUT=$(B)/demo

BENCHES := $(patsubst tests/%.c,$(B)/tests/%,$(filter-out %/measure.c,$(wildcard tests/bench/programs/*.c)))
bench: all $(BENCHES)
	PATH=$(abspath $(B))/bin:$(abspath $(B))/tests/bench/programs:$$PATH sh tests/bench/run.sh $(B)/bench
chart: ; sh tests/bench/charts/draw.sh $(B)/bench
# Goals that build on each other run in their order, also with -j.
$(if $(filter bench,$(MAKECMDGOALS)),$(eval chart: bench))
$(if $(filter clean,$(MAKECMDGOALS)),$(eval .NOTPARALLEL:))

# install_into FOLDER
install_into = for file in $(INSTALLED:$(B)/%=%); do mode=644; [ ! -x $(B)/$$file ] || mode=755; \
    install -D -m $$mode $(B)/$$file $(1)/$$file || exit 1; done
install: all
	@$(call install_into,"$(DESTDIR)$(PREFIX)")

# The commit alone makes the bytes.
DIST := hatch-$(VERSION)
dist:
	@mkdir -p $(B)
	git archive --format=tar --prefix=$(DIST)/ HEAD | gzip -9n >$(B)/$(DIST).tar.gz
	@echo $(B)/$(DIST).tar.gz

# Tests. A unit test program links of all archives what it needs, and OpenGL only if it draws.
TEST_SRC := $(wildcard tests/unit/*/test_*.c tests/prop/test_*.c tests/stability/test_*.c)
TESTS := $(patsubst tests/%.c,$(B)/tests/%,$(TEST_SRC))
ARCHIVES := $(call archive,$(FOLDERS) cmd $(PACKAGES) core)
include tests/steps.mk tests/memory/library.mk tests/stability/limits/limits.mk
$(addprefix $(B)/tests/,unit/render-gl/% unit/gpu/% prop/test_rptam_zoom prop/test_strokes_% prop/test_solid_% stability/limits/% stability/test_rptam_limits stability/test_solid_% bench/programs/%): GL := $(libs_gl)
$(TESTS) $(BENCHES) $(LIMITS): $(B)/tests/%: $(B)/obj/tests/%.c.o $(ARCHIVES)
	@mkdir -p $(@D)
	$(call say,link $@)$(LINK) $(filter %.o,$^) -Wl,--start-group $(ARCHIVES) -Wl,--end-group -Wl,--as-needed \
	    $(foreach a,$(PACKAGES),$(libs_$(a))) $(GL) -lsuitesparseconfig -lcheck_pic -lsubunit -lrt -lm -pthread
$(call obj,$(TEST_SRC) $(patsubst $(B)/%,%.c,$(BENCHES) $(LIMITS))): BASE += -Itests/support
$(call obj,$(TEST_SRC)): CFLAGS += -O0
SCRIPTS := $(wildcard $(patsubst %,tests/%/*.t,cli cli/* prop stability golden bad memory fuzz interop lint))
FUZZ_SRC := $(wildcard tests/fuzz/fuzz_*.c tests/fuzz/fuzz_*.cc)
FUZZ_NAMES := $(patsubst fuzz_%,%,$(basename $(notdir $(FUZZ_SRC))))
REPLAYS := $(FUZZ_NAMES:%=$(B)/tests/fuzz/%)
FUZZERS := $(FUZZ_NAMES:%=$(B)/bin/%)
fuzz_libs = -Wl,--start-group $(ARCHIVES) -Wl,--end-group -Wl,--as-needed \
    $(foreach a,$(PACKAGES),$(libs_$(a))) -lm -pthread
define fuzz_rule
$(B)/tests/fuzz/$(2): $(call obj,$(1) tests/fuzz/replay.c) $(ARCHIVES)
	@mkdir -p $$(@D)
	$$(call say,link $$@)$$(LINK) $$(filter %.o,$$^) $$(fuzz_libs) -lstdc++
$(B)/bin/$(2): $(call obj,$(1)) $(ARCHIVES)
	@mkdir -p $$(@D)
	$$(call say,link $$@)$(CXX) -fsanitize=address,undefined,fuzzer $(LDFLAGS) -o $$@ $$< $$(fuzz_libs)
endef
$(foreach s,$(FUZZ_SRC),$(eval $(call fuzz_rule,$(s),$(patsubst fuzz_%,%,$(basename $(notdir $(s)))))))
fuzz: $(FUZZERS)
check-long: fuzz
	LONG=1 $(MAKE) check
	sh tests/fuzz/long.sh $(FUZZERS)
# Readers that are not ours; those from npm are fetched once, and their tests skip without them.
INTEROP := $(addprefix $(B)/tests/,interop/samples interop/oiio_texels bad/maps golden/pixels)
$(filter-out %texels,$(INTEROP)): $(B)/tests/%: $(B)/obj/tests/%.c.o $(ARCHIVES)
	@mkdir -p $(@D)
	$(call say,link $@)$(LINK) $< $(fuzz_libs)
$(B)/tests/interop/oiio_texels: $(call obj,tests/interop/oiio_texels.cc)
	@mkdir -p $(@D)
	$(call say,link $@)$(CXX) $(CXXFLAGS) $(SANITIZERS) $(LDFLAGS) -o $@ $< -lOpenImageIO -lOpenImageIO_Util
$(B)/interop/node_modules: tests/interop/package.json
	@mkdir -p $(@D)
	cp $< $(@D) && cd $(@D) && npm install --no-audit --no-fund && touch node_modules
check-interop: all $(INTEROP) $(B)/interop/node_modules; B=$(B) perl tests/run $(wildcard tests/interop/*.t)
stage: all; @rm -rf $(B)/stage && $(call install_into,$(B)/stage/usr)
check: all stage $(TESTS) $(REPLAYS) $(INTEROP) $(FAIL_MALLOC)
	@B=$(B) SANITIZE=$(SANITIZE) CC=$(CC) perl tests/run $(SCRIPTS) $(TESTS)
mutants: ; perl tests/mutants/run.pl $(B)/mutants
lint: ; B=$(B) perl tests/run $(wildcard tests/lint/*.t)
clean: ; rm -rf build
.PHONY: all demo bench chart mutants stage check check-interop check-long fuzz install dist lint clean
.DELETE_ON_ERROR .SECONDARY:
