# SPDX-License-Identifier: GPL-3.0-or-later
"""What a hand feels of a solid with the hard law of contact, and would feel by the near field."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QGridLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from palpate_editor.document.problems import TrialFacts
from palpate_editor.edits import SetChoice
from palpate_editor.trial import has_hard_law
from palpate_editor.views.context import Context
from palpate_editor.views.stages.constant_form import choice_text
from palpate_editor.views.stages.facts import write_label
from palpate_editor.views.translations import number, quantity, tr

UPGRADE = SetChoice("contact_law", "near_field")
ALIGNED = (Qt.AlignmentFlag.AlignLeft, Qt.AlignmentFlag.AlignRight)


class ContactOffer(QWidget):
    """A table of forces before and after, and the button that changes the law."""

    def __init__(self, context: Context, parent: QWidget | None = None):
        super().__init__(parent)
        self.context = context
        self.setObjectName("contact_offer")
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 2, 0, 2)
        column.setSpacing(6)
        self.lead = write_label("", "note", self)
        self.lead.setWordWrap(True)
        column.addWidget(self.lead)
        self.grid = QGridLayout()
        self.grid.setHorizontalSpacing(14)
        self.grid.setVerticalSpacing(3)
        self.grid.setColumnStretch(0, 1)
        column.addLayout(self.grid)
        self.cells: list[list[QLabel]] = []
        self.button = QPushButton(tr("Feel it as on tissue"), self)
        self.button.setObjectName("use_near_field")
        self.button.clicked.connect(self.upgrade)
        column.addWidget(self.button, 0, Qt.AlignmentFlag.AlignLeft)
        self.setVisible(False)

    def show_trial(self, trial: TrialFacts | None) -> None:
        """Nothing where no force of both laws is known: of any but a solid with the hard law, and
        of one that has just been changed."""
        offer = () if trial is None else trial.offer
        shown = bool(offer) and has_hard_law(self.context.session.organ)
        self.setVisible(shown)
        if trial is None or not shown:
            return
        self.lead.setText(
            tr(
                "Contact as on the mesh, which files of before have, lets the mesh be felt. "
                "A hand that presses {depth} deep feels by either law:"
            ).format(depth=quantity(1e3 * trial.depth, "mm"))
        )
        self.write_row(
            0, [tr("Place [mm]"), choice_text("hard"), choice_text("near_field")], "name"
        )
        for row, place in enumerate(offer, start=1):
            point = ", ".join(number(round(1e3 * c)) for c in place.point)
            forces = [quantity(1e3 * force, "mN", 3) for force in place.forces or ()]
            self.write_row(row, [point, *forces], "value")
        for row, cells in enumerate(self.cells):
            for cell in cells:
                cell.setVisible(row <= len(offer))

    def write_row(self, row: int, texts: list[str], role: str) -> None:
        while len(self.cells) <= row:
            made = [write_label("", role, self) for _ in texts]
            for column, label in enumerate(made):
                self.grid.addWidget(label, len(self.cells), column, ALIGNED[column > 0])
            self.cells.append(made)
        for label, text in zip(self.cells[row], texts, strict=True):
            label.setText(text)

    def texts(self) -> list[list[str]]:
        """What the table shows, row by row."""
        return [[cell.text() for cell in row] for row in self.cells if not row[0].isHidden()]

    def upgrade(self) -> None:
        self.context.apply(UPGRADE)
