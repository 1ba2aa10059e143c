#!/bin/bash
# SPDX-License-Identifier: MIT
# Build the Debian packages of a release: the tree is the release with tools/debian as its debian/. What lintian says stands on standard output and fails
# the build, down to what it says pedantically, but for what an override names with its reason.
#   deb.sh RELEASE VERSION OUTPUT
set -euo pipefail

release=$(realpath "$1")
version=$2
# What the caller's make was told is not for the package's.
unset MAKEFLAGS MAKELEVEL MFLAGS BUILD CC CFLAGS CPPFLAGS LDFLAGS SOURCE_DATE_EPOCH PREFIX DESTDIR
export LC_ALL=C.UTF-8
# Modes are packed: they are not the caller's choice.
umask 022
rm -rf "$3"
mkdir -p "$3"
cd "$3"

cp "$release" "libtdsp_$version.orig.tar.gz"
tar -xzf "$release"
cd "libtdsp-$version"
cp -r tools/debian debian
packaged=$(dpkg-parsechangelog -S Version)
if [ "${packaged%-*}" != "$version" ]; then
    echo "deb: tools/debian/changelog is about version ${packaged%-*}, the release is $version" >&2
    exit 1
fi
if ! dpkg-buildpackage -us -uc >../build.log 2>&1; then
    tail -n 40 ../build.log >&2
    echo "deb: the packages could not be built; all of it is in $3/build.log" >&2
    exit 1
fi
cd ..
rm -rf "libtdsp-$version"
lintian --allow-root --tag-display-limit 0 -EI -L +pedantic --fail-on error,warning,info,pedantic,experimental ./*.changes
ls -- *.deb *.dsc
