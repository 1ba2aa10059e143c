#!/bin/bash
# SPDX-License-Identifier: MIT
# Add up the results that tests/run.sh left under a directory; succeed when there are some and none failed.
#   summary.sh DIRECTORY
set -euo pipefail

results=$(find "$1" -name '*.result' | sort)
[ -n "$results" ] || { echo "no test was run" >&2; echo "0 passed, 1 failed"; exit 1; }
while read -r file; do
    read -r _ failed <"$file"
    [ "$failed" -eq 0 ] || echo "failed: ${file%.result}"
done <<<"$results"
# shellcheck disable=SC2086
awk '{ passed += $1; failed += $2 } END { printf "%d passed, %d failed\n", passed, failed; exit failed > 0 }' $results
