# SPDX-License-Identifier: GPL-3.0-or-later
"""How the parts of a mesh file become one organ: side by side or as solids, with regions or not."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox, QComboBox, QGridLayout, QWidget

from palpate_editor.document import Organ
from palpate_editor.edits.import_mesh import Assembling
from palpate_editor.views.number_box import NumberBox
from palpate_editor.views.stages.facts import write_label
from palpate_editor.views.translations import tr

WELD, UNITE = 0, 1
MOST_WELD = 10.0
"""[mm]"""


class AssemblingForm(QWidget):
    """What is asked for beside which parts."""

    changed = Signal()

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(14)
        grid.setColumnStretch(1, 1)
        self.way = QComboBox(self)
        self.way.setObjectName("assembling")
        self.way.addItems([tr("Side by side"), tr("As solids, united")])
        self.way.currentIndexChanged.connect(self.on_way)
        self.weld = NumberBox(self)
        self.weld.setObjectName("weld")
        self.weld.setRange(0.0, MOST_WELD)
        self.weld.setDecimals(3)
        self.weld.setSingleStep(0.05)
        self.weld.setSuffix(" mm")
        self.weld.setSpecialValueText(tr("where they meet"))
        self.weld.setToolTip(tr("Vertices of different parts that are closer become one"))
        self.regions = QCheckBox(tr("Keep each part as a region, for a tissue of its own"), self)
        self.regions.setObjectName("region_per_part")
        self.weld_name = write_label(tr("Weld across"), "name", self)
        grid.addWidget(write_label(tr("Put together"), "name", self), 0, 0)
        grid.addWidget(self.way, 0, 1)
        grid.addWidget(self.weld_name, 1, 0)
        grid.addWidget(self.weld, 1, 1)
        grid.addWidget(self.regions, 2, 0, 1, 2)

    def on_way(self) -> None:
        welds = self.way.currentIndex() == WELD
        self.weld.setVisible(welds)
        self.weld_name.setVisible(welds)
        self.changed.emit()

    def show_taken(self, taken: bool) -> None:
        """Parts that others are taken away from are solids."""
        if taken:
            self.way.setCurrentIndex(UNITE)
        self.way.setEnabled(not taken)

    def show_organ(self, organ: Organ) -> None:
        """As the organ was put together."""
        done = organ.assembly
        self.way.setCurrentIndex(UNITE if done and (done.unite or done.subtracted) else WELD)
        self.weld.setValue(1e3 * (done.weld or 0.0) if done else 0.0)
        self.regions.setChecked(bool(done and done.regions))

    def read(self, taken: tuple[str, ...]) -> Assembling:
        united = self.way.currentIndex() == UNITE
        weld = None if united or self.weld.value() == 0.0 else 1e-3 * self.weld.value()
        return Assembling(weld, united, taken, self.regions.isChecked())
