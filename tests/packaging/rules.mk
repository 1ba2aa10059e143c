# SPDX-License-Identifier: MIT
# What a user installs: manual, completions, and what a release is made of.
checks += manual completions licences schemas dist debian
$(CHECK)/manual.result: man ; $(RUN) $(PYTHON) tests/packaging/check_manual.py $(BUILD)/tdsp $(MAN)
$(CHECK)/completions.result: completions ; $(RUN) $(PYTHON) tests/packaging/check_completions.py $(BUILD)/tdsp $(COMPLETIONS) bash
$(CHECK)/licences.result: ; $(RUN) $(PYTHON) tests/packaging/check_licences.py

$(CHECK)/schemas.result: all ; $(RUN) $(PYTHON) tests/packaging/check_schemas.py $(BUILD)/tdsp 5
$(CHECK)/dist.result: ; $(RUN) $(PYTHON) tests/packaging/check_dist.py $(VERSION)
$(CHECK)/debian.result: ; $(RUN) $(PYTHON) tests/packaging/check_debian.py $(VERSION)

# With the shells and tools that not everybody has.
PACKAGING := $(BUILD)/packaging
.PHONY: check-packaging
check-packaging: ## complete words in bash, zsh and fish; build the unpacked release; two Debian builds, the same to the bit, without a complaint of lintian
	@tools/setup/packages.sh packaging
	@$(MAKE) --no-print-directory -s all man completions dist
	@rm -rf $(PACKAGING)/check && mkdir -p $(PACKAGING)/check
	@tests/run.sh $(PACKAGING)/check/completions.result completions $(PYTHON) tests/packaging/check_completions.py $(BUILD)/tdsp $(COMPLETIONS) bash zsh fish
	@tests/run.sh $(PACKAGING)/check/schemas.result schemas $(PYTHON) tests/packaging/check_schemas.py $(BUILD)/tdsp
	@tests/run.sh $(PACKAGING)/check/release.result release tests/packaging/check_release.sh $(MAKE) $(RELEASE) $(VERSION)
	@TEST_TIMEOUT=3600 tests/run.sh $(PACKAGING)/check/twice.result deb-twice tests/packaging/check_deb_twice.sh $(RELEASE) $(VERSION) $(PACKAGING)/twice
	@tests/summary.sh $(PACKAGING)/check

.PHONY: check-deb
check-deb: deb ## install the Debian packages in a fresh root (debootstrap) and use them there
	@rm -rf $(PACKAGING)/check-deb && mkdir -p $(PACKAGING)/check-deb
	@TEST_TIMEOUT=3600 tests/run.sh $(PACKAGING)/check-deb/root.result root tests/packaging/check_deb.sh $(DEB) $(VERSION) $(PACKAGING)/root
	@tests/summary.sh $(PACKAGING)/check-deb
