# SPDX-License-Identifier: MIT
# The page: the library as WebAssembly, and one HTML file that holds everything and runs from anywhere. Built by clang 14 over Debian's wasi-libc, whose
# module needs nothing of the system it runs on.
PAGE := $(BUILD)/page
WASM_CC := clang-14 --target=wasm32-wasi --sysroot=/usr
# What every browser with import maps has (docs/page.md). The stack lies first, so that an overflow traps. Optimizing over all files at once saves a seventh of the
# time of a search, and changes no result.
WASM_CFLAGS := -std=c99 -O2 -flto $(WARNINGS) -ffp-contract=off -fno-math-errno -mbulk-memory -msign-ext -mnontrapping-fptoint -Iinclude
WASM_LINK := -O2 -flto -mexec-model=reactor -Wl,-z,stack-size=1048576 -Wl,--stack-first -Wl,--strip-all -Wl,--gc-sections
WASM_OBJECTS := $(patsubst %.c,$(PAGE)/obj/%.o,$(LIB_SOURCES) $(sort $(wildcard tools/page/core/*.c)))
PAGE_PARTS := $(wildcard tools/page/index.html tools/page/*.css tools/page/js/*.js tools/page/gallery/*.json examples/scenes/*.json)

$(PAGE)/flags: FORCE
	$(call remember,$(WASM_CC) $(WASM_CFLAGS) $(WASM_LINK) $(WASM_OBJECTS))
$(PAGE)/obj/src/%.o: src/%.c $(PAGE)/flags
	@mkdir -p $(@D)
	$(WASM_CC) $(WASM_CFLAGS) -Isrc -MMD -MP -c $< -o $@
# The glue sees the public headers only.
$(PAGE)/obj/tools/%.o: tools/%.c $(PAGE)/flags
	@mkdir -p $(@D)
	$(WASM_CC) $(WASM_CFLAGS) -MMD -MP -c $< -o $@
-include $(WASM_OBJECTS:.o=.d)

$(PAGE)/tdsp.wasm: $(WASM_OBJECTS)
	$(WASM_CC) $(WASM_LINK) $^ -o $@

$(PAGE)/index.html: tools/page/inline.py $(PAGE)/tdsp.wasm $(PAGE_PARTS)
	$(PYTHON) $< tools/page $(PAGE)/tdsp.wasm $@

.PHONY: page page-wasm
page-wasm: ## build the library for JavaScript, build/page/tdsp.wasm
	@tools/setup/packages.sh page
	@$(MAKE) --no-print-directory -s $(PAGE)/tdsp.wasm
page: ## build the page, build/page/index.html: one file with everything inside
	@tools/setup/packages.sh page
	@$(MAKE) --no-print-directory -s $(PAGE)/index.html
