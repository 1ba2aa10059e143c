#!/bin/bash
# Run fuzzing programs for a while each, from the committed inputs in tests/fuzz/corpus/NAME; what is found is kept beside the programs.
#   fuzz.sh SECONDS PROGRAM...
# FUZZ_SEED fixes the order of what is tried (default 1, as in the check); 0 takes another one each time, and prints it into the log.
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
    # Warnings of the command come by the million: into a file, and out of the report.
    if "$program" -seed="${FUZZ_SEED:-1}" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -print_final_stats=1 \
        -artifact_prefix="$found-" "$found" $([ -d "$seeds" ] && echo "$seeds") >"$found.log" 2>&1; then
        echo "ok fuzz $name: $(sed -n 's/^stat::number_of_executed_units: *//p' "$found.log") inputs"
    else
        echo "not ok fuzz $name"
        grep -av '^tdsp: warning:' "$found.log" | tail -n 40 >&2
        failed=1
    fi
done
exit $failed
