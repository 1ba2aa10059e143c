# SPDX-License-Identifier: MIT
# What is handed out: the release with its list of contents, and Debian packages made from it.
DIST := $(BUILD)/dist
RELEASE := $(DIST)/libtdsp-$(VERSION).tar.gz

.PHONY: dist
dist: ## pack the release, build/dist/libtdsp-VERSION.tar.gz, and its SPDX list of contents
	@$(PYTHON) tools/dist/dist.py $(VERSION) $(EPOCH) $(DIST)
	@ls $(DIST)/libtdsp-$(VERSION).*

# With the tests of the package, unless DEB_BUILD_OPTIONS=nocheck.
DEB := $(BUILD)/deb
.PHONY: deb
deb: ## build the Debian packages, source and binary, in build/deb
	@tools/setup/packages.sh packaging
	@$(MAKE) --no-print-directory -s dist
	@tools/dist/deb.sh $(RELEASE) $(VERSION) $(DEB)
