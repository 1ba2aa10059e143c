#!/bin/bash
# SPDX-License-Identifier: MIT
# Install into an empty directory, build a program against it by pkg-config, shared and static, run both, uninstall.
#   check.sh MAKE BUILD
set -uo pipefail
cd "$(dirname "$0")/../.." || exit 1

unset MAKEFLAGS MAKELEVEL
make=$1
build=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
dest=$work/dest
prefix=/opt/tdsp
here=$dest$prefix
failed=0

# step SENTENCE COMMAND...: the command's output matters only when it fails.
step() {
    local sentence=$1
    shift
    if "$@" >"$work/log" 2>&1; then
        echo "ok install: $sentence"
    else
        echo "not ok install: $sentence"
        cat "$work/log" >&2
        failed=1
    fi
}
flags() { PKG_CONFIG_SYSROOT_DIR=$dest PKG_CONFIG_PATH=$here/lib/pkgconfig pkg-config "$@" tdsp; }
build_shared() {
    # shellcheck disable=SC2046
    gcc -std=c99 -Wall -Wextra -Werror tests/install/program.c $(flags --cflags --libs) -o "$work/shared"
}
build_static() {
    # shellcheck disable=SC2046
    gcc -std=c99 -Wall -Wextra -Werror -static tests/install/program.c $(flags --static --cflags --libs) -o "$work/static"
}
all_files() {
    local major minor patch
    IFS=. read -r major minor patch <<<"$(flags --modversion)"
    for file in bin/tdsp lib/libtdsp.a lib/libtdsp-query.a lib/libtdsp.so "lib/libtdsp.so.$major" \
        "lib/libtdsp.so.$major.$minor.$patch" lib/pkgconfig/tdsp.pc $(cd include && echo tdsp/*.h | sed 's/tdsp\//include\/tdsp\//g'); do
        [ -s "$here/$file" ] || { echo "$file is not there"; return 1; }
    done
}
has_soname() { readelf -d "$work/shared" | grep -q "NEEDED.*\[libtdsp\.so\.[0-9]*\]"; }
runs_shared() { LD_LIBRARY_PATH=$here/lib "$work/shared"; }
nothing_left() { [ -z "$(find "$dest" -type f -o -type l)" ] || { find "$dest" -type f -o -type l; return 1; }; }

step "make install DESTDIR PREFIX" "$make" --no-print-directory install BUILD="$build" DESTDIR="$dest" PREFIX=$prefix
step "every file is there" all_files
step "the command runs" "$here/bin/tdsp" --version
step "a program builds against the shared library" build_shared
step "it asks for the library by its SONAME" has_soname
step "it runs" runs_shared
step "a program builds against the static library" build_static
step "it runs by itself" "$work/static"
step "make uninstall" "$make" --no-print-directory uninstall BUILD="$build" DESTDIR="$dest" PREFIX=$prefix
step "nothing is left" nothing_left
exit $failed
