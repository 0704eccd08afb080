# SPDX-License-Identifier: GPL-3.0-or-later
"""With which instrument a scene is touched."""

from __future__ import annotations

import math

from palpate.layout.document import Layout, SceneTool
from palpate.scene.instrument_kinds import KINDS
from PySide6.QtCore import QSignalBlocker, Signal
from PySide6.QtWidgets import QComboBox, QVBoxLayout, QWidget

from palpate_editor.layout_changes import write_three
from palpate_editor.views.layout.number_grid import NumberGrid, TickedNumbers
from palpate_editor.views.scenario.words import say_tool_kind
from palpate_editor.views.translations import tr

OWN = ""
"""That of the first organ."""
OPTIONS = {"radius": ("mm", 1e-3), "length": ("mm", 1e-3), "jaw_opening": ("°", math.pi / 180.0),
           "friction": ("", 1.0), "grip_force": ("N", 1.0)}  # fmt: skip
"""Of a SceneTool: how it is shown."""
TELLS = {"radius": "m", "length": "m", "grip_force": "N"}
"""Units that `palpate scene tool` wants behind a number."""
ABOVE = 0.15
"""[m] over the origin of the scene, where a trocar begins."""


class ToolForm(QWidget):
    """A kind, and its numbers, which begin as usual of the kind."""

    wanted = Signal(object)
    """The words of a change."""

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.tool: SceneTool | None = None
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self.kind = QComboBox(self)
        self.kind.setObjectName("tool_kind")
        self.kind.setAccessibleName(tr("Instrument"))
        self.kind.addItem(tr("That of the first organ"), OWN)
        for kind in KINDS:
            self.kind.addItem(say_tool_kind(kind), kind)
        self.kind.activated.connect(self._choose)
        column.addWidget(self.kind)
        self.numbers = NumberGrid(self)
        words = {
            "radius": tr("Radius"), "length": tr("Length that touches"),
            "jaw_opening": tr("Each jaw opens"), "friction": tr("Friction"),
            "grip_force": tr("Grip force"),
        }  # fmt: skip
        for name, (unit, scale) in OPTIONS.items():
            self.numbers.add(name, words[name], unit, scale)
        self.numbers.entered.connect(self._enter)
        column.addWidget(self.numbers)
        self.trocar = TickedNumbers(
            "trocar", tr("Through a trocar at"), [("mm", 1e-3)] * 3, (0.0, 0.0, ABOVE), self
        )
        self.trocar.setToolTip(tr("Without one the device turns it"))
        self.trocar.entered.connect(self._enter_trocar)
        column.addWidget(self.trocar)

    def show_layout(self, layout: Layout) -> None:
        self.tool = layout.tools[0] if layout.tools else None
        tool = self.tool
        with QSignalBlocker(self.kind):
            self.kind.setCurrentIndex(self.kind.findData(OWN if tool is None else tool.kind))
        self.numbers.setVisible(tool is not None)
        self.trocar.setVisible(tool is not None and tool.length > 0.0)
        if tool is None:
            return
        for name in OPTIONS:
            self.numbers.show_value(name, getattr(tool, name))
        has_jaws = tool.jaw_opening > 0.0
        self.numbers.show_value("grip_force", tool.grip_force if has_jaws else None)
        if not KINDS[tool.kind].length:
            self.numbers.show_value("length", None)
        if not KINDS[tool.kind].jaw_opening:
            self.numbers.show_value("jaw_opening", None)
        self.trocar.show_values(tool.trocar)

    def _choose(self) -> None:
        kind = self.kind.currentData()
        if kind == OWN:
            self.wanted.emit(("tool", "--remove"))
            return
        trocar = () if self.tool is None or not KINDS[kind].length else self.tool.trocar
        words = ["tool", f"--kind={kind}"]
        self.wanted.emit((*words, *write_trocar(trocar)))

    def _enter(self, name: str, value: float) -> None:
        if self.tool is not None:
            self.wanted.emit(write_tool(self.tool, {name: value}, self.tool.trocar))

    def _enter_trocar(self, trocar: tuple[float, ...]) -> None:
        if self.tool is not None:
            self.wanted.emit(write_tool(self.tool, {}, trocar))


def write_tool(
    tool: SceneTool, changed: dict[str, float], trocar: tuple[float, ...]
) -> tuple[str, ...]:
    """The words that make `tool` what it is with `changed`; what is as usual goes unsaid."""
    words = ["tool", f"--kind={tool.kind}"]
    usual = SceneTool(tool.kind, **vars(KINDS[tool.kind]))
    for name in (name for name in OPTIONS if name not in KINDS[tool.kind].idle):
        value = changed.get(name, getattr(tool, name))
        if value != getattr(usual, name):
            words.append(f"--{name.replace('_', '-')}={value:.9g}{TELLS.get(name, '')}")
    return (*words, *write_trocar(trocar))


def write_trocar(trocar: tuple[float, ...]) -> tuple[str, ...]:
    return (f"--trocar={write_three(trocar, 1e3)}",) if trocar else ()
