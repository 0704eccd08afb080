# SPDX-License-Identifier: GPL-3.0-or-later
"""The window of a scene: view in the middle, what is in it at the left, the stage at the right."""

from __future__ import annotations

import shlex
from collections.abc import Callable
from datetime import datetime
from pathlib import Path
from typing import Any

import numpy as np
from palpate import FileError
from palpate.command.verb import WrongCall
from palpate.files.refusal import Refusal
from palpate.layout.check import Checked
from palpate.layout.document import Layout, LayoutError, Placed
from palpate.layout.separate import Separation
from palpate.viewport import make_view
from palpate.viewport.screen import fit_to_screen, keep_on_screen
from PySide6.QtCore import QSize, Qt, QTimer, Signal
from PySide6.QtGui import QAction, QCloseEvent, QFont, QKeySequence, QShowEvent
from PySide6.QtWidgets import (
    QDockWidget,
    QMainWindow,
    QMessageBox,
    QPlainTextEdit,
)

from palpate_editor.app.autosave import Autosave
from palpate_editor.app.settings import Settings
from palpate_editor.layout_changes import Words, change, write_line, write_three
from palpate_editor.layout_shapes import Key, PartShape, find_degrees, key_of
from palpate_editor.views import file_questions
from palpate_editor.views.axis_gizmo import AxisGizmo
from palpate_editor.views.jobs import Jobs
from palpate_editor.views.layout.layout_files import LayoutFiles
from palpate_editor.views.layout.layout_session import LayoutSession
from palpate_editor.views.layout.move_gizmo import MoveGizmo
from palpate_editor.views.layout.part_tree import PartTree
from palpate_editor.views.layout.scene_drawing import SceneDrawing
from palpate_editor.views.layout.scene_panel import ScenePanel
from palpate_editor.views.layout.side import Side
from palpate_editor.views.layout.task_panel import TaskPanel
from palpate_editor.views.layout.words import list_adding, say_move
from palpate_editor.views.layout.work import ChangeWork, CheckWork, PublishWork, ReadWork
from palpate_editor.views.message_bar import MessageBar
from palpate_editor.views.sentences import sentence_of
from palpate_editor.views.theme import COLOURS, fixed_font
from palpate_editor.views.translations import tr

SIZE = QSize(1320, 860)
SIDE, STAGE, BELOW = 270, 400, 130
"""[px] of the docks at the left and right, and of the one below."""
PAUSE = 350
"""[ms] without a change, after which a scene is checked."""
REFUSALS = (LayoutError, WrongCall, Refusal, FileError, OSError, ValueError)
AREA = Qt.DockWidgetArea


class LayoutWindow(QMainWindow):
    """One layout and all that can be done to it."""

    closed = Signal()

    def __init__(self, settings: Settings, theme: str):
        super().__init__()
        self.setObjectName("layout_window")
        self.settings, self.theme = settings, theme
        fit_to_screen(self, SIZE)
        self.session = LayoutSession(self)
        self.jobs = Jobs(self)
        self.autosave: Autosave
        """Set by the editor that opens it."""
        self.files = LayoutFiles(self.session, settings, self)
        self.view = make_view(self)
        self.view.use_theme(theme)
        self.setCentralWidget(self.view)
        self.gizmo = AxisGizmo(self.view)
        self.messages = MessageBar(COLOURS[theme], self.view)
        self.drawing = SceneDrawing(self.view)
        self.mover = MoveGizmo(self.view, self.drawing)
        self.view.tool = self.mover
        self.tree = PartTree(self)
        self.panel = ScenePanel(COLOURS[theme], self)
        self.log = QPlainTextEdit(self)
        self.task = TaskPanel(self, self)
        self.shapes: dict[Key, PartShape] = {}
        self.seen: Layout | None = None  # what was shown last
        self.chosen = ""
        self.checked: Checked | None = None
        self.may_close = False
        self.kind = ""  # of what is being added
        self.question: QMessageBox | None = None
        self.pause = QTimer(self, singleShot=True, interval=PAUSE)
        self.pause.timeout.connect(self.check)
        self._build_docks()
        self._build_menus()
        self._connect()

    # ------------------------------------------------------------ building

    def _build_docks(self) -> None:
        area = Side((tr("Scene"), self.panel), (tr("Task"), self.task), self)
        area.turned.connect(self.task.marks.see)
        self.log.setObjectName("log")
        self.log.setReadOnly(True)
        self.log.setFont(fixed_font(QFont(self.font())))
        self.log.setPlaceholderText(tr("What you do appears here as a command line."))
        for corner in (Qt.Corner.TopRightCorner, Qt.Corner.BottomRightCorner):
            self.setCorner(corner, AREA.RightDockWidgetArea)
        self.docks = []
        for name, title, widget, where in (
            ("scene", tr("Scene"), self.tree, AREA.LeftDockWidgetArea),
            ("stage", tr("Stage"), area, AREA.RightDockWidgetArea),
            ("log", tr("Log"), self.log, AREA.BottomDockWidgetArea),
        ):
            dock = QDockWidget(title, self)
            dock.setObjectName(f"dock_{name}")
            dock.setWidget(widget)
            self.addDockWidget(where, dock)
            self.docks.append(dock)

    def _build_menus(self) -> None:
        file, edit = self.menuBar().addMenu(tr("&File")), self.menuBar().addMenu(tr("&Edit"))
        self.actions_by_name: dict[str, QAction] = {}
        for menu, name, words, keys, slot in (
            (file, "save", tr("&Save"), "Ctrl+S", self.files.save),
            (file, "save_as", tr("Save &as…"), "Ctrl+Shift+S", self.files.ask_save_as),
            (file, "publish", tr("Publish the scene…"), "Ctrl+P", self.ask_publish),
            (file, "close", tr("&Close"), "Ctrl+W", self.close),
            (edit, "undo", tr("&Undo"), "Ctrl+Z", self.undo),
            (edit, "redo", tr("&Redo"), "Ctrl+Shift+Z", self.redo),
            (edit, "remove", tr("Remove from the scene"), "Delete", self.remove),
        ):
            action = QAction(words, self)
            action.setObjectName(name)
            action.setShortcut(QKeySequence(keys))
            action.triggered.connect(slot)
            menu.addAction(action)
            self.actions_by_name[name] = action
        self.actions_by_name["redo"].setShortcuts([QKeySequence("Ctrl+Shift+Z"), "Ctrl+Y"])

    def _connect(self) -> None:
        self.session.changed.connect(self.show_layout)
        self.session.title_changed.connect(self.show_title)
        self.files.told.connect(self.tell)
        self.files.refused.connect(self.refuse)
        self.tree.chosen.connect(self.choose)
        self.mover.chosen.connect(self.choose)
        self.mover.dragged.connect(self.show_dragged)
        self.mover.dropped.connect(self.drop)
        panel = self.panel
        panel.form.heavy_wanted.connect(self.do_beside)
        for form in (panel.form, panel.pairs, panel.tool_form, panel.scene_form):
            form.wanted.connect(self.do)
        panel.add_wanted.connect(self.ask_add)
        panel.apart_wanted.connect(self.move_apart)
        panel.look_wanted.connect(self.look_at)
        panel.measure_wanted.connect(self.measure)
        panel.publish_wanted.connect(self.ask_publish)

    # ------------------------------------------------------------ files

    def open(self, path: Path) -> None:
        """Raises Refusal or OSError."""
        self.session.open(path)
        self.settings.add_recent(path)
        self.log_command(["palpate", "editor", str(path)])

    def begin(self, path: Path) -> None:
        """Raises OSError."""
        self.session.begin(path)
        self.settings.add_recent(path)
        self.log_command(["palpate", "scene", "new", "--out", str(path)])

    # ------------------------------------------------------------ changing

    def do(self, words: Words) -> None:
        """A change that takes no time."""
        try:
            layout = change(self.session.path, self.session.layout, words)
        except REFUSALS as problem:
            self.refuse(problem)
            self.show_layout()
            return
        self.take(words, layout)

    def do_beside(self, words: Words) -> None:
        """One that reads files."""
        work = ChangeWork(self.session.path, self.session.layout, words)
        self.jobs.start(tr("Changing the scene"), work, self.take_changed, self.refuse)

    def take_changed(self, found: tuple[Layout, Words, Layout]) -> None:
        before, words, layout = found
        if before is not self.session.layout:
            self.tell(tr("The scene has changed meanwhile: try again."), "warning")
            return
        self.take(words, layout)

    def take(self, words: Words, layout: Layout) -> None:
        if layout == self.session.layout:
            self.show_layout()
            return
        names = {part.name for part in self.session.layout.parts}
        new = [part.name for part in layout.parts if part.name not in names]
        if new:
            self.chosen = new[0]
        self.session.apply(layout)
        self.log_command(write_line(self.session.path, words))

    def undo(self) -> None:
        if self._try(self.session.undo):
            self.log_command(["palpate", "scene", "undo", str(self.session.path)])

    def redo(self) -> None:
        if self._try(self.session.redo):
            self.log_command(["palpate", "scene", "redo", str(self.session.path)])

    def remove(self) -> None:
        if self.chosen:
            self.do(("place", self.chosen, "--remove"))

    def drop(self, part: Placed) -> None:
        """A drag has ended."""
        words = ["place", part.name, f"--at={write_three(part.position, 1e3)}"]
        before = self.session.layout.find_part(part.name)
        if part.rotation != before.rotation:
            words.append(f"--turn={write_three(find_degrees(part))}")
        self.do(tuple(words))

    def ask_add(self, kind: str) -> None:
        self.kind = kind
        if kind == "organ":
            filters = [tr("Published scenarios (*.palpate)")]
        else:
            filters = [tr("Meshes ({names})").format(names="*.obj")]
        self.files.ask(tr("Add to the scene"), filters, self.add)

    def add(self, name: str) -> None:
        """A file was chosen."""
        self.settings.last_folder = Path(name).parent
        self.do_beside(list_adding(self.session.layout, self.kind, Path(name)))

    def move_apart(self) -> None:
        """Does to the layout what a scene would do when it begins, and tells what."""
        found = [] if self.checked is None else self.checked.separations
        told = []
        for _, separation in found:
            if separation.shift is not None:
                name = self.session.layout.bodies[separation.body].name
                self.do(("place", name, f"--by={write_three(separation.shift, 1e3)}"))
                told.append(say_move(self.session.layout, separation))
        if told:
            self.tell(" ".join(told), "info")

    # ------------------------------------------------------------ showing

    def choose(self, name: str) -> None:
        if name != self.chosen:
            self.chosen = name
            self.show_layout()

    def show_layout(self) -> None:
        """The layout as it is; what is new in it is read beside the window."""
        layout = self.session.layout
        part = next((each for each in layout.parts if each.name == self.chosen), None)
        self.chosen = "" if part is None else part.name
        self.drawing.show(layout, self.shapes, self.chosen)
        shape = None if part is None else self.shapes.get(key_of(part))
        self.mover.show(part, shape)
        self.tree.show_layout(layout, self.chosen)
        self.panel.show_layout(layout, self.shapes, part)
        self.task.show_layout(self.shapes)
        self.actions_by_name["undo"].setEnabled(bool(self.session.history.before))
        self.actions_by_name["redo"].setEnabled(bool(self.session.history.undone))
        self.actions_by_name["remove"].setEnabled(part is not None)
        if self.seen is not layout:
            self.seen, self.checked = layout, None
            self.drawing.forget_mark()
            self.panel.show_checked(None)
            self.task.show_checked(None)
            self.pause.start()
            if any(key_of(each) not in self.shapes for each in layout.parts):
                work = ReadWork(self.session.path, layout, dict(self.shapes))
                self.jobs.start_unseen(tr("Reading the scene"), work, self.take_read, self.refuse)

    def take_read(self, found: tuple[Layout, dict[Key, PartShape]]) -> None:
        self.shapes |= found[1]
        self.show_layout()

    def show_dragged(self, part: Placed) -> None:
        self.drawing.preview(part)
        self.panel.form.show_place(part)

    def check(self) -> None:
        work = CheckWork(self.session.path, self.session.layout, measures=False)
        self.jobs.start_unseen(tr("Checking the scene"), work, self.take_checked, self.refuse)

    def measure(self) -> None:
        work = CheckWork(self.session.path, self.session.layout, measures=True)
        self.log_command(["palpate", "scene", "check", str(self.session.path)])
        if self.jobs.start(tr("Pressing each pair"), work, self.take_measured, self.refuse):
            self.panel.budget.wait(tr("Pressing each pair"))

    def take_checked(self, found: tuple[Layout, Checked]) -> None:
        layout, checked = found
        if layout is self.session.layout:
            self.checked = checked
            self.panel.show_checked(checked)
            self.task.show_checked(checked)

    def take_measured(self, found: tuple[Layout, Checked]) -> None:
        self.take_checked(found)
        if found[0] is self.session.layout:
            self.panel.show_costs(found[1], found[0])

    def look_at(self, separation: Separation) -> None:
        """Flies to where two are deepest in each other."""
        self.drawing.look_at(np.asarray(separation.place))

    # ------------------------------------------------------------ publishing

    def ask_publish(self) -> None:
        name = self.session.path.name.removesuffix(".json").removesuffix(".layout")
        filters = [tr("Published scenarios (*.palpate)")]
        self.files.ask(tr("Publish the scene"), filters, self.publish, f"{name}.palpate")

    def publish(self, name: str) -> None:
        out = Path(name)
        out = out if out.suffix == ".palpate" else out.with_name(out.name + ".palpate")
        title = tr("Publishing {file}").format(file=out.name)
        work = PublishWork(self.session.path, self.session.layout, out)
        self.jobs.start(title, work, self.take_published, self.refuse)

    def take_published(self, found: tuple[Layout, Checked, Path]) -> None:
        layout, checked, out = found
        self.take_measured((layout, checked))
        if checked.has_errors:
            self.tell(tr("Not published: see the checks on the right."))
            return
        path = str(self.session.path)
        self.log_command(["palpate", "scene", "publish", path, "--out", str(out)])
        self.tell(tr("Published as {file}.").format(file=out.name), "info")

    # ------------------------------------------------------------ words

    def show_title(self) -> None:
        self.setWindowTitle(f"{self.session.path.name}[*] – Palpate")
        self.setWindowModified(not self.session.saved)

    def log_command(self, words: list[str]) -> None:
        self.log.appendPlainText(f"{datetime.now():%H:%M:%S}  $ {shlex.join(words)}")

    def tell(self, sentence: str, severity: str = "error") -> None:
        self.messages.tell(sentence, severity)

    def refuse(self, problem: BaseException) -> None:
        if isinstance(problem, LayoutError | WrongCall):
            problem = ValueError(str(problem))
        self.tell(sentence_of(problem))

    def _try(self, doing: Callable[..., None], *arguments: Any) -> bool:
        try:
            doing(*arguments)
        except REFUSALS as problem:
            self.refuse(problem)
            return False
        return True

    # ------------------------------------------------------------ closing

    def arrange(self) -> None:
        """The docks take their sizes only in a window that has one."""
        self.resizeDocks(self.docks[:2], [SIDE, STAGE], Qt.Orientation.Horizontal)
        self.resizeDocks(self.docks[2:], [BELOW], Qt.Orientation.Vertical)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.arrange()
        keep_on_screen(self)

    def closeEvent(self, event: QCloseEvent) -> None:
        if not self.may_close and not self.session.saved:
            event.ignore()
            name = self.session.path.name
            self.question = file_questions.ask_unsaved(self, name, self.answer_unsaved)
            return
        self.pause.stop()
        self.jobs.finish()
        event.accept()
        self.closed.emit()

    def answer_unsaved(self, button: int) -> None:
        self.question = None
        if button == QMessageBox.StandardButton.Save and not self.files.save():
            return
        if button in (QMessageBox.StandardButton.Save, QMessageBox.StandardButton.Discard):
            self.may_close = True
            self.close()
