# SPDX-License-Identifier: MIT
# The binary interface: the exported symbols and the layout of public types, compared with their record.
ABI = $(PYTHON) tests/abi/abi.py $(1) $(BUILD) $(CC) $(CFLAGS)
.PHONY: abi-record
abi-record: ## record the binary interface anew (tests/abi/libtdsp.abi, src/libtdsp.map, tools/debian/libtdsp0.symbols)
	@tools/setup/packages.sh check
	@$(call ABI,record)
	@tools/dist/symbols.py $(VERSION)

checks += abi
$(CHECK)/abi.result: all ; $(RUN) $(call ABI,check)
