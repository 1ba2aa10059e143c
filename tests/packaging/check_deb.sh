#!/bin/bash
# SPDX-License-Identifier: MIT
# Install the Debian packages in a fresh root, and use them there as a user would: the command on a scene, its manual and completions, C programs built by
# pkg-config and by CMake. Needs root and a Debian mirror.
#   check_deb.sh DEBS VERSION ROOT
# MIRROR (default: that of the machine) and SUITE (default: bookworm) say where the root comes from.
set -uo pipefail
debs=$(realpath "$1")
version=$2
root=$3
mirror=${MIRROR:-http://deb.debian.org/debian}
suite=${SUITE:-bookworm}
. "$(dirname "$0")/../support/steps.sh"
kind=root
log=$(realpath -m "$root").log
# Nothing of the outside's environment is inside.
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
install="apt-get install -y -q --no-install-recommends"
script() { inside bash -euo pipefail -c "$1"; }
cleanup() { mountpoint -q "$root/proc" && umount "$root/proc"; }
trap cleanup EXIT

fresh_root() {
    cleanup
    rm -rf "$root"
    debootstrap --variant=minbase "$suite" "$root" "$mirror" && mount -t proc proc "$root/proc"
}
# The machine's way to the mirror, if it has one of its own.
network() {
    cp /etc/resolv.conf "$root/etc/resolv.conf"
    apt-config dump | grep -E '^Acquire::(http|https)::Proxy' >"$root/etc/apt/apt.conf.d/99outside"
    inside apt-get update -q
}
install_packages() {
    mkdir -p "$root/debs" && cp "$debs"/*.deb "$root/debs/" && rm -f "$root"/debs/*-dbgsym_*
    script "$install"' bash-completion man-db /debs/libtdsp0_*.deb /debs/tdsp-tools_*.deb'
}
install_development() { script "$install"' gcc libc6-dev pkg-config cmake make /debs/libtdsp-dev_*.deb'; }
install_python() { script "$install"' /debs/python3-tdsp_*.deb'; }
copy_project() { mkdir -p "$root/project" && cp tests/install/CMakeLists.txt tests/install/*.c tests/packaging/use.py examples/scenes/two-discs.json "$root/project/"; }

[ "$(id -u)" -eq 0 ] || { echo "not ok root: debootstrap and chroot need root"; exit 1; }
mkdir -p "$(dirname "$root")"
root=$(realpath -m "$root")
step "a fresh $suite is made" fresh_root
step "its package lists are fetched" network
step "libtdsp0 and tdsp-tools install with their dependencies" install_packages
step "the project is copied" copy_project
step "the command says its version" script "[ \"\$(tdsp --version)\" = 'tdsp $version' ]"
step "the command uses the shared library" script 'grep -q "libtdsp.so.0 => /" <(ldd /usr/bin/tdsp)'
step "it solves a scene" script '[ "$(tdsp arrive /project/two-discs.json 0 | tail -n 1 | cut -d" " -f1)" = 0 ]'
step "it builds a table, answers from it and verifies it" script 'cd /project && tdsp build two-discs.json -o t.tdsp && tdsp query t.tdsp 5 && tdsp verify two-discs.json t.tdsp --deep 5'
step "it draws" script 'cd /project && tdsp plot two-discs.json -o a.png && [ -s a.png ]'
step "it writes the page, with the scene and with a table inside" script 'cd /project && for of in scene table; do input=two-discs.json; [ $of = scene ] || input=t.tdsp; tdsp view $input -o $of.html --no-open --json | grep -q "\"of\": \"$of\"" && grep -q "\"name\": \"$input\"" $of.html && [ "$(tail -n 1 $of.html)" = "</html>" ]; done'
step "bash completes it" script 'source /usr/share/bash-completion/bash_completion; _completion_loader tdsp || true; COMP_WORDS=(tdsp env); COMP_CWORD=1; _tdsp; [ "${COMPREPLY[*]}" = envelope ]'
step "libtdsp-dev installs" install_development
step "the manual is found, by command, file and function" script 'rm -f /etc/dpkg/dpkg.cfg.d/docker; for page in tdsp tdsp-build tdsp-table libtdsp tdsp_table_open; do man -w $page; done'
step "a C program builds by pkg-config and runs" script 'cd /project && gcc -std=c99 program.c $(pkg-config --cflags --libs tdsp) -o program && ./program'
step "it builds against the archive and runs" script 'cd /project && gcc -std=c99 -static program.c $(pkg-config --static --cflags --libs tdsp) -o still && ./still'
step "a reader builds against the archive of the reader alone" script 'cd /project && gcc -std=c99 reader.c $(pkg-config --cflags --libs tdsp-query) -o reader && ./reader'
step "a CMake project builds, shared and static, and runs" script 'cd /project && cmake -S . -B made && cmake --build made && made/shared && made/static && made/query'
step "python3-tdsp installs" install_python
step "Python solves and builds a table" script 'cd /project && python3 use.py'
step "the packages go without a trace" script 'apt-get purge -y -q python3-tdsp libtdsp-dev tdsp-tools libtdsp0 && left=$(find / -xdev -name "*tdsp*" -not -path "/debs/*" -not -path "/project/*" -not -path "/proc/*") && echo "$left" && [ -z "$left" ]'
exit $failed
