# SPDX-License-Identifier: GPL-3.0-or-later
"""What is left of an editor that was killed: unsaved organs in a folder, one for each editor.

<token>.lock     held by the living editor that writes the other two
<token>.organ    the organ as it was, in the format of working files
<token>.json     which file it belongs to, and when it was written
"""

from __future__ import annotations

import json
import secrets
import tempfile
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

from palpate.files.whole_file import write_whole
from PySide6.QtCore import QLockFile, QStandardPaths

from palpate_editor.document import Organ
from palpate_editor.document.files import read_organ, write_organ


def find_recovery_folder() -> Path:
    """The user's own, made where it is missing; one for this start alone where none can be made."""
    place = QStandardPaths.StandardLocation.GenericDataLocation
    folder = Path(QStandardPaths.writableLocation(place)) / "palpate" / "recovery"
    try:
        folder.mkdir(parents=True, exist_ok=True, mode=0o700)
    except OSError:  # a home that cannot be written keeps nobody from working
        return Path(tempfile.mkdtemp(prefix="palpate-recovery-"))
    return folder


@dataclass(frozen=True)
class Recovery:
    """An unsaved organ whose editor is no more."""

    file: Path
    document: Path | None
    """The file it belongs to; None where it never had one."""
    name: str
    """What the window called it."""
    time: datetime
    """When it was written."""
    state: str | None = None
    """Of the document when the organ was read from it; see document.file_state."""

    def read(self) -> Organ:
        """Raises FileError."""
        return read_organ(self.file)

    def remove(self) -> None:
        for ending in (".organ", ".json", ".lock"):
            self.file.with_suffix(ending).unlink(missing_ok=True)


def lock(file: Path) -> QLockFile:
    """The lock of a recovery file. One whose process has died is free, however new it is."""
    made = QLockFile(str(file.with_suffix(".lock")))
    made.setStaleLockTime(0)
    return made


def find_recoveries(folder: Path) -> list[Recovery]:
    """What no living editor is at work on, the newest first."""
    found = []
    for file in folder.glob("*.organ"):
        held = lock(file)
        if not held.tryLock(0):
            continue
        held.unlock()
        found.append(describe(file))
    return sorted(found, key=lambda recovery: recovery.time, reverse=True)


def describe(file: Path) -> Recovery:
    """A recovery file in words; the note beside it may be missing or damaged."""
    time = datetime.fromtimestamp(file.stat().st_mtime)
    try:
        note = json.loads(file.with_suffix(".json").read_bytes())
        document, name, state = note["document"], note["name"], note.get("state")
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        document, name, state = None, "", None
    known = isinstance(document, str) and document
    return Recovery(
        file,
        Path(document) if known else None,
        str(name),
        time,
        state if isinstance(state, str) else None,
    )


class RecoveryFile:
    """The recovery file of this editor, held by its lock until it is removed."""

    def __init__(self, folder: Path):
        self.path = folder / f"{secrets.token_hex(8)}.organ"
        self.held = lock(self.path)

    def write(
        self, organ: Organ, document: Path | None, name: str, state: str | None = None
    ) -> None:
        """Whole or not at all. Raises FileError or OSError."""
        if not self.held.isLocked() and not self.held.tryLock(0):
            raise OSError(f"{self.held.fileName()}: the lock of recovery cannot be had")
        note = {
            "document": str(document.absolute()) if document else None,
            "name": name,
            "state": state,
        }
        write_whole(self.path.with_suffix(".json"), json.dumps(note).encode())
        write_organ(self.path, organ)

    def remove(self) -> None:
        """Nothing is left to recover."""
        for ending in (".organ", ".json"):
            self.path.with_suffix(ending).unlink(missing_ok=True)
        if self.held.isLocked():
            self.held.unlock()
