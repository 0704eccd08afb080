# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeping what is unsaved where a crash cannot reach it."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from datetime import datetime
from pathlib import Path
from typing import Any

from palpate.layout.document import LayoutError
from PySide6.QtCore import QObject, QTimer, Signal

from palpate_editor.app.recovery import ORGAN, DocumentKind, Recovery, RecoveryFile

DELAY = 1000
"""[ms] An edit is on the disk at the latest so long after it was made, if the disk keeps up."""


class Autosave(QObject):
    """Writes the unsaved document of a session into a recovery file, beside the window.

    Documents are values, so a thread may write one while the next is being made. The file goes when
    the document is saved; it stays when the process is killed.
    """

    saved = Signal(object)
    """When [datetime]."""
    failed = Signal(str)
    """Why not, in a sentence."""
    _written = Signal(str)
    """What went wrong in the thread, or empty."""

    def __init__(
        self,
        session: Any,
        folder: Path,
        delay: int = DELAY,
        parent: QObject | None = None,
        kind: DocumentKind = ORGAN,
    ):
        """`session` is a Session, or a LayoutSession with `kind` LAYOUT."""
        super().__init__(parent)
        self.session = session
        self.file = RecoveryFile(folder, kind)
        self.thread_pool = ThreadPoolExecutor(1, thread_name_prefix="autosave")
        self.busy = False
        self.kept: Any = None
        """What the recovery file has."""
        self.timer = QTimer(self, singleShot=True, interval=delay)
        self.timer.timeout.connect(self.keep)
        self._written.connect(self._end_write)
        session.changed.connect(self._on_changed)
        session.title_changed.connect(self._on_title_changed)

    @property
    def value(self) -> Any:
        """The document as it is."""
        return getattr(self.session, self.file.kind.held)

    def keep(self) -> None:
        """Writes what is unsaved now, in the thread."""
        if self.session.saved or self.value is self.kept:
            return
        if self.busy:  # _end_write comes back to this
            return
        self.busy, self.kept = True, self.value
        session = self.session
        self.thread_pool.submit(self._write, self.kept, session.path, session.name, session.state)

    def restore(self, recovery: Recovery) -> None:
        """Puts what a crash left in the editor. It is removed once this editor has a copy of it.

        Raises FileError, Refusal or OSError, and then nothing has changed.
        """
        value = recovery.read()
        self.file.write(value, recovery.document, recovery.name, recovery.state)
        self.kept = value
        self.session.restore(value, recovery.document, recovery.state)
        recovery.remove()

    def finish(self) -> None:
        """The window closes, with everything saved or let go on purpose."""
        self.timer.stop()
        self.thread_pool.shutdown(wait=True)
        self.file.remove()

    def _write(self, value: Any, path: Path | None, name: str, state: str | None) -> None:
        try:
            self.file.write(value, path, name, state)
        except (LayoutError, OSError) as problem:  # a FileError is an OSError
            self._written.emit(str(problem))
        else:
            self._written.emit("")

    def _end_write(self, problem: str) -> None:
        self.busy = False
        if problem:
            self.kept = None
            self.failed.emit(problem)
            return
        if self.session.saved:  # saved while this was being written
            self._discard()
        else:
            self.saved.emit(datetime.now())
            self._on_changed()

    def _on_changed(self, *_: object) -> None:
        unsaved = not self.session.saved and self.value is not self.kept
        if unsaved and not self.timer.isActive():
            self.timer.start()

    def _on_title_changed(self) -> None:
        if self.session.saved:
            self._discard()
        else:
            self._on_changed()

    def _discard(self) -> None:
        """Nothing is unsaved: nothing is to be recovered."""
        self.timer.stop()
        if not self.busy:
            self.kept = None
            self.file.remove()
