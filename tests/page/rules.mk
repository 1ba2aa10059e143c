# SPDX-License-Identifier: MIT
# The page's core and its modules without a browser, by node's own test runner and no package of others.
NODE := node
PAGE_TESTS := $(sort $(wildcard tests/page/*.test.js))

checks += page
$(CHECK)/page.result: $(BUILD)/page/tdsp.wasm $(COMMAND) ; $(RUN) $(NODE) --test --test-reporter=tap $(PAGE_TESTS)
