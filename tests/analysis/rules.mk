# SPDX-License-Identifier: MIT
# Static analysis. `make check` analyses layers 0 to 2, which read bytes from anywhere, by gcc and cppcheck; `make analyze` everything, by clang-tidy too.
ANALYZE := tests/analysis/analyze.sh

.PHONY: analyze
analyze: ## analyse library and command by gcc -fanalyzer, cppcheck and clang-tidy (.clang-tidy)
	@tools/setup/packages.sh check
	@$(ANALYZE) gcc $(LIB_SOURCES) $(TOOL_SOURCES)
	@$(ANALYZE) cppcheck $(LIB_SOURCES) $(TOOL_SOURCES)
	@$(ANALYZE) clang-tidy $(LIB_SOURCES) $(TOOL_SOURCES)

checks += analysis
$(CHECK)/analysis.result: ; $(RUN) bash -c 'status=0; for tool in gcc cppcheck; do $(ANALYZE) $$tool $(QUERY_SOURCES) || status=1; done; exit $$status'
