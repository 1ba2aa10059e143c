#!/bin/bash
# SPDX-License-Identifier: MIT
# The Node.js wrapper over koffi, which npm installs below the build directory: as the lock file says, to the byte.
language=node
. "$(dirname "$0")/common.sh"

# Nothing is compiled: koffi brings its native part for this machine.
if ! cmp -s examples/node/package-lock.json "$work/installed"; then
    cp examples/node/package.json examples/node/package-lock.json "$work"
    must "koffi installs" npm ci --prefix "$work" --ignore-scripts --no-audit --no-fund
    cp examples/node/package-lock.json "$work/installed"
fi
export NODE_PATH=$work/node_modules TDSP_LIBRARY=$build/libtdsp.so
read_table "node examples/node/read_table.js"
node --expose-gc tests/languages/misuse.js $golden || failed=1
exit $failed
