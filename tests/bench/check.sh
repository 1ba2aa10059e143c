#!/bin/bash
# SPDX-License-Identifier: MIT
# The bench can be run: a short version of it measures every section, and leaves a page, CSV files with rows and pictures.
#   check.sh BUILD
# It uses only what the project has itself, whatever lies beside the checkout.
set -uo pipefail

build=$1
python=${PYTHON:-python3}
. "$(dirname "$0")/../support/steps.sh"
kind=bench
scratch
docs=$work/docs
has_rows() { [ "$(wc -l <"$1")" -ge 2 ]; }
is_png() { [ "$(head -c 8 "$1" | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a ]; }
# In files that are there: who finds nothing to read finds no failure.
measured() { cat "$docs"/results/*.csv >"$work/all" && ! grep 'exit status' "$work/all"; }
# Two baselines in two worlds, and the library itself.
baselines_agree() {
    "$python" - "$docs/results/peers.csv" <<'END'
import csv, sys
errors = [abs(float(row["travel_error"])) for row in csv.DictReader(open(sys.argv[1])) if row["source"] == "own" and row["setting"] == "exact"]
sys.exit(0 if len(errors) == 6 and max(errors) < 1e-9 else 1)
END
}

step "it runs" "$python" tests/bench/bench.py --build "$build" --short --scenes examples/scenes --peers "$docs/none" --docs "$docs"
for table in peers scaling epsilon threads envelope lookup scenes tables machine; do step "rows of $table" has_rows "$docs/results/$table.csv"; done
for picture in scaling-far scaling-near epsilon envelope look-up; do step "picture of $picture" is_png "$docs/pictures/$picture.png"; done
step "the page has every section" test "$(grep -c '^## ' "$docs/results.md")" -eq 7
step "the exact baselines agree with the library" baselines_agree
step "no measurement failed" measured
exit $failed
