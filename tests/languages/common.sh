# SPDX-License-Identifier: MIT
# What every wrapper is held to. Sourced by check_LANGUAGE.sh, which has set `language`; its first argument is the build directory.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.." || exit 1
build=$1
work=$build/languages/$language
golden=tests/golden/answered/two-discs.tdsp
. tests/support/steps.sh
kind=$language
log=$work/said
mkdir -p "$work"
failed=0
mkdir -p "$work"
export LD_LIBRARY_PATH=$build${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}

# Without what it is made of there is nothing to run.
must() {
    step "$@" || exit 1
}

alike() {
    local reference=$1 program=$2
    shift 2
    rm -f "$work/made.tdsp"
    "$reference" "$@" "$work/reference.tdsp" >"$work/expected.txt" || return 1
    $program "$@" "$work/made.tdsp" >"$work/printed.txt" || return 1
    diff "$work/expected.txt" "$work/printed.txt" && cmp "$work/reference.tdsp" "$work/made.tdsp"
}

# What cannot be read ends with status 1, the file's name and the library's words, where it could be opened at all.
refuses() {
    local program=$1 file=$2 words=$3 status=0
    $program "$file" >"$work/printed.txt" 2>"$work/refused.txt" || status=$?
    cat "$work/refused.txt"
    [ $status -eq 1 ] && [ ! -s "$work/printed.txt" ] && grep -q "$file.*$words\|$words.*$file" "$work/refused.txt"
}

# The three checks that all programs share: read_table PROGRAM
read_table() {
    step "prints what C prints, to the bit, and makes the same table" alike "$build/examples/read_table" "$1" $golden
    echo "no table" >"$work/text.tdsp"
    : >"$work/empty.tdsp"
    head -c 1000 $golden >"$work/cut.tdsp"
    step "refuses a file that is no table" refuses "$1" "$work/text.tdsp" "These bytes are not a table"
    step "refuses an empty file" refuses "$1" "$work/empty.tdsp" "These bytes are not a table"
    step "refuses a table that was cut" refuses "$1" "$work/cut.tdsp" "The table is shorter or longer than it says"
    step "names a file that is not there" refuses "$1" "$work/none.tdsp" ""
}

custom_oracle() {
    step "samples an oracle of its own, to the table of the C example" alike "$build/examples/custom_oracle" "$1"
}
