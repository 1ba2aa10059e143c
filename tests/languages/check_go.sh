#!/bin/bash
# SPDX-License-Identifier: MIT
# The Go wrapper, by cgo alone: no modules of others, no registry.
language=go
. "$(dirname "$0")/common.sh"

export CGO_ENABLED=1 CGO_CFLAGS="-I$PWD/include -O1" CGO_LDFLAGS="-L$build"
export GOCACHE=$work/cache GOPATH=$work/path GOPROXY=off GOFLAGS= GOTOOLCHAIN=local
in_go() { (cd examples/go && "$@"); }
formatted() { [ -z "$(gofmt -l examples/go | tee /dev/stderr)" ]; }
must "read_table compiles" in_go go build -o "$work/read_table" ./read_table
must "custom_oracle compiles" in_go go build -o "$work/custom_oracle" ./custom_oracle
step "is laid out by gofmt" formatted
step "go vet finds nothing" in_go go vet ./...
read_table "$work/read_table"
custom_oracle "$work/custom_oracle"

# Go looks at each pointer that goes to C.
(cd examples/go && TDSP_GOLDEN=$PWD/../../$golden GODEBUG=cgocheck=1 go test -count=1 -v ./tdsp) >"$work/tests.txt" 2>&1
sed -n 's/^ *--- PASS: \([^ ]*\).*/ok go \1/p; s/^ *--- FAIL: \([^ ]*\).*/not ok go \1/p' "$work/tests.txt"
grep -q "^ok[[:space:]]*tdsp.example/tdsp" "$work/tests.txt" || { tail -n 40 "$work/tests.txt" >&2; failed=1; }
exit $failed
