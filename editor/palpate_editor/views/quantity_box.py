# SPDX-License-Identifier: GPL-3.0-or-later
"""A field for one constant: a number over many decades, with its unit beside it."""

from __future__ import annotations

import math

from palpate.translation.numbers import say_digits
from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QKeyEvent, QValidator, QWheelEvent
from PySide6.QtWidgets import (
    QAbstractSpinBox,
    QCheckBox,
    QHBoxLayout,
    QLabel,
    QSizePolicy,
    QWidget,
)

STEP = 0.1
"""[-] of the leading digit's power of ten: one press of an arrow key."""


class QuantityBox(QAbstractSpinBox):
    """Edits a number in a unit of people's liking; tells it in SI when it has been entered."""

    entered = Signal(float)
    """[SI] The new value; only where it is another than before."""

    def __init__(self, unit: str, scale: float = 1.0, parent: QWidget | None = None):
        super().__init__(parent)
        self.unit, self.scale = unit, scale
        """`scale` is one shown unit in SI."""
        self.shown: float | None = None
        self.refused = ""
        """The text that was refused."""
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.setMinimumWidth(70)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.editingFinished.connect(self.enter)
        self.lineEdit().setTextMargins(5, 0, 5, 0)
        self.lineEdit().textEdited.connect(self.forgive)

    # ------------------------------------------------------------ value

    def show_value(self, value: float | None) -> None:
        """Shows a value [SI] of the document, unless another is being typed."""
        if value == self.shown and not self.property("refused"):
            return
        self.shown = value
        self.lineEdit().setText("" if value is None else write_number(value / self.scale))
        self.mark(False)

    def enter(self) -> None:
        """Takes what was typed; anything that is no number goes back to what was."""
        text = self.lineEdit().text()
        value = read_number(text)
        if value is None or (self.property("refused") and text == self.refused):
            # leaving a field that was refused goes back to what is
            self.revert()
            return
        value = float(f"{value * self.scale:.12g}")
        if self.shown is None or not math.isclose(value, self.shown, rel_tol=1e-12):
            self.entered.emit(value)

    def revert(self) -> None:
        value, self.shown = self.shown, math.nan
        self.show_value(value)

    def mark(self, refused: bool) -> None:
        """Shows that what stands here was refused."""
        self.refused = self.lineEdit().text() if refused else ""
        self.setProperty("refused", refused)
        self.style().unpolish(self)
        self.style().polish(self)

    def forgive(self) -> None:
        if self.property("refused"):
            self.mark(False)

    # ------------------------------------------------------------ Qt

    def validate(self, text: str, position: int) -> object:
        allowed = set("0123456789.,eE+-− \N{NARROW NO-BREAK SPACE}")
        known = set(text) <= allowed
        return QValidator.State.Acceptable if known else QValidator.State.Invalid, text, position

    def fixup(self, text: str) -> str:
        return text

    def stepEnabled(self) -> QAbstractSpinBox.StepEnabledFlag:
        flags = QAbstractSpinBox.StepEnabledFlag
        return flags.StepUpEnabled | flags.StepDownEnabled

    def stepBy(self, steps: int) -> None:
        """A tenth of the leading digit's decade: 150 goes to 160, 0.02 to 0.021."""
        value = read_number(self.lineEdit().text())
        if value is None:
            return
        decade = 10.0 ** math.floor(math.log10(abs(value))) if value else 1.0
        self.lineEdit().setText(write_number(value + steps * STEP * decade))
        self.enter()

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Scrolling the form must not change numbers on the way."""
        if self.hasFocus():
            super().wheelEvent(event)
        else:
            event.ignore()

    def event(self, event: QEvent) -> bool:
        """Escape goes back to what was, before it may mean anything else to the window."""
        if event.type() == QEvent.Type.ShortcutOverride and isinstance(event, QKeyEvent):
            shown = "" if self.shown is None else write_number(self.shown / self.scale)
            if event.key() == Qt.Key.Key_Escape and self.lineEdit().text() != shown:
                event.accept()
                return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.revert()
            event.accept()
            return
        super().keyPressEvent(event)


def read_number(text: str) -> float | None:
    """A finite number as people write it, with a comma or a point; None where it is none."""
    text = text.replace("−", "-").replace(" ", "").replace("\N{NARROW NO-BREAK SPACE}", "")
    if "," in text and "." not in text:
        text = text.replace(",", ".")
    try:
        value = float(text)
    except ValueError:
        return None
    return value if math.isfinite(value) else None


def write_number(value: float) -> str:
    """As short as it is exact enough: 0.0025 (0,0025 in Turkish), 150, 3e+07 as 3e7."""
    text = say_digits(f"{value:.6g}")
    if "e" in text:
        mantissa, power = text.split("e")
        text = f"{mantissa}e{int(power)}"
    return text.replace("-", "−") if text.startswith("-") else text


class QuantityRow(QWidget):
    """A quantity with its unit; with a box to tick where it may be none."""

    entered = Signal(object)
    """[SI] float, or None."""

    def __init__(
        self, box: QuantityBox, optional: str | None = None, parent: QWidget | None = None
    ):
        super().__init__(parent)
        self.box, self.default = box, 0.0
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(6)
        self.tick: QCheckBox | None = None
        if optional is not None:
            self.tick = QCheckBox(optional, self)
            self.tick.toggled.connect(self.switch)
            layout.addWidget(self.tick)
        layout.addWidget(box, 1)
        self.unit = QLabel(box.unit, self)
        self.unit.setProperty("role", "name")
        self.unit.setMinimumWidth(48)
        layout.addWidget(self.unit)
        box.entered.connect(self.tell)

    def show_value(self, value: float | None) -> None:
        """None shows the default, faint and locked."""
        if self.tick is not None:
            self.tick.blockSignals(True)
            self.tick.setChecked(value is not None)
            self.tick.blockSignals(False)
            self.box.setEnabled(value is not None)
        self.box.show_value(self.default if value is None else value)

    def tell(self, value: float) -> None:
        self.entered.emit(value)

    def switch(self, on: bool) -> None:
        self.entered.emit(self.default if on else None)
