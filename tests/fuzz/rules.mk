# Fuzzing: what reads bytes or text from nowhere. A program is any fuzz_*.c here; tests/fuzz.sh runs them.
FUZZ_SECONDS ?= 10
FUZZ_SOURCES := $(sort $(wildcard tests/fuzz/fuzz_*.c))
# What targets share: scenes from bytes, and what their answers are held to.
FUZZ_PARTS := tests/fuzz/world.c tests/fuzz/job.c
FUZZERS := $(patsubst %.c,$(BUILD)/%,$(FUZZ_SOURCES))

$(FUZZERS): $(BUILD)/tests/%: $(BUILD)/obj/tests/%.o $(call objects,$(FUZZ_PARTS)) $(SUPPORT) $(COMMAND_PARTS) $(STATIC)
	@mkdir -p $(@D)
	$(CC) $(LDFLAGS) $(filter %.o,$^) $(SUPPORT) $(COMMAND_PARTS) $(STATIC) $(TEST_LIBS) -o $@

.PHONY: run-fuzz
run-fuzz: $(FUZZERS:$(BUILD)/tests/%=$(CHECK)/%.result)
$(FUZZERS:$(BUILD)/tests/%=$(CHECK)/%.result): $(CHECK)/%.result: $(BUILD)/tests/% FORCE
	$(RUN) tests/fuzz.sh $(FUZZ_SECONDS) $<

.PHONY: fuzz
fuzz: ## fuzz for FUZZ_SECONDS each (default 600)
	@tools/setup/packages.sh check
	+@$(MAKE) --no-print-directory -s FUZZ=1 CC=$(CLANG) BUILD=$(BUILD)/fuzz fuzzers
	@FUZZ_SEED=$${FUZZ_SEED:-0} tests/fuzz.sh $(if $(filter command,$(origin FUZZ_SECONDS)),$(FUZZ_SECONDS),600) $(FUZZ_SOURCES:%.c=$(BUILD)/fuzz/%)
.PHONY: fuzzers
fuzzers: $(FUZZERS)

steps += check-fuzz
.PHONY: check-fuzz
check-fuzz:
	+@$(MAKE) --no-print-directory -s FUZZ=1 CC=$(CLANG) BUILD=$(BUILD)/fuzz CHECK=$(CHECK) run-fuzz
