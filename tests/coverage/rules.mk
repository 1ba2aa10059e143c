# Coverage of branches and conditions, by clang: every test program and every script of the command run in a build of its own.
# `coverage` measures all of it; `check` measures the freestanding line by the unit tests, which must cover it by themselves.
ifdef COVERAGE
CFLAGS += -fprofile-instr-generate -fcoverage-mapping -fcoverage-mcdc
LDFLAGS += -fprofile-instr-generate
# %m: programs that are run many times add up in one file each.
export LLVM_PROFILE_FILE := $(abspath $(BUILD))/profiles/%m.profraw
endif
COVERAGE_BUILD := $(BUILD)/coverage
COVERAGE_MAKE = $(MAKE) --no-print-directory -s COVERAGE=1 CC=$(CLANG) OPTIMIZE=-O1 BUILD=$(COVERAGE_BUILD) CHECK=$(COVERAGE_BUILD)/check VARIANT=coverage
COVERAGE_REPORT = $(PYTHON) tests/coverage/report.py --profiles $(COVERAGE_BUILD)/profiles

.PHONY: coverage
coverage: ## measure lines, branches and conditions covered by all tests, and compare with tests/coverage/uncovered.csv
	@tools/setup/packages.sh check
	@rm -rf $(COVERAGE_BUILD)/profiles $(COVERAGE_BUILD)/check
	+@$(COVERAGE_MAKE) all tests
	+@$(COVERAGE_MAKE) -k run-tests
	@tests/summary.sh $(COVERAGE_BUILD)/check
	@$(COVERAGE_REPORT) $(COVERAGE_BUILD)/libtdsp.so $(COVERAGE_BUILD)/tdsp
