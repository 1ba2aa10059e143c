# SPDX-License-Identifier: MIT
# The wrappers of examples/: each reads one golden table, makes one more, and prints what the C program prints, to the bit; and takes misuse well. What they
# build goes to build/languages. Their toolchains are those of `tools/setup/packages.sh languages`, or others that are there.
WRAPPERS := cpp rust go java node
languages += $(WRAPPERS)
$(WRAPPERS:%=$(CHECK)/languages/%.result): $(CHECK)/languages/%.result: all $(BUILD)/examples/read_table $(BUILD)/examples/custom_oracle
	$(RUN) tests/languages/check_$*.sh $(abspath $(BUILD))

# One language: make check-language LANGUAGE=go
.PHONY: check-language
check-language: ## the wrapper of one language: make check-language LANGUAGE=cpp, rust, go, java or node
	@tools/setup/packages.sh languages
	@rm -f $(CHECK)/languages/$(LANGUAGE).*
	+@$(MAKE) --no-print-directory -s $(CHECK)/languages/$(LANGUAGE).result
	@tests/summary.sh $(CHECK)/languages

# What docs/ffi.md tells: layouts, and code that is run elsewhere.
checks += ffi
$(CHECK)/ffi.result: ; $(RUN) $(PYTHON) tests/languages/check_ffi.py $(CC) docs/ffi.md
