# SPDX-License-Identifier: MIT
"""Files that appear whole or not at all."""
from __future__ import annotations

import os
import pathlib
import tempfile
from typing import Any, Union

PathLike = Union[str, "os.PathLike[str]"]
TEMPORARY = ".tdsp-"


def write_atomically(path: PathLike, data: Any) -> None:
    """Write bytes to a temporary file beside `path`, and rename it: whoever reads `path` sees the old bytes or the new ones, all of them."""
    target = pathlib.Path(path)
    descriptor, temporary = tempfile.mkstemp(prefix=TEMPORARY, dir=target.parent)
    try:
        with os.fdopen(descriptor, "wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        os.chmod(temporary, 0o666 & ~_umask())
        os.replace(temporary, target)
    except BaseException:
        pathlib.Path(temporary).unlink(missing_ok=True)
        raise


def _umask() -> int:
    """The process's mask, which can only be read by setting it; a file of /proc tells it without."""
    for line in pathlib.Path("/proc/self/status").read_text(encoding="ascii", errors="replace").splitlines():
        if line.startswith("Umask:"):
            return int(line.split()[1], 8)
    return 0o022
