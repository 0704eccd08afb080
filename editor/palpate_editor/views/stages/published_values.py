# SPDX-License-Identifier: GPL-3.0-or-later
"""What the literature says about a tissue: ranges, how they were measured, and by whom."""

from __future__ import annotations

from palpate.scene_parts import MaterialPart, ModelPart
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QPushButton, QVBoxLayout, QWidget

from palpate_editor.document.constants import find_constant
from palpate_editor.edits import SetMaterial
from palpate_editor.shipped import list_tissues
from palpate_editor.views.desk import Desk
from palpate_editor.views.stages.facts import Facts, write_label
from palpate_editor.views.words import number, say, tr


class TissueBox(QComboBox):
    def wheelEvent(self, event: QWheelEvent) -> None:
        """Scrolling the form must not change the tissue on the way."""
        event.ignore()


class PublishedValues(QWidget):
    """A tissue to look up, its published values, and a button that takes its constants."""

    def __init__(self, desk: Desk, parent: QWidget | None = None):
        super().__init__(parent)
        self.desk, self.tissues = desk, list_tissues()
        body = QVBoxLayout(self)
        body.setContentsMargins(0, 0, 0, 0)
        body.setSpacing(7)
        row = QHBoxLayout()
        row.setSpacing(8)
        self.box = TissueBox(self)
        self.box.setObjectName("published_tissue")
        self.box.setAccessibleName(tr("Tissue to look up"))
        self.box.addItems([say(tissue.title) for tissue in self.tissues])
        self.box.currentIndexChanged.connect(self.show_tissue)
        self.take = QPushButton(tr("Use its constants"), self)
        self.take.setObjectName("use_tissue")
        self.take.clicked.connect(self.use_tissue)
        row.addWidget(self.box, 1)
        row.addWidget(self.take)
        body.addLayout(row)
        self.facts = Facts(self)
        body.addWidget(self.facts)
        self.note = write_label("", "note", self)
        self.note.setWordWrap(True)
        body.addWidget(self.note)
        self.show_tissue(0)

    def show_tissue(self, row: int) -> None:
        tissue = self.tissues[row]
        self.facts.show_facts(
            [
                (
                    say_quantity(found.quantity),
                    f"{say_range(found.quantity, found.low, found.high)}\n"
                    f"{found.method}; {found.source}"
                    + (tr(" (not looked up)") if found.uncertain else ""),
                )
                for found in tissue.published
            ]
        )
        self.note.setText(" ".join(tissue.note.split()))

    def use_tissue(self) -> None:
        tissue = self.tissues[self.box.currentIndex()]
        edit = SetMaterial(MaterialPart(**tissue.material), ModelPart(**tissue.model))
        self.desk.apply(edit)


def say_quantity(quantity: str) -> str:
    constant = find_constant("material", quantity)
    return quantity if constant is None else say(constant.label)


def say_range(quantity: str, low: float, high: float) -> str:
    """In the unit of the form's own field."""
    constant = find_constant("material", quantity)
    scale, unit = (1.0, "") if constant is None else (constant.scale, constant.unit)
    words = number(low / scale, 3)
    if high != low:
        words += f" \N{EN DASH} {number(high / scale, 3)}"
    return f"{words}\N{NO-BREAK SPACE}{unit}"
