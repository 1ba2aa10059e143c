#!/bin/bash
# Draw the pictures of README.md from a real scene.
#   pictures.sh BUILD SCENE DIRECTORY
set -euo pipefail

build=$1
scene=$2
out=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
table=$work/$(basename "$scene" .json).tdsp
mkdir -p "$out"
"$build/tdsp" build "$scene" -o "$table" >/dev/null
"$build/tdsp" plot "$scene" --depart 0 -o "$out/path.png"
"$build/tdsp" plot "$table" -o "$out/travel-times.png"
