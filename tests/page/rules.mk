# SPDX-License-Identifier: MIT
# The page's core and its modules without a browser, by node's own test runner and no package of others.
NODE := node
PAGE_TESTS := $(sort $(wildcard tests/page/*.test.js))

checks += page
$(CHECK)/page.result: $(BUILD)/page/tdsp.wasm $(COMMAND) ; $(RUN) $(NODE) --test --test-reporter=tap $(PAGE_TESTS)

# The page itself in a browser: not everybody's machine has one.
.PHONY: check-page
check-page: ## try the page in Chromium, installed first where it is missing: clicks, keys, files, pictures, frame times; and check its types
	@tools/setup/packages.sh page-check
	@$(MAKE) --no-print-directory -s $(PAGE)/index.html $(COMMAND)
	@rm -rf $(CHECK)/browser && mkdir -p $(CHECK)/browser
	@TEST_TIMEOUT=3600 tests/run.sh $(CHECK)/browser/page.result page tests/page/browser/check.sh $(abspath $(BUILD))
	@tests/run.sh $(CHECK)/browser/types.result types tests/page/types/check.sh $(abspath $(BUILD))
	@sed -n 's/^# \(measured .*\)/\1/p' $(CHECK)/browser/page.out
	@tests/summary.sh $(CHECK)/browser
