#!/bin/bash
# SPDX-License-Identifier: MIT
# Try the page in Chromium: check.sh BUILD [TEST...]. playwright-core and axe-core come from npm, below the build directory, as the lock file says.
set -euo pipefail

here=$(dirname "$0")
export PAGE_BUILD=$1
shift
work=$PAGE_BUILD/page/browser
if ! cmp -s "$here/package-lock.json" "$work/installed"; then
    mkdir -p "$work"
    cp "$here/package.json" "$here/package-lock.json" "$work"
    npm ci --prefix "$work" --ignore-scripts --no-audit --no-fund >"$work/npm.log" 2>&1 || { cat "$work/npm.log" >&2; echo "not ok npm installs what the lock file says"; exit 1; }
    cp "$here/package-lock.json" "$work/installed"
fi
tests=("$@")
[ ${#tests[@]} -gt 0 ] || tests=("$here"/*.test.js)
# One browser at a time: frame times are measured.
exec node --test --test-reporter=tap --test-concurrency=1 "${tests[@]}"
