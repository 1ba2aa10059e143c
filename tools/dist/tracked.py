# SPDX-License-Identifier: MIT
"""The files that belong to the project: those that git tracks, or, where there is no repository, all but what was built."""
import pathlib
import shutil
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]


def _is_made(path):
    return path.parts[0] in ("build", ".git") or "__pycache__" in path.parts


def is_repository():
    return (ROOT / ".git").exists() and shutil.which("git") is not None


def files():
    """Sorted paths from the top of the checkout. A tracked file that is gone is left out."""
    if is_repository():
        # The checkout may be somebody else's.
        listed = subprocess.run(["git", "-c", f"safe.directory={ROOT}", "-C", ROOT, "ls-files", "-z"], check=True, capture_output=True).stdout.decode()
        found = [pathlib.Path(name) for name in listed.split("\0") if name]
    else:
        found = [path.relative_to(ROOT) for path in ROOT.rglob("*") if not path.is_dir()]
    return sorted(path for path in found if not _is_made(path) and (ROOT / path).is_file())
