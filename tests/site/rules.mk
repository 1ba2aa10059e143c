# SPDX-License-Identifier: MIT
# The site as `make docs` writes it: Doxygen has no warning, or nothing is made of it; then its links.
checks += site
$(CHECK)/site.result: ; $(RUN) bash -c 'env -u MAKEFLAGS -u MFLAGS $(MAKE) --no-print-directory -s BUILD=$(BUILD) site && echo "ok site: written without a warning" && $(PYTHON) tests/site/check_site.py $(SITE)/html'
