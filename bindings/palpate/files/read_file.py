# SPDX-License-Identifier: BSD-3-Clause
"""Reading a file that a user, or another file, has named: plain files only, of a stated size."""

from __future__ import annotations

import os
import stat
from pathlib import Path

from palpate.error import FileError

MOST_BYTES = 128 * 2**20
"""Of any file that is read as one piece, unless its reader allows less; as kMostFileBytes of
core/scenario/container.h."""


def read_file(path: Path, most: int = MOST_BYTES) -> bytes:
    """All of a plain file of at most `most` bytes.

    A device or a pipe is refused and not waited for, whatever file named it. Raises
    FileError, or another OSError where there is no such file or it cannot be read.
    """
    try:
        handle = os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC)
    except ValueError:  # a NUL in it, or half a character
        found = "a name that no file can have"
        raise FileError(ascii(str(path)), "", found, "the name of a file") from None
    try:
        status = os.fstat(handle)
        if not stat.S_ISREG(status.st_mode):
            raise FileError(str(path), "", "something other than a file", "a file")
        if status.st_size > most:
            raise FileError(str(path), "", f"{status.st_size} bytes", f"at most {most}")
        with os.fdopen(handle, "rb", closefd=False) as file:
            data = file.read(most + 1)
    finally:
        os.close(handle)
    if len(data) > most:
        found = "a file that grows while it is read"
        raise FileError(str(path), "", found, f"at most {most} bytes")
    return data
