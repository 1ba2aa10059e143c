# SPDX-License-Identifier: MIT
# The Python package, over ctypes: its declarations are written from the headers, its short tests need NumPy only, its full ones a wheel in an environment of
# their own under the build directory.
PACKAGE := tools/python
# Debian's NumPy belongs to Debian's Python, which need not be the first in PATH.
NUMPY_PYTHON = $(or $(shell for p in $(PYTHON) /usr/bin/python3; do "$$p" -c 'import numpy' 2>/dev/null && { echo "$$p"; break; }; done),$(PYTHON))
# The package straight from the source tree, over the library just built.
FROM_SOURCE = env TDSP_LIBRARY=$(abspath $(BUILD))/libtdsp.so PYTHONPATH=$(CURDIR)/$(PACKAGE)/src

.PHONY: python-abi
python-abi: ## write the Python package's declarations anew from the headers
	$(PYTHON) $(PACKAGE)/abi.py

checks += python python-checklist
$(CHECK)/python.result: all ; $(RUN) $(FROM_SOURCE) $(NUMPY_PYTHON) $(PACKAGE)/tests/run.py
$(CHECK)/python-checklist.result: ; $(RUN) $(PYTHON) $(PACKAGE)/checklist.py

# The same over the sanitized library, whose runtime must be there before the interpreter. What the interpreter holds at its end is no leak of ours;
# the test that measures memory would measure the sanitizer's.
SANITIZED_TESTS := test_golden test_oracle test_path test_scene test_solver test_table.TableTest test_table.LifetimeTest test_table.ThreadTest
ASAN_RUNTIME = $(shell $(CLANG) -print-file-name=libclang_rt.asan-$$(uname -m).so)
steps += check-python
.PHONY: check-python run-python
check-python: check-sanitize
	+@$(MAKE) --no-print-directory -s SANITIZE=1 CC=$(CLANG) BUILD=$(BUILD)/sanitize CHECK=$(CHECK) run-python
run-python: $(CHECK)/sanitize/python.result
$(CHECK)/sanitize/python.result: all FORCE
	$(RUN) $(FROM_SOURCE) LD_PRELOAD=$(ASAN_RUNTIME) ASAN_OPTIONS=$(ASAN_OPTIONS):detect_leaks=0 $(NUMPY_PYTHON) $(PACKAGE)/tests/run.py $(SANITIZED_TESTS)

# ------------------------------------------------------------------------------------------------------------------ wheel

# What builds the wheel, and what tests it, in environments of their own; pip takes packages from wherever the machine says.
PYTHON_TOOLS := $(BUILD)/python/tools
PYTHON_TEST := $(BUILD)/python/test
PIP := -m pip --disable-pip-version-check -q
WHEEL_PARTS := $(wildcard $(PACKAGE)/src/tdsp/*.py $(PACKAGE)/src/tdsp/*/*.py $(PACKAGE)/src/tdsp/py.typed $(PACKAGE)/pyproject.toml $(PACKAGE)/wheel.py $(PACKAGE)/README.md)

$(PYTHON_TOOLS)/ready: $(PACKAGE)/rules.mk
	@rm -rf $(@D)
	$(PYTHON) -m venv $(@D)
	$(@D)/bin/python $(PIP) install hatchling
	@touch $@

# The wheel's name holds its tag, which the library decides: `made` stands for it.
$(BUILD)/wheel/made: $(SHARED) $(WHEEL_PARTS) $(PYTHON_TOOLS)/ready
	@rm -rf $(@D) && mkdir -p $(@D)
	strip --strip-unneeded -o $(@D)/$(notdir $(SHARED)) $(SHARED)
	TDSP_LIBRARY=$(abspath $(@D))/$(notdir $(SHARED)) $(PYTHON_TOOLS)/bin/python $(PIP) wheel --no-deps --no-build-isolation -w $(@D) ./$(PACKAGE)
	@rm $(@D)/$(notdir $(SHARED))
	@ls $(@D)/*.whl > $@

.PHONY: wheel
wheel: $(BUILD)/wheel/made ## the Python package as a wheel with the library in it: build/wheel/
	@cat $<

# A fresh environment for each wheel.
$(PYTHON_TEST)/ready: $(BUILD)/wheel/made
	@rm -rf $(@D)
	$(PYTHON) -m venv $(@D)
	$(@D)/bin/python $(PIP) install "$$(cat $<)[plot,batch]" mypy auditwheel
	@touch $@

# Run away from the sources: what is tested is what was installed.
languages += python
$(CHECK)/languages/python.result: all $(PYTHON_TEST)/ready ; $(RUN) $(PACKAGE)/tests/wheel.sh $(abspath $(PYTHON_TEST))/bin $(abspath $(BUILD)/wheel)

.PHONY: python
python: ## all tests of the Python package, from its wheel in a fresh environment: types, pictures, batches with workers killed
	@tools/setup/packages.sh languages
	@rm -f $(CHECK)/languages/python.*
	+@$(MAKE) --no-print-directory -s $(CHECK)/languages/python.result
	@tests/summary.sh $(CHECK)/languages
