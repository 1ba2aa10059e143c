# SPDX-License-Identifier: MIT
# What is installed, and where: the command, the libraries, headers, what finds them (pkg-config, CMake), manual pages and completions.
HEADERS := $(sort $(wildcard include/tdsp/*.h))
SCHEMAS := $(sort $(wildcard docs/schema/*.json))
INSTALL := install
DATADIR ?= $(PREFIX)/share
MANDIR ?= $(DATADIR)/man
BASH_COMPLETIONS ?= $(DATADIR)/bash-completion/completions
ZSH_COMPLETIONS ?= $(DATADIR)/zsh/site-functions
FISH_COMPLETIONS ?= $(DATADIR)/fish/vendor_completions.d
SCDOC := scdoc

# ---------------------------------------------------------------------------------------- manual pages and completions

# Both tell what the program tells of itself. Cross-compiling, one that runs here has to tell it.
TELLING ?= $(BUILD)/tdsp
GENERATORS := $(wildcard tools/install/*.py)
MAN := $(BUILD)/man
COMPLETIONS := $(BUILD)/completions

# The day that stands in the pages and in all that is packed: that of the release, unless the environment says another.
EPOCH = $(or $(SOURCE_DATE_EPOCH),$(shell tools/dist/epoch.sh))

$(MAN)/made: $(TELLING) $(GENERATORS) $(HEADERS) docs/cli.md docs/format.md tools/debian/changelog
	@mkdir -p $(@D)
	$(PYTHON) tools/install/man.py $(TELLING) $(MAN)
	export SOURCE_DATE_EPOCH=$(EPOCH); for page in $(MAN)/*.scd; do $(SCDOC) < "$$page" > "$${page%.scd}" && rm "$$page" || exit 1; done
	@touch $@
$(COMPLETIONS)/made: $(TELLING) $(GENERATORS)
	@mkdir -p $(@D)
	$(PYTHON) tools/install/completions.py $(TELLING) $(COMPLETIONS)
	@touch $@

.PHONY: man completions
man: $(MAN)/made ## write the manual pages to build/man (scdoc)
completions: $(COMPLETIONS)/made ## write the completions of bash, zsh and fish to build/completions

# ----------------------------------------------------------------------------------------------------------- installing

# Neither stops an installation on a machine that lacks what they are made with.
EXTRAS := $(if $(shell command -v $(PYTHON)),completions $(if $(shell command -v $(SCDOC)),man))
POINTER_SIZE = $(shell $(CC) -dM -E -x c /dev/null | sed -n 's/.*__SIZEOF_POINTER__ //p')
INCLUDEDIR_FROM_CMAKE = $(shell realpath -m --relative-to='$(LIBDIR)/cmake/tdsp' '$(INCLUDEDIR)')
fill_in = sed -e 's|@PREFIX@|$(PREFIX)|' -e 's|@LIBDIR@|$(LIBDIR)|' -e 's|@INCLUDEDIR@|$(INCLUDEDIR)|' -e 's|@VERSION@|$(VERSION)|' \
  -e 's|@SOVERSION@|$(SOVERSION)|' -e 's|@POINTER_SIZE@|$(POINTER_SIZE)|' -e 's|@INCLUDEDIR_FROM_HERE@|$(INCLUDEDIR_FROM_CMAKE)|' tools/install/$(1).in > $(2)/$(1)

.PHONY: install install-extras
install: all install-extras ## install to DESTDIR/PREFIX (default /usr/local): command, libraries, headers, pkg-config, CMake, manual, completions
	$(INSTALL) -d $(DESTDIR)$(BINDIR) $(DESTDIR)$(LIBDIR)/pkgconfig $(DESTDIR)$(LIBDIR)/cmake/tdsp $(DESTDIR)$(INCLUDEDIR)/tdsp
	$(INSTALL) -m 755 $(BUILD)/tdsp $(DESTDIR)$(BINDIR)/tdsp
	$(INSTALL) -m 644 $(STATIC) $(QUERY) $(DESTDIR)$(LIBDIR)
	$(INSTALL) -m 644 $(SHARED) $(DESTDIR)$(LIBDIR)
	ln -sf libtdsp.so.$(VERSION) $(DESTDIR)$(LIBDIR)/libtdsp.so.$(SOVERSION)
	ln -sf libtdsp.so.$(SOVERSION) $(DESTDIR)$(LIBDIR)/libtdsp.so
	$(INSTALL) -m 644 $(HEADERS) $(DESTDIR)$(INCLUDEDIR)/tdsp
	$(INSTALL) -d $(DESTDIR)$(DATADIR)/tdsp/schema
	$(INSTALL) -m 644 $(SCHEMAS) $(DESTDIR)$(DATADIR)/tdsp/schema
	@if [ -e $(BUILD)/page/index.html ]; then $(INSTALL) -m 644 $(BUILD)/page/index.html $(DESTDIR)$(DATADIR)/tdsp/page.html; \
	else echo "install: no page for tdsp view: 'make page' builds it" >&2; fi
	$(call fill_in,tdsp.pc,$(DESTDIR)$(LIBDIR)/pkgconfig)
	$(call fill_in,tdsp-query.pc,$(DESTDIR)$(LIBDIR)/pkgconfig)
	$(call fill_in,tdsp-config.cmake,$(DESTDIR)$(LIBDIR)/cmake/tdsp)
	$(call fill_in,tdsp-config-version.cmake,$(DESTDIR)$(LIBDIR)/cmake/tdsp)

install-extras: $(EXTRAS)
ifneq ($(findstring man,$(EXTRAS)),)
	$(INSTALL) -d $(DESTDIR)$(MANDIR)/man1 $(DESTDIR)$(MANDIR)/man3 $(DESTDIR)$(MANDIR)/man5
	for page in $(MAN)/*.[135]; do cp -P --remove-destination "$$page" $(DESTDIR)$(MANDIR)/man$${page##*.}/ || exit 1; done
else
	@echo "install: no manual pages: they need $(PYTHON) and $(SCDOC)" >&2
endif
ifneq ($(findstring completions,$(EXTRAS)),)
	$(INSTALL) -d $(DESTDIR)$(BASH_COMPLETIONS) $(DESTDIR)$(ZSH_COMPLETIONS) $(DESTDIR)$(FISH_COMPLETIONS)
	$(INSTALL) -m 644 $(COMPLETIONS)/tdsp $(DESTDIR)$(BASH_COMPLETIONS)
	$(INSTALL) -m 644 $(COMPLETIONS)/_tdsp $(DESTDIR)$(ZSH_COMPLETIONS)
	$(INSTALL) -m 644 $(COMPLETIONS)/tdsp.fish $(DESTDIR)$(FISH_COMPLETIONS)
else
	@echo "install: no completions: they need $(PYTHON)" >&2
endif

# Pages of an older version may have had other names, but all of this project's begin alike.
.PHONY: uninstall
uninstall: ## remove what install put there
	rm -f $(DESTDIR)$(BINDIR)/tdsp $(DESTDIR)$(LIBDIR)/libtdsp.a $(DESTDIR)$(LIBDIR)/libtdsp-query.a $(DESTDIR)$(LIBDIR)/libtdsp.so*
	rm -f $(DESTDIR)$(LIBDIR)/pkgconfig/tdsp.pc $(DESTDIR)$(LIBDIR)/pkgconfig/tdsp-query.pc
	rm -f $(addprefix $(DESTDIR)$(INCLUDEDIR)/tdsp/,$(notdir $(HEADERS))) $(DESTDIR)$(LIBDIR)/cmake/tdsp/tdsp-config.cmake $(DESTDIR)$(LIBDIR)/cmake/tdsp/tdsp-config-version.cmake
	rm -f $(DESTDIR)$(MANDIR)/man1/tdsp.1 $(DESTDIR)$(MANDIR)/man1/tdsp-*.1 $(DESTDIR)$(MANDIR)/man3/libtdsp.3 $(DESTDIR)$(MANDIR)/man3/tdsp_*.3 $(DESTDIR)$(MANDIR)/man5/tdsp-*.5
	rm -f $(DESTDIR)$(BASH_COMPLETIONS)/tdsp $(DESTDIR)$(ZSH_COMPLETIONS)/_tdsp $(DESTDIR)$(FISH_COMPLETIONS)/tdsp.fish
	rm -f $(addprefix $(DESTDIR)$(DATADIR)/tdsp/schema/,$(notdir $(SCHEMAS))) $(DESTDIR)$(DATADIR)/tdsp/page.html
	rmdir $(DESTDIR)$(INCLUDEDIR)/tdsp $(DESTDIR)$(LIBDIR)/cmake/tdsp $(DESTDIR)$(DATADIR)/tdsp/schema $(DESTDIR)$(DATADIR)/tdsp
