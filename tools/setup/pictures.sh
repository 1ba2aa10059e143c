#!/bin/bash
# SPDX-License-Identifier: MIT
# Draw the pictures of README.md, from a real scene, and those of docs/guide.md and docs/math, from examples/scenes.
#   pictures.sh BUILD SCENE DIRECTORY           draw them, and write what they show to DIRECTORY/shown.txt
#   pictures.sh --check BUILD SCENE DIRECTORY   is DIRECTORY/shown.txt what they would show now?
# What a picture shows is, in numbers, the paths, gaps or rows that it draws, to five digits: pictures of the same numbers are the same, whatever fonts
# a machine has. That of the page is drawn where there are a browser and the page ('make page'); elsewhere the one that is there stays.
set -euo pipefail

check=
if [ "$1" = --check ]; then check=1; shift; fi
build=$1
scene=$2
out=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Numbers to five digits, and no times that were measured.
rounded() { awk '{ for (i = 1; i <= NF; i++) if ($i ~ /^-?[0-9.]+(e[-+]?[0-9]+)?$/) $i = sprintf("%.5g", $i); print }'; }

path() { # PICTURE SCENE DEPARTURE
    { echo "$1"; "$build/tdsp" path "$2" "$3"; } | rounded >>"$work/shown.txt"
    [ -n "$check" ] || "$build/tdsp" plot "$2" --depart "$3" -o "$out/$1" >/dev/null
}

moving() { # PICTURE SCENE DEPARTURE LATER
    { echo "$1"; "$build/tdsp" path "$2" "$3"; "$build/tdsp" path "$2" "$4"; "$build/tdsp" jumps "$2"; } | rounded >>"$work/shown.txt"
    [ -n "$check" ] || "$build/tdsp" plot "$2" --depart "$3" --beside "$4" --jumps --animate -o "$out/$1" >/dev/null
}

page() { # PICTURE SCENE NAME DEPARTURE WIDTH HEIGHT COLOURS: of the scene that has this name in the page's gallery
    { echo "$1"; "$build/tdsp" path "$2" "$4"; "$build/tdsp" jumps "$2"; } | rounded >>"$work/shown.txt"
    [ -z "$check" ] || return 0
    if ! command -v chromium >/dev/null || [ ! -e "$build/page/index.html" ]; then
        echo "pictures: $1 stays as it is: it takes chromium, and the page that 'make page' builds" >&2
        return 0
    fi
    # The table comes last, and bends after it.
    tools/setup/screenshot.py "$build/page/index.html#scene=$3&leave=$4" "$out/$1" "$5" "$6" "$7" \
        'globalThis.tdspPage && (({ built, working, stale }) => built && !working && !stale)(tdspPage.answers.found)'
}

travel_times() { # PICTURE SCENE
    local table=$work/table.tdsp # the picture names the scene
    "$build/tdsp" build "$2" -o "$table" >/dev/null
    { echo "$1"; "$build/tdsp" info "$table" | sed '1d;/^size\|^guides\|^scene hash/d; s/, at (.*//'; } | rounded >>"$work/shown.txt"
    mv "$table" "$work/$(basename "$2" .json).tdsp"
    [ -n "$check" ] || "$build/tdsp" plot "$work/$(basename "$2" .json).tdsp" -o "$out/$1" >/dev/null
}

[ -n "$check" ] || mkdir -p "$out/math"
examples=examples/scenes
moving fires.svg "$scene" 52 53
page page.png "$scene" fire-oregon-c 52 1280 962 light
page page-phone.png $examples/two-discs.json two-discs 9.8 390 1190 dark
moving gate.svg $examples/two-discs.json 9.8 9.9
travel_times travel-times.png "$scene"
travel_times math/two-discs-travel-times.png $examples/two-discs.json
travel_times math/slow-disc-travel-times.png $examples/gaps/slow-disc.json
path math/settled-too-soon.png $examples/gaps/settled-too-soon.json 0
path math/first-to-leave.png $examples/gaps/first-to-leave.json 5
path math/emerging.png $examples/gaps/emerging.json 0
path math/close-to-the-source.png $examples/gaps/close-to-the-source.json 1
path math/one-centre.png $examples/gaps/one-centre.json 0

if [ -z "$check" ]; then
    cp "$work/shown.txt" "$out/shown.txt"
elif diff -u "$out/shown.txt" "$work/shown.txt"; then
    echo "ok pictures"
else
    echo "not ok pictures: 'make pictures' draws them anew"
    exit 1
fi
