# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers of a scripted press, and where it goes."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from palpate.runs.press import PressScript
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QFormLayout, QHBoxLayout, QLabel, QPushButton, QSizePolicy, QWidget

from palpate_editor.views.quantity_box import QuantityBox, QuantityRow
from palpate_editor.views.stages.facts import write_label
from palpate_editor.views.translations import fill, tr

FIRST = {"depth": 6e-3, "pull": 0.0, "speed": 0.03, "hold": 0.3}
"""[m] [m] [m/s] [s], those of `palpate press`."""
LIMITS = {
    "depth": (1e-4, 0.1),
    "pull": (0.0, 0.1),
    "speed": (1e-3, 0.5),
    "hold": (0.05, 10.0),
}


class PressForm(QWidget):
    """Depth, pull, speed, hold and place."""

    changed = Signal()
    refused = Signal(str)
    """A sentence: a number was out of its range."""
    pick_toggled = Signal(bool)
    """The person wants to point at the place, or no longer."""

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.setObjectName("press_form")
        self.values = dict(FIRST)
        self.place: NDArray[np.float64] | None = None
        """[m] (3,) near which the surface is pressed; None for the top."""
        self._rows: dict[str, QuantityRow] = {}
        form = QFormLayout(self)
        form.setContentsMargins(0, 0, 0, 0)
        form.setHorizontalSpacing(12)
        form.setVerticalSpacing(7)
        self._add(form, "depth", tr("Depth"), "mm", tr("How far the tip goes below the surface"))
        self._add(form, "pull", tr("Pull"), "mm", tr("Then it grips and pulls this far above"))
        self._add(form, "speed", tr("Speed"), "mm/s", tr("Mean speed of the press and the pull"))
        self._add(form, "hold", tr("Hold"), "ms", tr("Time at the deepest and highest point"))
        form.addRow(write_label(tr("Place"), "name", self), self._build_place())
        self.show_place(None)

    def _add(self, form: QFormLayout, field: str, title: str, unit: str, tip: str) -> None:
        row = QuantityRow(QuantityBox(unit, 1e-3), parent=self)
        row.box.setObjectName(f"press_{field}")
        row.setToolTip(tip)
        row.show_value(self.values[field])
        take = {
            "depth": self._take_depth,
            "pull": self._take_pull,
            "speed": self._take_speed,
            "hold": self._take_hold,
        }[field]
        row.entered.connect(take)
        self._rows[field] = row
        name = write_label(title, "name", self)
        # a form keeps a label that does not grow at the top of its field
        name.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Expanding)
        form.addRow(name, row)

    def _build_place(self) -> QWidget:
        box = QWidget(self)
        line = QHBoxLayout(box)
        line.setContentsMargins(0, 0, 0, 0)
        line.setSpacing(6)
        self.where = QLabel(box)
        self.pick = QPushButton(tr("Pick"), box)
        self.pick.setCheckable(True)
        self.pick.setObjectName("pick_place")
        self.pick.setToolTip(tr("Then click on the organ where the tip shall press"))
        self.top = QPushButton(tr("Top"), box)
        self.top.setToolTip(tr("Press from above, over the middle of the organ"))
        for button in (self.pick, self.top):
            button.setProperty("small", True)
        self.pick.toggled.connect(self.pick_toggled)
        self.top.clicked.connect(self.use_top)
        line.addWidget(self.where, 1)
        line.addWidget(self.pick)
        line.addWidget(self.top)
        return box

    # ------------------------------------------------------------ both ways

    def script(self) -> PressScript:
        """What to run."""
        return PressScript(**self.values)

    def show_place(self, place: NDArray[np.float64] | None) -> None:
        """Presses near a point [m] from now on; None for the top."""
        # as the command line writes it, so that both press the very same point
        self.place = None if place is None else np.round(place, 6)
        if place is None:
            self.where.setText(tr("the top"))
        else:
            self.where.setText(" ".join(f"{1e3 * c:.0f}" for c in place) + " mm")
        self.top.setEnabled(place is not None)
        self.pick.setChecked(False)
        self.changed.emit()

    def use_top(self) -> None:
        self.show_place(None)

    def _take_depth(self, value: object) -> None:
        self._take("depth", float(value))

    def _take_pull(self, value: object) -> None:
        self._take("pull", float(value))

    def _take_speed(self, value: object) -> None:
        self._take("speed", float(value))

    def _take_hold(self, value: object) -> None:
        self._take("hold", float(value))

    def _take(self, field: str, value: float) -> None:
        low, high = LIMITS[field]
        row = self._rows[field]
        if low <= value <= high:
            self.values[field] = value
            row.show_value(value)
            self.changed.emit()
            return
        row.box.revert()
        self.refused.emit(
            fill(
                tr("{name} must lie between {low:g} and {high:g} {unit}, got {got:g}."),
                name={
                    "depth": tr("Depth"),
                    "pull": tr("Pull"),
                    "speed": tr("Speed"),
                    "hold": tr("Hold"),
                }[field],
                low=1e3 * low,
                high=1e3 * high,
                got=1e3 * value,
                unit=row.box.unit,
            )
        )


def write_command(file: str, script: PressScript, place: NDArray[np.float64] | None) -> list[str]:
    """The arguments of the command line that presses the same way."""
    arguments = ["palpate", "press", file, "--depth", f"{1e3 * script.depth:g}mm"]
    if script.pull:
        arguments += ["--pull", f"{1e3 * script.pull:g}mm"]
    arguments += ["--speed", f"{1e3 * script.speed:g}mm/s", "--hold", f"{1e3 * script.hold:g}ms"]
    if place is not None:
        arguments.append("--at=" + ",".join(f"{1e3 * c:.3f}" for c in place))
    return arguments
