# SPDX-License-Identifier: GPL-3.0-or-later
"""What a file holds, so that nobody overwrites what they have not seen."""

from __future__ import annotations

import hashlib
from pathlib import Path


def read_state(path: Path) -> str | None:
    """SHA-256 of a file's bytes, in hexadecimal digits; None where there is no file to read.

    Read it before the file itself: should the file change in between, it will count as changed.
    """
    try:
        with path.open("rb") as file:
            return hashlib.file_digest(file, "sha256").hexdigest()
    except OSError:
        return None


def is_changed(path: Path, state: str | None) -> bool:
    """Whether `path` holds something else than when `state` was read. A file that is gone does
    not: nothing of it can be overwritten."""
    found = read_state(path)
    return found is not None and found != state
