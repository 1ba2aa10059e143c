#!/bin/bash
# SPDX-License-Identifier: MIT
# Run fuzzing programs for a while each, from the inputs in tests/fuzz/corpus/NAME and tests/fuzz/found/NAME.
#   fuzz.sh SECONDS PROGRAM...
# What is found is kept across runs beside the programs: inputs that reach something new in corpus/NAME, inputs that fail as corpus/NAME-crash-..., and what was said of them in
# corpus/NAME.log. FUZZ_SEED fixes the order of what is tried (default 1, as in the check); 0 takes another one each time, and prints it into the log.
# FUZZ_RUNS ends each after so many inputs (default -1: after SECONDS only). FUZZ_REPORT names a CSV file to which the numbers of each program are written.
set -uo pipefail
cd "$(dirname "$0")/.." || exit 1

# A number of libFuzzer's log: of its statistics, or of the last line that has it.
stat() { sed -n "s/^stat::$1: *//p" "$2" | tail -n 1; }
last() { grep -ao " $1: [0-9]*" "$2" | tail -n 1 | grep -o '[0-9]*$'; }

# target, seconds, executions, edges run through, all edges, features, inputs that failed
report() {
    local name=$1 log=$2 seconds=$3 crashes=$4
    printf '%s,%s,%s,%s,%s,%s,%s\n' "$name" "$seconds" "$(stat number_of_executed_units "$log")" "$(last cov "$log")" \
        "$(sed -n 's/.*Loaded 1 PC tables (\([0-9]*\) PCs).*/\1/p' "$log")" "$(last ft "$log")" "$crashes"
}

seconds=$1
shift
failed=0
table=${FUZZ_REPORT:-/dev/null}
echo "target,seconds,executions,edges,of,features,failed" >"$table"
for program in "$@"; do
    name=$(basename "$program")
    kept=$(dirname "$program")/corpus/$name
    mkdir -p "$kept"
    rm -f "$kept"-{crash,timeout,oom,leak}-*
    inputs=()
    for place in "tests/fuzz/corpus/$name" "tests/fuzz/found/$name"; do [ -d "$place" ] && inputs+=("$place"); done
    words=()
    [ -f "tests/fuzz/$name.dict" ] && words=("-dict=tests/fuzz/$name.dict")
    begin=$SECONDS
    # Warnings of the command come by the million: into a file, and out of the report.
    "$program" -seed="${FUZZ_SEED:-1}" -max_total_time="$seconds" -runs="${FUZZ_RUNS:--1}" -timeout=60 -rss_limit_mb=2048 -print_final_stats=1 \
        "${words[@]}" -artifact_prefix="$kept-" "$kept" "${inputs[@]}" >"$kept.log" 2>&1
    status=$?
    crashes=$(find "$(dirname "$kept")" -maxdepth 1 -regex ".*/$name-\(crash\|timeout\|oom\|leak\)-.*" | wc -l)
    report "$name" "$kept.log" $((SECONDS - begin)) "$crashes" >>"$table"
    executed=$(stat number_of_executed_units "$kept.log")
    if [ $status -eq 0 ] && [ "${executed:-0}" -gt 0 ]; then
        echo "ok fuzz $name: $executed inputs"
    else
        echo "not ok fuzz $name: $(find "$(dirname "$kept")" -maxdepth 1 -name "$name-*-*" | head -n 1)"
        grep -av '^tdsp: warning:' "$kept.log" | tail -n 60 >&2
        failed=1
    fi
done
exit $failed
