# Numbers: the library's answers beside those of the slow solver in long double, a bound beside each error (docs/numerics.md).
NUMERICS_SCENES ?= 200
NUMERICS := $(BUILD)/tests/numerics/numerics
# The sources of tests/slow once more, with other names and another number.
PRECISE := $(patsubst tests/slow/%.c,$(BUILD)/obj/tests/precise/%.o,$(wildcard tests/slow/slow*.c))
$(PRECISE): $(BUILD)/obj/tests/precise/%.o: tests/slow/%.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(CC) -DSLOW_PRECISE $(CPPFLAGS) -Itests $(CFLAGS) -MMD -MP -c $< -o $@
$(NUMERICS): $(call objects,$(wildcard tests/numerics/*.c)) $(PRECISE) $(SUPPORT) $(STATIC)
	@mkdir -p $(@D)
	$(CC) $(LDFLAGS) $(filter %.o %.a,$^) $(TEST_LIBS) -o $@

.PHONY: numerics
numerics: $(NUMERICS) ## measure the errors of answers against a precise solver (NUMERICS_SCENES=200 of each mix)
	$< table $(NUMERICS_SCENES)

checks += numerics
$(CHECK)/numerics.result: $(NUMERICS) ; $(RUN) $< check
