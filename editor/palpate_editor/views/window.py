# SPDX-License-Identifier: GPL-3.0-or-later
"""The main window: viewport in the middle, stages above, panels around it."""

from __future__ import annotations

from pathlib import Path

from palpate.viewport import make_view
from palpate.viewport.screen import find_room, fit_to_screen, keep_on_screen
from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QCloseEvent, QDragEnterEvent, QDropEvent, QShowEvent
from PySide6.QtWidgets import QMainWindow, QToolBar, QVBoxLayout, QWidget

from palpate_editor.app.session import Session
from palpate_editor.app.settings import Settings
from palpate_editor.document import Organ
from palpate_editor.document.constants import SHORT_KINDS
from palpate_editor.views.action_set import ActionSet
from palpate_editor.views.appearance import Appearance
from palpate_editor.views.axis_gizmo import AxisGizmo
from palpate_editor.views.chart.advisor import Advisor
from palpate_editor.views.chart.chart_view import ChartView
from palpate_editor.views.commands import build_commands
from palpate_editor.views.context import Context
from palpate_editor.views.display import Display
from palpate_editor.views.docks import Docks, build_history
from palpate_editor.views.files import Files
from palpate_editor.views.help import HelpWindow
from palpate_editor.views.log_dock import LogDock
from palpate_editor.views.menu_actions import MenuActions
from palpate_editor.views.message_bar import MessageBar
from palpate_editor.views.palette import CommandPalette
from palpate_editor.views.problem_marks import ProblemMarks
from palpate_editor.views.publishing import Publishing
from palpate_editor.views.recent_menu import RecentMenu
from palpate_editor.views.scan.scans import Scans
from palpate_editor.views.scenario import ScenarioPanel
from palpate_editor.views.scene_tree import SceneTree
from palpate_editor.views.stability.atlas_view import AtlasView
from palpate_editor.views.stage_bar import StageBar
from palpate_editor.views.stage_dock import StageDock
from palpate_editor.views.stages.decimate_panel import DecimatePanel
from palpate_editor.views.stages.import_panel import ImportPanel
from palpate_editor.views.stages.material_panel import MaterialPanel
from palpate_editor.views.stages.panels import build_panels, find_panel, list_stages
from palpate_editor.views.stages.publish_panel import PublishPanel
from palpate_editor.views.stages.stage_panel import Workers
from palpate_editor.views.status import Status
from palpate_editor.views.tasks import Tasks
from palpate_editor.views.tool_strip import ToolStrip
from palpate_editor.views.touch import TestPanel, build_tools
from palpate_editor.views.touch.tools import Tool
from palpate_editor.views.translations import tr
from palpate_editor.views.welcome import Welcome

SHORT_NAMES = {kind: short for short, kind in SHORT_KINDS.items()}
"""Of the kinds of tissue, as actions and the command line call them."""
SIZE = QSize(1440, 900)
"""[px] of a window that nobody has resized yet."""


class MainWindow(QMainWindow):
    """One organ and all that can be done to it."""

    closed = Signal()

    def __init__(self, session: Session, settings: Settings, theme: str | None = None):
        super().__init__()
        self.setObjectName("main_window")
        self.session, self.settings = session, settings
        fit_to_screen(self, SIZE)
        self.setAcceptDrops(True)
        self.may_close = False
        self.view = make_view(self)
        self.context = Context(session, self.view, settings, list_stages(), self)
        self.appearance = Appearance(self.context, theme)
        self.tasks = Tasks(self.context, self)
        self.files = Files(self.context, self.tasks, self)
        self.publishing = Publishing(self.context, self.files, self.tasks, self)
        self.display = Display(self.context, self)
        self.problem_marks = ProblemMarks(self.context, self)
        self.context.look_wanted.connect(self.problem_marks.look_at)
        self.menu_actions = MenuActions(
            self.context, self.display, self.files, self.tasks, self.publishing, self
        )
        self.build_centre()
        self.build_panels()
        self.build_bars()
        self.actions_by_name = ActionSet(self, build_commands(self))
        self.fill_menus()
        self.connect_all()
        self.help = HelpWindow(self)
        self.fresh = not self.docks.restore(settings)
        self.appearance.begin(self.actions_by_name)
        self.show_stage(self.context.stage)
        self.show_organ(session.organ)
        self.show_title()

    # ------------------------------------------------------------ building

    def build_centre(self) -> None:
        centre = QWidget(self)
        column = QVBoxLayout(centre)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.view, 1)
        self.messages = MessageBar(self.context.colours, self.view)
        self.setCentralWidget(centre)
        self.gizmo = AxisGizmo(self.view)
        self.welcome = Welcome(self.context, self.view)

    def build_panels(self) -> None:
        context = self.context
        self.docks = Docks(self)
        hold = self.docks.hold
        self.stage_dock = StageDock(context, hold("stage"))
        self.advisor = Advisor(context, self)
        workers = Workers(context, self.tasks, self.publishing, self.advisor)
        panels = build_panels(workers, self.stage_dock.hold)
        self.stage_dock.fill(panels)
        self.import_panel = find_panel(panels, ImportPanel)
        self.decimate_panel = find_panel(panels, DecimatePanel)
        self.material_panel = find_panel(panels, MaterialPanel)
        self.test_panel = find_panel(panels, TestPanel)
        self.scenario_panel = find_panel(panels, ScenarioPanel)
        self.publish_panel = find_panel(panels, PublishPanel)
        self.log = LogDock(context, hold("log"))
        self.scans = Scans(context, self.files, self.tasks, self)
        self.chart = ChartView(context, self.tasks, self.files, self.advisor, hold("chart"))
        self.atlas = AtlasView(context, self.files, hold("stability"))
        self.docks.build(
            {
                "scene": SceneTree(context, hold("scene")),
                "history": build_history(hold("history"), self.session.history),
                "stage": self.stage_dock,
                "log": self.log,
                "force": self.test_panel.plot,
                "costs": self.test_panel.costs,
                "chart": self.chart,
                "stability": self.atlas,
            }
        )

    def build_bars(self) -> None:
        bar = QToolBar(tr("Stages"), self)
        bar.setObjectName("stage_tools")
        bar.setMovable(False)
        self.stage_bar = StageBar(self.context.stages, self.context.colours, bar)
        bar.addWidget(self.stage_bar)
        self.addToolBar(Qt.ToolBarArea.TopToolBarArea, bar)
        self.tools = ToolStrip(self.context, build_tools(self.context), self)
        self.addToolBar(Qt.ToolBarArea.LeftToolBarArea, self.tools)
        self.status = Status(self.context, self)
        self.setStatusBar(self.status)

    def fill_menus(self) -> None:
        actions = self.actions_by_name
        self.recent = RecentMenu(actions.menu("recent"), self.settings, self)
        self.recent.wanted.connect(self.files.open)
        actions.adopt(list(self.tools.choices.values()), "edit")
        for tool in self.tools.tools:
            if hasattr(tool, "actions"):
                actions.adopt(tool.actions(), "edit")
        toggles = [dock.toggleViewAction() for dock in self.docks.docks.values()]
        actions.adopt(toggles, "docks")

    def connect_all(self) -> None:
        context, session = self.context, self.session
        session.changed.connect(self.on_changed)
        session.title_changed.connect(self.show_title)
        session.history.canUndoChanged.connect(self.show_history)
        session.history.canRedoChanged.connect(self.show_history)
        context.assessed.connect(self.show_assessment)
        context.told.connect(self.messages.tell)
        context.stage_wanted.connect(self.show_stage)
        context.theme_changed.connect(self.on_theme)
        self.tasks.read.connect(self.import_panel.show_reading)
        context.jobs.started.connect(self.on_job)
        context.jobs.stopped.connect(self.on_job)
        self.publishing.published.connect(self.on_published)
        self.chart.opened.connect(self.show_chart)
        self.atlas.opened.connect(self.show_atlas)
        self.material_panel.advice.chart_wanted.connect(self.show_chart)
        self.stage_bar.chosen.connect(self.show_stage)
        self.docks.folding.connect(self.tools.be_narrow)
        self.tools.chosen.connect(self.on_tool)
        self.test_panel.run_changed.connect(self.display.hold)
        context.preview_shown.connect(self.display.hold)
        self.menu_actions.decimate_wanted.connect(self.decimate_panel.decimate)
        self.menu_actions.reimport_wanted.connect(self.import_panel.import_parts)
        self.welcome.open_wanted.connect(self.files.ask_open)
        self.welcome.recent_wanted.connect(self.files.open)
        self.welcome.shipped.chosen.connect(self.files.open_shipped)

    def ask_scan(self) -> None:
        self.context.scan_wanted.emit(None)

    # ------------------------------------------------------------ stages

    def on_stage_action(self) -> None:
        """Ctrl+1 for the first, and so on."""
        self.show_stage(self.sender().objectName().removeprefix("stage_"))

    def show_stage(self, stage: str) -> None:
        """Any stage, at any time."""
        self.context.stage = stage
        self.stage_bar.show_stage(stage)
        self.stage_dock.show_stage(stage)
        self.docks.show("stage")
        self.actions_by_name.check(f"stage_{stage}")
        dock = self.context.stages.by_name[stage].dock
        if dock is not None:
            self.docks.show_beside(dock)
        self.context.stage_shown.emit(stage)

    def toggle_run(self) -> None:
        if self.context.stage != "test":
            self.show_stage("test")
        self.test_panel.toggle()

    def show_chart(self) -> None:
        self.docks.show("chart")

    def show_atlas(self) -> None:
        self.docks.show("stability")

    # ------------------------------------------------------------ showing

    def on_changed(self, before: Organ, after: Organ) -> None:
        if before.surface is None or after.surface is None or before.source is not after.source:
            self.messages.dismiss()
        self.show_organ(after)

    def show_organ(self, organ: Organ) -> None:
        there = organ.surface is not None
        self.actions_by_name.show_organ(there)
        self.actions_by_name.check(SHORT_NAMES[organ.model.kind])
        self.tools.show_organ(there)
        self.stage_dock.show_organ()
        self.display.refresh()
        self.show_history()
        self.show_assessment()

    def on_tool(self, tool: Tool | None) -> None:
        self.stage_dock.show_tool(tool)
        self.display.refresh_values()

    def show_assessment(self) -> None:
        self.stage_dock.show_assessment()
        self.fit_stages()
        for stage in self.context.stages.names:
            self.stage_bar.show_verdict(stage, self.stage_dock.verdict(stage))

    def show_history(self) -> None:
        history, actions = self.session.history, self.actions_by_name.actions
        for name, can, text in (
            ("undo", history.canUndo(), history.undoText()),
            ("redo", history.canRedo(), history.redoText()),
        ):
            title = tr("&Undo") if name == "undo" else tr("&Redo")
            actions[name].setEnabled(can)
            actions[name].setText(f"{title}: {text}" if can and text else title)

    def show_title(self) -> None:
        name = self.session.name or tr("untitled")
        self.setWindowTitle(f"{name}[*] - Palpate Editor")
        self.setWindowModified(not self.session.saved)

    def on_job(self) -> None:
        busy = self.context.jobs.current is not None
        for button in (self.import_panel.import_button, self.decimate_panel.button):
            button.setDisabled(busy or self.session.organ.imported is None and button is
                               self.decimate_panel.button)  # fmt: skip
        if not busy:
            self.stage_dock.show_organ()

    def on_published(self, path: Path) -> None:
        del path
        self.publish_panel.show_organ(self.session.organ)

    def on_theme(self) -> None:
        colours = self.context.colours
        self.messages.use_colours(colours)
        self.stage_bar.use_colours(colours)
        self.tools.use_colours(colours)
        self.actions_by_name.use_colours(colours)
        self.stage_dock.show_assessment()
        self.fit_stages()

    def fit_stages(self) -> None:
        """Keeps the dock of the stages wide enough; folded, it has what room there is."""
        if not self.docks.folded:
            self.stage_dock.fit()

    # ------------------------------------------------------------ extras

    def show_palette(self) -> None:
        self.palette_dialog = CommandPalette(self.actions_by_name.walk(), self)
        self.palette_dialog.place()
        self.palette_dialog.open()
        self.palette_dialog.query.setFocus()

    def show_help(self) -> None:
        self.help.show_stage(self.context.stages.by_name[self.context.stage])

    def show_keys(self) -> None:
        self.help.show_keys(self.actions_by_name.walk())

    def show_about(self) -> None:
        self.help.show_about()

    def switch_full(self) -> None:
        self.setWindowState(self.windowState() ^ Qt.WindowState.WindowFullScreen)

    def reset_layout(self) -> None:
        self.docks.reset()

    def showEvent(self, event: QShowEvent) -> None:
        """The docks only take their sizes in a window that has one."""
        super().showEvent(event)
        if self.fresh:
            self.fresh = False
            self.docks.arrange()
        self.docks.fit(find_room(self))
        keep_on_screen(self)

    # ------------------------------------------------------------ dropping and closing

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        if any(url.isLocalFile() for url in event.mimeData().urls()):
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        urls = event.mimeData().urls()
        event.acceptProposedAction()
        self.files.drop([Path(url.toLocalFile()) for url in urls if url.isLocalFile()])

    def quit(self) -> None:
        self.close()

    def closeEvent(self, event: QCloseEvent) -> None:
        if not self.may_close:
            event.ignore()
            self.files.guard(self.close_now)
            return
        self.docks.keep(self.settings)
        self.test_panel.stop()
        self.advisor.cancel()
        self.context.jobs.finish()
        self.publishing.child_processes.finish()
        event.accept()
        self.closed.emit()

    def close_now(self) -> None:
        self.may_close = True
        self.close()
