# SPDX-License-Identifier: MIT
# Other machines: aarch64, s390x (big-endian) and armhf (32 bits), cross-compiled and emulated; of tables' bytes also riscv64, i386 and WebAssembly.
#   make portable                       everything on all of them
#   make portable MACHINES=s390x        on one
MACHINES ?= aarch64 s390x armhf
# Where bytes of tables are compared: tests/portable/bytes.py needs nothing but a compiler and the C library there.
BYTES_MACHINES ?= aarch64 s390x armhf riscv64 i386 wasm32
BYTES = $(PYTHON) tests/portable/bytes.py $(1) $(BUILD)
# What to run there: run-unit for the unit tests only.
PORTABLE_GOALS ?= run-tests
PORTABLE := $(BUILD)/portable
triple_aarch64 := aarch64-linux-gnu
triple_s390x := s390x-linux-gnu
triple_armhf := arm-linux-gnueabihf
emulator_aarch64 := qemu-aarch64-static
emulator_s390x := qemu-s390x-static
emulator_armhf := qemu-arm-static
# Debian's names, where they are others.
debian_aarch64 := arm64
debian_s390x := s390x
debian_armhf := armhf
packages_of = $(abspath $(PORTABLE))/packages/$(debian_$(1))

# What runs on another machine goes through its emulator: the test programs, and the command that scripts call.
ifdef EMULATOR
RUN = @TDSP=$(abspath $(BUILD))/tdsp.sh TDSP_BUILD=$(abspath $(BUILD)) EMULATOR='$(EMULATOR)' TEST_TIMEOUT=7200 tests/run.sh $@ "$(patsubst $(CHECK)/%.result,%,$@)" \
  tests/portable/emulate.sh
$(BUILD)/tdsp.sh: FORCE
	@mkdir -p $(@D)
	@printf '#!/bin/bash\nexec %s %s "$$@"\n' '$(EMULATOR)' '$(abspath $(BUILD))/tdsp' > $@ && chmod +x $@
endif

portable_make = $(MAKE) --no-print-directory -s -k BUILD=$(PORTABLE)/$(1) CHECK=$(PORTABLE)/check VARIANT=$(1) CC=$(triple_$(1))-gcc AR=$(triple_$(1))-ar \
  TOOL_CPPFLAGS='$(POSIX) $(patsubst %,-isystem $(call packages_of,$(1))/usr/%,include include/glib-2.0 lib/$(triple_$(1))/glib-2.0/include include/json-glib-1.0 include/cairo)' \
  TOOL_LIBS='-lgio-2.0 -lgobject-2.0 -ljson-glib-1.0 -lglib-2.0 -lcairo -lm' LDFLAGS='-L$(call packages_of,$(1))/lib -Wl,-rpath-link,$(call packages_of,$(1))/lib' \
  EMULATOR='$(emulator_$(1)) -L /usr/$(triple_$(1)) -E LD_LIBRARY_PATH=$(call packages_of,$(1))/lib -E LOCPATH=$(call packages_of,$(1))/usr/lib/locale'

.PHONY: portable portable-run
portable: ## run the tests on aarch64, s390x and armhf, emulated, and read their tables here (MACHINES="...")
	@tools/setup/packages.sh trust
	@rm -rf $(PORTABLE)/check && mkdir -p $(PORTABLE)/check
	@$(foreach m,$(MACHINES),tests/portable/fetch.sh $(debian_$(m)) $(call packages_of,$(m)) &&) true
	@$(MAKE) --no-print-directory -s all
	+@$(foreach m,$(MACHINES),{ $(call portable_make,$(m)) all tests $(PORTABLE)/$(m)/tdsp.sh && $(call portable_make,$(m)) $(PORTABLE_GOALS) \
	  || echo "0 1" > $(PORTABLE)/check/$(m)-build.result; };)
	@tests/run.sh $(PORTABLE)/check/reader.result reader $(PYTHON) tests/portable/reader.py check $(BUILD) $(foreach m,$(MACHINES),$(triple_$(m)))
	@tests/run.sh $(PORTABLE)/check/tables.result tables $(PYTHON) tests/portable/tables.py $(BUILD) $(foreach m,$(MACHINES),$(PORTABLE)/$(m)/tdsp.sh)
	@tests/run.sh $(PORTABLE)/check/bytes.result bytes $(call BYTES,check) here $(BYTES_MACHINES)
	@tests/summary.sh $(PORTABLE)/check

.PHONY: bytes
bytes: ## compare the bytes of tables on BYTES_MACHINES (aarch64 s390x armhf riscv64 i386 wasm32) with those recorded
	@tools/setup/packages.sh trust
	$(call BYTES,check) here $(BYTES_MACHINES)

.PHONY: golden-record
golden-record: ## write the golden files' answers, the broken files, and the bits of tables and functions in tests/golden anew
	$(PYTHON) tests/golden/refuse.py
	$(PYTHON) tests/portable/reader.py record $(BUILD)
	$(call BYTES,record)

# The short version: the reader and the mathematics by themselves on two machines, tables here and in WebAssembly, and the list of broken files held to the
# specification's second reader.
checks += golden portable bytes mathematics
$(CHECK)/bytes.result: ; $(RUN) $(call BYTES,check) here wasm32
$(CHECK)/mathematics.result: ; $(RUN) $(call BYTES,mathematics) aarch64 s390x
$(CHECK)/golden.result: ; $(RUN) $(PYTHON) tests/golden/refuse.py --check
$(CHECK)/portable.result: ; $(RUN) $(PYTHON) tests/portable/reader.py check $(BUILD) aarch64-linux-gnu s390x-linux-gnu
