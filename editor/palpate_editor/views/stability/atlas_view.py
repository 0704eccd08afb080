# SPDX-License-Identifier: GPL-3.0-or-later
"""The panel of an atlas: the map, the scene's mark on it, and where an atlas comes from."""

from __future__ import annotations

from pathlib import Path

from palpate.scene.scene_parts import INTEGRATORS
from palpate.study.atlas import Atlas
from palpate.study.atlas_file import read_atlas, write_atlas
from palpate.study.step_limit import LIMIT_SHARE
from palpate.system.data_folder import find_cache_folder
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QHBoxLayout, QPushButton, QVBoxLayout, QWidget

from palpate_editor.atlas_fit import find_line, find_mark, say_mark
from palpate_editor.document import Organ
from palpate_editor.views.context import Context
from palpate_editor.views.elided_label import ElidedLabel
from palpate_editor.views.files import Files
from palpate_editor.views.jobs import Job, Progress
from palpate_editor.views.stability.atlas_plot import AtlasPlot
from palpate_editor.views.translations import say, tr


class ReadWork:
    """Reads an atlas's file."""

    def __init__(self, path: Path):
        self.path = path

    def __call__(self, progress: Progress) -> Atlas:
        progress(tr("Opening {file}").format(file=self.path.name), 0.3)
        return read_atlas(self.path)


class DrawWork:
    """Runs what is not kept of an organ's atlas, in a process of its own."""

    def __init__(self, organ: Organ, file: str, cache: Path):
        self.organ, self.file, self.cache = organ, file, cache

    def __call__(self, progress: Progress) -> Atlas:
        # they load SciPy
        from palpate_editor.atlas import Step, compute_key, draw_atlas, run_tissues
        from palpate_editor.atlas_jobs import Plan
        from palpate_editor.atlas_store import Store
        from palpate_editor.chart_jobs import pack_document

        def tell(step: Step) -> None:
            said = tr("{done} of {all} tissues").format(done=step.done, all=step.all)
            progress(said, step.done / step.all)

        progress(tr("It begins"), 0.0)
        plan = Plan(pack_document(self.organ))
        with Store(compute_key(plan), self.cache) as store:
            command = f"palpate stability {self.file}"
            return draw_atlas(plan, runner=run_tissues(1), store=store, told=tell, command=command)


class AtlasView(QWidget):
    """Shows one atlas, and where the organ on the desk is on it."""

    opened = Signal()
    """There is another atlas to look at."""

    def __init__(self, context: Context, files: Files, parent: QWidget | None = None):
        super().__init__(parent)
        self.setObjectName("atlas_view")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.context, self.files = context, files
        self.cache = find_cache_folder() / "atlases"
        self.atlas: Atlas | None = None
        self.job: Job | None = None
        self.plot = AtlasPlot(self)
        self.words = ElidedLabel(self)
        self.words.setObjectName("atlas_words")
        column = QVBoxLayout(self)
        column.setContentsMargins(6, 4, 4, 4)
        column.setSpacing(2)
        column.addLayout(self.build_bar())
        column.addWidget(self.plot, 1)
        context.session.changed.connect(self.on_changed)
        context.assessed.connect(self.show_present)
        context.dragged.connect(self.show_organ)
        self.show_atlas(None)

    def build_bar(self) -> QHBoxLayout:
        bar = QHBoxLayout()
        bar.setSpacing(8)
        bar.addWidget(self.words, 1)
        self.buttons = {
            "draw_atlas": (tr("Find the limits"), self.draw),
            "stop_atlas": (tr("Stop"), self.stop),
            "open_atlas": (tr("Open an atlas…"), self.ask_open),
            "save_atlas": (tr("Save the atlas…"), self.ask_save),
        }
        self.made: dict[str, QPushButton] = {}
        for name, (text, slot) in self.buttons.items():
            button = QPushButton(text, self)
            button.setObjectName(name)
            button.setProperty("small", True)
            button.clicked.connect(slot)
            bar.addWidget(button)
            self.made[name] = button
        return bar

    # ------------------------------------------------------------ showing

    def show_atlas(self, atlas: Atlas | None) -> None:
        self.atlas = atlas
        self.made["save_atlas"].setEnabled(atlas is not None)
        self.show_busy()
        self.show_present()

    def show_busy(self) -> None:
        self.made["draw_atlas"].setVisible(self.job is None)
        self.made["stop_atlas"].setVisible(self.job is not None)
        self.made["stop_atlas"].setEnabled(True)

    def on_changed(self, before: Organ, after: Organ) -> None:
        del before, after
        self.show_present()

    def show_present(self) -> None:
        self.show_organ(self.context.session.organ)

    def show_organ(self, organ: Organ) -> None:
        """The mark of an organ, of the one on the desk or of one that a drag would make of it."""
        if self.atlas is None:
            self.plot.show_line(())
            self.plot.show_mark(None)
            self.words.setText(tr("No atlas yet: find the limits of this organ, or open one"))
            return
        line = find_line(self.atlas, organ)
        if line != self.plot.line:
            self.plot.show_line(line)
        mark = find_mark(self.atlas, organ, self.find_known(organ))
        self.plot.show_mark(mark)
        if self.job is None:
            self.words.setText(str(say(say_mark(mark, organ))))

    def find_known(self, organ: Organ) -> float | None:
        """[s] The limit that the assessment foretold for this very organ."""
        assessment = self.context.assessment
        if assessment is None or assessment.organ is not organ or assessment.tissue is None:
            return None
        step = assessment.tissue.stable_step
        if organ.model.integrator != INTEGRATORS[0] or not step:
            return None
        return step / LIMIT_SHARE

    # ------------------------------------------------------------ doing

    def draw(self) -> None:
        """Runs beside the window what is not kept yet."""
        organ = self.context.session.organ
        if self.job is not None:
            return
        if organ.surface is None:
            self.context.tell(tr("There is no organ yet: import a mesh first."), "warning")
            return
        work = DrawWork(organ, str(self.context.document()), self.cache)
        self.job = self.context.jobs.start_unseen(
            tr("Find the limits"), work, self.on_drawn, self.on_refused
        )
        if self.job is not None:
            self.job.progressed.connect(self.tell)
            self.job.ended.connect(self.on_ended)
        self.show_busy()

    def tell(self, text: str, share: float) -> None:
        self.words.setText(f"{text} ({share:.0%})" if share else text)

    def stop(self) -> None:
        """What is finished is kept, and the next time it goes on from there."""
        if self.job is not None:
            self.job.cancel()
            self.made["stop_atlas"].setEnabled(False)  # the tissue under way comes to its end

    def on_drawn(self, atlas: Atlas) -> None:
        self.job = None
        self.show_atlas(atlas)
        self.opened.emit()

    def on_refused(self, problem: BaseException) -> None:
        self.on_ended()
        self.context.refuse(problem)

    def on_ended(self, job: object = None) -> None:
        if job is not None and job is not self.job:
            return
        self.job = None
        self.show_busy()
        self.show_present()

    def ask_open(self) -> None:
        filters = [tr("Atlases (*.json)"), tr("All files (*)")]
        self.files.ask(tr("Open an atlas"), filters, self.open_name)

    def open_name(self, name: str) -> None:
        self.open(Path(name))

    def open(self, path: Path) -> None:
        """Reads it beside the window."""
        title = tr("Opening {file}").format(file=path.name)
        self.context.jobs.start_unseen(title, ReadWork(path), self.on_read, self.context.refuse)

    def on_read(self, atlas: Atlas) -> None:
        self.show_atlas(atlas)
        self.opened.emit()

    def ask_save(self) -> None:
        name = f"{self.context.stem()}.atlas.json"
        self.files.ask(tr("Save the atlas"), [tr("Atlases (*.json)")], self.save_name, save=name)

    def save_name(self, name: str) -> None:
        if self.atlas is None:
            return
        try:
            write_atlas(Path(name), self.atlas)
        except OSError as problem:
            self.context.refuse(problem)
            return
        self.context.tell(tr("Saved as {file}.").format(file=Path(name).name), "info")
