#!/bin/bash
# SPDX-License-Identifier: MIT
# The bench can be run: a short version of it measures every section, and leaves a page, CSV files with rows and pictures.
#   check.sh BUILD
# It uses only what the project has itself, whatever lies beside the checkout.
set -uo pipefail

build=$1
python=${PYTHON:-python3}
docs=$(mktemp -d)
trap 'rm -rf "$docs"' EXIT
verdict() {
    local name=$1
    shift
    if "$@"; then echo "ok $name"; else echo "not ok $name"; fi
}
has_rows() { [ "$(wc -l <"$1")" -ge 2 ]; }
is_png() { [ "$(head -c 8 "$1" | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a ]; }
# Two baselines in two worlds, and the library itself.
baselines_agree() {
    "$python" - "$docs/results/peers.csv" <<'END'
import csv, sys
errors = [abs(float(row["travel_error"])) for row in csv.DictReader(open(sys.argv[1])) if row["source"] == "own" and row["setting"] == "exact"]
sys.exit(0 if len(errors) == 6 and max(errors) < 1e-9 else 1)
END
}

verdict "the short bench runs" "$python" tests/bench/bench.py --build "$build" --short --scenes examples/scenes --peers "$docs/none" --docs "$docs"
for table in peers scaling epsilon threads envelope lookup scenes tables machine; do verdict "bench rows $table" has_rows "$docs/results/$table.csv"; done
for picture in scaling-far scaling-near epsilon envelope look-up; do verdict "bench picture $picture" is_png "$docs/pictures/$picture.png"; done
verdict "the page has every section" test "$(grep -c '^## ' "$docs/results.md")" -eq 7
verdict "the exact baselines agree with the library" baselines_agree
verdict "no measurement failed" test -z "$(grep -l 'exit status' "$docs"/results/*.csv)"
