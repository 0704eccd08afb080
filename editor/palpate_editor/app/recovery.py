# SPDX-License-Identifier: GPL-3.0-or-later
"""What is left of an editor that was killed: unsaved documents in a folder, one for each window.

<token>.lock              held by the living editor that writes the other two
<token>.organ, .layout    the organ, or the scene with its past, in the format of its files
<token>.json              which file it belongs to, and when it was written
"""

from __future__ import annotations

import json
import secrets
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import Any

from palpate.files.whole_file import write_whole
from palpate.layout.layout_file import read_layout, write_layout
from PySide6.QtCore import QLockFile, QStandardPaths

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
class DocumentKind:
    """How a document is kept."""

    ending: str
    held: str
    """The attribute of its session that is the document, a value."""
    read: Callable[[Path], Any]
    """Raises FileError, Refusal or OSError."""
    write: Callable[[Path, Any], None]


ORGAN = DocumentKind(".organ", "organ", read_organ, write_organ)
LAYOUT = DocumentKind(".layout", "history", read_layout, write_layout)
KINDS = {kind.ending: kind for kind in (ORGAN, LAYOUT)}


@dataclass(frozen=True)
class Recovery:
    """An unsaved document whose editor is no more."""

    file: Path
    document: Path | None
    """The file it belongs to; None where it never had one."""
    name: str
    """What the window called it."""
    time: datetime
    """When it was written."""
    state: str | None = None
    """Of the document's file when it was read from it; see document.file_state."""

    @property
    def kind(self) -> DocumentKind:
        return KINDS[self.file.suffix]

    def read(self) -> Any:
        """Raises FileError, Refusal or OSError."""
        return self.kind.read(self.file)

    def remove(self) -> None:
        for ending in (self.file.suffix, ".json", ".lock"):
            self.file.with_suffix(ending).unlink(missing_ok=True)


def lock(file: Path) -> QLockFile:
    """The lock of a recovery file. One whose process has died is free, however new it is."""
    made = QLockFile(str(file.with_suffix(".lock")))
    made.setStaleLockTime(0)
    return made


def find_recoveries(folder: Path) -> list[Recovery]:
    """What no living editor is at work on, the newest first."""
    found = []
    for file in (file for ending in KINDS for file in folder.glob(f"*{ending}")):
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
    """The recovery file of a session, held by its lock until it is removed."""

    def __init__(self, folder: Path, kind: DocumentKind = ORGAN):
        self.kind = kind
        self.path = folder / f"{secrets.token_hex(8)}{kind.ending}"
        self.held = lock(self.path)

    def write(self, value: Any, document: Path | None, name: str, state: str | None = None) -> None:
        """Whole or not at all. Raises FileError or OSError."""
        if not self.held.isLocked() and not self.held.tryLock(0):
            raise OSError(f"{self.held.fileName()}: the lock of recovery cannot be had")
        note = {
            "document": str(document.absolute()) if document else None,
            "name": name,
            "state": state,
        }
        write_whole(self.path.with_suffix(".json"), json.dumps(note).encode())
        self.kind.write(self.path, value)

    def remove(self) -> None:
        """Nothing is left to recover."""
        for ending in (self.kind.ending, ".json"):
            self.path.with_suffix(ending).unlink(missing_ok=True)
        if self.held.isLocked():
            self.held.unlock()
