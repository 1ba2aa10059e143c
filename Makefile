# SPDX-License-Identifier: MIT
# libtdsp: how it is built, tested, shown and installed. `make help` lists the targets.
#
# Sources are found by pattern: a new file in src/*/, tools/tdsp/ or tests/*/ needs no change here. Each variant (compiler,
# sanitizers, fuzzing) has a directory of its own, so that objects of different kinds never meet:
#   make                    build/             gcc
#   make CC=clang-19        build/clang-19/
#   make SANITIZE=1         build/sanitize/    clang-19 with ASan and UBSan
#   make BUILD=DIR          DIR/
.SUFFIXES:
.DELETE_ON_ERROR:
SHELL := /bin/bash

VERSION := $(shell sed -n 's/.*TDSP_VERSION_STRING "\(.*\)".*/\1/p' include/tdsp/export.h)
SOVERSION := $(firstword $(subst ., ,$(VERSION)))

CLANG := clang-19
CLANGXX := clang++-19
ifeq ($(origin CC),default)
CC := $(if $(SANITIZE)$(FUZZ),$(CLANG),gcc)
endif
AR := ar
NM := nm
PKG_CONFIG := pkg-config
PYTHON := python3

ifdef FUZZ
BUILD ?= build/fuzz
else ifdef SANITIZE
BUILD ?= build/sanitize
else ifeq ($(filter-out gcc cc,$(CC)),)
BUILD ?= build
else
BUILD ?= build/$(notdir $(firstword $(CC)))
endif

PREFIX ?= /usr/local
DESTDIR ?=
BINDIR ?= $(PREFIX)/bin
LIBDIR ?= $(PREFIX)/lib
INCLUDEDIR ?= $(PREFIX)/include

# Real scenes that are too large to ship; tests that want them say so when they are not there.
export TDSP_DATA ?= ../shared/data

# ---------------------------------------------------------------------------------------------------------------- flags

WARNINGS := -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror
OPTIMIZE ?= -O2
# No fused multiply-add and no -ffast-math: results are the same on every machine. -fno-math-errno changes no result.
CFLAGS := -std=c99 $(OPTIMIZE) -g $(WARNINGS) -ffp-contract=off -fno-math-errno -fPIC -fvisibility=hidden
SAN_FLAGS := -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
ifdef SANITIZE
CFLAGS += $(SAN_FLAGS)
LDFLAGS += $(SAN_FLAGS)
endif
ifdef FUZZ
CFLAGS += $(SAN_FLAGS) -fsanitize=fuzzer-no-link
LDFLAGS += $(SAN_FLAGS) -fsanitize=fuzzer
endif
CPPFLAGS := -Iinclude -Isrc
POSIX := -D_POSIX_C_SOURCE=200809L

# Headers of other people are not held to our warnings: -isystem.
TOOL_PACKAGES := glib-2.0 gobject-2.0 gio-2.0 json-glib-1.0 cairo
TOOL_CPPFLAGS = $(POSIX) $(patsubst -I%,-isystem %,$(shell $(PKG_CONFIG) --cflags $(TOOL_PACKAGES)))
TOOL_LIBS = $(shell $(PKG_CONFIG) --libs $(TOOL_PACKAGES)) -lm
TEST_CPPFLAGS = $(TOOL_CPPFLAGS) -Itests -Itools
TEST_LIBS = -Wl,--as-needed -lcmocka $(TOOL_LIBS)

# -------------------------------------------------------------------------------------------------------------- sources

LIB_SOURCES := $(sort $(wildcard src/*/*.c))
# The freestanding line: what a microcontroller needs to read a table.
QUERY_SOURCES := $(filter src/base/% src/geom/% src/table/% src/query/%,$(LIB_SOURCES))
TOOL_SOURCES := $(sort $(wildcard tools/tdsp/*.c))
SUPPORT_SOURCES := $(sort $(wildcard tests/support/*.c tests/slow/*.c))
TEST_SOURCES := $(sort $(wildcard tests/unit/test_*.c tests/property/test_*.c tests/cli/test_*.c))

objects = $(patsubst %.c,$(BUILD)/obj/%.o,$(1))

STATIC := $(BUILD)/libtdsp.a
QUERY := $(BUILD)/libtdsp-query.a
SHARED := $(BUILD)/libtdsp.so.$(VERSION)
COMMAND := $(if $(TOOL_SOURCES),$(BUILD)/tdsp)
# The command without its main(), for tests that call into it.
COMMAND_PARTS := $(BUILD)/libcommand.a
SUPPORT := $(BUILD)/tests/libsupport.a
TESTS := $(patsubst %.c,$(BUILD)/%,$(TEST_SOURCES))

.PHONY: all
all: $(STATIC) $(QUERY) $(SHARED) $(COMMAND) ## build the library and the command (build/tdsp)

# ------------------------------------------------------------------------------------------------------------ compiling

# A change of flags, or of the list of files, rebuilds what depends on it; nothing else does.
.PHONY: FORCE
FORCE:
remember = @mkdir -p $(@D); echo '$(1)' | cmp -s - $@ || echo '$(1)' > $@
$(BUILD)/flags: FORCE
	$(call remember,$(CC) $(CFLAGS) $(CPPFLAGS) $(LDFLAGS))
$(BUILD)/files: FORCE
	$(call remember,$(LIB_SOURCES) $(TOOL_SOURCES) $(SUPPORT_SOURCES))

$(BUILD)/obj/src/%.o: src/%.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(CC) $(CPPFLAGS) $(CFLAGS) -MMD -MP -c $< -o $@

$(BUILD)/obj/tools/%.o: tools/%.c $(BUILD)/flags | tool-packages
	@mkdir -p $(@D)
	$(CC) $(CPPFLAGS) $(TOOL_CPPFLAGS) $(CFLAGS) -MMD -MP -c $< -o $@

$(BUILD)/obj/tests/%.o: tests/%.c $(BUILD)/flags | tool-packages
	@mkdir -p $(@D)
	$(CC) $(CPPFLAGS) $(TEST_CPPFLAGS) $(CFLAGS) -MMD -MP -c $< -o $@

.PHONY: tool-packages
tool-packages:
	@$(PKG_CONFIG) --exists $(TOOL_PACKAGES) || { echo "make: the command needs $(TOOL_PACKAGES); 'make packages' installs them" >&2; exit 1; }

define archive
@mkdir -p $(@D)
@rm -f $@
$(AR) crs $@ $(filter %.o,$^)
endef
$(STATIC): $(call objects,$(LIB_SOURCES)) $(BUILD)/files
	$(archive)
$(QUERY): $(call objects,$(QUERY_SOURCES)) $(BUILD)/files
	$(archive)
$(SUPPORT): $(call objects,$(SUPPORT_SOURCES)) $(BUILD)/files
	$(archive)
$(COMMAND_PARTS): $(call objects,$(filter-out tools/tdsp/main.c,$(TOOL_SOURCES))) $(BUILD)/files
	$(archive)

# Sanitized objects leave symbols to the program that loads them and bring some of their own; every other build must be whole, and exports what is listed.
SYMBOLS := src/libtdsp.map
WHOLE := -Wl,--no-undefined -Wl,--version-script=$(SYMBOLS) -Wl,--no-undefined-version
$(SHARED): $(call objects,$(LIB_SOURCES)) $(BUILD)/files $(SYMBOLS)
	$(CC) -shared -Wl,-soname,libtdsp.so.$(SOVERSION) $(if $(SANITIZE)$(FUZZ),,$(WHOLE)) $(filter-out -fsanitize=fuzzer,$(LDFLAGS)) $(filter %.o,$^) -lm -o $@
	ln -sf $(@F) $(BUILD)/libtdsp.so.$(SOVERSION)
	ln -sf $(@F) $(BUILD)/libtdsp.so

# The archive, so that the command runs from anywhere; a distribution has it use the shared library: COMMAND_LIBRARY=build/libtdsp.so.VERSION.
COMMAND_LIBRARY ?= $(STATIC)
$(BUILD)/tdsp: $(call objects,$(TOOL_SOURCES)) $(COMMAND_LIBRARY)
	$(CC) $(LDFLAGS) $(filter %.o,$^) $(COMMAND_LIBRARY) $(TOOL_LIBS) -o $@

$(TESTS): $(BUILD)/tests/%: $(BUILD)/obj/tests/%.o $(SUPPORT) $(COMMAND_PARTS) $(STATIC)
	@mkdir -p $(@D)
	$(CC) $(LDFLAGS) $< $(SUPPORT) $(COMMAND_PARTS) $(STATIC) $(TEST_LIBS) -o $@

-include $(shell find $(BUILD)/obj -name '*.d' 2>/dev/null)

.PHONY: tests
tests: $(TESTS) ## build the test programs

.PHONY: sanitize
sanitize: ## build everything with ASan and UBSan in build/sanitize
	$(MAKE) SANITIZE=1 BUILD=$(BUILD)/sanitize all tests

.PHONY: packages
packages: ## install the Debian packages that `make check` needs, those that are missing
	tools/setup/packages.sh check

# ------------------------------------------------------------------------------------------------------------- examples

EXAMPLE_SOURCES := $(sort $(wildcard examples/c/*.c))
EXAMPLES := $(patsubst examples/c/%.c,$(BUILD)/examples/%,$(EXAMPLE_SOURCES))
EXAMPLE_CFLAGS = $(filter-out -fvisibility=hidden -fPIC,$(CFLAGS)) -Iinclude -MMD -MP

# They see what a user sees: the public headers and the archive.
$(filter-out %/firmware_lookup,$(EXAMPLES)): $(BUILD)/examples/%: examples/c/%.c $(STATIC)
	@mkdir -p $(@D)
	$(CC) $(EXAMPLE_CFLAGS) $(LDFLAGS) $< $(STATIC) -lm -o $@

# Firmware has no scene and no solver: an array made by `tdsp embed`, and the reader.
$(BUILD)/examples/route.c: examples/scenes/two-discs.json $(COMMAND)
	@mkdir -p $(@D)
	$(BUILD)/tdsp build $< -o $(BUILD)/examples/route.tdsp >/dev/null
	$(BUILD)/tdsp embed $(BUILD)/examples/route.tdsp -o $@
$(BUILD)/examples/firmware_lookup: examples/c/firmware_lookup.c $(BUILD)/examples/route.c $(QUERY)
	$(CC) $(EXAMPLE_CFLAGS) $(LDFLAGS) $(filter %.c,$^) $(QUERY) -lm -o $@

.PHONY: examples
examples: $(EXAMPLES) ## build the example programs of examples/c

# ----------------------------------------------------------------------------------------------------------------- demo

DEMO_SCENE ?= examples/scenes/fire-oregon-c.json

.PHONY: demo
demo: ## the main job on a real scene: table and two pictures in build/demo
	@tools/setup/packages.sh demo
	@echo "building the library and the command"
	@$(MAKE) --no-print-directory -s all
	@tools/setup/demo.sh $(BUILD) $(DEMO_SCENE)

.PHONY: pictures
pictures: all ## draw the pictures of README.md and docs/math again
	tools/setup/pictures.sh $(BUILD) $(DEMO_SCENE) docs/pictures

# -------------------------------------------------------------------------------------------------------------- testing

# Results of one run of the tests: CHECK/VARIANT/.../NAME.result, added up at the end. A failing test does not stop make (its result
# counts); only what does not build does.
CHECK := $(BUILD)/check
VARIANT ?= gcc
JOBS ?= $(shell nproc)
# Tests find the command in TDSP, and its directory in TDSP_BUILD.
RUN = @TDSP=$(abspath $(BUILD))/tdsp TDSP_BUILD=$(abspath $(BUILD)) tests/run.sh $@ "$(patsubst $(CHECK)/%.result,%,$@)"

CLI_SCRIPTS := $(sort $(wildcard tests/cli/test_*.sh tests/cli/test_*.py tests/independent/test_*.sh tests/independent/test_*.py))
TEST_RUNS := $(patsubst tests/%.c,$(CHECK)/$(VARIANT)/%.result,$(TEST_SOURCES))
SCRIPT_RUNS := $(patsubst tests/%,$(CHECK)/$(VARIANT)/%.result,$(CLI_SCRIPTS))

# A sanitizer's report has an exit status of its own: 1 is an answer of the command. Leaks that tests/lsan.supp names are known.
export ASAN_OPTIONS ?= exitcode=99:detect_stack_use_after_return=1:strict_string_checks=1
export LSAN_OPTIONS ?= exitcode=99:suppressions=$(CURDIR)/tests/lsan.supp:print_suppressions=0
export UBSAN_OPTIONS ?= exitcode=99:print_stacktrace=1
export PYTHONDONTWRITEBYTECODE := 1
export G_SLICE ?= always-malloc

$(TEST_RUNS): $(CHECK)/$(VARIANT)/%.result: $(BUILD)/tests/% $(COMMAND) FORCE
	$(RUN) $<
$(SCRIPT_RUNS): $(CHECK)/$(VARIANT)/%.result: tests/% $(COMMAND) FORCE
	$(RUN) $(if $(filter %.py,$<),$(PYTHON),bash) $<

.PHONY: run-tests run-unit
run-tests: $(TEST_RUNS) $(SCRIPT_RUNS)
run-unit: $(filter $(CHECK)/$(VARIANT)/unit/%,$(TEST_RUNS))

# Everything that is checked once and needs no variant. A kind of test with targets of its own keeps them in tests/KIND/rules.mk, which adds to
# `checks` what `make check` runs once, with its rule $(CHECK)/NAME.result, and to `steps` targets that need a variant of the build.
checks := runner layers functions stack links pictures headers objects examples snippets install
# What tests/languages and the like add to `languages` runs in `make check-languages`, whose toolchains are not everybody's.
steps :=
languages :=
include $(sort $(wildcard tests/*/rules.mk tools/*/rules.mk))
check_runs := $(checks:%=$(CHECK)/%.result)
.PHONY: run-checks
run-checks: $(check_runs)
$(check_runs): FORCE
$(CHECK)/runner.result: ; $(RUN) tests/runner/check.sh
$(CHECK)/stack.result: ; $(RUN) $(PYTHON) tests/check_stack.py
$(CHECK)/layers.result: ; $(RUN) $(PYTHON) tests/check_layers.py
$(CHECK)/functions.result: ; $(RUN) $(PYTHON) tests/check_functions.py
$(CHECK)/links.result: ; $(RUN) $(PYTHON) tests/check_links.py
$(CHECK)/pictures.result: all ; $(RUN) tools/setup/pictures.sh --check $(BUILD) $(DEMO_SCENE) docs/pictures
$(CHECK)/headers.result: ; $(RUN) bash -c 'tests/headers/check.sh gcc g++; a=$$?; tests/headers/check.sh $(CLANG) $(CLANGXX) || a=1; exit $$a'
$(CHECK)/objects.result: all ; $(RUN) $(PYTHON) tests/check_objects.py $(BUILD)
$(CHECK)/examples.result: $(EXAMPLES) ; $(RUN) tests/check_examples.sh $(BUILD)/examples
$(CHECK)/snippets.result: all ; $(RUN) $(PYTHON) tests/check_snippets.py $(BUILD) README.md $(sort $(wildcard docs/*.md docs/math/*.md))
$(CHECK)/install.result: all ; $(RUN) tests/install/check.sh $(MAKE) $(BUILD)

.PHONY: check-steps check-gcc check-clang check-sanitize
check-steps: check-gcc check-clang check-sanitize $(steps) run-checks
check-gcc: run-tests
# The second compiler is for its warnings and for what depends on the compiler: the unit tests show that.
check-clang:
	+@$(MAKE) --no-print-directory -s CC=$(CLANG) BUILD=$(BUILD)/clang-19 CHECK=$(CHECK) VARIANT=clang all tests examples bench-programs run-unit
check-sanitize:
	+@$(MAKE) --no-print-directory -s SANITIZE=1 CC=$(CLANG) BUILD=$(BUILD)/sanitize CHECK=$(CHECK) VARIANT=sanitize all run-tests
.PHONY: check
check: ## run every test; the last line says how many passed and failed
	@tools/setup/packages.sh check
	@rm -rf $(CHECK) && mkdir -p $(CHECK)
	+@$(MAKE) --no-print-directory -s -k -Otarget $(if $(findstring jobserver,$(MAKEFLAGS)),,-j$(JOBS)) check-steps || echo "0 1" > $(CHECK)/build.result
	@tests/summary.sh $(CHECK)

language_runs := $(languages:%=$(CHECK)/languages/%.result)
.PHONY: run-languages check-languages
$(language_runs): FORCE
run-languages: $(language_runs)
check-languages: ## run the packages, wrappers and examples of the other languages, their toolchains installed first
	@tools/setup/packages.sh languages
	@rm -rf $(CHECK)/languages && mkdir -p $(CHECK)/languages
	@$(MAKE) --no-print-directory -s -k -Otarget run-languages || echo "0 1" > $(CHECK)/languages/build.result
	@tests/summary.sh $(CHECK)/languages

.PHONY: unit
unit: ## run the unit tests only
	@mkdir -p $(CHECK)
	@rm -rf $(CHECK)/$(VARIANT)/unit
	@$(MAKE) --no-print-directory -s -k run-unit
	@tests/summary.sh $(CHECK)/$(VARIANT)/unit

.PHONY: format
format: ## lay out the C sources by .clang-format
	clang-format-19 -i $(wildcard include/tdsp/*.h src/*/*.[ch] tools/tdsp/*.[ch] tests/*/*.[ch] examples/c/*.[ch])

# ------------------------------------------------------------------------------------------------------------- the rest

.PHONY: clean
clean: ## remove everything that was built
	rm -rf build

.PHONY: help
help: ## this list
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/\1|\2/p' $(MAKEFILE_LIST) | while IFS='|' read -r name text; do printf '  make %-12s %s\n' "$$name" "$$text"; done
