# SPDX-License-Identifier: GPL-3.0-or-later
"""What is in a scene, as a tree: bodies, stones and scenery; the chosen one is marked."""

from __future__ import annotations

from palpate.layout.document import Layout, Placed
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QHeaderView, QTreeWidget, QTreeWidgetItem, QWidget

from palpate_editor.views.translations import number, tr

NAME = Qt.ItemDataRole.UserRole


class PartTree(QTreeWidget):
    """Each part with where it stands."""

    chosen = Signal(str)

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.setObjectName("part_tree")
        self.setColumnCount(2)
        self.setHeaderLabels([tr("In the scene"), tr("Stands at (mm)")])
        self.header().setSectionResizeMode(0, QHeaderView.ResizeMode.ResizeToContents)
        self.setIndentation(15)
        self.setMinimumWidth(230)
        self.currentItemChanged.connect(self._tell)

    def show_layout(self, layout: Layout, chosen: str) -> None:
        self.blockSignals(True)
        self.clear()
        current = None
        for title, parts in (
            (tr("Organs"), layout.bodies),
            (tr("Stones"), layout.stones),
            (tr("Scenery"), layout.scenery),
        ):
            head = QTreeWidgetItem([title, "" if parts else tr("none")])
            head.setFlags(Qt.ItemFlag.ItemIsEnabled)
            self.addTopLevelItem(head)
            for part in parts:
                item = QTreeWidgetItem([part.name, write_place(part)])
                item.setData(0, NAME, part.name)
                item.setToolTip(0, part.file)
                head.addChild(item)
                if part.name == chosen:
                    current = item
        self.expandAll()
        self.setCurrentItem(current)
        self.blockSignals(False)

    def _tell(self, item: QTreeWidgetItem | None, before: QTreeWidgetItem | None) -> None:
        del before
        if item is not None and item.data(0, NAME):
            self.chosen.emit(item.data(0, NAME))


def write_place(part: Placed) -> str:
    return ", ".join(number(round(1e3 * x, 2), 4) for x in part.position)
