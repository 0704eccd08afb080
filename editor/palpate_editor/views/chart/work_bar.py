# SPDX-License-Identifier: GPL-3.0-or-later
"""How far a chart or an advice is, and the button that ends it."""

from __future__ import annotations

from PySide6.QtWidgets import QHBoxLayout, QProgressBar, QPushButton, QWidget

from palpate_editor.views.chart.advisor import Advisor
from palpate_editor.views.elided_label import ElidedLabel
from palpate_editor.views.translations import tr

WIDTH = 110
"""[px] of the bar."""


class WorkBar(QWidget):
    """Shown while the advisor is at work."""

    def __init__(self, advisor: Advisor, parent: QWidget | None = None):
        super().__init__(parent)
        self.advisor = advisor
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(8)
        self.label, self.bar = ElidedLabel(self), QProgressBar(self)
        self.bar.setFixedWidth(WIDTH)
        self.bar.setRange(0, 100)
        self.bar.setTextVisible(False)
        self.button = QPushButton(tr("Stop"), self)
        self.button.setObjectName("stop_chart")
        self.button.setProperty("small", True)
        self.button.clicked.connect(advisor.cancel)
        row.addWidget(self.label, 1)
        row.addWidget(self.bar)
        row.addWidget(self.button)
        advisor.began.connect(self.begin)
        advisor.progressed.connect(self.tell)
        advisor.ended.connect(self.hide)
        self.setVisible(advisor.is_busy)

    def begin(self) -> None:
        self.label.setText("")
        self.bar.setValue(0)
        self.show()

    def tell(self, text: str, share: float) -> None:
        self.label.setText(text)
        self.bar.setValue(round(100 * share))
