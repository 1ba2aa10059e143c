#!/bin/bash
# SPDX-License-Identifier: MIT
# Debian packages of another machine, unpacked into a folder and not installed: what the tests of that machine are linked with.
#   fetch.sh ARCHITECTURE FOLDER      arm64, s390x, armhf, ...
# apt works with lists and states of its own, in FOLDER/apt, so that this machine's packages stay as they are, and no root is needed.
set -euo pipefail

architecture=$1
folder=$2
# The locale of UTF-8, which depends on the order of bytes; CMocka for the tests; GLib, json-glib and cairo for the command; and what these need.
packages=(libc-bin libcmocka0 libcmocka-dev libglib2.0-0 libglib2.0-dev libffi8 libpcre2-8-0 zlib1g libmount1 libblkid1 libselinux1 libjson-glib-1.0-0 libjson-glib-dev
    libcairo2 libcairo2-dev libfontconfig1 libfreetype6 libpixman-1-0 libpng16-16 libx11-6 libxcb1 libxcb-render0 libxcb-shm0 libxext6 libxrender1 libxau6
    libxdmcp6 libbsd0 libmd0 libexpat1 libbrotli1 libuuid1)

[ "$(cat "$folder/done" 2>/dev/null)" = "${packages[*]}" ] && exit 0
rm -rf "$folder"
mkdir -p "$folder/apt/lists/partial" "$folder/apt/archives/partial"
cd "$folder"
: >apt/status
options=(-o "APT::Architecture=$architecture" -o "APT::Architectures=$architecture" -o "Dir::State=$PWD/apt" -o "Dir::State::lists=$PWD/apt/lists"
    -o "Dir::State::status=$PWD/apt/status" -o "Dir::Cache=$PWD/apt" -o "Acquire::Languages=none" -o "APT::Sandbox::User=")
apt-get "${options[@]}" -q update >apt/log 2>&1 || true # a mirror may lack one list; what is missing shows when it is asked for
(cd apt/archives && apt-get "${options[@]}" -q download "${packages[@]}") >>apt/log 2>&1 || { tail -n 20 apt/log >&2; exit 1; }
for package in apt/archives/*.deb; do dpkg -x "$package" .; done
rm -rf apt/archives apt/lists
# One place for all libraries, as the linker and the emulator look for them.
mkdir -p lib
for library in usr/lib/*-linux-gnu*/*.so* lib/*-linux-gnu*/*.so*; do [ -e "$library" ] || [ -L "$library" ] || continue; cp -P "$library" lib/ 2>/dev/null || true; done
echo "${packages[*]}" >done
