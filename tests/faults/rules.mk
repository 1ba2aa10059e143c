# SPDX-License-Identifier: MIT
# Faults: allocations that fail, files that cannot be read or written, and interruptions.
#
# Every test with CMocka's runner is linked a second time, with ours and the allocator's functions wrapped (inject.h, memory.h).
FAULTY := $(patsubst tests/%.c,$(BUILD)/tests/faults/%,$(filter tests/unit/% tests/property/%,$(TEST_SOURCES)))
PLANTED := $(BUILD)/tests/faults/planted
MEMORY_WRAP := -Wl,--wrap=memory_resize,--wrap=memory_array,--wrap=memory_reserve,--wrap=memory_shrink
REWIND_WRAP := -Wl,--wrap=free,--wrap=realloc,--wrap=fopen,--wrap=pthread_create
INJECT := $(call objects,tests/faults/blocks.c tests/faults/inject.c tests/faults/memory.c tests/faults/rewind.c tests/faults/run_tests.c)
REWOUND := $(call objects,tests/faults/rewind_begin.c tests/faults/rewind_end.c)
$(BUILD)/obj/tests/faults/%.o: POSIX += -D_DEFAULT_SOURCE
# What is to be rewound stands between the two, and what rewinds it behind.
$(FAULTY) $(PLANTED): $(INJECT) $(REWOUND) $(SUPPORT) $(COMMAND_PARTS) $(STATIC)
	@mkdir -p $(@D)
	$(CC) $(LDFLAGS) $(MEMORY_WRAP) $(REWIND_WRAP) $(firstword $(REWOUND)) $(filter %/$(@F).o,$^) $(SUPPORT) $(COMMAND_PARTS) $(STATIC) $(lastword $(REWOUND)) \
		$(INJECT) $(STATIC) $(TEST_LIBS) -o $@
$(FAULTY): $(BUILD)/tests/faults/%: $(BUILD)/obj/tests/%.o
$(PLANTED): $(call objects,tests/faults/planted.c)
FAULTY_UNIT := $(filter $(BUILD)/tests/faults/unit/%,$(FAULTY))

# The command with the system's answers changed.
SHIMMED := $(BUILD)/tests/faults/tdsp
SHIM_WRAP := -Wl,--wrap=open,--wrap=read,--wrap=write,--wrap=close,--wrap=fsync,--wrap=fchmod,--wrap=rename,--wrap=mkstemp,--wrap=progress_show,--wrap=g_thread_pool_new,--wrap=cairo_status,--wrap=cairo_surface_status
$(SHIMMED): $(call objects,$(TOOL_SOURCES) tests/faults/shim.c tests/faults/memory.c) $(STATIC)
	@mkdir -p $(@D)
	$(CC) $(LDFLAGS) $(SHIM_WRAP) $(MEMORY_WRAP) $(filter %.o,$^) $(STATIC) $(TOOL_LIBS) -o $@

# Small: a victim's fork copies what the sanitizer holds back of freed blocks and of how blocks came to be.
CAMPAIGN = env ASAN_OPTIONS=$$ASAN_OPTIONS:quarantine_size_mb=1:thread_local_quarantine_size_kb=64:malloc_context_size=8$(FRAMES) $(PYTHON) tests/faults/campaign.py
# Frames on the sanitizer's heap cannot be rewound. Forks keep them: in `make check` all victims are forked.
faults: FRAMES := :detect_stack_use_after_return=0

FAULTS_OF ?= unit property
# Every public function, without each of its allocations.
STARVED := tests/unit/test_no_memory tests/unit/test_no_memory_building
.PHONY: faulty-programs run-faults faults
faulty-programs: $(FAULTY) $(PLANTED) $(SHIMMED)
faults: ## fail every allocation of all tests, going on where the last run stopped (FAULTS_SECONDS=3600: for so long), and every file operation of the command
	@tools/setup/packages.sh check
	+@$(MAKE) --no-print-directory -s SANITIZE=1 CC=$(CLANG) BUILD=$(BUILD)/sanitize faulty-programs all $(STARVED:%=$(BUILD)/sanitize/%)
	$(foreach program,$(STARVED:%=$(BUILD)/sanitize/%),SCARCE_ALL=1000000 $(program) &&) $(PYTHON) tests/faults/check_planted.py $(BUILD)/sanitize/tests/faults/planted
	TDSP=$(abspath $(BUILD))/sanitize/tdsp TDSP_SHIMMED=$(abspath $(BUILD))/sanitize/tests/faults/tdsp SHIM_EVERY=1 $(PYTHON) tests/faults/files.py
	$(CAMPAIGN) --jobs $(JOBS) --keep $(BUILD)/faults/allocations $(FAULTS_SECONDS:%=--seconds %) --report $(BUILD)/faults/allocations.txt $(foreach kind,$(FAULTS_OF),$(filter $(BUILD)/sanitize/tests/faults/$(kind)/%,$(FAULTY:$(BUILD)/%=$(BUILD)/sanitize/%)))

# In `make check`: the first of each way to an allocation, told by three calls, among the first 100 of each unit test. Left out are tests without
# allocations, and those that only read tables.
SHORT_LEFT_OUT := angle bernstein bytes contact contact_wide geodesic georeference instant law margin_touch path path_json path_points polynomial polynomial_edges skyline spiral status tangent tangent_ends curve_table guide query query_paths table table_edges table_versions
FAULTS_SHORT := FAULTS_ALL=0 FAULTS_EACH_PATH=1 FAULTS_DEPTH=3 FAULTS_STOP=100 FAULTS_ONCE_ONLY=1
FAULTY_SHORT := $(filter-out $(SHORT_LEFT_OUT:%=$(BUILD)/tests/faults/unit/test_%),$(FAULTY_UNIT))
run-faults: $(CHECK)/faults/planted.result $(CHECK)/faults/allocations.result
$(CHECK)/faults/planted.result: $(PLANTED) FORCE
	$(RUN) $(PYTHON) tests/faults/check_planted.py $(PLANTED)
$(CHECK)/faults/allocations.result: $(FAULTY_SHORT) FORCE
	$(RUN) env $(FAULTS_SHORT) $(CAMPAIGN) $(FAULTY_SHORT)

# The operations of the command on files, and its memory; signals at one in 20 of the steps of long work.
SHIM_EVERY := 20
checks += file-faults no-memory-calls
$(CHECK)/file-faults.result: $(COMMAND) $(SHIMMED)
	$(RUN) env TDSP_SHIMMED=$(abspath $(SHIMMED)) SHIM_EVERY=$(SHIM_EVERY) $(PYTHON) tests/faults/files.py

# No public function is left out of the tests without memory.
$(CHECK)/no-memory-calls.result: all ; $(RUN) $(PYTHON) tests/faults/check_calls.py $(BUILD)

steps += check-faults
.PHONY: check-faults
check-faults: check-sanitize
	+@$(MAKE) --no-print-directory -s SANITIZE=1 CC=$(CLANG) BUILD=$(BUILD)/sanitize CHECK=$(CHECK) run-faults
