#!/bin/bash
# Run fuzzing programs for a while each, from the committed inputs in tests/fuzz/corpus/NAME; what is found is kept beside the programs.
#   fuzz.sh SECONDS PROGRAM...
set -uo pipefail
cd "$(dirname "$0")/.." || exit 1

seconds=$1
shift
failed=0
for program in "$@"; do
    name=$(basename "$program")
    found=$(dirname "$program")/corpus/$name
    seeds=tests/fuzz/corpus/$name
    mkdir -p "$found"
    if log=$("$program" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -print_final_stats=1 \
        -artifact_prefix="$found-" "$found" $([ -d "$seeds" ] && echo "$seeds") 2>&1); then
        echo "ok fuzz $name: $(sed -n 's/^stat::number_of_executed_units: *//p' <<<"$log") inputs"
    else
        echo "not ok fuzz $name"
        tail -n 40 <<<"$log" >&2
        failed=1
    fi
done
exit $failed
