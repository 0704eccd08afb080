# SPDX-License-Identifier: GPL-3.0-or-later
"""The editor as a program: one session, its window, its recovery, its language."""

from __future__ import annotations

import gc
import logging
from collections.abc import Callable
from functools import partial
from pathlib import Path

from palpate import FileError
from palpate.files.refusal import Refusal
from palpate.translation import install
from palpate.translation.refusals import read_patterns
from PySide6.QtCore import QLocale, QObject, QTimer
from PySide6.QtWidgets import QApplication, QMessageBox

from palpate_editor.app.autosave import Autosave
from palpate_editor.app.open_document import OpenDocument
from palpate_editor.app.recovery import (
    LAYOUT,
    Recovery,
    find_recoveries,
    find_recovery_folder,
)
from palpate_editor.app.session import Session
from palpate_editor.app.settings import Settings
from palpate_editor.views.layout.layout_window import LayoutWindow
from palpate_editor.views.sentences import ExceptHook
from palpate_editor.views.translations import tr
from palpate_editor.views.window import MainWindow

LOG = logging.getLogger(__name__)
SWEEP = 2000
"""[ms] between two collections of reference cycles."""


class Editor(QObject):
    """Keeps the session while windows come and go with the language."""

    def __init__(
        self,
        app: QApplication,
        settings: Settings,
        *,
        theme: str | None = None,
        language: str | None = None,
        recovery_folder: Path | None = None,
    ):
        super().__init__(app)
        self.app, self.settings, self.theme = app, settings, theme
        self.language = install(app, language or settings.language)
        # numbers as the language of the window writes them, whatever the desktop says
        QLocale.setDefault(QLocale(self.language))
        self.session = Session(parent=self)
        self.folder = recovery_folder or find_recovery_folder()
        self.autosave = Autosave(self.session, self.folder, parent=self)
        self.document = OpenDocument(self.folder)
        self.session.title_changed.connect(self.take_document)
        self.hook = ExceptHook(self)
        self.hook.install()
        self.layouts: list[LayoutWindow] = []
        """Windows of scenes that are open."""
        self.is_ending = False
        self.recoveries: list[Recovery] = []
        self.question: QMessageBox | None = None
        # widgets must die in the window's thread: a collection in a worker would end them there
        gc.disable()
        self.sweeper = QTimer(self, interval=SWEEP)
        self.sweeper.timeout.connect(self.sweep)
        self.sweeper.start()
        self.window = self.build_window()
        read_patterns()  # now, so that the first sentence of the core need not wait 50 ms for it
        self.settle_memory()

    def settle_memory(self) -> None:
        """What stands now stays: sweeping through all of it would stop the window for 0.1 s."""
        gc.unfreeze()
        gc.collect()
        gc.freeze()

    def build_window(self) -> MainWindow:
        window = MainWindow(self.session, self.settings, self.theme)
        window.actions_by_name.check(f"language_{self.language}")
        window.appearance.language_wanted.connect(self.use_language)
        self.autosave.saved.connect(window.status.show_autosaved)
        self.autosave.failed.connect(window.context.tell)
        self.hook.caught.connect(window.context.tell)
        window.context.layout_wanted.connect(self.open_layout)
        window.closed.connect(self.finish)
        return window

    def show(self) -> None:
        self.window.show()
        self.recoveries = find_recoveries(self.folder)
        if self.recoveries:
            self.ask_recovery()

    def take_document(self) -> None:
        """Tells where another editor has the same file open."""
        path = self.session.path
        other = self.document.take(path)
        if other is not None and path is not None:
            self.window.context.tell(
                tr(
                    "{file} is open in another editor too (process {process}): saving asks before "
                    "it overwrites what was saved there."
                ).format(file=path.name, process=other),
                "warning",
            )

    def sweep(self) -> None:
        gc.collect()

    # ------------------------------------------------------------ scenes

    def open_layout(self, path: Path, is_new: bool = False) -> None:
        """A scene in a window of its own; a refusal is said in the main one."""
        layout = self.build_layout()
        self.show_layout(layout, partial(layout.begin if is_new else layout.open, path))

    def build_layout(self) -> LayoutWindow:
        layout = LayoutWindow(self.settings, self.window.context.theme)
        layout.autosave = Autosave(layout.session, self.folder, parent=layout, kind=LAYOUT)
        layout.autosave.failed.connect(layout.tell)
        return layout

    def show_layout(self, layout: LayoutWindow, fill: Callable[[], None]) -> bool:
        """The window, if it can be filled; a refusal is said in the main one."""
        try:
            fill()
        except (Refusal, OSError) as problem:
            layout.may_close = True
            layout.autosave.finish()
            layout.deleteLater()
            self.window.context.refuse(problem)
            return False
        self.layouts.append(layout)
        layout.closed.connect(self.forget_layout)
        layout.show()
        return True

    def forget_layout(self) -> None:
        """A window of a scene has closed."""
        layout = self.sender()
        layout.autosave.finish()
        self.layouts = [each for each in self.layouts if each is not layout]
        layout.deleteLater()
        if self.is_ending:
            self.finish()

    # ------------------------------------------------------------ language

    def use_language(self, language: str) -> None:
        """The same session in a window of another language, once the menu has closed."""
        if language == self.language:
            return
        self.language = install(self.app, language)
        QLocale.setDefault(QLocale(self.language))
        QTimer.singleShot(0, self.rebuild)

    def rebuild(self) -> None:
        old, stage = self.window, self.window.context.stage
        old.closed.disconnect(self.finish)
        self.theme = None
        old.may_close = True
        old.close()
        self.window = self.build_window()
        self.window.show_stage(stage)
        self.window.show()
        old.deleteLater()
        QTimer.singleShot(SWEEP, self.settle_memory)

    # ------------------------------------------------------------ recovery

    def ask_recovery(self) -> None:
        """What a crash left behind: restore it or discard it."""
        newest = self.recoveries[0]
        box = QMessageBox(self.window)
        box.setObjectName("recovery")
        box.setIcon(QMessageBox.Icon.Information)
        box.setWindowTitle(tr("Unsaved work was found"))
        box.setText(
            tr("The editor ended without saving {name}, changed at {time}.").format(
                name=newest.name or tr("an organ without a name"),
                time=f"{newest.time:%Y-%m-%d %H:%M}",
            )
        )
        box.setInformativeText(tr("Nothing is lost: continue where you were?"))
        buttons = QMessageBox.StandardButton
        box.setStandardButtons(buttons.Open | buttons.Discard | buttons.Cancel)
        box.button(buttons.Open).setText(tr("Restore"))
        box.button(buttons.Discard).setText(tr("Discard"))
        box.button(buttons.Cancel).setText(tr("Ask me later"))
        box.setDefaultButton(buttons.Open)
        box.finished.connect(self.answer_recovery)
        box.finished.connect(box.deleteLater)
        self.question = box
        box.open()

    def answer_recovery(self, button: int) -> None:
        self.question = None
        newest = self.recoveries.pop(0)
        context = self.window.context
        if button == QMessageBox.StandardButton.Open and newest.kind is LAYOUT:
            self.restore_layout(newest)
            if self.recoveries:
                self.ask_recovery()
        elif button == QMessageBox.StandardButton.Open:
            try:
                self.autosave.restore(newest)
            except (FileError, Refusal, OSError) as problem:
                context.refuse(problem)
                return
            context.view.frame_all()
            context.show_stage("material")
            context.tell(tr("Here is what was not saved. Save it to keep it."), "info")
        elif button == QMessageBox.StandardButton.Discard:
            newest.remove()
            if self.recoveries:
                self.ask_recovery()

    def restore_layout(self, recovery: Recovery) -> None:
        layout = self.build_layout()
        if self.show_layout(layout, partial(layout.autosave.restore, recovery)):
            layout.tell(tr("Here is what was not saved. Save it to keep it."), "info")

    def finish(self) -> None:
        """The main window has closed; what ends now may still be used by those of scenes."""
        self.is_ending = True
        if self.layouts:
            return
        self.sweeper.stop()
        self.autosave.finish()
        self.document.release()
        self.hook.remove()
        gc.unfreeze()
        gc.enable()
