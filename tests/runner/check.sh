#!/bin/bash
# SPDX-License-Identifier: MIT
# The tests' own runner is tested: it counts rightly what ends well, badly, early, or with 256 failures.
set -uo pipefail
cd "$(dirname "$0")/../.." || exit 1

. tests/support/steps.sh
scratch
gcc -std=c99 -Wall -Wextra -Werror tests/runner/traps.c -lcmocka -o "$work/traps" || exit 1

# expect COUNTS SENTENCE COMMAND...
expect() {
    local counts=$1 sentence=$2
    shift 2
    TEST_TIMEOUT=2 tests/run.sh "$work/one.result" one "$@" >/dev/null 2>&1
    if [ "$(cat "$work/one.result")" = "$counts" ]; then
        echo "ok runner: $sentence"
    else
        echo "not ok runner: $sentence: $(cat "$work/one.result")"
        failed=1
    fi
}
expect "2 0" "two good tests pass" "$work/traps" good
expect "0 256" "256 failures, exit status 0, are 256 failures" "$work/traps" many
expect "1 1" "a skipped test has failed" "$work/traps" skip
expect "1 1" "a test that aborts has failed" "$work/traps" abort
expect "1 2" "tests that were not run have failed" "$work/traps" exit
expect "2 1" "ok and not ok lines are counted" "$work/traps" lines
expect "3 1" "a last line is believed" "$work/traps" sum
expect "2 1" "an exit status other than 0 is a failure even after good tests" "$work/traps" after
expect "0 1" "a program that says nothing has failed" "$work/traps" nothing
expect "0 1" "a program that is not there has failed" "$work/absent"
expect "0 1" "a program that hangs has failed" sleep 60

mkdir "$work/sum"
echo "3 0" >"$work/sum/a.result"
echo "4 1" >"$work/sum/b.result"
if [ "$(tests/summary.sh "$work/sum" | tail -n 1)" = "7 passed, 1 failed" ] && ! tests/summary.sh "$work/sum" >/dev/null; then
    echo "ok runner: the sum fails when one result does"
else
    echo "not ok runner: the sum fails when one result does"
    failed=1
fi
exit $failed
