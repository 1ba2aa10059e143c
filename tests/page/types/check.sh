#!/bin/bash
# SPDX-License-Identifier: MIT
# The page's types, strictly in what others may use, the core and its workers: check.sh BUILD. TypeScript comes from npm, below the build directory, as the lock file says.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
work=$1/page/types
if ! cmp -s "$here/package-lock.json" "$work/installed"; then
    mkdir -p "$work"
    cp "$here/package.json" "$here/package-lock.json" "$work"
    npm ci --prefix "$work" --ignore-scripts --no-audit --no-fund >"$work/npm.log" 2>&1 || { cat "$work/npm.log" >&2; echo "not ok npm installs what the lock file says"; exit 1; }
    cp "$here/package-lock.json" "$work/installed"
fi
check() {
    if "$work/node_modules/.bin/tsc" -p "$1" >"$work/log" 2>&1; then echo "ok types: $2"; else sed 's/^/    /' "$work/log"; echo "not ok types: $2"; fi
}
check "$here/tsconfig.json" "the core and its workers, strictly"
check "$here/page.json" "all modules of the page"
# A check that finds nothing must be able to find something.
printf 'import { loadCore } from "%s";\n(await loadCore(new Uint8Array())).scene({}).arrival("soon");\n' "$here/../../../tools/page/js/core.js" >"$work/wrong.mjs"
found=$("$work/node_modules/.bin/tsc" --allowJs --checkJs --strict --noEmit --target ES2022 --module NodeNext --lib ES2022,DOM "$work/wrong.mjs" | grep -c 'wrong.mjs' || true)
[ "$found" -ge 2 ] && echo "ok types: what is wrong is found" || echo "not ok types: $found of 2 mistakes were found"
