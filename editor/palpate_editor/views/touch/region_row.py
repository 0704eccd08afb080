# SPDX-License-Identifier: GPL-3.0-or-later
"""Named regions of an organ: keep the selection under a name, and take it up again."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QPushButton, QWidget

from palpate_editor.document import Organ
from palpate_editor.edits import RemoveRegion, SetRegion
from palpate_editor.views.touch.tools import SelectionTool
from palpate_editor.views.translations import tr


class RegionRow(QWidget):
    """A list of names to choose from or type into, with buttons to keep and forget."""

    def __init__(self, tool: SelectionTool, parent: QWidget | None = None):
        super().__init__(parent)
        self.tool = tool
        self.names = QComboBox(self)
        self.names.setObjectName("regions")
        self.names.setEditable(True)
        self.names.setInsertPolicy(QComboBox.InsertPolicy.NoInsert)
        self.names.lineEdit().setPlaceholderText(tr("Region"))
        self.names.setAccessibleName(tr("Region"))
        self.names.activated.connect(self._recall)
        self.names.editTextChanged.connect(self.show_use)
        self.keep = self._button(
            tr("Keep"), tr("Keep the selection under this name"), self._keep, "keep_region"
        )
        self.forget = self._button(
            tr("Forget"), tr("Forget this name; nothing else changes"), self._forget, "drop_region"
        )
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(6)
        row.addWidget(self.names, 1)
        row.addWidget(self.keep)
        row.addWidget(self.forget)
        self.show_names()
        tool.context.session.changed.connect(self._on_changed)
        tool.selection_changed.connect(self.show_use)

    def _button(self, title: str, tip: str, slot: Callable[[], None], name: str) -> QPushButton:
        button = QPushButton(title, self)
        button.setObjectName(name)
        button.setProperty("small", True)
        button.setToolTip(tip)
        button.clicked.connect(slot)
        return button

    @property
    def name(self) -> str:
        """What stands in the field."""
        return self.names.currentText().strip()

    def show_names(self) -> None:
        """Lists the regions of the open organ; what was typed stays."""
        typed = self.names.currentText()
        self.names.blockSignals(True)
        self.names.clear()
        self.names.addItems(sorted(self.tool.context.session.organ.regions))
        self.names.setEditText(typed)
        self.names.blockSignals(False)
        self.show_use()

    def show_use(self) -> None:
        """Locks what would do nothing."""
        self.keep.setEnabled(bool(self.name) and bool(self.tool.selected.any()))
        self.forget.setEnabled(self.name in self.tool.context.session.organ.regions)

    def _on_changed(self, before: Organ, after: Organ) -> None:
        if before.regions is not after.regions:
            self.show_names()

    def _recall(self, index: int) -> None:
        ids = self.tool.context.session.organ.regions.get(self.names.itemText(index))
        if ids is not None:
            self.tool.select(ids)

    def _keep(self) -> None:
        ids = np.flatnonzero(self.tool.selected)
        self.tool.context.apply(SetRegion(self.name, ids))

    def _forget(self) -> None:
        if self.tool.context.apply(RemoveRegion(self.name)):
            self.names.setEditText("")
