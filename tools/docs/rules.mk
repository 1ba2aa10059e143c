# SPDX-License-Identifier: MIT
# The site: the headers and the Markdown pages by Doxygen, in the build directory. A warning is an error.
DOXYGEN := doxygen
SITE := $(BUILD)/docs
PAGES := README.md $(sort $(wildcard docs/*.md docs/*/*.md))

.PHONY: docs site
docs: ## write the documentation site, build/docs/html (Doxygen)
	@tools/setup/packages.sh docs
	@$(MAKE) --no-print-directory -s site
	@echo "$(SITE)/html/index.html"

site: $(SITE)/made
$(SITE)/made: $(wildcard include/tdsp/*.h) $(PAGES) $(wildcard tools/docs/*) docs/pictures
	@rm -rf $(SITE) && mkdir -p $(SITE)
	@$(PYTHON) tools/docs/pages.py pages $(SITE)/pages
	@{ cat tools/docs/Doxyfile; printf '%s\n' 'PROJECT_NUMBER = $(VERSION)' 'OUTPUT_DIRECTORY = $(SITE)' 'INPUT = include/tdsp $(SITE)/pages'; } > $(SITE)/Doxyfile
	@$(DOXYGEN) $(SITE)/Doxyfile
	@$(PYTHON) tools/docs/pages.py files $(SITE)/html
	@touch $@
