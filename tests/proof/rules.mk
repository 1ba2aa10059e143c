# SPDX-License-Identifier: MIT
# Proof: what Frama-C's Eva shows of the table reader for every input up to a length. Apart from `make check`: Frama-C takes 290 MB, and a length up to minutes.
PROOF_LENGTHS ?= 0-400
PROOF_MACHINES ?= x86_64 x86_32
PROVE = $(PYTHON) tests/proof/prove.py $(BUILD)/proof

.PHONY: prove
prove: ## prove by Frama-C that tables of PROOF_LENGTHS bytes (default 0-400) cannot harm the reader
	@tools/setup/packages.sh trust
	$(PROVE) --self-test
	$(PROVE) $(PROOF_LENGTHS) $(PROOF_MACHINES:%=--machine %) --jobs $(JOBS)
