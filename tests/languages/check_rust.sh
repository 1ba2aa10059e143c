#!/bin/bash
# SPDX-License-Identifier: MIT
# The Rust wrapper, by rustc alone: no crates, no registry.
language=rust
. "$(dirname "$0")/common.sh"

rust="rustc --edition 2021 -D warnings -C opt-level=1 -L $build"
must "the crate compiles without a warning" $rust --crate-type rlib --crate-name tdsp examples/rust/tdsp/lib.rs --out-dir "$work"
must "read_table compiles" $rust --extern tdsp="$work/libtdsp.rlib" examples/rust/read_table.rs -o "$work/read_table"
must "custom_oracle compiles" $rust --extern tdsp="$work/libtdsp.rlib" examples/rust/custom_oracle.rs -o "$work/custom_oracle"
must "tests compile" $rust --extern tdsp="$work/libtdsp.rlib" --test tests/languages/misuse.rs -o "$work/misuse"
read_table "$work/read_table"
custom_oracle "$work/custom_oracle"

TDSP_GOLDEN=$golden "$work/misuse" >"$work/tests.txt" 2>"$work/tests.err" || failed=1
sed -n 's/^test \(.*\) \.\.\. ok$/ok rust \1/p; s/^test \(.*\) \.\.\. FAILED$/not ok rust \1/p' "$work/tests.txt"
grep -q "test result: ok" "$work/tests.txt" || { cat "$work/tests.txt" "$work/tests.err" >&2; failed=1; }

# What would be used after it is freed must not compile.
outlives() {
    ! $rust --extern tdsp="$work/libtdsp.rlib" --crate-type lib --crate-name outlives "$1" --out-dir "$work" >"$work/refused.txt" 2>&1 &&
        grep -q 'E0505\|E0597' "$work/refused.txt"
}
cat >"$work/solver.rs" <<'END'
pub fn f(scene: tdsp::Scene) -> f64 {
    let mut solver = tdsp::Solver::new(&scene).unwrap();
    drop(scene);
    solver.earliest_arrival(0.0).unwrap()
}
END
cat >"$work/view.rs" <<'END'
pub fn f(bytes: Vec<u8>) -> f64 {
    let table = tdsp::Table::view(&bytes).unwrap();
    drop(bytes);
    table.arrival(0.0).unwrap().upper
}
END
step "a solver that outlives its scene does not compile" outlives "$work/solver.rs"
step "a table that outlives borrowed bytes does not compile" outlives "$work/view.rs"
exit $failed
