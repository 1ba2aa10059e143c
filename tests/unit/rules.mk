# SPDX-License-Identifier: MIT
# test_untrue_solver puts functions of its own before the solver's. `private`: what the program is made of is not linked so; `override`: LDFLAGS may be given.
UNTRUE_SOLVER := $(BUILD)/tests/unit/test_untrue_solver $(BUILD)/tests/faults/unit/test_untrue_solver
$(UNTRUE_SOLVER): private override LDFLAGS += -Wl,--wrap=tdsp_earliest_arrival,--wrap=tdsp_latest_departure,--wrap=tdsp_solver_gap
