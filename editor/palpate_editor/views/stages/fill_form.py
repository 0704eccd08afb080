# SPDX-License-Identifier: GPL-3.0-or-later
"""How a solid is filled: tetrahedra, how their volumes count, and what the tool can reach."""

from __future__ import annotations

from palpate.scene.scene_parts import FILLED
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QComboBox, QWidget

from palpate_editor.document import Organ
from palpate_editor.edits import SetReach
from palpate_editor.views.context import Context
from palpate_editor.views.stages.constant_form import build_grid
from palpate_editor.views.stages.facts import Section, write_label
from palpate_editor.views.translations import tr

FILLING = ("fill.tetrahedra", "fill.nodal_share")


class ReachField(QComboBox):
    """The region on which a linear solid can be pushed."""

    def __init__(self, context: Context, parent: QWidget | None = None):
        super().__init__(parent)
        self.context = context
        self.names: list[str] = []
        """One for each item; empty for all of the surface."""
        label = tr("The tool reaches")
        self.setObjectName("fill.reach")
        self.setAccessibleName(label)
        self.label = write_label(label, "name", parent)
        self.label.setBuddy(self)
        self.activated.connect(self.choose)

    def choose(self, row: int) -> None:
        if self.names[row] != self.context.session.organ.fill.reach:
            self.context.apply(SetReach(self.names[row]))
        self.show_organ(self.context.session.organ)

    def show_organ(self, organ: Organ) -> None:
        chosen = organ.fill.reach
        names = ["", *organ.regions]
        if chosen not in names:  # a region that is gone, of which a check says so
            names.append(chosen)
        if names != self.names:
            self.names = names
            self.clear()
            self.addItems([name or tr("All of the surface") for name in names])
        self.setCurrentIndex(names.index(chosen))
        shown = organ.model.kind == "linear_solid"
        self.label.setVisible(shown)
        self.setVisible(shown)

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Scrolling the form must not change the reach on the way."""
        event.ignore()


class FillForm(Section):
    """Shown for solids alone."""

    def __init__(self, context: Context, parent: QWidget | None = None):
        super().__init__(tr("Filling"), parent)
        grid, self.constants = build_grid(context, FILLING, self)
        self.reach = ReachField(context, self)
        grid.addWidget(self.reach.label, len(FILLING), 0)
        grid.addWidget(self.reach, len(FILLING), 1)
        self.body.addLayout(grid)
        self.note = write_label("", "note", self)
        self.note.setWordWrap(True)
        self.add(self.note)

    def show_organ(self, organ: Organ) -> None:
        self.setVisible(organ.model.kind in FILLED)
        self.reach.show_organ(organ)
        text = tr(
            "About as many tetrahedra are made as are asked for; more are nearer to the tissue and "
            "take longer. A nodal share of 0 lets volumes lock, which makes the organ too stiff; 1 "
            "lets tetrahedra turn inside out."
        )
        if organ.model.kind == "linear_solid":
            text += " " + tr(
                "The memory of a linear solid grows with what can be pushed: name a region, and "
                "elsewhere it does not give."
            )
        self.note.setText(text)
