# SPDX-License-Identifier: GPL-3.0-or-later
"""What a scene has beside what is placed in it: its words, gravity, the fluid of its stones."""

from __future__ import annotations

from palpate.layout.document import Layout
from PySide6.QtCore import QEvent, QObject, Signal
from PySide6.QtWidgets import QFormLayout, QLabel, QLineEdit, QPlainTextEdit, QWidget

from palpate_editor.views.layout.number_grid import TickedNumbers
from palpate_editor.views.translations import tr

TASK_HEIGHT = 64
"""[px]"""
GRAVITY = (0.0, 0.0, -9.81)
"""[m/s²] Of a scene whose z axis goes up."""
WATER = (1000.0, 1e-3)
"""[kg/m³], [Pa s]"""


class SceneForm(QWidget):
    """A change is wanted when the cursor leaves a text, or a number is entered."""

    wanted = Signal(object)
    """The words of a change."""

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.shown = Layout()
        form = QFormLayout(self)
        form.setContentsMargins(0, 0, 0, 0)
        form.setRowWrapPolicy(QFormLayout.RowWrapPolicy.WrapAllRows)
        self.titles: dict[str, QLineEdit] = {}
        self.tasks: dict[str, QPlainTextEdit] = {}
        for ending, title, task in (
            ("", tr("Title"), tr("Task")),
            ("_tr", tr("Title in Turkish"), tr("Task in Turkish")),
        ):
            line, text = QLineEdit(self), QPlainTextEdit(self)
            line.setObjectName(f"title{ending}")
            line.editingFinished.connect(self._enter_titles)
            text.setObjectName(f"task{ending}")
            text.setFixedHeight(TASK_HEIGHT)
            text.setTabChangesFocus(True)
            text.installEventFilter(self)
            for words, widget in ((title, line), (task, text)):
                label = QLabel(words, self)
                label.setProperty("role", "name")
                label.setBuddy(widget)
                widget.setAccessibleName(words)
                form.addRow(label, widget)
            self.titles[f"title{ending}"], self.tasks[f"task{ending}"] = line, text
        self.gravity = TickedNumbers(
            "gravity", tr("Gravity"), [("m/s²", 1.0)] * 3, GRAVITY, self
        )  # fmt: skip
        self.gravity.setToolTip(tr("Without it, as the first organ was published, often none"))
        self.gravity.entered.connect(self._enter_gravity)
        form.addRow(self.gravity)
        self.fluid = TickedNumbers(
            "fluid", tr("Stones are in a fluid"), [("kg/m³", 1.0), ("mPa s", 1e-3)], WATER, self
        )
        self.fluid.setToolTip(tr("It bears them and slows them down"))
        self.fluid.entered.connect(self._enter_fluid)
        form.addRow(self.fluid)

    def show_layout(self, layout: Layout) -> None:
        """What is being typed stays."""
        before, self.shown = self.shown, layout
        for name, line in self.titles.items():
            if line.text() == getattr(before, name):
                line.setText(getattr(layout, name))
        for name, text in self.tasks.items():
            if text.toPlainText() == getattr(before, name) != getattr(layout, name):
                text.setPlainText(getattr(layout, name))
        self.gravity.show_values(layout.gravity)
        self.fluid.show_values(layout.fluid)
        self.fluid.setVisible(bool(layout.stones) or bool(layout.fluid))

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.FocusOut:
            self.enter_tasks()
        return super().eventFilter(watched, event)

    def enter_tasks(self) -> None:
        for name, text in self.tasks.items():
            self._enter(name, text.toPlainText())

    def _enter_titles(self) -> None:
        for name, line in self.titles.items():
            self._enter(name, line.text())

    def _enter(self, name: str, text: str) -> None:
        if text != getattr(self.shown, name):
            self.wanted.emit(("set", f"--{name.replace('_', '-')}={text}"))

    def _enter_gravity(self, values: tuple[float, ...]) -> None:
        self.wanted.emit(("set", f"--gravity={write(values)}"))

    def _enter_fluid(self, values: tuple[float, ...]) -> None:
        self.wanted.emit(("set", f"--fluid={write(values)}"))


def write(values: tuple[float, ...]) -> str:
    """As `palpate scene set` reads it."""
    return ",".join(f"{value:.9g}" for value in values) or "none"
