#!/bin/bash
# SPDX-License-Identifier: MIT
# Build the Debian packages twice, in places, at hours, with file modes and under languages that differ: they are the same to the bit. The first build runs the
# unit tests, the second does not.
#   check_deb_twice.sh RELEASE VERSION WORK
set -uo pipefail
release=$1
version=$2
work=$3
first=$work/first
second=$work/second/in/a/deeper/place
. "$(dirname "$0")/../support/steps.sh"
kind=deb
log=$work/log
build_first() { TZ=UTC DEB_BUILD_OPTIONS=parallel=2 tools/dist/deb.sh "$release" "$version" "$first"; }
build_second() {
    umask 0027
    TZ=Pacific/Kiritimati LANG=de_DE.UTF-8 HOME=/nonexistent DEB_BUILD_OPTIONS="parallel=1 nocheck" tools/dist/deb.sh "$release" "$version" "$second"
}
same() { cmp "$first/$1" "$second/$1"; }
tests_ran() { grep -Eq '^[0-9]+ passed, 0 failed' "$first/build.log"; }

rm -rf "$work"
step "the packages are built, and lintian has no complaint" build_first
step "the unit tests ran while they were built" tests_ran
step "they are built again, elsewhere" build_second
for file in "$first"/*.deb "$first"/*.dsc "$first"/*.debian.tar.xz; do
    step "$(basename "$file") is the same to the bit" same "$(basename "$file")"
done
exit $failed
