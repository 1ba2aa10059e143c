# SPDX-License-Identifier: MIT
# Mutation of branches: the freestanding line and its tests, compiled so that each condition is an instruction of its own, are changed one condition at a time.
MUTATION := $(BUILD)/mutation
MUTATION_CC := gcc
# Addresses are those of the file; conditions stay where the source has them; objdump misreads the files of later DWARF.
MUTATION_FLAGS := -std=c99 -O1 -gdwarf-4 -fno-pie -ffp-contract=off -fno-math-errno -fno-inline -fno-if-conversion -fno-if-conversion2 -fno-tree-loop-if-convert \
  -fno-ssa-phiopt -fno-jump-tables -fno-tree-switch-conversion -fno-bit-tests -fno-reorder-blocks -fno-crossjumping -fno-thread-jumps \
  -fno-tree-dominator-opts --param logical-op-non-short-circuit=0
# The unit tests of the freestanding line, as for its coverage.
MUTATION_TESTS := $(LINE_TESTS:%=$(MUTATION)/test_%)
MUTATE = $(PYTHON) tests/mutation/mutate.py --build $(MUTATION)

$(MUTATION)/obj/%.o: %.c tests/mutation/rules.mk | tool-packages
	@mkdir -p $(@D)
	$(MUTATION_CC) $(CPPFLAGS) $(TEST_CPPFLAGS) $(MUTATION_FLAGS) -MMD -MP -c $< -o $@
$(MUTATION)/libquery.a: $(patsubst %.c,$(MUTATION)/obj/%.o,$(QUERY_SOURCES))
	@rm -f $@
	$(AR) crs $@ $^
# What is not to be changed has no lines.
MUTATION_REST := $(addprefix $(MUTATION)/,$(notdir $(SUPPORT) $(COMMAND_PARTS) $(STATIC)))
$(MUTATION_REST): $(SUPPORT) $(COMMAND_PARTS) $(STATIC)
	@mkdir -p $(@D)
	strip --strip-debug -o $@ $(filter %/$(@F),$^)
$(MUTATION_TESTS): $(MUTATION)/%: $(MUTATION)/obj/tests/unit/%.o $(MUTATION)/libquery.a $(MUTATION_REST)
	$(MUTATION_CC) -no-pie $< -Wl,--whole-archive $(MUTATION)/libquery.a -Wl,--no-whole-archive $(MUTATION_REST) $(TEST_LIBS) -o $@
$(MUTATION)/hits: tests/mutation/hits.c
	@mkdir -p $(@D)
	$(MUTATION_CC) -std=c99 -O1 $(WARNINGS) $< -o $@
-include $(wildcard $(MUTATION)/obj/*/*/*.d)

.PHONY: mutate
mutate: ## take each condition of layers 0 to 2 always, then never: a unit test must notice
	@tools/setup/packages.sh check
	@$(MAKE) --no-print-directory -s $(MUTATION_TESTS) $(MUTATION)/hits
	@nice $(MUTATE) --jobs $(JOBS) $(MUTATION_TESTS)

# In `make check`: the same few every time, which must die, of the folders whose tests take no time.
MUTATION_SHORT := $(addprefix $(MUTATION)/test_,bytes curve_table forged gap_table guide math matrix matrix_edges outward path query query_edges query_paths reopen single status table table_edges table_versions)
checks += mutation
$(CHECK)/mutation.result: $(MUTATION_SHORT) $(MUTATION)/hits ; $(RUN) $(MUTATE) --jobs 1 --sample 60 --only 'src/(base|table|query)/' $(MUTATION_SHORT)
