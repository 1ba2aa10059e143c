# SPDX-License-Identifier: MIT
# Firmware: the reader on Cortex-M3, M4F and M7, run in qemu-system-arm: the example, golden files, and what a look-up costs, held to budgets.
FIRMWARE := $(BUILD)/firmware
FIRMWARE_CORES := m3 m4f m7
FIRMWARE_CC := arm-none-eabi-gcc
# The M4F does floats in hardware and doubles in software, the M3 both in software, the M7 both in hardware.
flags_m3 := -mcpu=cortex-m3 -mthumb
flags_m4f := -mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard
flags_m7 := -mcpu=cortex-m7 -mthumb -mfpu=fpv5-d16 -mfloat-abi=hard
FIRMWARE_CFLAGS := -std=c99 -Os $(WARNINGS) -ffp-contract=off -fno-math-errno -ffunction-sections -fdata-sections -Iinclude -Isrc
# What it would be linked with: the freestanding line, from which the linker takes what is called. Of src/geom only paths are.
FIRMWARE_READER := $(filter-out src/geom/%,$(QUERY_SOURCES)) src/geom/path.c
FIRMWARE_LINK := -T examples/firmware/firmware.ld -nostartfiles -Wl,--gc-sections --specs=rdimon.specs
# Debian's newlib has PRIx64 and the like only for its own <stdint.h>, and its gcc brings another.
FIRMWARE_INTTYPES := -D__int32_t_defined=1 -D__int64_t_defined=1
FIRMWARE_PROGRAMS := robot measure answers mathematics
FIRMWARE_ROUTE_SCENE := examples/scenes/two-discs.json
# Rows of 256 departures, with legs on discs whose rates change: the longest there are.
FIRMWARE_LONG_SCENE := examples/scenes/fires-accelerating.json

$(FIRMWARE)/route.c: $(FIRMWARE_ROUTE_SCENE) $(COMMAND)
	@mkdir -p $(@D)
	$(BUILD)/tdsp build $< -o $(@:.c=.tdsp) >/dev/null
	$(BUILD)/tdsp embed $(@:.c=.tdsp) -o $@
$(FIRMWARE)/long.c: $(FIRMWARE_LONG_SCENE) $(COMMAND)
	@mkdir -p $(@D)
	$(BUILD)/tdsp build $< --epsilon 0.000614 -o $(@:.c=.tdsp) >/dev/null
	$(BUILD)/tdsp embed $(@:.c=.tdsp) --name route -o $@

# One core: $(1).
define firmware_core
$(FIRMWARE)/$(1)/src/%.o: src/%.c tests/firmware/rules.mk
	@mkdir -p $$(@D)
	$(FIRMWARE_CC) $(FIRMWARE_CFLAGS) $$(flags_$(1)) -fcallgraph-info=su -MMD -MP -c $$< -o $$@
$(FIRMWARE)/$(1)/libtdsp-query.a: $(patsubst %.c,$(FIRMWARE)/$(1)/%.o,$(FIRMWARE_READER))
	@rm -f $$@
	arm-none-eabi-ar crs $$@ $$^
$(FIRMWARE)/$(1)/robot.elf: examples/firmware/robot.c $(FIRMWARE)/route.c
$(FIRMWARE)/$(1)/measure.elf: tests/firmware/measure.c $(FIRMWARE)/long.c
$(FIRMWARE)/$(1)/answers.elf: tests/firmware/answers.c tests/portable/answers.c
$(FIRMWARE)/$(1)/mathematics.elf: tests/portable/mathematics.c tests/support/functions.c
$(FIRMWARE_PROGRAMS:%=$(FIRMWARE)/$(1)/%.elf): examples/firmware/startup.c examples/firmware/firmware.ld $(FIRMWARE)/$(1)/libtdsp-query.a
	$(FIRMWARE_CC) $(FIRMWARE_CFLAGS) -Itests $(FIRMWARE_INTTYPES) $$(flags_$(1)) $(FIRMWARE_LINK) -Wl,-Map,$$(@:.elf=.map) $$(filter-out tests/portable/answers.c,$$(filter %.c,$$^)) $(FIRMWARE)/$(1)/libtdsp-query.a -lm -o $$@
endef
$(foreach core,$(FIRMWARE_CORES),$(eval $(call firmware_core,$(core))))
-include $(wildcard $(FIRMWARE)/*/src/*/*.d)

# The same programs on this machine.
$(FIRMWARE)/host/robot: examples/firmware/robot.c $(FIRMWARE)/route.c
$(FIRMWARE)/host/measure: tests/firmware/measure.c $(FIRMWARE)/long.c
$(FIRMWARE)/host/%: $(QUERY)
	@mkdir -p $(@D)
	$(CC) $(EXAMPLE_CFLAGS) $(LDFLAGS) $(filter %.c,$^) $(QUERY) -lm -o $@

FIRMWARE_ELFS := $(foreach core,$(FIRMWARE_CORES),$(FIRMWARE_PROGRAMS:%=$(FIRMWARE)/$(core)/%.elf)) $(FIRMWARE)/host/robot $(FIRMWARE)/host/measure

.PHONY: firmware
firmware: ## run the example firmware on Cortex-M3, M4F and M7 in qemu, and print what the reader takes there
	@tools/setup/packages.sh check
	@$(MAKE) --no-print-directory -s $(FIRMWARE_ELFS)
	@$(PYTHON) tests/firmware/firmware.py show $(FIRMWARE)

checks += firmware
$(CHECK)/firmware.result: $(FIRMWARE_ELFS) ; $(RUN) $(PYTHON) tests/firmware/firmware.py check $(FIRMWARE)
