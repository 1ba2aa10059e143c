# SPDX-License-Identifier: MIT
# Proof: what Frama-C's Eva shows of the readers for every input up to a length. Apart from `make check`: Frama-C takes 290 MB, and a length up to minutes.
PROOF_LENGTHS ?= 0-400
# A matrix that is longer by its least header, ends and pair has a table of that length.
PROOF_MATRIX_LENGTHS ?= 0-560
PROOF_MACHINES ?= x86_64 x86_32
PROVE = $(PYTHON) tests/proof/prove.py $(BUILD)/proof

.PHONY: prove
prove: ## prove by Frama-C that tables of PROOF_LENGTHS bytes (default 0-400) and matrices of PROOF_MATRIX_LENGTHS (0-560) cannot harm the reader
	@tools/setup/packages.sh trust
	$(PROVE) --self-test
	$(PROVE) $(PROOF_LENGTHS) $(PROOF_MACHINES:%=--machine %) --jobs $(JOBS)
	$(PROVE) $(PROOF_MATRIX_LENGTHS) --matrices $(PROOF_MACHINES:%=--machine %) --jobs $(JOBS)
