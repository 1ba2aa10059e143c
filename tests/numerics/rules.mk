# SPDX-License-Identifier: MIT
# Numbers: the library's answers beside those of the slow solver in long double, a bound beside each error (docs/numerics.md).
NUMERICS_SCENES ?= 60
NUMERICS := $(BUILD)/tests/numerics/numerics
# The sources of tests/slow once more, with other names and another number.
PRECISE := $(patsubst tests/slow/%.c,$(BUILD)/obj/tests/precise/%.o,$(wildcard tests/slow/slow*.c))
$(PRECISE): $(BUILD)/obj/tests/precise/%.o: tests/slow/%.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(CC) -DSLOW_PRECISE $(CPPFLAGS) -Itests $(CFLAGS) -MMD -MP -c $< -o $@
$(NUMERICS): $(call objects,$(wildcard tests/numerics/*.c)) $(PRECISE) $(SUPPORT) $(STATIC)
	@mkdir -p $(@D)
	$(CC) $(LDFLAGS) $(filter %.o %.a,$^) $(TEST_LIBS) -o $@

.PHONY: numerics
numerics: $(NUMERICS) all ## measure the errors of answers against a precise solver (NUMERICS_SCENES=60 of each mix) and with a hundred digits
	$< table $(NUMERICS_SCENES)
	$(PYTHON) tests/numerics/digits.py $(BUILD) --table --scenes examples/scenes $(wildcard $(TDSP_DATA)/scenes)

checks += numerics digits
$(CHECK)/numerics.result: $(NUMERICS) ; $(RUN) $< check
$(CHECK)/digits.result: all ; $(RUN) $(PYTHON) tests/numerics/digits.py $(BUILD) --departures 3
