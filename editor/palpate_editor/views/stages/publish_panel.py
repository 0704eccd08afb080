# SPDX-License-Identifier: GPL-3.0-or-later
"""Stage 7: what the trainee reads, what still prevents publishing, and the published file."""

from __future__ import annotations

from dataclasses import dataclass

import palpate
from palpate.runs.costs import hold_costs
from palpate.translation import LANGUAGES
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QCheckBox, QComboBox, QLineEdit, QPlainTextEdit, QPushButton, QWidget

from palpate_editor.document import Organ, Translation
from palpate_editor.document.cost_rules import LATE
from palpate_editor.document.problems import Problem
from palpate_editor.edits import SetTask
from palpate_editor.views.budget_bar import BudgetBar, find_budget
from palpate_editor.views.context import Context
from palpate_editor.views.jobs import Progress
from palpate_editor.views.publishing import Publishing
from palpate_editor.views.stages.facts import Facts, write_label
from palpate_editor.views.stages.stage_panel import StagePanel, Workers
from palpate_editor.views.translations import count, quantity, tr

TASK_HEIGHT = 130
"""[px]"""


class TaskEdit(QPlainTextEdit):
    """Text that is entered when the cursor leaves it."""

    def __init__(self, panel: PublishPanel):
        super().__init__(panel)
        self.panel = panel

    def focusOutEvent(self, event: object) -> None:
        super().focusOutEvent(event)  # type: ignore[arg-type]
        self.panel.set_task()


class LanguageBox(QComboBox):
    """The texts that stand where there is no translation, and every translation there may be."""

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.codes: list[str] = []
        self.setObjectName("task_language")
        self.setAccessibleName(tr("Language of title and task"))
        self.setToolTip(tr("A trainee reads the translation of the window's language, if any"))

    def code(self) -> str:
        """Empty for the texts that stand where there is no translation."""
        return self.codes[self.currentIndex()] if self.codes else ""

    def show_organ(self, organ: Organ) -> None:
        codes = ["", *LANGUAGES, *(code for code in organ.languages if code not in LANGUAGES)]
        if codes == self.codes:
            return
        chosen = self.code()
        self.codes = codes
        self.clear()
        self.addItem(tr("In every language"))
        self.addItems([tr("In {name}").format(name=LANGUAGES.get(c, c)) for c in codes[1:]])
        self.setCurrentIndex(codes.index(chosen) if chosen in codes else 0)

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Scrolling the form must not change the language on the way."""
        event.ignore()


@dataclass(frozen=True)
class PressWork:
    """Presses or grasps a scene and measures what its parts cost while it is touched."""

    scene: palpate.Scene

    def __call__(self, progress: Progress) -> tuple[palpate.Scene, palpate.SceneCosts]:
        del progress
        return self.scene, hold_costs(self.scene)


class PublishPanel(StagePanel):
    """Names the scenario and publishes it."""

    stage = "publish"
    shows_fixed = True

    @staticmethod
    def title() -> str:
        return tr("Publish")

    @staticmethod
    def lead() -> str:
        return tr("Write one file that a trainee can open and feel.")

    @staticmethod
    def help() -> list[str]:
        return [
            tr("A published file holds the finished model and everything needed to feel it; it "
               "also holds your document, so it can be opened here again."),
            tr("Errors of any stage, in red, prevent publishing. Each says what it got and what "
               "was expected."),
        ]  # fmt: skip

    def __init__(self, context: Context, publishing: Publishing, parent: QWidget | None = None):
        self.publishing = publishing
        self.pressed: palpate.Scene | None = None
        """Of which the costs are measured, or shown."""
        super().__init__(context, parent)
        context.stage_shown.connect(self._on_stage)

    @classmethod
    def make(cls, workers: Workers, parent: QWidget) -> PublishPanel:
        return cls(workers.context, workers.publishing, parent)

    def build(self) -> None:
        section = self.section(tr("What the trainee reads"))
        self.language = LanguageBox(self)
        self.language.activated.connect(self.show_translation)
        section.add(self.language)
        section.add(write_label(tr("Title"), "name", self))
        self.title = QLineEdit(self)
        self.title.setObjectName("title")
        self.title.setPlaceholderText(tr("Palpate the spleen"))
        self.title.editingFinished.connect(self.set_title)
        section.add(self.title)
        section.add(write_label(tr("Task"), "name", self))
        self.task = TaskEdit(self)
        self.task.setObjectName("task")
        self.task.setTabChangesFocus(True)
        self.task.setFixedHeight(TASK_HEIGHT)
        self.task.setPlaceholderText(
            tr("Press the lower edge gently, then say where the tissue is harder.")
        )
        section.add(self.task)
        self.facts = self.section(tr("What is published")).add(Facts(self))
        self.costs = self.section(tr("Cost of a tick in touch"))
        self.budget = self.costs.add(BudgetBar(tr("Measured once the organ is compiled."), self))
        self.slow = QCheckBox(tr("Publish although it is late here, for a faster machine"), self)
        self.slow.setObjectName("slow")
        self.slow.toggled.connect(self.allow_slow)
        self.costs.add(self.slow)
        self.button = self.main_button(tr("Publish…"), "publish")
        self.button.clicked.connect(self.publish)
        self.form.addWidget(self.button)
        self.play_button = QPushButton(tr("Play the published file"), self)
        self.play_button.setObjectName("play")
        self.play_button.clicked.connect(self.play)
        self.form.addWidget(self.play_button)
        self.published = write_label("", "note", self)
        self.published.setWordWrap(True)
        self.form.addWidget(self.published)

    # ------------------------------------------------------------ showing

    def translation(self) -> Translation:
        """Title and task in the language that is being written."""
        organ, code = self.context.session.organ, self.language.code()
        if not code:
            return Translation(organ.title, organ.task)
        return organ.languages.get(code, Translation())

    def show_translation(self) -> None:
        """Another language, or another organ."""
        translation = self.translation()
        self.title.setText(translation.title)
        if self.task.toPlainText() != translation.task:
            self.task.setPlainText(translation.task)

    def show_organ(self, organ: Organ) -> None:
        self.language.show_organ(organ)
        translation = self.translation()
        if not self.title.hasFocus():
            self.title.setText(translation.title)
        if not self.task.hasFocus() and self.task.toPlainText() != translation.task:
            self.task.setPlainText(translation.task)
        path = self.publishing.path
        self.play_button.setEnabled(path is not None)
        self.published.setVisible(path is not None)
        if path is not None:
            self.published.setText(tr("Published as {file}.").format(file=path))

    def show_assessment(self) -> None:
        assessment, organ = self.context.assessment, self.context.session.organ
        tissue = assessment.tissue if assessment else None
        self.facts.parentWidget().setVisible(organ.surface is not None)
        self.costs.setVisible(organ.surface is not None)
        late = bool(assessment) and any(p.key == LATE for p in assessment.problems)
        self.slow.setVisible(late)
        if not late:
            self.slow.setChecked(False)
        self._measure_costs()
        self.button.setEnabled(organ.surface is not None)
        if organ.surface is None:
            return
        kinds = {
            "mass_spring": tr("Mass–spring"),
            "molecular": tr("Molecular"),
            "shell": tr("Shell of prisms"),
            "solid": tr("Solid"),
            "linear_solid": tr("Linear solid"),
            "corotated_solid": tr("Corotated solid"),
            "neo_hookean_solid": tr("Neo-Hookean solid"),
        }
        mass = tissue.total_mass if tissue else None
        self.facts.show_facts(
            [
                (tr("Organ"), organ.name),
                (tr("Model"), kinds.get(organ.model.kind, organ.model.kind)),
                (tr("Vertices"), count(organ.vertex_count)),
                (tr("Total mass"), quantity(None if mass is None else 1e3 * mass, "g")),
                (tr("Fixed vertices"), count(int(organ.fixed.sum()))),
            ]
        )

    def _on_stage(self, stage: str) -> None:
        del stage
        self._measure_costs()

    def _measure_costs(self) -> None:
        """Presses the scene in the background, once, where a person can see what comes of it."""
        found = self.context.assessment
        scene = None if found is None else found.scene
        if self.context.stage != self.stage or scene is self.pressed:
            return
        self.pressed = scene
        if scene is None:
            self.budget.wait(tr("Measured once the organ is compiled."))
            return
        self.budget.wait(tr("The organ is being pressed to measure it…"))
        self.context.jobs.start_unseen(
            "costs of a press", PressWork(scene), self._take_costs, self._refuse_costs
        )

    def _take_costs(self, measured: tuple[palpate.Scene, palpate.SceneCosts]) -> None:
        scene, costs = measured
        if scene is not self.pressed:
            return
        budget = find_budget(costs, scene.rate, self.context.session.organ)
        if budget is None:
            self.budget.wait(tr("An alarm ended the press: see the Test stage."))
        else:
            self.budget.show_budget(budget)

    def _refuse_costs(self, problem: BaseException) -> None:
        self.pressed = None
        self.context.refuse(problem)

    def problems(self) -> list[Problem]:
        assessment = self.context.assessment
        if assessment is None:
            return []
        others = [p for p in assessment.problems if p.severity == "error" and p.stage != self.stage]
        return others + assessment.of_stage(self.stage)

    def text_of(self, problem: Problem) -> str:
        text = super().text_of(problem)
        return (
            text
            if problem.stage == self.stage
            else f"{self.context.stages.title(problem.stage)}: {text}"
        )

    def good_news(self) -> list[str]:
        assessment = self.context.assessment
        if assessment is None or assessment.organ.surface is None:
            return []
        if any(p.severity == "error" for p in assessment.problems):
            return []
        return [tr("Nothing prevents publishing.")]

    # ------------------------------------------------------------ doing

    def set_title(self) -> None:
        title = self.title.text().strip()
        if title != self.translation().title:
            self.context.apply(SetTask(scenario_title=title, language=self.language.code()))

    def set_task(self) -> None:
        task = self.task.toPlainText().strip()
        if task != self.translation().task:
            self.context.apply(SetTask(task=task, language=self.language.code()))

    def allow_slow(self, allowed: bool) -> None:
        self.publishing.slow = allowed

    def publish(self) -> None:
        self.set_title()
        self.set_task()
        self.publishing.ask()

    def play(self) -> None:
        self.publishing.play()
