# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the panels stand around the viewport, and how that is kept from one start to the next."""

from __future__ import annotations

from PySide6.QtCore import QByteArray, Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QDockWidget, QMainWindow, QUndoView, QWidget

from palpate_editor.app.settings import LAYOUT_VERSION, Settings
from palpate_editor.views.words import tr

AREA = Qt.DockWidgetArea
SIDE, STAGE, BELOW = 262, 396, 226
"""[px] widths of the docks at the left and right, height of those below."""


class Docks:
    """The dock widgets of a main window, by name."""

    def __init__(self, window: QMainWindow):
        self.window = window
        self.docks: dict[str, QDockWidget] = {}
        # the stage's form needs all the height there is
        window.setCorner(Qt.Corner.BottomRightCorner, AREA.RightDockWidgetArea)
        window.setCorner(Qt.Corner.TopRightCorner, AREA.RightDockWidgetArea)
        window.setCorner(Qt.Corner.BottomLeftCorner, AREA.BottomDockWidgetArea)
        window.setDockNestingEnabled(True)
        self.start: QByteArray | None = None

    def add(self, name: str, title: str, widget: QWidget, area: AREA) -> QDockWidget:
        dock = QDockWidget(title, self.window)
        dock.setObjectName(f"dock_{name}")
        dock.setWidget(widget)
        self.window.addDockWidget(area, dock)
        toggle = dock.toggleViewAction()
        toggle.setShortcut(QKeySequence(f"Shift+F{len(self.docks) + 2}"))
        self.docks[name] = dock
        return dock

    def build(self, panels: dict[str, QWidget]) -> None:
        """All docks; `panels` by name: scene, history, stage, force, costs, log."""
        self.add("scene", tr("Scene"), panels["scene"], AREA.LeftDockWidgetArea)
        self.add("history", tr("History"), panels["history"], AREA.LeftDockWidgetArea)
        self.add("stage", tr("Stage"), panels["stage"], AREA.RightDockWidgetArea)
        self.add("log", tr("Problems and log"), panels["log"], AREA.BottomDockWidgetArea)
        if "force" in panels:
            self.add("force", tr("Force"), panels["force"], AREA.BottomDockWidgetArea)
        if "costs" in panels:
            self.add("costs", tr("Cost of a tick"), panels["costs"], AREA.BottomDockWidgetArea)
        self.arrange()
        self.start = self.window.saveState(LAYOUT_VERSION)

    def arrange(self) -> None:
        """The sizes of a fresh window."""
        docks, window = self.docks, self.window
        window.resizeDocks(
            [docks["scene"], docks["stage"]], [SIDE, STAGE], Qt.Orientation.Horizontal
        )
        window.resizeDocks([docks["scene"], docks["history"]], [400, 190], Qt.Orientation.Vertical)
        window.resizeDocks([docks["log"]], [BELOW], Qt.Orientation.Vertical)
        below = [docks[name] for name in ("log", "force", "costs") if name in docks]
        window.resizeDocks(below, [440, 380, 190][: len(below)], Qt.Orientation.Horizontal)

    def show(self, name: str) -> None:
        if name in self.docks:
            self.docks[name].show()
            self.docks[name].raise_()

    # ------------------------------------------------------------ keeping

    def restore(self, settings: Settings) -> bool:
        layout = settings.layout
        if layout is None:
            return False
        self.window.restoreGeometry(layout[0])
        return self.window.restoreState(layout[1], LAYOUT_VERSION)

    def keep(self, settings: Settings) -> None:
        settings.layout = (self.window.saveGeometry(), self.window.saveState(LAYOUT_VERSION))

    def reset(self) -> None:
        if self.start is not None:
            self.window.restoreState(self.start, LAYOUT_VERSION)
        for dock in self.docks.values():
            dock.setFloating(False)
            dock.show()
        self.arrange()


def build_history(window: QMainWindow, stack: object) -> QUndoView:
    view = QUndoView(window)
    view.setStack(stack)  # type: ignore[arg-type]
    view.setEmptyLabel(tr("As it was opened"))
    view.setObjectName("history")
    return view
