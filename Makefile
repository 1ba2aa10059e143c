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
FUZZ_SOURCES := $(sort $(wildcard tests/fuzz/*.c))

objects = $(patsubst %.c,$(BUILD)/obj/%.o,$(1))

STATIC := $(BUILD)/libtdsp.a
QUERY := $(BUILD)/libtdsp-query.a
SHARED := $(BUILD)/libtdsp.so.$(VERSION)
COMMAND := $(if $(TOOL_SOURCES),$(BUILD)/tdsp)
# The command without its main(), for tests that call into it.
COMMAND_PARTS := $(BUILD)/libcommand.a
SUPPORT := $(BUILD)/tests/libsupport.a
TESTS := $(patsubst %.c,$(BUILD)/%,$(TEST_SOURCES))
FUZZERS := $(patsubst %.c,$(BUILD)/%,$(FUZZ_SOURCES))

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

archive = @mkdir -p $(@D); rm -f $@; echo "$(AR) $@"; $(AR) crs $@ $(filter %.o,$^)
$(STATIC): $(call objects,$(LIB_SOURCES)) $(BUILD)/files
	$(archive)
$(QUERY): $(call objects,$(QUERY_SOURCES)) $(BUILD)/files
	$(archive)
$(SUPPORT): $(call objects,$(SUPPORT_SOURCES)) $(BUILD)/files
	$(archive)
$(COMMAND_PARTS): $(call objects,$(filter-out tools/tdsp/main.c,$(TOOL_SOURCES))) $(BUILD)/files
	$(archive)

# Sanitized objects leave symbols to the program that loads them; every other build must be whole.
$(SHARED): $(call objects,$(LIB_SOURCES)) $(BUILD)/files
	$(CC) -shared -Wl,-soname,libtdsp.so.$(SOVERSION) $(if $(SANITIZE)$(FUZZ),,-Wl,--no-undefined) $(filter-out -fsanitize=fuzzer,$(LDFLAGS)) $(filter %.o,$^) -lm -o $@
	ln -sf $(@F) $(BUILD)/libtdsp.so.$(SOVERSION)
	ln -sf $(@F) $(BUILD)/libtdsp.so

$(BUILD)/tdsp: $(call objects,$(TOOL_SOURCES)) $(STATIC)
	$(CC) $(LDFLAGS) $(filter %.o,$^) $(STATIC) $(TOOL_LIBS) -o $@

$(TESTS): $(BUILD)/tests/%: $(BUILD)/obj/tests/%.o $(SUPPORT) $(COMMAND_PARTS) $(STATIC)
	@mkdir -p $(@D)
	$(CC) $(LDFLAGS) $< $(SUPPORT) $(COMMAND_PARTS) $(STATIC) $(TEST_LIBS) -o $@

$(FUZZERS): $(BUILD)/tests/%: $(BUILD)/obj/tests/%.o $(SUPPORT) $(COMMAND_PARTS) $(STATIC)
	@mkdir -p $(@D)
	$(CC) $(LDFLAGS) $< $(SUPPORT) $(COMMAND_PARTS) $(STATIC) $(TEST_LIBS) -o $@

-include $(shell find $(BUILD)/obj -name '*.d' 2>/dev/null)

.PHONY: tests
tests: $(TESTS) ## build the test programs

.PHONY: sanitize
sanitize: ## build everything with ASan and UBSan in build/sanitize
	$(MAKE) SANITIZE=1 BUILD=build/sanitize all tests

.PHONY: clean
clean: ## remove everything that was built
	rm -rf build

.PHONY: help
help: ## this list
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/  make \1|\2/p' $(MAKEFILE_LIST) | column -t -s'|'
