# SPDX-License-Identifier: GPL-3.0-or-later
"""What a step of repair would do: shown in the view and told in a card, then applied or not."""

from __future__ import annotations

from PySide6.QtWidgets import QHBoxLayout, QPushButton, QVBoxLayout, QWidget

from palpate_editor.edits import Edit
from palpate_editor.views.context import Context
from palpate_editor.views.stages.facts import write_label
from palpate_editor.views.step_work import Step, StepWork
from palpate_editor.views.tasks import Tasks
from palpate_editor.views.translations import say, say_title, tr


class StepCard(QWidget):
    """Hidden until a step has been tried."""

    def __init__(self, context: Context, tasks: Tasks, parent: QWidget | None = None):
        super().__init__(parent)
        self.setObjectName("step_card")
        self.context, self.tasks = context, tasks
        self.step: Step | None = None
        self.title = write_label("", "section", self)
        self.text = write_label("", "value", self)
        self.text.setObjectName("step_text")
        self.text.setWordWrap(True)
        self.apply_button = QPushButton(tr("Apply"), self)
        self.apply_button.setObjectName("apply_step")
        self.apply_button.setProperty("main", True)
        self.apply_button.clicked.connect(self.apply)
        self.discard_button = QPushButton(tr("Discard"), self)
        self.discard_button.setObjectName("discard_step")
        self.discard_button.clicked.connect(self.discard)
        row = QHBoxLayout()
        row.addStretch(1)
        row.addWidget(self.discard_button)
        row.addWidget(self.apply_button)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.title)
        column.addWidget(self.text)
        column.addLayout(row)
        self.hide()
        context.session.changed.connect(self.discard)
        context.stage_shown.connect(self.discard)

    def attempt(self, edit: Edit) -> None:
        """Does a step beside the window and shows what it comes to; the organ stays what it is."""
        if self.tasks.is_busy():
            return
        self.discard()
        work = StepWork(self.context.session.organ, edit)
        self.context.jobs.start(say_title(edit.title), work, self.show_step, self.context.refuse)

    def show_step(self, step: Step) -> None:
        if step.edit.before is not self.context.session.organ:
            self.context.tell(tr("The organ has changed meanwhile: try the step again."), "warning")
            return
        self.step = step
        self.title.setText(tr("Preview: {step}").format(step=say_title(step.edit.title)))
        self.text.setText(say_step(step))
        self.show()
        surface = step.edit.after.surface
        assert surface is not None
        self.context.show_preview(True)
        self.context.view.show_selection(None)
        self.context.view.show_surface(surface.vertices, surface.triangles)
        self.context.view.show_colours(surface.colours)

    def apply(self) -> None:
        step = self.step
        self.discard()
        if step is not None:
            self.context.apply(step.edit)

    def discard(self, *_: object) -> None:
        """The organ has the view again."""
        if self.step is None:
            return
        self.step = None
        self.hide()
        self.context.show_preview(False)


def say_step(step: Step) -> str:
    """Rung by rung, what each did; then what is left."""
    lines = []
    for rung in step.rungs:
        if rung.title != step.edit.title or not rung.did:
            lines.append(say_title(rung.title))
        lines += [f"\N{BULLET} {say(text)}" for text in rung.did]
    if step.left:
        lines.append(tr("Left as it is:"))
        lines += [f"\N{BULLET} {say(text)}" for text in step.left]
    return "\n".join(lines)
