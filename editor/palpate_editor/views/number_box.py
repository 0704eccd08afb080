# SPDX-License-Identifier: GPL-3.0-or-later
"""A number that is stepped through: what stands in it stands as in a QuantityBox."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDoubleSpinBox, QWidget


class NumberBox(QDoubleSpinBox):
    """To the right, and off the edge."""

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.lineEdit().setTextMargins(5, 0, 5, 0)
