#!/bin/bash
# SPDX-License-Identifier: MIT
# Run each example program and compare what it prints with examples/c/expected/NAME.txt, but for the bits of numbers, [0123456789abcdef]: the last
# of them depend on the sine of the C library.
#   check_examples.sh DIRECTORY OF THE PROGRAMS
set -uo pipefail
cd "$(dirname "$0")/.." || exit 1

failed=0
for source in examples/c/*.c; do
    name=$(basename "$source" .c)
    expected=examples/c/expected/$name.txt
    if ! printed=$("$1/$name" 2>&1); then
        echo "not ok example $name: it failed"
        echo "$printed" >&2
        failed=1
    elif ! difference=$(diff "$expected" <(sed 's/\[[0-9a-f]\{16\}\]//g' <<<"$printed") 2>&1); then
        echo "not ok example $name: it prints something else"
        echo "$difference" >&2
        failed=1
    else
        echo "ok example $name"
    fi
done
exit $failed
