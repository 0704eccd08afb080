# SPDX-License-Identifier: GPL-3.0-or-later
"""A tissue of the literature: a button that takes its constants, and one that shows its values."""

from __future__ import annotations

from palpate.scene.scene_parts import MaterialPart, ModelPart
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QPushButton, QWidget

from palpate_editor.edits import SetMaterial
from palpate_editor.shipped import list_tissues
from palpate_editor.views.context import Context
from palpate_editor.views.shipped_organs import name_tissue
from palpate_editor.views.stages.published_dialog import PublishedDialog
from palpate_editor.views.translations import tr


class TissueBox(QComboBox):
    def wheelEvent(self, event: QWheelEvent) -> None:
        """Scrolling the form must not change the tissue on the way."""
        event.ignore()


class PublishedValues(QWidget):
    """One row at the top of the form."""

    def __init__(self, context: Context, parent: QWidget | None = None):
        super().__init__(parent)
        self.context, self.tissues = context, list_tissues()
        self.dialog: PublishedDialog | None = None
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(8)
        self.box = TissueBox(self)
        self.box.setObjectName("published_tissue")
        self.box.setAccessibleName(tr("Tissue to look up"))
        self.box.addItems([name_tissue(tissue.name, tissue.title) for tissue in self.tissues])
        self.box.setSizeAdjustPolicy(
            QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
        )
        self.take = QPushButton(tr("Use"), self)
        self.take.setObjectName("use_tissue")
        self.take.setToolTip(tr("Use the constants of this tissue"))
        self.take.clicked.connect(self.use_tissue)
        self.show_button = QPushButton(tr("Values…"), self)
        self.show_button.setObjectName("show_published")
        self.show_button.setToolTip(tr("What the literature says, and what you add to it"))
        self.show_button.clicked.connect(self.show_values)
        row.addWidget(self.box, 1)
        row.addWidget(self.take)
        row.addWidget(self.show_button)

    def show_values(self) -> None:
        if self.dialog is None:
            self.dialog = PublishedDialog(self.context, self)
        self.dialog.show_tissue(self.box.currentIndex())

    def use_tissue(self) -> None:
        tissue = self.tissues[self.box.currentIndex()]
        material, model = MaterialPart(**tissue.material), ModelPart(**tissue.model)
        self.context.apply(SetMaterial(material, model, name_tissue(tissue.name, tissue.title)))
