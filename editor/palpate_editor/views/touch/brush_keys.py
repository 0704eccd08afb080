# SPDX-License-Identifier: GPL-3.0-or-later
"""Keys for the size of a brush that work wherever the keyboard's focus is."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from PySide6.QtCore import QObject
from PySide6.QtGui import QAction

from palpate_editor.views.touch.tools import SizedTool
from palpate_editor.views.translations import tr


class BrushKeys(QObject):
    """Two actions that size whichever brush has the mouse, wherever the keyboard's focus is."""

    def __init__(self, tools: Sequence[SizedTool], parent: QObject | None = None):
        super().__init__(parent)
        self.tools = tools
        self.actions = [
            self._add("brush_smaller", tr("Smaller brush"), "[", self.shrink),
            self._add("brush_larger", tr("Larger brush"), "]", self.grow),
        ]
        for tool in tools:
            tool.activated.connect(self._take_active)
        self._take_active(False)

    def _add(self, name: str, title: str, key: str, slot: Callable[[], None]) -> QAction:
        action = QAction(title, self)
        action.setObjectName(name)
        action.setShortcut(key)
        action.triggered.connect(slot)
        return action

    def grow(self) -> None:
        self._size(1.0)

    def shrink(self) -> None:
        self._size(-1.0)

    def _size(self, notches: float) -> None:
        for tool in self.tools:
            if tool.active:
                tool.grow(notches)

    def _take_active(self, on: bool) -> None:
        for action in self.actions:
            action.setEnabled(on)
