#!/bin/bash
# SPDX-License-Identifier: MIT
# The wheel, installed in an environment of its own: its tag, its types, all tests, doctests and examples.
#   wheel.sh BIN WHEELS     BIN: the environment's programs; WHEELS: the folder of the wheel
set -uo pipefail

bin=$1
wheels=$2
package=$(cd "$(dirname "$0")/.." && pwd)
cd "$(mktemp -d)" || exit 1
trap 'rm -rf "$PWD"' EXIT
unset TDSP_LIBRARY PYTHONPATH
status=0
say() {
    if [ "$1" -eq 0 ]; then echo "ok python $2"; else echo "not ok python $2"; [ -n "${3:-}" ] && echo "$3"; status=1; fi
}

wheel=$(echo "$wheels"/tdsp-*-py3-none-manylinux_*.whl)
[ -f "$wheel" ]
say $? "one wheel with a tag for all versions of Python" "$wheel"

# auditwheel finds the same tag by itself, and nothing that is not everywhere.
shown=$("$bin/auditwheel" show "$wheel" 2>&1)
tag=$(basename "$wheel" .whl)
grep -q "platform tag: \"${tag##*-}\"" <<<"$(tr '\n' ' ' <<<"$shown" | tr -s ' ')"
say $? "auditwheel finds the tag ${tag##*-} too" "$shown"

where=$("$bin/python" -c 'import tdsp; print(tdsp.__file__)')
case $where in "$(dirname "$bin")"/*) true ;; *) false ;; esac
say $? "the package is the installed one" "$where"

typed=$("$bin/mypy" --config-file "$package/pyproject.toml" "$package/src/tdsp" 2>&1)
say $? "mypy --strict finds nothing" "$typed"

# And a user's program sees the types.
printf 'import tdsp\nreveal_type(tdsp.Scene(1.0, (0, 0), (1, 1)).solver().arrival(0.0))\ntdsp.Table(b"").arrival("soon")\n' > user.py
typed=$("$bin/mypy" --strict user.py 2>&1)
grep -qE 'Revealed type is "(builtins\.)?float"' <<<"$typed" && grep -q 'incompatible type "str"; expected "float"' <<<"$typed"
say $? "a program that imports the package sees its types" "$typed"

MPLBACKEND=Agg "$bin/python" "$package/tests/run.py" --full || status=1
exit $status
