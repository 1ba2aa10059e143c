# SPDX-License-Identifier: MIT
# The library's own mathematics (src/base/math_*.c): errors and price beside the C library's, and where its constants come from.
MATHEMATICS_COUNT ?= 3000000
MATHEMATICS_SEED ?= 1
MATHEMATICS := $(BUILD)/tests/mathematics/errors
$(MATHEMATICS): $(call objects,tests/mathematics/errors.c) $(SUPPORT) $(STATIC)
	@mkdir -p $(@D)
	$(CC) $(LDFLAGS) $(filter %.o %.a,$^) $(TEST_LIBS) -o $@

.PHONY: mathematics
mathematics: $(MATHEMATICS) ## measure errors and price of the library's own sine, logarithm, ... (MATHEMATICS_COUNT=3000000 arguments of each range)
	$< $(MATHEMATICS_COUNT) $(MATHEMATICS_SEED)
	$(PYTHON) tests/mathematics/constants.py check

checks += constants
$(CHECK)/constants.result: ; $(RUN) $(PYTHON) tests/mathematics/constants.py check
