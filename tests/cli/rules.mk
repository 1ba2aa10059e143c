# SPDX-License-Identifier: MIT
# The command beside the page that `make page` builds; tests of the command alone are found by their names.
checks += view
$(CHECK)/view.result: $(BUILD)/page/index.html $(COMMAND) ; $(RUN) $(PYTHON) tests/cli/view_page.py
