# SPDX-License-Identifier: BSD-3-Clause
"""Files that appear whole or not at all: the Python twin of core/sim/base/private/whole_file.h."""

from __future__ import annotations

import contextlib
import errno
import fcntl
import os
import secrets
import stat
from pathlib import Path

from palpate.error import NotDurable

MOST_NAME_BYTES = 200
"""Of a file's name within the name of the one beside it, which must fit into 255."""
MOST_TRIES = 100
NEW = os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_NOFOLLOW | os.O_CLOEXEC
FOUND = os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC


def write_whole(path: str | os.PathLike[str], data: bytes) -> None:
    """Writes beside `path` under a name nobody can foresee, syncs, then renames.

    A reader, a full disk, a kill or a power cut never meets half a file: what stood under the name
    stays until all of the new one is on the disk. What a killed writer left beside it is removed by
    the next one. The file gets the permissions a plain open() gives.

    Raises OSError, and leaves nothing behind; NotDurable where the file is in place but the disk
    has not confirmed its name.
    """
    # follow a link, as open() does, instead of replacing it by a plain file
    target = Path(path).resolve()
    if target.exists() and not target.is_file():
        kind = errno.EISDIR if target.is_dir() else errno.EINVAL
        raise OSError(kind, f"{os.strerror(kind)}: not a plain file", str(path))
    try:
        remove_leftovers(target)
        beside, handle = create_beside(target)
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
    sync_folder(target.parent, str(path))


class Journal:
    """A file that grows by a line at a time, each on the disk before the next is begun.

    What an end of the process cut short is a last line without its end; `kept` leaves it out.
    """

    def __init__(self, path: Path, kept: int = 0):
        """Goes on behind the first `kept` bytes, all that stands behind them is dropped. Raises
        OSError."""
        self.file = os.fdopen(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_CLOEXEC, 0o666), "wb")
        self.file.truncate(kept)
        self.file.seek(kept)

    def append(self, line: bytes) -> None:
        """Raises OSError."""
        self.file.write(line + b"\n")
        self.file.flush()
        os.fsync(self.file.fileno())

    def close(self) -> None:
        self.file.close()


def open_locked(path: Path) -> int | None:
    """A handle with a lock on a file, which is made where it is not there; None where another
    program has it. The lock lives as long as this program, or the handle. Raises OSError.
    """
    handle = os.open(path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        os.close(handle)
        return None
    return handle


def begin_part_name(target: Path) -> str:
    """What all names of new files beside `target` begin with."""
    return f".{os.fsdecode(os.fsencode(target.name)[:MOST_NAME_BYTES])}.part-"


def create_beside(target: Path) -> tuple[Path, int]:
    """A new file with a lock on it, which tells others that its writer lives."""
    for _ in range(MOST_TRIES):
        beside = target.with_name(begin_part_name(target) + secrets.token_hex(8))
        # os.open and not tempfile: the latter makes files only their owner may read
        with contextlib.suppress(FileExistsError):
            handle = os.open(beside, NEW, 0o666)
            with contextlib.suppress(OSError):  # without locks nothing is removed either
                fcntl.flock(handle, fcntl.LOCK_EX)
            if os.fstat(handle).st_nlink > 0:
                return beside, handle
            os.close(handle)  # another writer took it for a leftover before it was locked
    raise OSError(errno.EEXIST, os.strerror(errno.EEXIST), str(target))


def remove_leftovers(target: Path) -> None:
    """Removes what writers of `target` left that were killed; a living one holds a lock."""
    begin = begin_part_name(target)
    with contextlib.suppress(OSError), os.scandir(target.parent) as entries:
        for entry in entries:
            if entry.name.startswith(begin):
                remove_if_left(Path(entry.path))


def remove_if_left(part: Path) -> None:
    """Removes a plain file of ours that no living writer holds."""
    with contextlib.suppress(OSError):
        handle = os.open(part, FOUND)
        try:
            status = os.fstat(handle)
            if stat.S_ISREG(status.st_mode) and status.st_uid == os.geteuid():
                fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
                part.unlink()
        finally:
            os.close(handle)


def sync_folder(folder: Path, path: str) -> None:
    """Makes a rename in `folder` survive a power cut, where the file system can be asked.

    Raises NotDurable, which names the file at `path`.
    """
    try:
        handle = os.open(folder, os.O_RDONLY | os.O_DIRECTORY | os.O_CLOEXEC)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)
    except OSError as problem:
        # one may write in a folder that one may not read; network folders may not know of syncs
        if problem.errno not in (errno.EACCES, errno.EINVAL, errno.ENOTSUP, errno.EBADF):
            raise NotDurable(
                path,
                "",
                f"a folder that the disk does not sync ({problem.strerror})",
                "one that it does: the file is saved, but a loss of power may bring back what "
                "stood there before",
            ) from None
