# SPDX-License-Identifier: BSD-3-Clause
"""Files that appear whole or not at all."""

from __future__ import annotations

import os
import secrets
from pathlib import Path


def write_whole(path: str | os.PathLike[str], data: bytes) -> None:
    """Writes beside `path` under a temporary name, syncs, then renames.

    A reader, a full disk or a power cut never meets half a file: what stood under the name stays
    until all of the new one is on the disk. The file gets the permissions a plain open() gives.
    Raises OSError, and leaves nothing behind.
    """
    # follow a link, as open() does, instead of replacing it by a plain file
    target = Path(path).resolve()
    # os.open and not tempfile: the latter makes files only their owner may read
    beside = target.with_name(f".{target.name}.{secrets.token_hex(6)}")
    try:
        handle = os.open(beside, os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_CLOEXEC, 0o666)
    except OSError as problem:  # of the name that was asked for, not of ours
        raise OSError(problem.errno, problem.strerror, str(path)) from None
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        os.replace(beside, target)
    except BaseException:
        beside.unlink(missing_ok=True)
        raise
    sync_folder(target.parent)


def sync_folder(folder: Path) -> None:
    """Makes a rename in `folder` survive a power cut, where the file system can say so."""
    handle = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
    try:
        os.fsync(handle)
    except OSError:  # some network file systems refuse to sync a folder; the file itself is safe
        pass
    finally:
        os.close(handle)
