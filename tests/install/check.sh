#!/bin/bash
# SPDX-License-Identifier: MIT
# Install into an empty directory, build programs against it by pkg-config and by CMake, shared and static, run them, read the manual, uninstall.
#   check.sh MAKE BUILD
set -uo pipefail
cd "$(dirname "$0")/../.." || exit 1

unset MAKEFLAGS MAKELEVEL
make=$1
build=$2
. tests/support/steps.sh
kind=install
scratch
dest=$work/dest
prefix=/opt/tdsp
here=$dest$prefix
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
        "lib/libtdsp.so.$major.$minor.$patch" lib/pkgconfig/tdsp.pc lib/pkgconfig/tdsp-query.pc \
        lib/cmake/tdsp/tdsp-config.cmake lib/cmake/tdsp/tdsp-config-version.cmake \
        share/man/man1/tdsp.1 share/man/man1/tdsp-build.1 share/man/man3/libtdsp.3 share/man/man3/tdsp_build.3 share/man/man5/tdsp-scene.5 share/man/man5/tdsp-table.5 \
        share/tdsp/schema/scene.json share/bash-completion/completions/tdsp share/zsh/site-functions/_tdsp share/fish/vendor_completions.d/tdsp.fish $(cd include && echo tdsp/*.h | sed 's/tdsp\//include\/tdsp\//g'); do
        [ -s "$here/$file" ] || { echo "$file is not there"; return 1; }
    done
}
# All of the listing is read: who stops at the first hit may end the lister, and seem to have found nothing.
links_libtdsp() { [ -n "$(readelf -d "$1" | grep libtdsp)" ]; }
has_soname() { readelf -d "$work/shared" | grep -q "NEEDED.*\[libtdsp\.so\.[0-9]*\]"; }
build_query() {
    # shellcheck disable=SC2046
    gcc -std=c99 -Wall -Wextra -Werror tests/install/reader.c $(PKG_CONFIG_SYSROOT_DIR=$dest PKG_CONFIG_PATH=$here/lib/pkgconfig pkg-config --cflags --libs tdsp-query) \
        -o "$work/query"
}
build_by_cmake() { cmake -S tests/install -B "$work/cmake" -DCMAKE_PREFIX_PATH="$here" && cmake --build "$work/cmake"; }
by_cmake_shared() { readelf -d "$work/cmake/shared" | grep -q "NEEDED.*\[libtdsp\.so\.[0-9]*\]" && "$work/cmake/shared"; }
by_cmake_static() { ! links_libtdsp "$work/cmake/static" && "$work/cmake/static"; }
by_cmake_query() { ! links_libtdsp "$work/cmake/query" && "$work/cmake/query"; }
# The lines of docs/packaging.md, over the program of README.md.
block() { sed -n "/^\`\`\`$1\$/,/^\`\`\`\$/p" "$2" | sed '1d;/^```$/,$d'; }
build_as_the_page_says() {
    mkdir -p "$work/page"
    block c README.md >"$work/page/program.c"
    { echo 'cmake_minimum_required(VERSION 3.13)'; echo 'project(page C)'; block cmake docs/packaging.md; } >"$work/page/CMakeLists.txt"
    cmake -S "$work/page" -B "$work/page/build" -DCMAKE_PREFIX_PATH="$here" && cmake --build "$work/page/build"
}
as_the_page_says() { [ "$("$work/page/build/program")" = "arrive at 20.0000, or leave by 9.8496" ]; }
without_the_shared_library() {
    rm "$here"/lib/libtdsp.so* && cmake -S tests/install -B "$work/archives" -DCMAKE_PREFIX_PATH="$here" && cmake --build "$work/archives" &&
        ! links_libtdsp "$work/archives/shared" && "$work/archives/shared"
}
# The page is installed where it has been built by then, which another test may do at any time: each case is made here.
installed_page=$here/share/tdsp/page.html
view() { (unset TDSP_PAGE; "$here/bin/tdsp" view examples/scenes/two-discs.json -o "$work/view.html" --no-open); }
views() {
    mkdir -p "$(dirname "$installed_page")"
    [ -e "$installed_page" ] || printf '<title>page</title>\n<script type="application/json" id="given">null</script>\n</html>\n' >"$installed_page"
    view && [ -s "$work/view.html" ]
}
misses_the_page() {
    rm -f "$installed_page"
    local said
    said=$(view 2>&1)
    [ $? = 4 ] && grep -q "make page" <<<"$said"
}
runs_shared() { LD_LIBRARY_PATH=$here/lib "$work/shared"; }
nothing_left() { [ -z "$(find "$dest" -type f -o -type l)" ] || { find "$dest" -type f -o -type l; return 1; }; }

step "make install DESTDIR PREFIX" "$make" --no-print-directory install BUILD="$build" DESTDIR="$dest" PREFIX=$prefix
step "every file is there" all_files
step "the command runs" "$here/bin/tdsp" --version
step "the command finds the page where it is installed" views
step "it says how to make the page where it is not" misses_the_page
step "a program builds against the shared library" build_shared
step "it asks for the library by its SONAME" has_soname
step "it runs" runs_shared
step "a program builds against the static library" build_static
step "it runs by itself" "$work/static"
step "a reader builds by pkg-config against the archive of the reader alone" build_query
step "it runs" "$work/query"
step "a CMake project finds the package, its targets and its version" build_by_cmake
step "its program with the shared library runs" by_cmake_shared
step "its program with the archive runs by itself" by_cmake_static
step "its reader runs" by_cmake_query
step "README.md's program builds by the lines of docs/packaging.md" build_as_the_page_says
step "it prints what its comments say" as_the_page_says
step "tdsp::tdsp is the archive where there is no shared library" without_the_shared_library
step "make uninstall" "$make" --no-print-directory uninstall BUILD="$build" DESTDIR="$dest" PREFIX=$prefix
step "nothing is left" nothing_left
exit $failed
