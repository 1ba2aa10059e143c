# SPDX-License-Identifier: MIT
# What every wrapper is held to. Sourced by check_LANGUAGE.sh, which has set `language`; its first argument is the build directory.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.." || exit 1
build=$1
work=$build/languages/$language
golden=tests/golden/answered/two-discs.tdsp
failed=0
mkdir -p "$work"
export LD_LIBRARY_PATH=$build${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}

# expect NAME COMMAND...: one line for a command that has to succeed; what it says otherwise.
expect() {
    local name=$1
    shift
    if "$@" >"$work/said" 2>&1; then
        echo "ok $language $name"
    else
        echo "not ok $language $name"
        tail -n 40 "$work/said" >&2
        failed=1
        return 1
    fi
}

# Without what it is made of there is nothing to run.
must() {
    expect "$@" || exit 1
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
    expect "prints what C prints, to the bit, and makes the same table" alike "$build/examples/read_table" "$1" $golden
    echo "no table" >"$work/text.tdsp"
    : >"$work/empty.tdsp"
    head -c 1000 $golden >"$work/cut.tdsp"
    expect "refuses a file that is no table" refuses "$1" "$work/text.tdsp" "These bytes are not a table"
    expect "refuses an empty file" refuses "$1" "$work/empty.tdsp" "These bytes are not a table"
    expect "refuses a table that was cut" refuses "$1" "$work/cut.tdsp" "The table is shorter or longer than it says"
    expect "names a file that is not there" refuses "$1" "$work/none.tdsp" ""
}

custom_oracle() {
    expect "samples an oracle of its own, to the table of the C example" alike "$build/examples/custom_oracle" "$1"
}
