# SPDX-License-Identifier: GPL-3.0-or-later
"""Saving a layout, and the questions before something could be lost."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from palpate.files.refusal import Refusal
from palpate.layout.document import LayoutError
from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QFileDialog, QMessageBox, QWidget

from palpate_editor.app.settings import Settings
from palpate_editor.views import file_questions
from palpate_editor.views.layout.layout_session import LayoutSession
from palpate_editor.views.translations import tr


class LayoutFiles(QObject):
    """Asks with dialogs that do not block."""

    told = Signal(str, str)
    refused = Signal(object)

    def __init__(self, session: LayoutSession, settings: Settings, window: QWidget):
        super().__init__(window)
        self.session, self.settings, self.window = session, settings, window
        self.dialog: QFileDialog | None = None
        self.question: QMessageBox | None = None

    def save(self) -> bool:
        """Unless the file holds what nobody has seen here: then it asks."""
        if self.session.is_changed_on_disk():
            name = self.session.path.name
            self.question = file_questions.ask_changed(self.window, name, self.answer_changed)
            return False
        return self.overwrite()

    def overwrite(self) -> bool:
        try:
            self.session.save()
        except (LayoutError, OSError) as problem:
            self.refused.emit(problem)
            return False
        words = tr("Saved as {file}.").format(file=self.session.path.name)
        self.told.emit(words, "info")
        return True

    def answer_changed(self, button: int) -> None:
        self.question = None
        if button == file_questions.OVERWRITE:
            self.overwrite()
        elif button == file_questions.SAVE_AS:
            self.ask_save_as()
        elif button == file_questions.RELOAD:
            try:
                self.session.open(self.session.path)
            except (Refusal, OSError) as problem:
                self.refused.emit(problem)

    def ask_save_as(self) -> None:
        filters = [tr("Scenes ({names})").format(names="*.layout.json")]
        self.ask(tr("Save as"), filters, self.save_name, self.session.path.name)

    def save_name(self, name: str) -> None:
        try:
            self.session.save_as(name_layout(Path(name)))
        except (LayoutError, OSError) as problem:
            self.refused.emit(problem)

    def ask(
        self, title: str, filters: list[str], chosen: Callable[[str], None], save: str = ""
    ) -> None:
        """A file dialog; `save` is the name proposed where a file is to be written."""
        dialog = QFileDialog(self.window, title)
        dialog.setNameFilters(filters)
        dialog.setDirectory(str(self.settings.last_folder or self.session.path.parent))
        if save:
            dialog.setAcceptMode(QFileDialog.AcceptMode.AcceptSave)
            dialog.selectFile(save)
        else:
            dialog.setFileMode(QFileDialog.FileMode.ExistingFile)
        dialog.fileSelected.connect(chosen)
        dialog.finished.connect(dialog.deleteLater)
        self.dialog = dialog
        dialog.open()


def name_layout(path: Path) -> Path:
    """With the ending of a layout."""
    return path if path.suffix == ".json" else path.with_name(path.name + ".layout.json")
