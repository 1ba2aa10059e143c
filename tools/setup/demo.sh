#!/bin/bash
# SPDX-License-Identifier: MIT
# The main job, command by command: a real scene in, a certified table out, answers with safe paths, two pictures, and the page where it has been built.
#   demo.sh BUILD SCENE
set -euo pipefail

build=$1
scene=$2
out=$build/demo
name=$(basename "$scene" .json)
table=$out/$name.tdsp
mkdir -p "$out"

# Show a command as a person would type it, and run it.
show() {
    printf '\n$ %s\n' "${*/#$build\/tdsp/tdsp}"
    "$@"
}

show "$build/tdsp" build "$scene" -o "$table"
show "$build/tdsp" info "$table"
# Halfway through the departures that the table answers.
middle=$("$build/tdsp" info --json "$table" | sed -n 's/.*"last_departure" *: *\([0-9.e+-]*\).*/\1/p' | head -n 1 | awk '{ printf "%.0f", $1 / 2 }')
show "$build/tdsp" query "$table" 0 "$middle"
show "$build/tdsp" path "$table" "$middle"
show "$build/tdsp" verify "$scene" "$table"
show "$build/tdsp" plot "$scene" --depart "$middle" --animate -o "$out/$name-path.svg"
show "$build/tdsp" plot "$table" -o "$out/$name-travel-times.svg"
if [ -e "$build/page/index.html" ]; then
    show "$build/tdsp" view "$scene" --no-open -o "$out/$name.html"
    look="          $out/$name.html (all of it to play with: open it in a browser)"
else
    look="          'make page' builds a page to play with: then tdsp view $scene"
fi

echo
echo "table:    $table"
echo "pictures: $out/$name-path.svg (the path, leaving at $middle: a browser plays it)"
echo "          $out/$name-travel-times.svg (the travel time of every departure)"
echo "$look"
