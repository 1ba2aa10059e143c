# SPDX-License-Identifier: MIT
# What scripts of steps share, sourced: `kind` names them in what is printed, `log` is the file that a step's output goes to, and `failed` becomes 1 when a step
# has failed.
failed=0

# step SENTENCE COMMAND...: one line, "ok" or "not ok"; what the command says matters only when it fails.
step() {
    local sentence=$1
    shift
    mkdir -p "$(dirname "$log")"
    if "$@" >"$log" 2>&1; then
        echo "ok $kind: $sentence"
    else
        echo "not ok $kind: $sentence"
        tail -n 40 "$log" >&2
        failed=1
        return 1
    fi
}

# A directory for this script alone, gone with it.
scratch() {
    work=$(mktemp -d) || exit 1
    trap 'rm -rf "$work"' EXIT
    log=$work/log
}
