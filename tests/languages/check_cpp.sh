#!/bin/bash
# SPDX-License-Identifier: MIT
# The C++ wrapper, by both compilers, and with sanitizers.
language=cpp
. "$(dirname "$0")/common.sh"

clang=$(command -v clang++-19 || command -v clang++)
warnings="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror"
flags="-std=c++17 -O1 -g -Iinclude -Iexamples/cpp"
must "compiles with g++ without a warning" g++ $flags $warnings examples/cpp/read_table.cpp -L"$build" -ltdsp -o "$work/read_table"
step "compiles with clang++ without a warning" "$clang" $flags $warnings -fsyntax-only examples/cpp/read_table.cpp tests/languages/misuse.cpp
read_table "$work/read_table"
must "tests compile" g++ $flags $warnings -fsanitize=address,undefined -fno-sanitize-recover=all tests/languages/misuse.cpp -L"$build" -ltdsp -o "$work/misuse"
"$work/misuse" $golden || failed=1
exit $failed
