#!/bin/bash
# SPDX-License-Identifier: MIT
# Run fuzzing programs built with afl-clang-fast for a while each, from the inputs that are kept; fails when one of them crashed or hung.
#   afl.sh SECONDS BUILD NAME...
# What is found stays in BUILD/runs/NAME/default; the next run goes on from there. The numbers of all programs are written to BUILD/report.csv.
set -uo pipefail
cd "$(dirname "$0")/../.." || exit 1

# No questions, no screen, and nothing of the machine's settings; the sanitizers end a program by a signal, as AFL++ wants it.
export AFL_SKIP_CPUFREQ=1 AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES=1 AFL_NO_UI=1 AFL_NO_AFFINITY=1 AFL_AUTORESUME=1 AFL_NO_COLOR=1 AFL_FORKSRV_INIT_TMOUT=60000
export ASAN_OPTIONS=abort_on_error=1:symbolize=0:detect_leaks=0 UBSAN_OPTIONS=abort_on_error=1:halt_on_error=1:symbolize=0

seconds=$1
build=$2
shift 2
failed=0
table=$build/report.csv
mkdir -p "$build"
echo "target,seconds,executions,edges,of,crashes,hangs" >"$table"
for name in "$@"; do
    out=$build/runs/$name
    seeds=$build/seeds/$name
    rm -rf "$seeds"
    mkdir -p "$seeds" "$out"
    # Without empty ones, which AFL++ refuses.
    find tests/fuzz/corpus/"$name" tests/fuzz/found/"$name" -type f -size +0 -exec cp {} "$seeds" \; 2>/dev/null
    words=()
    [ -f "tests/fuzz/$name.dict" ] && words=(-x "tests/fuzz/$name.dict")
    afl-fuzz -i "$seeds" -o "$out" -V "$seconds" -m none -t 60000 "${words[@]}" -- "$build/tests/fuzz/$name" >"$out/log" 2>&1
    status=$?
    stats=$out/default/fuzzer_stats
    if [ ! -f "$stats" ]; then
        echo "not ok afl $name: exit status $status"
        tail -n 20 "$out/log" >&2
        failed=1
        continue
    fi
    value() { sed -n "s/^$1 *: *//p" "$stats"; }
    crashes=$(value saved_crashes)
    hangs=$(value saved_hangs)
    echo "$name,$(value run_time),$(value execs_done),$(value edges_found),$(value total_edges),$crashes,$hangs" >>"$table"
    if [ "$status" -eq 0 ] && [ "$crashes" -eq 0 ] && [ "$hangs" -eq 0 ]; then
        echo "ok afl $name: $(value execs_done) inputs"
    else
        echo "not ok afl $name: exit status $status, $crashes crashes, $hangs hangs in $out/default"
        failed=1
    fi
done
exit $failed
