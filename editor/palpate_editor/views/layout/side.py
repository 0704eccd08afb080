# SPDX-License-Identifier: GPL-3.0-or-later
"""What stands at the right of a scene: pages that scroll, one at a time."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QScrollArea, QTabWidget, QWidget

LEAST = 340
"""[px] of a page."""


class Side(QTabWidget):
    """The scene first, its task behind it."""

    turned = Signal(bool)
    """Whether it is the second page that is seen."""

    def __init__(self, first: tuple[str, QWidget], second: tuple[str, QWidget], parent: QWidget):
        super().__init__(parent)
        self.setObjectName("side")
        for title, page in (first, second):
            area = QScrollArea(self)
            area.setWidgetResizable(True)
            page.setMinimumWidth(LEAST)
            area.setWidget(page)
            self.addTab(area, title)
        self.currentChanged.connect(lambda index: self.turned.emit(index == 1))
