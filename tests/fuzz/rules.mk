# SPDX-License-Identifier: MIT
# Fuzzing: what reads bytes or text from nowhere, and the whole library behind scenes from bytes. A target is any fuzz_*.c here; tests/fuzz.sh runs them under
# libFuzzer, tests/fuzz/afl.sh under AFL++, and driver.c runs them over the inputs that are kept, in every build.
# In the check each target runs so many inputs, not so long: what it tries does not depend on how fast the machine is.
FUZZ_RUNS ?= 1000
FUZZ_SECONDS ?= 600
FUZZ_SOURCES := $(sort $(wildcard tests/fuzz/fuzz_*.c))
FUZZERS := $(patsubst %.c,$(BUILD)/%,$(FUZZ_SOURCES))
FUZZ_DRIVER := tests/fuzz/driver.c
# What targets share: scenes from bytes, and what their answers are held to.
FUZZ_PARTS := $(filter-out $(FUZZ_SOURCES) $(FUZZ_DRIVER),$(wildcard tests/fuzz/*.c))
FUZZ_LIBS = $(call objects,$(FUZZ_PARTS)) $(SUPPORT) $(COMMAND_PARTS) $(STATIC)

$(FUZZERS): $(BUILD)/tests/%: $(BUILD)/obj/tests/%.o $(call objects,$(FUZZ_PARTS)) $(SUPPORT) $(COMMAND_PARTS) $(STATIC)
	@mkdir -p $(@D)
	$(CC) $(LDFLAGS) $< $(FUZZ_LIBS) $(TEST_LIBS) -o $@

.PHONY: run-fuzz
run-fuzz: $(FUZZERS:$(BUILD)/tests/%=$(CHECK)/%.result) $(CHECK)/fuzz/reached.result
$(FUZZERS:$(BUILD)/tests/%=$(CHECK)/%.result): $(CHECK)/%.result: $(BUILD)/tests/% FORCE
	$(RUN) env FUZZ_RUNS=$(FUZZ_RUNS) tests/fuzz.sh $(FUZZ_SECONDS) $<

.PHONY: fuzz
fuzz: ## fuzz for FUZZ_SECONDS each (default 600); numbers in build/fuzz/report.csv
	@tools/setup/packages.sh check
	+@$(MAKE) --no-print-directory -s FUZZ=1 CC=$(CLANG) BUILD=$(BUILD)/fuzz fuzzers
	@FUZZ_SEED=$${FUZZ_SEED:-0} FUZZ_REPORT=$(BUILD)/fuzz/report.csv tests/fuzz.sh $(FUZZ_SECONDS) $(FUZZ_SOURCES:%.c=$(BUILD)/fuzz/%)

# The compiler is the same, and so are the targets; AFL++ brings its counters and its main().
.PHONY: fuzz-afl
fuzz-afl: ## the same under AFL++; numbers in build/afl/report.csv
	@tools/setup/packages.sh trust
	+@AFL_CC=$(CLANG) AFL_LLVM_INSTRUMENT=LLVM-NATIVE AFL_QUIET=1 $(MAKE) --no-print-directory -s FUZZ=1 CC=afl-clang-fast BUILD=$(BUILD)/afl fuzzers
	@tests/fuzz/afl.sh $(FUZZ_SECONDS) $(BUILD)/afl $(FUZZ_SOURCES:tests/fuzz/%.c=%)

.PHONY: fuzzers
fuzzers: $(FUZZERS)

steps += check-fuzz
.PHONY: check-fuzz
check-fuzz:
	+@$(MAKE) --no-print-directory -s FUZZ=1 CC=$(CLANG) BUILD=$(BUILD)/fuzz CHECK=$(CHECK) run-fuzz

# --------------------------------------------------------------------------------------------------- inputs that are kept

# Corpus and found cases through every target, without libFuzzer, in whatever build this is; the build for libFuzzer counts what is reached.
RERUNS := $(patsubst tests/fuzz/fuzz_%.c,$(BUILD)/tests/fuzz/rerun_%,$(FUZZ_SOURCES))
RERUN_RESULTS := $(patsubst $(BUILD)/tests/fuzz/%,$(CHECK)/$(VARIANT)/fuzz/%.result,$(RERUNS))
fuzz_inputs = $(wildcard tests/fuzz/corpus/fuzz_$(1) tests/fuzz/found/fuzz_$(1))

$(RERUNS): $(BUILD)/tests/fuzz/rerun_%: $(BUILD)/obj/tests/fuzz/fuzz_%.o $(call objects,$(FUZZ_DRIVER) $(FUZZ_PARTS)) $(SUPPORT) $(COMMAND_PARTS) $(STATIC)
	@mkdir -p $(@D)
	$(CC) $(filter-out -fsanitize=fuzzer,$(LDFLAGS)) $< $(call objects,$(FUZZ_DRIVER)) $(FUZZ_LIBS) $(TEST_LIBS) -o $@
$(RERUN_RESULTS): $(CHECK)/$(VARIANT)/fuzz/rerun_%.result: $(BUILD)/tests/fuzz/rerun_% FORCE
	$(RUN) $< $(call fuzz_inputs,$*)
run-tests: $(RERUN_RESULTS)

$(CHECK)/fuzz/reached.result: $(RERUNS) FORCE
	$(RUN) $(PYTHON) tests/fuzz/check_reached.py $(BUILD)
