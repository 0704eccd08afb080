# SPDX-License-Identifier: GPL-3.0-or-later
"""What is asked of an organ's simulation, the button that asks, and what is advised."""

from __future__ import annotations

from typing import TYPE_CHECKING

from palpate.study.advice import Targets
from palpate.study.scene_chart import DISPLACEMENT_TARGET, FORCE_TARGET
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QGridLayout, QHBoxLayout, QPushButton, QWidget

from palpate_editor.advice_words import describe_advised
from palpate_editor.document import Organ
from palpate_editor.views.chart.advisor import Advisor
from palpate_editor.views.chart.work_bar import WorkBar
from palpate_editor.views.context import Context
from palpate_editor.views.number_box import NumberBox
from palpate_editor.views.stages.facts import Section, write_label
from palpate_editor.views.translations import say, tr

if TYPE_CHECKING:  # it loads SciPy
    from palpate_editor.advise import Advised

SHORT = 3
"""Sentences that the form shows; the chart has all of them."""


class AdviceForm(Section):
    """Two targets; the rate is the hand's own."""

    chart_wanted = Signal()

    def __init__(self, context: Context, advisor: Advisor, parent: QWidget | None = None):
        super().__init__(tr("Advice"), parent)
        self.context, self.advisor = context, advisor
        grid = QGridLayout()
        grid.setHorizontalSpacing(14)
        grid.setColumnStretch(1, 1)
        self.force = self.add_target(grid, tr("Force error"), "target_force", FORCE_TARGET)
        self.displacement = self.add_target(
            grid, tr("Displacement error"), "target_displacement", DISPLACEMENT_TARGET
        )
        self.depth = self.add_depth(grid)
        self.body.addLayout(grid)
        row = QHBoxLayout()
        row.setSpacing(8)
        self.button = QPushButton(tr("Advise"), self)
        self.button.setObjectName("advise")
        self.button.clicked.connect(self.ask)
        self.chart_button = QPushButton(tr("Chart\N{HORIZONTAL ELLIPSIS}"), self)
        self.chart_button.setObjectName("show_chart")
        self.chart_button.clicked.connect(self.chart_wanted)
        row.addWidget(self.button)
        row.addWidget(self.chart_button)
        row.addStretch(1)
        self.body.addLayout(row)
        self.add(WorkBar(advisor, self))
        self.words = self.add(write_label("", "note", self))
        self.words.setObjectName("advice_words")
        self.words.setWordWrap(True)
        self.say_nothing()
        advisor.began.connect(self.show_busy)
        advisor.ended.connect(self.show_busy)
        advisor.advised.connect(self.show_advised)

    def add_target(self, grid: QGridLayout, text: str, name: str, target: float) -> NumberBox:
        """In per cent."""
        box = NumberBox(self)
        box.setObjectName(name)
        box.setAccessibleName(text)
        box.setRange(0.1, 100.0)
        box.setDecimals(1)
        box.setValue(100.0 * target)
        box.setSuffix("\N{NO-BREAK SPACE}%")
        self.add_box(grid, text, box)
        return box

    def add_depth(self, grid: QGridLayout) -> NumberBox:
        """In millimetres; 0 is as far as the chart goes."""
        box = NumberBox(self)
        box.setObjectName("target_depth")
        text = tr("Pressed or pulled to")
        box.setAccessibleName(text)
        box.setRange(0.0, 1000.0)
        box.setDecimals(1)
        box.setSpecialValueText(tr("as charted"))
        box.setSuffix("\N{NO-BREAK SPACE}mm")
        self.add_box(grid, text, box)
        return box

    def add_box(self, grid: QGridLayout, text: str, box: NumberBox) -> None:
        label = write_label(text, "name", self)
        label.setBuddy(box)
        line = grid.rowCount()
        grid.addWidget(label, line, 0)
        grid.addWidget(box, line, 1)

    def say_nothing(self) -> None:
        self.words.setText(
            tr("The cheapest way to simulate this organ that is right and quick enough. Its chart "
               "is drawn first where there is none: minutes, and kept.")
        )  # fmt: skip

    def show_organ(self, organ: Organ) -> None:
        self.button.setEnabled(organ.surface is not None and not self.advisor.is_busy)

    def show_busy(self) -> None:
        self.show_organ(self.context.session.organ)

    def ask(self) -> None:
        rate = self.context.session.organ.hand.rate
        self.advisor.advise(
            Targets(
                self.force.value() / 100.0,
                self.displacement.value() / 100.0,
                rate,
                1e-3 * self.depth.value(),
            )
        )

    def show_advised(self, advised: Advised) -> None:
        """The first sentences of it."""
        chart = self.advisor.chart
        if chart is not None:
            lines = describe_advised(advised, chart, self.context.session.organ)
            self.words.setText(" ".join(str(say(line)) for line in lines[:SHORT]))
