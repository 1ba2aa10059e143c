# SPDX-License-Identifier: MIT
# The reader in one source and one header, and that they say what libtdsp-query.a says.
AMALGAMATION := $(BUILD)/amalgamation
$(AMALGAMATION)/tdsp_query.c: tools/amalgamation/amalgamate.py $(QUERY_SOURCES) $(wildcard $(foreach l,base geom table query,src/$(l)/*.h)) $(wildcard include/tdsp/*.h)
	$(PYTHON) $< $(VERSION) $(@D)

.PHONY: amalgamation
amalgamation: $(AMALGAMATION)/tdsp_query.c ## write the reader as one file, build/amalgamation/tdsp_query.c, and its header

checks += amalgamation
$(CHECK)/amalgamation.result: $(AMALGAMATION)/tdsp_query.c $(QUERY) ; $(RUN) $(PYTHON) tests/amalgamation/check.py $(BUILD)
