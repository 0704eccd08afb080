# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the panels stand around the viewport, and how that is kept from one start to the next."""

from __future__ import annotations

from PySide6.QtCore import QByteArray, QEvent, QObject, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QDockWidget, QMainWindow, QTabBar, QUndoView, QWidget

from palpate_editor.app.settings import LAYOUT_VERSION, Settings
from palpate_editor.views.translations import tr

AREA = Qt.DockWidgetArea
DIRECT = Qt.FindChildOption.FindDirectChildrenOnly
SIDE, STAGE, BELOW = 262, 396, 226
"""[px] widths of the docks at the left and right, height of those below."""
APART = {"chart": QSize(1060, 640), "stability": QSize(820, 560)}
"""[px] Docks that begin hidden, as floating windows; they can be docked."""
FOLDED, LEAST = 400, 200
"""[px] width of docks that are folded into one column, as it begins and at the least."""


class Docks(QObject):
    """The dock widgets of a main window, by name.

    A window that gets smaller squeezes its docks, and Qt gives what it wins back to the middle
    alone. So the sizes that a person gave them are kept, and given again as far as there is room.
    """

    folding = Signal(bool)
    """Whether they stand in one column now."""

    def __init__(self, window: QMainWindow):
        super().__init__(window)
        self.window = window
        self.wanted: dict[str, QSize] = {}
        """[px] The size that each dock was given last, by us or by a drag."""
        self.settled = QTimer(self, singleShot=True, interval=0)
        self.settled.timeout.connect(self.recover)
        window.installEventFilter(self)
        self.docks: dict[str, QDockWidget] = {}
        self.holders: dict[str, QDockWidget] = {}
        """Docks from when they are asked for, before they stand anywhere."""
        # the stage's form needs all the height there is
        window.setCorner(Qt.Corner.BottomRightCorner, AREA.RightDockWidgetArea)
        window.setCorner(Qt.Corner.TopRightCorner, AREA.RightDockWidgetArea)
        window.setCorner(Qt.Corner.BottomLeftCorner, AREA.BottomDockWidgetArea)
        window.setDockNestingEnabled(True)
        self.start: QByteArray | None = None
        self.folded = False
        """Whether all docks are tabs of one column, as a small screen needs them."""

    def hold(self, name: str) -> QDockWidget:
        """The dock of a name, to be the parent of its panel: a panel that moves to another parent
        once it is filled is dressed again, widget by widget.
        """
        if name not in self.holders:
            self.holders[name] = QDockWidget(self.window)
            self.holders[name].setObjectName(f"dock_{name}")
        return self.holders[name]

    def add(self, name: str, title: str, widget: QWidget, area: AREA) -> QDockWidget:
        dock = self.hold(name)
        dock.setWindowTitle(title)
        dock.setWidget(widget)
        self.window.addDockWidget(area, dock)
        toggle = dock.toggleViewAction()
        toggle.setShortcut(QKeySequence(f"Shift+F{len(self.docks) + 2}"))
        self.docks[name] = dock
        return dock

    def build(self, panels: dict[str, QWidget]) -> None:
        """All docks; `panels` by name: scene, history, stage, force, costs, chart, stability,
        log."""
        self.add("scene", tr("Scene"), panels["scene"], AREA.LeftDockWidgetArea)
        self.add("history", tr("History"), panels["history"], AREA.LeftDockWidgetArea)
        self.add("stage", tr("Stage"), panels["stage"], AREA.RightDockWidgetArea)
        self.add("log", tr("Problems and log"), panels["log"], AREA.BottomDockWidgetArea)
        if "force" in panels:
            self.add("force", tr("Force"), panels["force"], AREA.BottomDockWidgetArea)
        if "costs" in panels:
            self.add("costs", tr("Cost of a tick"), panels["costs"], AREA.BottomDockWidgetArea)
        if "chart" in panels:
            dock = self.add(
                "chart", tr("Speed and accuracy"), panels["chart"], AREA.BottomDockWidgetArea
            )
            dock.setFloating(True)
            dock.hide()
        if "stability" in panels:
            dock = self.add(
                "stability", tr("Stability"), panels["stability"], AREA.BottomDockWidgetArea
            )
            dock.setFloating(True)
            dock.hide()
        self.arrange()
        self.start = self.window.saveState(LAYOUT_VERSION)

    # ------------------------------------------------------------ sizes

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """A drag of a line between docks is told to the window alone."""
        if event.type() == QEvent.Type.Resize:
            if self.folded and self.window.size().expandedTo(self.unfolded[1]) == (
                self.window.size()
            ):
                self.unfold()
            self.settled.start()
        elif event.type() == QEvent.Type.MouseButtonRelease:
            self.remember()
        return super().eventFilter(watched, event)

    def remember(self) -> None:
        """The sizes there are now are those that are wanted."""
        for name, dock in self.list_docked().items():
            self.wanted[name] = dock.size()

    def recover(self) -> None:
        """Gives the docks the sizes that are wanted, as far as the window has room for them."""
        if not self.wanted:  # those of a layout that was kept without them
            self.remember()
        docks = self.list_docked()
        docks = {name: dock for name, dock in docks.items() if name in self.wanted}
        for orientation in (Qt.Orientation.Horizontal, Qt.Orientation.Vertical):
            across = orientation == Qt.Orientation.Horizontal
            sizes = [
                self.wanted[name].width() if across else self.wanted[name].height()
                for name in docks
            ]
            self.window.resizeDocks(list(docks.values()), sizes, orientation)

    def list_docked(self) -> dict[str, QDockWidget]:
        """Those that stand in the window and can be seen; of tabs the one in front."""
        return {
            name: dock
            for name, dock in self.docks.items()
            if dock.isVisible() and not dock.isFloating() and not dock.visibleRegion().isEmpty()
        }

    def arrange(self) -> None:
        """The sizes of a fresh window."""
        self.wanted = {
            "scene": QSize(SIDE, 400),
            "history": QSize(SIDE, 190),
            "stage": QSize(STAGE, 400),
            "log": QSize(440, BELOW),
            "force": QSize(380, BELOW),
            "costs": QSize(190, BELOW),
        }
        self.recover()

    def fit(self, room: QSize) -> None:
        """Folds the docks where side by side they need more than the room [px] of the screen."""
        least = self.window.minimumSizeHint()
        if not self.folded and (least.width() > room.width() or least.height() > room.height()):
            self.unfolded = self.window.saveState(LAYOUT_VERSION), least, dict(self.wanted)
            self.least = {name: dock.widget().minimumWidth() for name, dock in self.docks.items()}
            self.fold()

    def fold(self) -> None:
        """All docks as tabs of one column at the right, the stage in front."""
        self.folded = True
        stage = self.docks["stage"]
        folded = [dock for name, dock in self.docks.items() if name not in APART]
        for dock in (stage, *(dock for dock in folded if dock is not stage)):
            dock.setFloating(False)
            self.window.addDockWidget(AREA.RightDockWidgetArea, dock)
            dock.show()
            if dock is not stage:
                self.window.tabifyDockWidget(stage, dock)
            dock.widget().setMinimumWidth(LEAST)
            dock.setTitleBarWidget(QWidget(dock))  # its tab says what it is
        for bar in self.window.findChildren(QTabBar, options=DIRECT):
            bar.setElideMode(Qt.TextElideMode.ElideNone)
            bar.setUsesScrollButtons(True)
        stage.raise_()
        self.folding.emit(True)
        layout = self.window.layout()
        if layout is not None:  # until then the window keeps the least size it had
            layout.invalidate()
            layout.activate()
        self.wanted = {"stage": QSize(FOLDED, stage.height())}
        self.recover()

    def unfold(self) -> None:
        """As before, in a window that has come to a larger screen."""
        self.folded = False
        state, _, self.wanted = self.unfolded
        for name, dock in self.docks.items():
            if name in APART:
                continue
            holder = dock.titleBarWidget()
            dock.setTitleBarWidget(None)  # type: ignore[arg-type]
            holder.deleteLater()
            dock.widget().setMinimumWidth(self.least[name])
        self.folding.emit(False)
        self.window.restoreState(state, LAYOUT_VERSION)
        self.recover()

    def show(self, name: str) -> None:
        if name not in self.docks:
            return
        dock = self.docks[name]
        if name in APART and dock.isFloating() and not dock.isVisible():
            self.place(dock, APART[name])
        dock.show()
        dock.raise_()

    def place(self, dock: QDockWidget, wanted: QSize) -> None:
        """In the middle of the window, as large as the screen has room for."""
        room = self.window.screen().availableGeometry()
        dock.resize(wanted.boundedTo(0.9 * room.size()))
        frame = dock.frameGeometry()
        frame.moveCenter(self.window.frameGeometry().center())
        dock.move(frame.topLeft())

    def show_beside(self, name: str) -> None:
        """Shows a dock, but not over the one that is in front of it where they are folded."""
        if not self.folded:
            self.show(name)

    # ------------------------------------------------------------ keeping

    def restore(self, settings: Settings) -> bool:
        layout = settings.layout
        if layout is None:
            return False
        self.wanted = settings.dock_sizes
        self.window.restoreGeometry(layout[0])
        return self.window.restoreState(layout[1], LAYOUT_VERSION)

    def keep(self, settings: Settings) -> None:
        """But for a layout that the screen alone asked for."""
        if self.folded:
            return
        settings.layout = (self.window.saveGeometry(), self.window.saveState(LAYOUT_VERSION))
        settings.dock_sizes = self.wanted

    def reset(self) -> None:
        if self.start is not None:
            self.window.restoreState(self.start, LAYOUT_VERSION)
        for name, dock in self.docks.items():
            dock.setFloating(name in APART)
            dock.setVisible(name not in APART)
        if self.folded:
            self.fold()
        else:
            self.arrange()


def build_history(parent: QWidget, stack: object) -> QUndoView:
    view = QUndoView(parent)
    view.setStack(stack)  # type: ignore[arg-type]
    view.setEmptyLabel(tr("As it was opened"))
    view.setObjectName("history")
    return view
