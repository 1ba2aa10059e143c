# SPDX-License-Identifier: MIT
# What a user installs: manual, completions, and what a release is made of.
checks += manual completions licences
$(CHECK)/manual.result: man ; $(RUN) $(PYTHON) tests/packaging/check_manual.py $(BUILD)/tdsp $(MAN)
$(CHECK)/completions.result: completions ; $(RUN) $(PYTHON) tests/packaging/check_completions.py $(BUILD)/tdsp $(COMPLETIONS) bash
$(CHECK)/licences.result: ; $(RUN) $(PYTHON) tests/packaging/check_licences.py

# With the shells and tools that not everybody has.
PACKAGING := $(BUILD)/packaging
.PHONY: check-packaging
check-packaging: ## complete words in bash, zsh and fish
	@tools/setup/packages.sh packaging
	@$(MAKE) --no-print-directory -s all man completions
	@rm -rf $(PACKAGING)/check && mkdir -p $(PACKAGING)/check
	@tests/run.sh $(PACKAGING)/check/completions.result completions $(PYTHON) tests/packaging/check_completions.py $(BUILD)/tdsp $(COMPLETIONS) bash zsh fish
	@tests/summary.sh $(PACKAGING)/check
