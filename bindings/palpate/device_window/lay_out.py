# SPDX-License-Identifier: BSD-3-Clause
"""Where the parts of the device window stand."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from PySide6.QtWidgets import (
    QButtonGroup,
    QHBoxLayout,
    QPushButton,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from palpate.device_window.cards import build_button

PANEL = 410
"""[px] width of what stands on the right."""
EDGE, GAP = 12, 10
"""[px]"""


class Pages(QWidget):
    """Pages of which one is seen, under their names."""

    def __init__(self, parent: QWidget, pages: Mapping[str, QWidget]):
        super().__init__(parent)
        self._pages = dict(pages)
        self._stack = QStackedWidget(self)
        self.tabs: dict[str, QPushButton] = {}
        group = QButtonGroup(self)
        row = QHBoxLayout()
        row.setSpacing(18)
        for k, (name, page) in enumerate(self._pages.items()):
            button = build_button(self, checkable=True)
            button.setObjectName("tab")
            group.addButton(button, k)
            row.addWidget(button)
            self.tabs[name] = button
            self._stack.addWidget(page)
        row.addStretch(1)
        group.idClicked.connect(self._stack.setCurrentIndex)
        next(iter(self.tabs.values())).setChecked(True)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(GAP)
        column.addLayout(row)
        column.addWidget(self._stack, 1)
        self.setFixedWidth(PANEL)

    def open(self, name: str) -> None:
        self.tabs[name].setChecked(True)
        self._stack.setCurrentWidget(self._pages[name])

    def seen(self) -> QWidget:
        return self._stack.currentWidget()

    def say(self, *names: str) -> None:
        for tab, name in zip(self.tabs.values(), names, strict=True):
            tab.setText(name)


def lay_out(window: QWidget, bar: QWidget, left: Sequence[QWidget], right: QWidget) -> None:
    """The bar on top; on the left one below the other, the first of them large."""
    column = QVBoxLayout()
    column.setSpacing(GAP)
    for k, part in enumerate(left):
        column.addWidget(part, int(k == 0))
    body = QHBoxLayout()
    body.setSpacing(EDGE)
    body.addLayout(column, 1)
    body.addWidget(right)
    whole = QVBoxLayout(window)
    whole.setContentsMargins(EDGE, EDGE, EDGE, EDGE)
    whole.setSpacing(GAP)
    whole.addWidget(bar)
    whole.addLayout(body, 1)
