# SPDX-License-Identifier: MIT
# Measuring: what `make bench` times beside its peers, and the gates.
# Everything in tests/bench with a main() is a program of its own; the rest is shared by them.
BENCH_PROGRAMS := $(addprefix $(BUILD)/tests/bench/,$(notdir $(basename $(shell grep -l '^int main' $(wildcard tests/bench/*.c tests/bench/*.cpp)))))
BENCH_SHARED := $(call objects,$(filter-out $(BENCH_PROGRAMS:$(BUILD)/%=%.c),$(wildcard tests/bench/*.c)))
$(filter-out %_peers,$(BENCH_PROGRAMS)): $(BUILD)/%: $(BUILD)/obj/%.o $(BENCH_SHARED) $(COMMAND_PARTS) $(STATIC)
	@mkdir -p $(@D)
	$(CC) $(LDFLAGS) $(filter %.o %.a,$^) $(TOOL_LIBS) -o $@
# valgrind does not understand the debugging information of every compiler, and needs none.
$(BUILD)/tests/bench/gates: LDFLAGS += -Wl,--strip-debug
# The peers of a look-up come from the C++ library; the library's own is timed beside them.
$(BUILD)/tests/bench/lookup_peers: tests/bench/lookup_peers.cpp $(STATIC) $(BUILD)/flags
	@mkdir -p $(@D)
	$(CXX) -std=c++17 $(OPTIMIZE) $(CPPFLAGS) -Itests $< $(STATIC) -lm -o $@

.PHONY: bench-programs
bench-programs: all $(BENCH_PROGRAMS)

# Sections: peers scaling epsilon lookup real. None given: all. The page is made from the CSV files of all sections, whenever they were measured.
ONLY ?=
BENCH_LIMIT ?= 15
BENCH = $(PYTHON) tests/bench/bench.py --build $(BUILD) --limit $(BENCH_LIMIT)

.PHONY: bench results
bench: ## measure everything (ONLY="lookup real": that) and write docs/results.md, its CSV files and pictures
	@tools/setup/packages.sh bench
	@$(MAKE) --no-print-directory -s bench-programs
	$(BENCH) --scenes $(TDSP_DATA)/scenes $(if $(ONLY),--only $(ONLY))
results: ## write docs/results.md and its pictures again from the CSV files in docs/results
	@tools/setup/packages.sh bench
	$(BENCH) --render

# Instruction counts of the hot paths, by callgrind: they repeat exactly, so that a slowdown shows on any machine, however busy.
GATES = $(PYTHON) tests/bench/gates.py $(1) $(BUILD)/tests/bench/gates tests/bench/gates.csv examples/scenes
.PHONY: gates gates-record
gates: $(BUILD)/tests/bench/gates ## compare the hot paths' instruction counts with the record
	@$(call GATES,check)
gates-record: $(BUILD)/tests/bench/gates ## record the hot paths' instruction counts in tests/bench/gates.csv
	@$(call GATES,record)

checks += gates bench
$(CHECK)/gates.result: $(BUILD)/tests/bench/gates ; $(RUN) $(call GATES,check)
$(CHECK)/bench.result: bench-programs ; $(RUN) tests/bench/check.sh $(BUILD)
