#!/bin/bash
# SPDX-License-Identifier: MIT
# Each public header compiles alone, first in its file and twice, in C99 and in C++, without a warning under -Wpedantic; and
# the same for the headers inside the library, in C99.
#   check.sh C-COMPILER C++-COMPILER
set -uo pipefail
cd "$(dirname "$0")/../.." || exit 1

failed=0
# try NAME INCLUDE LINE OF THE COMPILER...
try() {
    local name=$1 header=$2 errors
    shift 2
    if errors=$(printf '#include "%s"\n#include "%s"\ntypedef int not_empty;\n' "$header" "$header" |
        "$@" -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wundef -Werror -fsyntax-only - 2>&1); then
        echo "ok header $header in $name"
    else
        echo "not ok header $header in $name"
        echo "$errors" >&2
        failed=1
    fi
}
for path in include/tdsp/*.h; do
    header=tdsp/$(basename "$path")
    try C99 "$header" "$1" -std=c99 -Wstrict-prototypes -Wmissing-prototypes -Iinclude -x c
    try C11 "$header" "$1" -std=c11 -Iinclude -x c
    try C++98 "$header" "$2" -std=c++98 -Wno-long-long -Wno-c++11-long-long -Iinclude -x c++
    try C++17 "$header" "$2" -std=c++17 -Wold-style-cast -Iinclude -x c++
done
for path in src/*/*.h; do
    [ -e "$path" ] && try C99 "${path#src/}" "$1" -std=c99 -Iinclude -Isrc -x c
done
exit $failed
