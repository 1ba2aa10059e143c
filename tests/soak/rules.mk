# SPDX-License-Identifier: MIT
# The soak: random scenes of all mixes through all checks; tests/soak/soak.py spreads them over processes and keeps what was done.
SOAK_SCENES ?= 1000000
SOAK_SEED ?= 1
SOAK_JOBS ?= 2
# Short, in `make check`: from a seed of its own.
SOAK_SHORT ?= --seed 1 --count 5000
SOAK_OBJECTS := $(call objects,$(wildcard tests/soak/*.c))

$(BUILD)/tests/soak/soak: $(SOAK_OBJECTS) $(SUPPORT) $(COMMAND_PARTS) $(STATIC)
	@mkdir -p $(@D)
	$(CC) $(LDFLAGS) $(SOAK_OBJECTS) $(SUPPORT) $(COMMAND_PARTS) $(STATIC) $(TEST_LIBS) -o $@

.PHONY: soak
soak: all $(BUILD)/tests/soak/soak ## a million random scenes (SOAK_SCENES, SOAK_SEED, SOAK_JOBS) through all checks; goes on where it stopped
	@tools/setup/packages.sh check
	$(PYTHON) tests/soak/soak.py --program $(BUILD)/tests/soak/soak --out $(BUILD)/soak --scenes $(SOAK_SCENES) --seed $(SOAK_SEED) --jobs $(SOAK_JOBS)

checks += soak
$(CHECK)/soak.result: $(BUILD)/tests/soak/soak ; $(RUN) $< $(SOAK_SHORT)
