# SPDX-License-Identifier: GPL-3.0-or-later
"""Which document an editor has open, for other editors of the same user to know."""

from __future__ import annotations

import hashlib
from pathlib import Path

from PySide6.QtCore import QLockFile


class OpenDocument:
    """A lock per document, in a folder of the user's own: beside the document it would litter, or
    could not be made. It is a warning and no more: a file that has changed is found when saving."""

    def __init__(self, folder: Path):
        self.folder = folder
        self.path: Path | None = None
        self.held: QLockFile | None = None

    def take(self, path: Path | None) -> int | None:
        """Lets go of the former document, and takes this one.

        Returns the number of the process that has it open already; None where there is none.
        """
        if path == self.path:
            return None
        self.release()
        self.path = path
        if path is None:
            return None
        key = hashlib.sha256(str(path.resolve()).encode(errors="surrogateescape")).hexdigest()
        self.held = QLockFile(str(self.folder / f"{key[:24]}.open"))
        self.held.setStaleLockTime(0)
        if self.held.tryLock(0) or self.held.error() != QLockFile.LockError.LockFailedError:
            return None
        return int(self.held.getLockInfo()[0])

    def release(self) -> None:
        """The document is open here no longer."""
        if self.held is not None and self.held.isLocked():
            self.held.unlock()
        self.path, self.held = None, None
