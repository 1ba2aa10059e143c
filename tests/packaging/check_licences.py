#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every source names its licence where a reader and a scanner look: in one of its first lines. What cannot hold a comment is under LICENSE as a whole."""
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools/dist"))
import tracked  # noqa: E402

LINE = "SPDX-License-Identifier: MIT"
FIRST_LINES = 3
# Data, prose and pictures; lock files and manifests in formats without comments; records that programs write.
WITHOUT = {".md", ".json", ".csv", ".tsv", ".txt", ".png", ".svg", ".tdsp", ".tdspm", ".abi", ".supp", ".map", ".lock", ".sum", ".mod", ".bin", ".dict", ".ipynb",
           ".geojson", ".gpx", ".xml", ".typed", ".places", ".path", ".parquet"}
NAMED = {"LICENSE", ".gitignore", ".clang-format", ".clang-tidy", ".editorconfig", ".gitattributes"}
# Files whose names dpkg gives, in formats of its own.
FOLDERS = ("tools/debian", "tests/fuzz/corpus", "tests/fuzz/found", "tests/golden")


def needs(path):
    return path.suffix not in WITHOUT and path.name not in NAMED and not str(path).startswith(FOLDERS)


def names_it(path):
    with open(ROOT / path, encoding="utf-8", errors="replace") as file:
        return any(LINE in line for _, line in zip(range(FIRST_LINES), file))


def main():
    sources = [path for path in tracked.files() if needs(path)]
    missing = [path for path in sources if not names_it(path)]
    print(f"{'not ok' if missing else 'ok'} licences: each of {len(sources)} sources names its licence in its first {FIRST_LINES} lines")
    for path in missing:
        print(f"    {path}")
    print(f"{'ok' if sources else 'not ok'} licences: there are sources")
    return 1 if missing or not sources else 0


if __name__ == "__main__":
    sys.exit(main())
