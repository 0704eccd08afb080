# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of the window: new, open, save, recent, dropped; and never losing what is unsaved."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from palpate import FileError
from palpate.files.file_kind import LAYOUT, find_kind
from PySide6.QtCore import QObject
from PySide6.QtWidgets import QFileDialog, QMessageBox, QWidget

from palpate_editor.document import Organ
from palpate_editor.document.file_state import is_changed, read_state
from palpate_editor.formats import EXTENSIONS, is_mesh
from palpate_editor.open_organ import open_organ
from palpate_editor.scan import is_scan
from palpate_editor.shipped import make_organ
from palpate_editor.views import file_questions
from palpate_editor.views.context import Context
from palpate_editor.views.jobs import Progress
from palpate_editor.views.tasks import ImportWork, Tasks
from palpate_editor.views.translations import tr

DOCUMENTS = (".organ", ".palpate")
MESHES = tuple(f".{extension}" for extension in EXTENSIONS)
SOME_MESHES = f"{', '.join(MESHES[:8])} ..."
"""For a sentence; the file dialog lists them all."""


def is_document(path: Path) -> bool:
    return path.suffix.lower() in DOCUMENTS or path.name.endswith(".scene.json")


def is_layout(path: Path) -> bool:
    """A scene of several organs, as `palpate scene` writes it."""
    try:
        return path.suffix.lower() == ".json" and find_kind(path) == LAYOUT
    except OSError:
        return False


def is_replaceable(organ: Organ, path: Path) -> bool:
    """Whether a mesh file may be imported into the document of `organ`: it has no surface yet, or
    one of that very file, wherever the file lies now."""
    source = organ.source
    if organ.surface is None or source is None:
        return organ.surface is None
    return Path(source.folder) / source.file == path.resolve() or (
        source.file == path.name and not is_changed(path, source.sha256)
    )


@dataclass(frozen=True, eq=False)
class Opened:
    """A document that was read."""

    path: Path
    organ: Organ
    state: str | None
    """Of the file before it was read; see document.file_state."""


@dataclass(frozen=True)
class OpenWork:
    """Reads a document."""

    path: Path

    def __call__(self, progress: Progress) -> Opened:
        progress(tr("Opening {file}").format(file=self.path.name), 0.1)
        state = read_state(self.path)
        return Opened(self.path, open_organ(self.path), state)


@dataclass(frozen=True)
class ShippedWork:
    """Makes one of the organs that come with Palpate."""

    name: str

    def __call__(self, progress: Progress) -> Organ:
        progress(tr("Opening {file}").format(file=self.name), 0.1)
        return make_organ(self.name)


class Files(QObject):
    """Asks for files with dialogs that do not block, and does what they are for."""

    def __init__(self, context: Context, tasks: Tasks, window: QWidget):
        super().__init__(window)
        self.context, self.tasks, self.window = context, tasks, window
        self.after: Callable[[], None] | None = None
        """What waits for the answer about unsaved changes; a bound method."""
        self.wanted: Path | None = None
        self.mesh: ImportWork | None = None
        """The mesh that a new document is wanted of."""
        self.over: Organ | None = None
        """The organ that may go, as it was when its owner said so, or when it was saved."""
        self.unwritten: Path | None = None
        """Where to save, while a question about that file is open."""
        self.shipped = ""
        """The name of the organ of ours that is wanted."""
        self.dialog: QFileDialog | None = None
        self.question: QMessageBox | None = None
        context.import_wanted.connect(self.ask_import)
        context.mesh_wanted.connect(self.import_mesh)

    # ------------------------------------------------------------ dialogs

    def ask(
        self, title: str, filters: list[str], chosen: Callable[[str], None], save: str = ""
    ) -> QFileDialog:
        """Shows a file dialog; `save` is the name proposed where a file is to be written."""
        dialog = QFileDialog(self.window, title)
        dialog.setNameFilters(filters)
        folder = self.context.settings.last_folder
        if folder is not None:
            dialog.setDirectory(str(folder))
        if save:
            dialog.setAcceptMode(QFileDialog.AcceptMode.AcceptSave)
            dialog.setDefaultSuffix(Path(save).suffix.lstrip("."))
            dialog.selectFile(save)
        else:
            dialog.setFileMode(QFileDialog.FileMode.ExistingFile)
        dialog.fileSelected.connect(chosen)
        dialog.fileSelected.connect(self.remember_folder)
        dialog.finished.connect(dialog.deleteLater)
        self.dialog = dialog
        dialog.open()
        return dialog

    def remember_folder(self, name: str) -> None:
        self.context.settings.last_folder = Path(name).parent

    def ask_open(self) -> None:
        self.guard(self.show_open_dialog)

    def show_open_dialog(self) -> None:
        endings = (*DOCUMENTS, ".scene.json", ".layout.json", *MESHES)
        names = " ".join(f"*{ending}" for ending in endings)
        filters = [
            tr("Organs and meshes ({names})").format(names=names),
            tr("Organ documents (*.organ)"),
            tr("Published scenarios (*.palpate)"),
            tr("Scenes ({names})").format(names="*.layout.json"),
            tr("All files (*)"),
        ]
        self.ask(tr("Open"), filters, self.load_name)

    def ask_import(self) -> None:
        names = " ".join(f"*{ending}" for ending in MESHES)
        filters = [tr("Meshes ({names})").format(names=names), tr("All files (*)")]
        self.ask(tr("Import a mesh"), filters, self.import_name)

    # ------------------------------------------------------------ opening

    def load_name(self, name: str) -> None:
        self.load(Path(name))

    def import_name(self, name: str) -> None:
        self.import_mesh(ImportWork(Path(name)))

    def import_mesh(self, work: ImportWork) -> None:
        """Imports a mesh: over an organ of another file it begins a document of its own."""
        if is_replaceable(self.context.session.organ, work.path):
            self.tasks.start_import(work)
            return
        self.mesh = work
        self.guard(self.import_over)

    def import_over(self) -> None:
        work = self.mesh
        if work is not None:
            self.tasks.start_import(replace(work, over=self.context.session.organ))

    def open(self, path: Path) -> None:
        """Opens a document or imports a mesh, after asking about unsaved changes."""
        if is_layout(path):  # takes nothing from the organ
            self.load(path)
            return
        self.wanted = path
        self.guard(self.load_wanted)

    def load_wanted(self) -> None:
        if self.wanted is not None:
            self.load(self.wanted)

    def load(self, path: Path) -> None:
        """Opens a document, or imports a mesh into a new one."""
        if not path.is_file():
            self.context.tell(tr("There is no file {file}.").format(file=path))
            return
        if is_layout(path):
            self.context.layout_wanted.emit(path, False)
            return
        if is_mesh(path):
            self.mesh = ImportWork(path)
            self.import_over()
            self.context.settings.add_recent(path)
            return
        if is_scan(path):
            self.context.scan_wanted.emit(path)
            return
        if not is_document(path):
            self.context.tell(
                tr("{file}: the editor opens .organ and .palpate files and imports {meshes}.")
                .format(file=path.name, meshes=SOME_MESHES)
            )  # fmt: skip
            return
        if not self.tasks.is_busy():
            title = tr("Opening {file}").format(file=path.name)
            self.over = self.context.session.organ
            self.context.jobs.start(title, OpenWork(path), self.show_opened, self.context.refuse)

    def show_opened(self, opened: Opened) -> None:
        """Shows what was read."""
        path = opened.path
        if self.tasks.is_overtaken(self.over, path.name):
            return
        self.context.session.load(opened.organ, path, opened.state)
        self.context.settings.add_recent(path)
        self.context.view.frame_all()
        self.context.log_command(["palpate", "editor", path])
        self.context.show_stage("import" if opened.organ.surface is None else "material")

    def open_shipped(self, name: str) -> None:
        """Opens one of the organs that come with Palpate, after asking."""
        self.shipped = name
        self.guard(self.load_shipped)

    def load_shipped(self) -> None:
        if not self.tasks.is_busy():
            title = tr("Opening {file}").format(file=self.shipped)
            self.over = self.context.session.organ
            self.context.jobs.start(
                title, ShippedWork(self.shipped), self.show_shipped, self.context.refuse
            )

    def show_shipped(self, organ: Organ) -> None:
        """It has no file of its own yet: the one that ships stays as it is."""
        if self.tasks.is_overtaken(self.over, self.shipped):
            return
        self.context.session.load(organ, None)
        self.context.view.frame_all()
        self.context.log_command(
            ["palpate", "organs", self.shipped, "--out", f"{self.shipped}.organ"]
        )
        self.context.show_stage("material")

    def drop(self, paths: list[Path]) -> None:
        """Files were dropped on the window: the first one that can be used is."""
        usable = [p for p in paths if is_mesh(p) or is_document(p) or is_layout(p)]
        if not usable:
            names = ", ".join(path.name for path in paths) or tr("Nothing")
            self.context.tell(
                tr("{file}: the editor opens .organ and .palpate files and imports {meshes}.")
                .format(file=names, meshes=SOME_MESHES)
            )  # fmt: skip
            return
        if is_mesh(usable[0]):
            self.import_mesh(ImportWork(usable[0]))
            self.context.settings.add_recent(usable[0])
        else:
            self.open(usable[0])

    def start_new(self) -> None:
        self.guard(self.show_empty)

    def show_empty(self) -> None:
        self.context.session.clear()
        self.context.show_stage("import")

    def ask_new_scene(self) -> None:
        """A scene of several organs belongs to a file from the beginning."""
        filters = [tr("Scenes ({names})").format(names="*.layout.json")]
        self.ask(tr("New scene"), filters, self.begin_scene, save="scene.layout.json")

    def begin_scene(self, name: str) -> None:
        path = Path(name)
        named = path if path.suffix == ".json" else path.with_name(path.name + ".layout.json")
        self.context.layout_wanted.emit(named, True)

    # ------------------------------------------------------------ saving

    def save(self) -> None:
        session = self.context.session
        if session.path is None or session.path.suffix != ".organ":
            self.ask_save()
            return
        self.write(session.path)

    def ask_save(self) -> None:
        name = f"{self.context.stem()}.organ"
        self.ask(tr("Save as"), [tr("Organ documents (*.organ)")], self.write_name, save=name)
        if self.dialog is not None:
            self.dialog.rejected.connect(self.forget_after)

    def write_name(self, name: str) -> None:
        path = Path(name)
        self.write(path if path.suffix == ".organ" else path.with_name(path.name + ".organ"))

    def write(self, path: Path) -> bool:
        """Saves, unless the session's own file holds what nobody has seen here: then it asks."""
        session = self.context.session
        own = session.path is not None and path.resolve() == session.path.resolve()
        if own and session.is_changed_on_disk():
            self.unwritten = path
            self.question = file_questions.ask_changed(self.window, path.name, self.answer_changed)
            return False
        return self.overwrite(path)

    def overwrite(self, path: Path) -> bool:
        """Saves, whatever stands there."""
        try:
            self.context.session.save(path)
        except (FileError, OSError, ValueError) as problem:
            self.context.refuse(problem)
            self.after = None
            return False
        self.context.settings.add_recent(path)
        self.context.log_command(["palpate", "check", path])
        self.context.tell(tr("Saved as {file}.").format(file=path.name), "info")
        self.go_on()
        return True

    # ------------------------------------------------------------ unsaved changes

    def guard(self, then: Callable[[], None]) -> None:
        """Calls `then` at once, or after asking where something is unsaved; a bound method."""
        self.after = then
        if self.context.session.saved:
            self.go_on()
            return
        name = self.context.session.name or tr("This organ")
        self.question = file_questions.ask_unsaved(self.window, name, self.answer)

    def answer(self, button: int) -> None:
        self.question = None
        if button == QMessageBox.StandardButton.Save:
            self.save()
        elif button == QMessageBox.StandardButton.Discard:
            self.go_on()
        else:
            self.after = None

    def answer_changed(self, button: int) -> None:
        """What to do about a file that another program has changed."""
        self.question = None
        path = self.unwritten
        if path is None:
            return
        if button == file_questions.OVERWRITE:
            self.overwrite(path)
        elif button == file_questions.SAVE_AS:
            self.ask_save()
        else:
            self.after = None
            if button == file_questions.RELOAD:
                self.load(path)

    def go_on(self) -> None:
        then, self.after = self.after, None
        if then is not None:
            then()

    def forget_after(self) -> None:
        self.after = None
