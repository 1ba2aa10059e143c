# SPDX-License-Identifier: MIT
# Threads: what the headers promise to them, under the thread sanitizer.
THREADS_PROGRAM := $(BUILD)/threads/threads
THREADS_SOURCES := tests/threads/threads.c tests/support/random_scene.c $(LIB_SOURCES)
$(THREADS_PROGRAM): $(THREADS_SOURCES) $(wildcard src/*/*.h include/tdsp/*.h) tests/support/chance.h tests/support/random_scene.h
	@mkdir -p $(@D)
	$(CLANG) -std=c99 -O1 -g $(WARNINGS) -ffp-contract=off -fno-math-errno $(POSIX) $(CPPFLAGS) -Itests -fsanitize=thread $(THREADS_SOURCES) -lm -o $@

.PHONY: threads
threads: $(THREADS_PROGRAM) ## what the headers promise to threads, 100 times, under the thread sanitizer
	@tests/run.sh $(BUILD)/threads/threads.result threads tests/threads/check.sh $(THREADS_PROGRAM) 100

checks += threads
$(CHECK)/threads.result: $(THREADS_PROGRAM) ; $(RUN) tests/threads/check.sh $(THREADS_PROGRAM) 5
