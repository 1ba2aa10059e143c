#!/bin/bash
# SPDX-License-Identifier: MIT
# Unpack the release in an empty place, without a repository, build and install it, and ask what was installed.
#   check_release.sh MAKE RELEASE VERSION
set -uo pipefail
unset MAKEFLAGS MAKELEVEL BUILD
make=$1
release=$(realpath "$2")
version=$3
. "$(dirname "$0")/../support/steps.sh"
kind=release
scratch
cd "$work" || exit 1
tree=$work/libtdsp-$version
tdsp=$work/dest/usr/bin/tdsp
certified() { "$tdsp" build "$tree/examples/scenes/two-discs.json" -o t.tdsp && "$tdsp" verify "$tree/examples/scenes/two-discs.json" t.tdsp --deep 5; }

step "it unpacks" tar -xzf "$release"
step "it builds and installs without a repository" "$make" -C "$tree" install DESTDIR="$work/dest" PREFIX=/usr
step "the command says its version" grep -qx "tdsp $version" <("$tdsp" --version)
step "it builds a table and verifies it" certified
step "the manual is there" test -s "$work/dest/usr/share/man/man1/tdsp-build.1"
exit $failed
