#!/bin/bash
# SPDX-License-Identifier: MIT
# Run the threads' jobs, and see that the sanitizer would have found a race.
#   check.sh PROGRAM ROUNDS
set -uo pipefail

# The thread sanitizer reads the options of the others too, and their exit status would be its own.
unset ASAN_OPTIONS LSAN_OPTIONS UBSAN_OPTIONS
export TSAN_OPTIONS="exitcode=66 halt_on_error=0"
"$1" "$2"
status=$?
if [ $status -eq 66 ]; then echo "not ok threads: races (above)"; fi
race=$(mktemp)
trap 'rm -f "$race"' EXIT
# Where one thread is done before the next begins there may be nothing to see: more than one attempt.
found=0
for _ in 1 2 3 4 5; do
    "$1" race >"$race" 2>&1
    [ $? -eq 66 ] && grep -q 'data race' "$race" && found=1 && break
done
if [ $found -eq 1 ]; then
    echo "ok threads: a race on purpose is found"
else
    echo "not ok threads: a race on purpose is not found"
    status=1
fi
exit $status
