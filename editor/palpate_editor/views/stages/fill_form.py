# SPDX-License-Identifier: GPL-3.0-or-later
"""How a solid is filled: tetrahedra, how their volumes count, and what the tool can reach."""

from __future__ import annotations

from palpate.scene.scene_parts import FILLED
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QComboBox, QPushButton, QWidget

from palpate_editor.document import Organ
from palpate_editor.edits import CapHoles, SetFineRegion, SetReach
from palpate_editor.edits.wall import is_closed
from palpate_editor.views.context import Context
from palpate_editor.views.stages.constant_form import build_grid
from palpate_editor.views.stages.facts import Section, write_label
from palpate_editor.views.translations import tr

FILLING = ("fill.tetrahedra", "fill.nodal_share", "fill.fine_ratio")


class RegionField(QComboBox):
    """A region of the surface that the filling has a use for."""

    def __init__(
        self, context: Context, field: str, edit: type, texts: tuple[str, str], parent: QWidget
    ):
        """`field` of the fill part, what sets it; its label, and what no region is called."""
        super().__init__(parent)
        self.context, self.field, self.edit = context, field, edit
        self.names: list[str] = []
        """One for each item; empty for no region."""
        label, self.nothing = texts
        self.setObjectName(f"fill.{field}")
        self.setAccessibleName(label)
        self.label = write_label(label, "name", parent)
        self.label.setBuddy(self)
        self.activated.connect(self.choose)

    def find_chosen(self, organ: Organ) -> str:
        return str(getattr(organ.fill, self.field))

    def choose(self, row: int) -> None:
        if self.names[row] != self.find_chosen(self.context.session.organ):
            self.context.apply(self.edit(self.names[row]))
        self.show_organ(self.context.session.organ, self.isVisible())

    def show_organ(self, organ: Organ, shown: bool) -> None:
        chosen = self.find_chosen(organ)
        names = ["", *organ.regions]
        if chosen not in names:  # a region that is gone, of which a check says so
            names.append(chosen)
        if names != self.names:
            self.names = names
            self.clear()
            self.addItems([name or self.nothing for name in names])
        self.setCurrentIndex(names.index(chosen))
        self.label.setVisible(shown)
        self.setVisible(shown)

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Scrolling the form must not change the region on the way."""
        event.ignore()


class FillForm(Section):
    """Shown for solids alone."""

    def __init__(self, context: Context, parent: QWidget | None = None):
        super().__init__(tr("Filling"), parent)
        self.context = context
        grid, self.constants = build_grid(context, FILLING, self)
        finer = (tr("Finer at"), tr("Nowhere"))
        reaches = (tr("The tool reaches"), tr("All of the surface"))
        self.fine = RegionField(context, "fine_region", SetFineRegion, finer, self)
        self.reach = RegionField(context, "reach", SetReach, reaches, self)
        for row, field in enumerate((self.fine, self.reach), start=len(FILLING)):
            grid.addWidget(field.label, row, 0)
            grid.addWidget(field, row, 1)
        self.body.addLayout(grid)
        self.close_button = QPushButton(tr("Close for filling"), self)
        self.close_button.setObjectName("close_for_filling")
        self.close_button.setToolTip(
            tr("Closes every hole; each cap stays known as a region, so that it can be held.")
        )
        self.close_button.clicked.connect(self.close_holes)
        self.add(self.close_button)
        self.note = write_label("", "note", self)
        self.note.setWordWrap(True)
        self.add(self.note)

    def show_organ(self, organ: Organ) -> None:
        self.setVisible(organ.model.kind in FILLED)
        is_open = organ.surface is not None and not is_closed(organ.surface)
        self.close_button.setVisible(is_open)
        self.fine.show_organ(organ, organ.model.kind in FILLED)
        self.reach.show_organ(organ, organ.model.kind == "linear_solid")
        text = tr(
            "As many tetrahedra are made as are asked for, to a tenth; more are nearer to the "
            "tissue and take longer. A nodal share of 0 lets volumes lock, which makes the organ "
            "too stiff; 1 lets tetrahedra turn inside out."
        )
        if organ.model.kind == "linear_solid":
            text += " " + tr(
                "The memory of a linear solid grows with what can be pushed: name a region, and "
                "elsewhere it does not give."
            )
        self.note.setText(text)

    def close_holes(self) -> None:
        self.context.long_edit_wanted.emit(CapHoles(even=True, bent=True))
