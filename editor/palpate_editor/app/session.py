# SPDX-License-Identifier: GPL-3.0-or-later
"""The open organ, its history, and the only way to change it."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoCommand, QUndoStack

from palpate_editor.app.spoken import say_title
from palpate_editor.compile import is_built_alike
from palpate_editor.document import EMPTY, Organ
from palpate_editor.document.file_state import is_changed, read_state
from palpate_editor.document.files import write_organ
from palpate_editor.edits import Edit
from palpate_editor.open_organ import open_organ

REMEMBERED = 200
"""Steps that can be undone. They share what they did not change, so most cost little."""


class Session(QObject):
    """One organ being edited. Every change goes through `apply`, one call for one step of undo."""

    changed = Signal(object, object)
    """before, after: views redraw what is not the same object."""
    title_changed = Signal()
    """The name, the file or the unsaved marker is another."""
    undone = Signal(str)
    redone = Signal(str)
    """What the edit is called."""

    def __init__(self, organ: Organ = EMPTY, parent: QObject | None = None):
        super().__init__(parent)
        self.organ = organ
        self.path: Path | None = None
        self.state: str | None = None
        """Of the file when it was last read or written here; see document.file_state."""
        self.tested: Organ | None = None
        """The organ that was felt last, as it was then."""
        self._loading = False
        self.history = QUndoStack(self)
        self.history.setUndoLimit(REMEMBERED)
        self.history.cleanChanged.connect(self._tell_title)

    @property
    def name(self) -> str:
        """What a window calls the document: its file, else the organ, else empty."""
        return self.path.name if self.path else self.organ.name

    @property
    def saved(self) -> bool:
        return self.history.isClean()

    def apply(self, edit: Edit) -> None:
        """Applies an edit and remembers it. On EditError nothing has changed."""
        self.history.push(_Applied(self, edit))

    def show(self, organ: Organ) -> None:
        """Shows another organ; `apply`, undo and redo are the ways to call this."""
        before, self.organ = self.organ, organ
        self.changed.emit(before, organ)
        if before.name != organ.name:
            self.title_changed.emit()

    def clear(self) -> None:
        """No organ."""
        self.load(EMPTY, None)

    def open(self, path: Path) -> None:
        """Reads any file that has an organ. Raises FileError, Refusal or OSError, and then nothing
        has changed. A window reads in a thread and calls load."""
        state = read_state(path)
        self.load(open_organ(path), path, state)

    def load(self, organ: Organ, path: Path | None, state: str | None = None) -> None:
        """Opens the organ of a file, with an empty history.

        Only a working file is saved where it came from: what came out of a published file or a
        scene file still stands there, and has no working file yet. `state` is the file's, read
        before the organ was.
        """
        self._replace(organ, path if path and path.suffix == ".organ" else None, state)

    def restore(self, organ: Organ, path: Path | None, state: str | None = None) -> None:
        """Opens an unsaved organ: it belongs to `path` but is not what is there.

        `state` is that of the file when the organ was read from it, None where nobody knows.
        """
        self._replace(organ, path, state, saved=False)

    def is_changed_on_disk(self) -> bool:
        """Whether the file holds what this session neither read nor wrote."""
        return self.path is not None and is_changed(self.path, self.state)

    def save(self, path: Path | None = None) -> None:
        """Writes the organ to its file or to another, whole or not at all.

        Raises ValueError where there is no file yet, FileError where the disk refuses.
        """
        target = path or self.path
        if target is None:
            raise ValueError("save: got no file yet, expected a path")
        write_organ(target, self.organ)
        self.mark_saved(self.organ, target)

    def mark_saved(self, organ: Organ, path: Path) -> None:
        """The organ stands in the file. A window writes in a thread and then calls this; what was
        edited meanwhile is still unsaved."""
        self.path, self.state = path, read_state(path)
        if organ is self.organ:
            self.history.setClean()
        self.title_changed.emit()

    def mark_tested(self) -> None:
        """The open organ has been felt."""
        self.tested = self.organ

    @property
    def is_tested(self) -> bool:
        """Whether the organ was felt as it is now; its texts may be others."""
        return self.tested is not None and is_built_alike(self.tested, self.organ)

    def _replace(
        self, organ: Organ, path: Path | None, state: str | None, saved: bool = True
    ) -> None:
        # nobody is told before all of it is true: half way, the new organ would pass for saved
        self._loading = True
        self.history.clear()
        if not saved:
            self.history.resetClean()
        self._loading = False
        self.path, self.state, self.tested = path, state, None
        self.show(organ)
        self.title_changed.emit()

    def _tell_title(self) -> None:
        if not self._loading:
            self.title_changed.emit()


class _Applied(QUndoCommand):
    """Documents are values, so to undo is to remember: no edit writes its own inverse."""

    def __init__(self, session: Session, edit: Edit):
        after = edit(session.organ)  # refused before anything is said of it
        super().__init__(say_title(edit.title))
        self.session, self.before, self.after = session, session.organ, after

        self.first = True
        """Qt calls redo when the command is pushed, too."""

    def redo(self) -> None:
        self.session.show(self.after)
        if not self.first:
            self.session.redone.emit(self.text())
        self.first = False

    def undo(self) -> None:
        self.session.show(self.before)
        self.session.undone.emit(self.text())
