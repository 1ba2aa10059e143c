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
