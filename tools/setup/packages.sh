#!/bin/bash
# SPDX-License-Identifier: MIT
# Install the Debian packages that building, showing or testing needs, and only those that are missing.
#   packages.sh demo     what the library and the command need
#   packages.sh bench    that, and what measuring needs
#   packages.sh check    both, and what the tests need
#   packages.sh languages  what the library, its Python package and the wrappers in other languages need
#   packages.sh packaging  what packing and installing releases and Debian packages needs, and other shells to complete words in
#   packages.sh docs     what writing the documentation site needs
#   packages.sh page     what building the page needs; packaging needs it too, for the page is packed
#   packages.sh page-check  that, the command, and what trying the page in a browser needs
#   packages.sh trust    all that of check, and what the longer campaigns of docs/testing.md need
# Whether something is missing is decided by trying it, not by asking the package manager: a machine that has the tools
# from elsewhere is left alone, and so is a system without apt.
set -euo pipefail

tier=${1:-}
case $tier in demo | bench | check | languages | packaging | docs | page | page-check | trust) ;; *) echo "usage: packages.sh demo|bench|check|languages|packaging|docs|page|page-check|trust" >&2; exit 2 ;; esac

missing=()
has_command() { command -v "$1" >/dev/null 2>&1; }
# The compiler may be there without the C library's headers, and clang without its runtimes, so each compiles something.
compiles() {
    local compiler=$1 source=$2 dir status=0
    shift 2
    has_command "$compiler" || return 1
    dir=$(mktemp -d)
    "$compiler" "$@" -x "$source" - -o "$dir/a.out" >/dev/null 2>&1 || status=1
    rm -rf "$dir"
    return $status
}
need() {
    local package=$1
    shift
    "$@" || missing+=("$package")
}
c_program() { echo '#include <math.h>
#include <stdio.h>
int main(void) { return printf("") != 0; }'; }
fuzz_program() { echo '#include <stddef.h>
int LLVMFuzzerTestOneInput(const unsigned char *data, size_t size);
int LLVMFuzzerTestOneInput(const unsigned char *data, size_t size) { return data && size > 9; }'; }
callgrind_program() { echo '#include <valgrind/callgrind.h>
int main(void) { CALLGRIND_ZERO_STATS; return 0; }'; }
has_gcc() { c_program | compiles gcc c; }
has_gxx() { c_program | compiles g++ c++; }
has_clang() { c_program | compiles clang-19 c; }
has_sanitizers() { fuzz_program | compiles clang-19 c -fsanitize=fuzzer,address,undefined; }
# A program for WebAssembly that needs the C library, the compiler's runtime and the linker.
has_wasm() { c_program | compiles clang-14 c --target=wasm32-wasi --sysroot=/usr; }
has_callgrind() { has_command valgrind && callgrind_program | compiles gcc c; }
# Debian's cross compiler comes without a C library, so one is linked with.
has_firmware() { echo 'int main(void) { return 0; }' | compiles arm-none-eabi-gcc c -mcpu=cortex-m3 -mthumb --specs=rdimon.specs; }
has_library() { has_command pkg-config && pkg-config --exists "$1"; }
# Asked for by name where it can be: trying to compile reports the header whatever its version.
has_cmocka() { has_library cmocka; }
has_cross() { c_program | compiles "$1-linux-gnu-gcc" c; }
has_cross_hf() { c_program | compiles "$1-linux-gnueabihf-gcc" c; }
has_afl() { has_command afl-fuzz && fuzz_program | AFL_CC=clang-19 AFL_LLVM_INSTRUMENT=LLVM-NATIVE AFL_QUIET=1 compiles afl-clang-fast c -fsanitize=fuzzer,address,undefined; }
# Whichever of the two runs the check (tests/packaging/check_schemas.py).
has_jsonschema() { python3 -c 'import jsonschema' >/dev/null 2>&1 || /usr/bin/python3 -c 'import jsonschema' >/dev/null 2>&1; }
# Debian's packages of Python modules are for Debian's Python, whichever is the first in PATH.
has_numpy() { python3 -c 'import numpy' >/dev/null 2>&1 || /usr/bin/python3 -c 'import numpy' >/dev/null 2>&1; }
# Rust and Go may be there by name only: a proxy without a toolchain, a compiler without its library. Any C++ clang will do.
has_rust() {
    local dir status=0
    has_command rustc || return 1
    dir=$(mktemp -d)
    echo 'fn main() {}' | rustc --edition 2021 - -o "$dir/a.out" >/dev/null 2>&1 || status=1
    rm -rf "$dir"
    return $status
}
has_go() { has_command gofmt && go version >/dev/null 2>&1; }
has_jdk() { has_command java && javac -version >/dev/null 2>&1; }
has_jna() { [ -e "${JNA_JAR:-/usr/share/java/jna.jar}" ]; }
has_clangxx() { c_program | compiles clang++-19 c++ || c_program | compiles clang++ c++; }
has_venv() { has_command python3 && python3 -c 'import ensurepip, venv' >/dev/null 2>&1; }
has_python() { has_command python3 && python3 -c 'import json, subprocess, argparse' >/dev/null 2>&1; }

if [ "$tier" != docs ] && [ "$tier" != page ]; then
    need gcc has_gcc
    need libc6-dev has_gcc
    need make has_command make
    need pkg-config has_command pkg-config
    need libglib2.0-dev has_library gio-2.0
    need libjson-glib-dev has_library json-glib-1.0
    need libcairo2-dev has_library cairo
fi
if [ "$tier" != demo ] && [ "$tier" != languages ] && [ "$tier" != docs ] && [ "$tier" != page ] && [ "$tier" != page-check ]; then
    need g++ has_gxx
    need python3 has_python
    need valgrind has_callgrind
    need gnuplot-nox has_command gnuplot
fi
if [ "$tier" = check ] || [ "$tier" = trust ]; then
    need libcmocka-dev has_cmocka
    need python3-numpy has_numpy
    need clang-19 has_clang
    need libclang-rt-19-dev has_sanitizers
    need llvm-19 has_command llvm-symbolizer-19
    need binutils has_command nm
    need diffutils has_command cmp
    need abigail-tools has_command abidiff
    need cppcheck has_command cppcheck
    need clang-tidy-19 has_command clang-tidy-19
    need gcc-aarch64-linux-gnu has_cross aarch64
    need libc6-dev-arm64-cross has_cross aarch64
    need gcc-s390x-linux-gnu has_cross s390x
    need libc6-dev-s390x-cross has_cross s390x
    need qemu-user-static has_command qemu-s390x-static
    need gcc-arm-none-eabi has_firmware
    need libnewlib-arm-none-eabi has_firmware
    need qemu-system-arm has_command qemu-system-arm
    need cmake has_command cmake
    need scdoc has_command scdoc
    need mandoc has_command mandoc
    need python3-jsonschema has_jsonschema
fi
if [ "$tier" = check ] || [ "$tier" = docs ] || [ "$tier" = trust ]; then
    need doxygen has_command doxygen
fi
if [ "$tier" = page ] || [ "$tier" = packaging ] || [ "$tier" = page-check ] || [ "$tier" = check ] || [ "$tier" = trust ]; then
    need clang-14 has_wasm
    need lld-14 has_wasm
    need wasi-libc has_wasm
    need libclang-rt-14-dev-wasm32 has_wasm
    need python3 has_python
    need make has_command make
fi
if [ "$tier" = page-check ] || [ "$tier" = check ] || [ "$tier" = trust ]; then
    need nodejs has_command node
fi
if [ "$tier" = page-check ]; then
    need npm has_command npm
    need chromium has_command chromium
    need python3-jsonschema has_jsonschema
    need diffutils has_command cmp
    need ca-certificates test -e /etc/ssl/certs/ca-certificates.crt
fi
if [ "$tier" = docs ]; then
    need python3 has_python
    need make has_command make
fi
if [ "$tier" = languages ]; then
    need g++ has_gxx
    need python3 has_python
    need python3-numpy has_numpy
    need python3-venv has_venv
    need binutils has_command readelf
    need diffutils has_command cmp
    need clang has_clangxx
    need rustc has_rust
    need golang-go has_go
    need default-jdk-headless has_jdk
    need libjna-java has_jna
    need nodejs has_command node
    need npm has_command npm
    need ca-certificates test -e /etc/ssl/certs/ca-certificates.crt
fi
if [ "$tier" = packaging ]; then
    need python3 has_python
    need libcmocka-dev has_cmocka
    need cmake has_command cmake
    need scdoc has_command scdoc
    need man-db has_command man
    need dpkg-dev has_command dpkg-buildpackage
    need debhelper has_command dh
    need dh-python has_command dh_python3
    need lintian has_command lintian
    need debootstrap has_command debootstrap
    need zsh has_command zsh
    need fish has_command fish
fi
if [ "$tier" = trust ]; then
    need frama-c-base has_command frama-c
    need gcc-arm-linux-gnueabihf has_cross_hf arm
    need libc6-dev-armhf-cross has_cross_hf arm
    need gcc-riscv64-linux-gnu has_cross riscv64
    need libc6-dev-riscv64-cross has_cross riscv64
    need gcc-i686-linux-gnu has_cross i686
    need libc6-dev-i386-cross has_cross i686
    need afl++ has_afl
fi

[ ${#missing[@]} -eq 0 ] && exit 0

if ! has_command apt-get; then
    echo "packages: these are missing, and there is no apt-get here to install them: ${missing[*]}" >&2
    exit 1
fi
sudo=()
if [ "$(id -u)" -ne 0 ]; then
    if ! has_command sudo; then
        echo "packages: missing: ${missing[*]}" >&2
        echo "packages: run as root: apt-get install --no-install-recommends ${missing[*]}" >&2
        exit 1
    fi
    sudo=(sudo)
fi
echo "packages: installing ${missing[*]}"
install() { "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}"; }
log=$(mktemp)
trap 'rm -f "$log"' EXIT
# The lists of a fresh system are empty, those of an old one stale: fetch them, then try.
if ! { "${sudo[@]}" apt-get update -q && install; } >"$log" 2>&1; then
    cat "$log" >&2
    echo "packages: apt-get could not install: ${missing[*]}" >&2
    exit 1
fi
