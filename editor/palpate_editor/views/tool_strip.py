# SPDX-License-Identifier: GPL-3.0-or-later
"""The tools of the viewport at its left edge: one at a time has the mouse."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QAction, QActionGroup, QKeySequence
from PySide6.QtWidgets import QToolBar, QToolButton, QWidget

from palpate_editor.views.context import Context
from palpate_editor.views.icons import icon
from palpate_editor.views.theme import Colours
from palpate_editor.views.touch.tools import Tool
from palpate_editor.views.translations import tr

SIGNS = {"orbit": "orbit", "select": "select", "fix": "fix", "stiffness": "stiffness"}


class ToolStrip(QToolBar):
    """Orbit and the tools that change the organ."""

    chosen = Signal(object)
    """The tool, None for Orbit."""

    def __init__(self, context: Context, tools: list[Tool], parent: QWidget | None = None):
        super().__init__(tr("Tools"), parent)
        self.setObjectName("tool_strip")
        self.context, self.tools = context, tools
        self.current: Tool | None = None
        self.setOrientation(Qt.Orientation.Vertical)
        self.setMovable(False)
        self.setIconSize(QSize(24, 24))
        self.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextUnderIcon)
        self.group = QActionGroup(self)
        self.choices: dict[str, QAction] = {}
        self.add("orbit", tr("Orbit"), ("Esc",))
        for tool in tools:
            self.add(tool.name, tool.title(), (tool.shortcut,))
            tool.left.connect(self.use_orbit)
        self.choices["orbit"].setChecked(True)
        context.stage_shown.connect(self.on_stage)
        self.group.triggered.connect(self.on_action)

    def add(self, name: str, title: str, keys: tuple[str, ...]) -> None:
        action = QAction(title, self)
        action.setObjectName(f"tool_{name}")
        action.setCheckable(True)
        action.setShortcuts([QKeySequence(key) for key in keys])
        action.setToolTip(f"{title} ({keys[0]})")
        self.group.addAction(action)
        self.addAction(action)
        self.choices[name] = action

    def on_action(self, action: QAction) -> None:
        self.use(action.objectName().removeprefix("tool_"))

    def use_orbit(self) -> None:
        self.use("orbit")

    def use(self, name: str) -> None:
        """Gives the mouse to a tool."""
        wanted = next((tool for tool in self.tools if tool.name == name), None)
        self.choices[name].setChecked(True)
        if wanted is self.current:
            return
        if self.current is not None:
            self.current.deactivate()
        self.current = wanted
        if wanted is not None:
            wanted.activate()
        self.show_hint()
        self.chosen.emit(wanted)

    def on_stage(self, stage: str) -> None:
        del stage
        self.show_hint()

    def show_hint(self) -> None:
        self.context.set_hint(orbit_hint() if self.current is None else self.current.hint())

    def be_narrow(self, narrow: bool) -> None:
        """Icons alone, for a small screen; they say their names when pointed at."""
        style = Qt.ToolButtonStyle
        self.setToolButtonStyle(
            style.ToolButtonIconOnly if narrow else style.ToolButtonTextUnderIcon
        )
        self.setProperty("narrow", narrow)
        for part in (self, *self.findChildren(QToolButton)):
            part.style().unpolish(part)
            part.style().polish(part)

    def show_organ(self, there: bool) -> None:
        for name, action in self.choices.items():
            action.setEnabled(there or name == "orbit")
        if not there:
            self.use_orbit()

    def use_colours(self, colours: Colours) -> None:
        for name, action in self.choices.items():
            action.setIcon(icon(SIGNS[name], colours.text, "#ffffff", colours.disabled))


def orbit_hint() -> str:
    return tr("Drag to turn, Shift+drag to move, wheel to zoom")
