# SPDX-License-Identifier: MIT
# Results are the same to the bit whatever the compiler and its optimisation.
SAME = $(PYTHON) tests/same/same.py $(1) $(BUILD) $(PKG_CONFIG) -std=c99 $(CPPFLAGS) $(TEST_CPPFLAGS)
.PHONY: same
same: all ## compare the bits of answers between gcc and clang-19 at every level of optimisation
	@tools/setup/packages.sh check
	@$(MAKE) --no-print-directory -s $(COMMAND_PARTS)
	@tests/run.sh $(BUILD)/same/full.result same $(call SAME,full)

checks += same
$(CHECK)/same.result: all $(COMMAND_PARTS) ; $(RUN) $(call SAME,short)
