# SPDX-License-Identifier: MIT
# Coverage of branches and conditions, by clang: every test program, every script of the command and the tests of faults run in a build of their own.
# `coverage` measures all of it; `check` measures the freestanding line by the unit tests, which must cover it by themselves.
ifdef COVERAGE
# Atomic: where threads lose counts, those of rare outcomes, which are differences, come out as none.
CFLAGS += -fprofile-instr-generate -fcoverage-mapping -fcoverage-mcdc -fprofile-update=atomic
LDFLAGS += -fprofile-instr-generate
# %m: programs that are run many times add up in one file each.
export LLVM_PROFILE_FILE := $(abspath $(BUILD))/profiles/%m.profraw
endif
COVERAGE_BUILD := $(BUILD)/coverage
COVERAGE_MAKE = $(MAKE) --no-print-directory -s COVERAGE=1 CC=$(CLANG) OPTIMIZE=-O1 BUILD=$(COVERAGE_BUILD) CHECK=$(COVERAGE_BUILD)/check VARIANT=coverage
COVERAGE_MAKE += SHIM_EVERY=5 FAULTS_SHORT="FAULTS_ALL=0 FAULTS_EACH_PATH=1 FAULTS_DEPTH=4 FAULTS_ONCE_ONLY=1 FAULTS_STOP=2000"
COVERAGE_REPORT = $(PYTHON) tests/coverage/report.py --profiles $(COVERAGE_BUILD)/profiles

# The tests of the freestanding line are objects, too: its inline functions are compiled into each.
COVERAGE_OBJECTS = $(COVERAGE_BUILD)/libtdsp.so $(COVERAGE_BUILD)/tdsp $(LINE_TESTS:%=$(COVERAGE_BUILD)/tests/unit/test_%)

# The freestanding line by itself, and the unit tests that are about it: those must cover it without the help of others.
LINE_TESTS := angle bytes contact contact_wide curve_table forged gap_table guide law math matrix matrix_edges outward path polynomial polynomial_edges query query_edges query_paths reopen single skyline spiral status table table_edges table_versions tangent tangent_ends
LINE := $(COVERAGE_BUILD)/line
LINE_PROGRAMS := $(LINE_TESTS:%=$(LINE)/test_%)
LINE_FLAGS := -std=c99 -O1 -fPIC -ffp-contract=off -fno-math-errno -fprofile-instr-generate -fcoverage-mapping -fcoverage-mcdc
$(LINE)/obj/%.o: %.c tests/coverage/rules.mk | tool-packages
	@mkdir -p $(@D)
	$(CLANG) $(CPPFLAGS) $(TEST_CPPFLAGS) $(LINE_FLAGS) -MMD -MP -c $< -o $@
$(LINE)/libline.so: $(patsubst %.c,$(LINE)/obj/%.o,$(QUERY_SOURCES))
	$(CLANG) -fprofile-instr-generate -shared $^ -lm -o $@
# What the tests need above the line to make their tables is not measured.
$(LINE_PROGRAMS): $(LINE)/%: $(LINE)/obj/tests/unit/%.o $(patsubst %.c,$(LINE)/obj/%.o,$(QUERY_SOURCES)) $(SUPPORT) $(COMMAND_PARTS) $(STATIC)
	$(CLANG) -fprofile-instr-generate $^ $(TEST_LIBS) -o $@
-include $(wildcard $(LINE)/obj/*/*/*.d)

.PHONY: coverage-line
coverage-line: $(LINE)/libline.so $(LINE_PROGRAMS) ## measure how the unit tests of layers 0 to 2 cover these by themselves
	@rm -rf $(LINE)/profiles
	@for program in $(LINE_PROGRAMS); do LLVM_PROFILE_FILE=$(LINE)/profiles/%m.profraw $$program >$(LINE)/log 2>&1 || { cat $(LINE)/log; exit 1; }; done
	@$(PYTHON) tests/coverage/report.py --profiles $(LINE)/profiles --strict-only $(LINE)/libline.so $(LINE_PROGRAMS)

checks += coverage-line
$(CHECK)/coverage-line.result: $(STATIC) $(SUPPORT) $(COMMAND_PARTS) ; $(RUN) $(MAKE) --no-print-directory -s coverage-line

.PHONY: coverage
coverage: ## measure lines, branches and conditions covered by all tests, and compare with tests/coverage/uncovered.csv
	@tools/setup/packages.sh check
	@rm -rf $(COVERAGE_BUILD)/profiles $(COVERAGE_BUILD)/check
	+@$(COVERAGE_MAKE) all tests faulty-programs
	+@$(COVERAGE_MAKE) -k run-tests $(COVERAGE_BUILD)/check/faults/allocations.result $(COVERAGE_BUILD)/check/file-faults.result
	@tests/summary.sh $(COVERAGE_BUILD)/check
	@$(COVERAGE_REPORT) $(COVERAGE_OBJECTS)
