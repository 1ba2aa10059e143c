#!/bin/bash
# SPDX-License-Identifier: MIT
# Static analysis: any finding fails. What is let pass stands, with its reason, in tests/analysis/cppcheck.txt and in .clang-tidy.
#   analyze.sh cppcheck|gcc|clang-tidy FILE...
set -uo pipefail
cd "$(dirname "$0")/../.." || exit 1

analyzer=$1
shift
[ $# -gt 0 ] || { echo "not ok $analyzer: no files"; exit 1; }
report=$(mktemp)
trap 'rm -f "$report"' EXIT
flags=(-std=c99 -D_POSIX_C_SOURCE=200809L -Iinclude -Isrc -Itools)
# The headers of other people are theirs to analyse.
for flag in $(pkg-config --cflags glib-2.0 gobject-2.0 gio-2.0 json-glib-1.0 cairo 2>/dev/null); do
    case $flag in -I*) flags+=(-isystem "${flag#-I}") ;; esac
done

status=0
case $analyzer in
cppcheck)
    cppcheck --std=c99 --library=posix --library=gtk --enable=warning,portability,performance --suppressions-list=tests/analysis/cppcheck.txt \
        --error-exitcode=1 --quiet -Iinclude -Isrc -Itools "$@" 2>"$report" || status=1
    ;;
gcc)
    for file in "$@"; do gcc "${flags[@]}" -O2 -ffp-contract=off -fanalyzer -Werror -c "$file" -o /dev/null 2>>"$report" || status=1; done
    ;;
clang-tidy) clang-tidy-19 --quiet "$@" -- "${flags[@]}" >"$report" 2>/dev/null || status=1 ;;
*)
    echo "usage: analyze.sh cppcheck|gcc|clang-tidy FILE..." >&2
    exit 2
    ;;
esac
if [ $status -ne 0 ]; then
    echo "not ok $analyzer"
    cat "$report" >&2
    exit 1
fi
echo "ok $analyzer: $# files"
