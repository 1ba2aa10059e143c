#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Pack the release: dist.py VERSION EPOCH OUTPUT

Writes OUTPUT/libtdsp-VERSION.tar.gz with the files that the project tracks, as they are now, and beside it the list of what is in it, as
OUTPUT/libtdsp-VERSION.spdx.json. Both depend on the files and on EPOCH only, so whoever packs the same files has the same bytes, also from an unpacked
release.
"""
import gzip
import io
import os
import pathlib
import subprocess
import sys
import tarfile

import sbom
import tracked

ROOT = tracked.ROOT


def header(name, path, epoch):
    """What a file of that content is called, and who may run it: nothing else of the machine."""
    entry = tarfile.TarInfo(name)
    entry.size = path.stat().st_size
    entry.mode = 0o755 if os.access(path, os.X_OK) else 0o644
    entry.mtime = epoch
    entry.uname = entry.gname = "root"
    return entry


def packed(files, top, epoch):
    archive = io.BytesIO()
    with tarfile.open(fileobj=archive, mode="w", format=tarfile.PAX_FORMAT) as tar:
        for file in files:
            path = ROOT / file
            if path.is_symlink():
                raise SystemExit(f"dist: {file} is a symbolic link; releases have none")
            with open(path, "rb") as content:
                tar.addfile(header(f"{top}/{file}", path, epoch), content)
    return gzip.compress(archive.getvalue(), mtime=0)


def write(path, content):
    """Whole or not at all."""
    fresh = path.with_name(f".{path.name}.new")
    fresh.write_bytes(content)
    fresh.replace(path)


def warn_of_changes():
    if tracked.is_repository():
        changed = subprocess.run(["git", "-c", f"safe.directory={ROOT}", "-C", ROOT, "status", "--porcelain"], check=True, capture_output=True, text=True).stdout
        if changed:
            print(f"dist: {len(changed.splitlines())} files are not as they were committed, or are not tracked", file=sys.stderr)


def main(version, epoch, output):
    output = pathlib.Path(output)
    output.mkdir(parents=True, exist_ok=True)
    warn_of_changes()
    files, top = tracked.files(), f"libtdsp-{version}"
    write(output / f"{top}.tar.gz", packed(files, top, int(epoch)))
    write(output / f"{top}.spdx.json", sbom.document(files, version, int(epoch)).encode())


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
