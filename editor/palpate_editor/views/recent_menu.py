# SPDX-License-Identifier: GPL-3.0-or-later
"""File > Open recent: the files used last; those that are gone are grey."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMenu

from palpate_editor.app.settings import Settings
from palpate_editor.views.translations import tr


class RecentMenu(QObject):
    """Fills its menu whenever it opens."""

    wanted = Signal(object)
    """The path."""

    def __init__(self, menu: QMenu, settings: Settings, parent: QObject | None = None):
        super().__init__(parent)
        self.menu, self.settings = menu, settings
        menu.aboutToShow.connect(self.fill)
        self.fill()

    def fill(self) -> None:
        self.menu.clear()
        files = self.settings.recent_files()
        for i, file in enumerate(files, start=1):
            action = QAction(f"&{i % 10}  {file.path.name}", self.menu)
            action.setData(str(file.path))
            action.setToolTip(str(file.path))
            action.setEnabled(file.exists)
            action.triggered.connect(self.choose)
            self.menu.addAction(action)
        if files:
            self.menu.addSeparator()
        forget = QAction(tr("&Forget them"), self.menu)
        forget.setShortcut("Ctrl+Alt+N")
        forget.setEnabled(bool(files))
        forget.triggered.connect(self.forget)
        self.menu.addAction(forget)

    def choose(self) -> None:
        action = self.sender()
        if isinstance(action, QAction):
            self.wanted.emit(Path(str(action.data())))

    def forget(self) -> None:
        self.settings.clear_recent()
        self.fill()
