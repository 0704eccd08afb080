# SPDX-License-Identifier: GPL-3.0-or-later
"""The open layout with the history that its file keeps, and the only way to change it."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

from palpate.layout import document
from palpate.layout.document import KINDS, History, Layout
from palpate.layout.layout_file import read_layout, write_layout
from PySide6.QtCore import QObject, Signal

from palpate_editor.document.file_state import is_changed, read_state


class LayoutSession(QObject):
    """A layout belongs to a file from the beginning: what is in it is named from there."""

    changed = Signal()
    """The layout or its history is another."""
    title_changed = Signal()
    """The file or the unsaved marker is another."""

    def __init__(self, parent: QObject | None = None):
        super().__init__(parent)
        self.path = Path()
        self.history = History(Layout())
        self.written: History | None = None
        """As the file has it."""
        self.state: str | None = None

    @property
    def layout(self) -> Layout:
        return self.history.now

    @property
    def name(self) -> str:
        return self.path.name

    @property
    def saved(self) -> bool:
        return self.history == self.written

    def open(self, path: Path) -> None:
        """Raises Refusal or OSError, and then nothing has changed."""
        state = read_state(path)
        history = read_layout(path)
        self.path, self.state, self.written = path, state, history
        self._show(history)

    def begin(self, path: Path) -> None:
        """An empty layout in a new file. Raises OSError."""
        self.path, self.written = path, None
        self.history = History(Layout())
        self.save()
        self.changed.emit()

    def restore(self, history: History, path: Path | None, state: str | None = None) -> None:
        """What belongs to the file at `path` but is not in it; `state` is that of the file when it
        was read. Raises OSError where nobody knows which file."""
        if path is None:
            raise OSError(
                "recovery: got a scene of no file, expected one: what is in it is named from there"
            )
        self.path, self.state, self.written = path, state, None
        self._show(history)

    def apply(self, layout: Layout) -> None:
        """One step of the history."""
        self._show(document.apply(self.history, layout))

    def undo(self) -> None:
        """Raises LayoutError where nothing was done."""
        self._show(document.undo(self.history))

    def redo(self) -> None:
        """Raises LayoutError where nothing was undone."""
        self._show(document.redo(self.history))

    def is_changed_on_disk(self) -> bool:
        """Whether the file holds what this session neither read nor wrote."""
        return is_changed(self.path, self.state)

    def save(self) -> None:
        """Raises LayoutError or OSError."""
        write_layout(self.path, self.history)
        self.state, self.written = read_state(self.path), self.history
        self.title_changed.emit()

    def save_as(self, path: Path) -> None:
        """In another file, from whose folder all files are named then. Raises LayoutError or
        OSError."""
        before = self.path.resolve().parent
        history = rename_files(self.history, before, path.resolve().parent)
        write_layout(path, history)
        self.path, self.state, self.written = path, read_state(path), history
        self._show(history)

    def _show(self, history: History) -> None:
        self.history = history
        self.changed.emit()
        self.title_changed.emit()


def rename_files(history: History, before: Path, after: Path) -> History:
    """With paths from the folder `after` that were from `before`."""

    def rename(part: Any) -> Any:
        moved = os.path.relpath((before / part.file).resolve(), after)
        return replace(part, file=Path(moved).as_posix())

    return change_parts(history, rename)


def change_parts(history: History, changed: Callable[[Any], Any]) -> History:
    def each(layout: Layout) -> Layout:
        fields = {name: tuple(map(changed, getattr(layout, name))) for name in KINDS.values()}
        return replace(layout, **fields)

    return History(
        each(history.now), tuple(map(each, history.before)), tuple(map(each, history.undone))
    )
