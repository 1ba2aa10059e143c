#!/bin/bash
# SPDX-License-Identifier: MIT
# Run one test program and count what it found, so that nothing that goes wrong is taken for success.
#   run.sh RESULT NAME COMMAND...
# Writes "passed failed" to RESULT and the output beside it, prints one line, and exits 0: tests/summary.sh judges.
#
# A count is read from the output, never from the exit status alone, for CMocka returns the number of failures modulo 256. Known
# are CMocka's lines, "ok NAME" / "not ok NAME" lines, and a last line "N passed, N failed". A program that says none of
# these, dies, or ends with a status other than 0 without admitting a failure has one failure. A skipped test has failed.
set -uo pipefail

result=$1
name=$2
shift 2
log=${result%.result}
mkdir -p "$(dirname "$result")"

begin=$SECONDS
# Two files: a buffered stream and an unbuffered one would cut each other's lines in one.
timeout --kill-after=10 "${TEST_TIMEOUT:-900}" "$@" >"$log.out" 2>"$log.err" </dev/null
status=$?

counts=$(awk -v status="$status" '
    /\[==========\] Running [0-9]+ test/ { sub(/.*\] Running /, ""); cmocka += $1 + 0; next }
    /\[       OK \]/ { fine++; next }
    /^ok / { tap_ok++ }
    /^not ok / { tap_bad++ }
    /^[0-9]+ passed, [0-9]+ failed$/ { said = 1; said_ok = $1; said_bad = $3 }
    END {
        if (cmocka) { passed = fine + 0; failed = cmocka - fine }
        else if (said) { passed = said_ok; failed = said_bad }
        else { passed = tap_ok + 0; failed = tap_bad + 0 }
        if (failed < 0) failed = 0
        if (failed == 0 && (status != 0 || passed == 0)) failed = 1
        print passed, failed
    }' "$log.out" "$log.err")
echo "$counts" >"$result"

read -r passed failed <<<"$counts"
echo "$name: $passed passed, $failed failed ($((SECONDS - begin)) s)"
if [ "$failed" -ne 0 ]; then
    [ $status -eq 124 ] && echo "    stopped after ${TEST_TIMEOUT:-900} s"
    echo "    exit status $status; the end of $log.out and $log.err:"
    { grep -av -e '\[ RUN  ' -e '\[       OK' "$log.out" | tail -n 30; tail -n 40 "$log.err"; } | sed 's/^/    /'
fi
exit 0
