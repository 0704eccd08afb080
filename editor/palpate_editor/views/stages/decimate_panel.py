# SPDX-License-Identifier: GPL-3.0-or-later
"""Stage 3: as many vertices as a thousand ticks a second allow, and what that costs in shape."""

from __future__ import annotations

from palpate.runs.trial import DEPTH
from palpate.viewport.tone import set_tone
from PySide6.QtWidgets import (
    QCheckBox,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSpinBox,
    QWidget,
)

from palpate_editor.compile import is_built_alike
from palpate_editor.document import Decimation, Organ
from palpate_editor.document.cost_rules import TICK_SHARE
from palpate_editor.edits import UseImported
from palpate_editor.felt_change import FeltChange
from palpate_editor.views.context import Context
from palpate_editor.views.quantity_box import QuantityBox
from palpate_editor.views.stages.facts import write_label
from palpate_editor.views.stages.stage_panel import StagePanel, Workers
from palpate_editor.views.tasks import Tasks
from palpate_editor.views.translations import count, number, quantity, say, tr

LEAST, STEP = 12, 100
PRESETS = (600, 1200, 2400, 5400)
GOOD_ANGLE = 15.0
"""[degree] below it a warning is given."""
USUAL_ERROR = 1e-3
"""[m] What the field for a largest distance says at first."""
LITTLE = 0.1
"""[-] Of the felt force, by which decimating may change it without a warning."""


class DecimatePanel(StagePanel):
    """Chooses how coarse the model is."""

    stage = "decimate"
    colouring = "distance"

    @staticmethod
    def title() -> str:
        return tr("Decimate")

    @staticmethod
    def lead() -> str:
        return tr("Fewer vertices tick faster. The shape shown is what will be felt.")

    @staticmethod
    def help() -> list[str]:
        return [
            tr("The loop has a millisecond for every tick. Fewer vertices leave more of it free; "
               "600 to 2400 are usual. The colours show how far the new surface is from the file."),
            tr("Decimating always starts from the imported surface, so you can try several counts. "
               "What you have painted is carried over; its borders, ridges and thin parts are kept "
               "as far as there are vertices for them."),
        ]  # fmt: skip

    def __init__(self, context: Context, tasks: Tasks, parent: QWidget | None = None):
        self.tasks = tasks
        super().__init__(context, parent)

    @classmethod
    def make(cls, workers: Workers, parent: QWidget) -> DecimatePanel:
        return cls(workers.context, workers.tasks, parent)

    def build(self) -> None:
        section = self.section(tr("Target"))
        row = QHBoxLayout()
        row.setSpacing(8)
        row.addWidget(write_label(tr("Vertices"), "name", self))
        self.target = QSpinBox(self)
        self.target.setObjectName("target_vertices")
        self.target.setRange(LEAST, 10_000_000)
        self.target.setSingleStep(STEP)
        self.target.setValue(PRESETS[0])
        self.target.lineEdit().setTextMargins(5, 0, 5, 0)
        self.target.setKeyboardTracking(False)
        self.target.lineEdit().returnPressed.connect(self.button_pressed)
        row.addWidget(self.target, 1)
        self.button = self.main_button(tr("Decimate"), "decimate")
        self.button.clicked.connect(self.decimate)
        row.addWidget(self.button)
        section.body.addLayout(row)
        presets = QHBoxLayout()
        presets.setSpacing(5)
        self.presets: list[QPushButton] = []
        for vertices in PRESETS:
            button = QPushButton(count(vertices), self)
            button.setProperty("small", True)
            button.setProperty("vertices", vertices)
            button.clicked.connect(self.use_preset)
            presets.addWidget(button)
            self.presets.append(button)
        presets.addStretch(1)
        section.body.addLayout(presets)
        section.body.addLayout(self.build_error())
        self.shown: Decimation | None = None
        """The decimation whose count stands in the field."""
        self.build_table()
        self.undo_button = QPushButton(tr("Use the imported surface"), self)
        self.undo_button.setObjectName("use_imported")
        self.undo_button.clicked.connect(self.use_imported)
        self.form.addWidget(self.undo_button)
        self.tasks.felt.connect(self.show_felt)

    def build_error(self) -> QHBoxLayout:
        """The other target: a distance, for which the fewest vertices are found."""
        row = QHBoxLayout()
        row.setSpacing(8)
        label = write_label(tr("Largest distance"), "name", self)
        row.addWidget(label)
        self.error = QuantityBox("mm", 1e-3, self)
        self.error.setObjectName("target_error")
        self.error.setAccessibleName(tr("Largest distance"))
        self.error.show_value(USUAL_ERROR)
        self.error.entered.connect(self.error.show_value)
        label.setBuddy(self.error)
        row.addWidget(self.error, 1)
        row.addWidget(write_label("mm", "name", self))
        self.within_button = QPushButton(tr("Find the count"), self)
        self.within_button.setObjectName("decimate_within")
        self.within_button.setToolTip(
            tr("The fewest vertices that keep every point of both surfaces within this distance of "
               "the other. Takes some ten times as long as one count.")
        )  # fmt: skip
        self.within_button.clicked.connect(self.decimate_within)
        row.addWidget(self.within_button)
        return row

    def build_table(self) -> None:
        self.result = self.section(tr("Before and after"))
        self.grid = QGridLayout()
        self.grid.setHorizontalSpacing(14)
        self.grid.setVerticalSpacing(5)
        self.grid.setColumnStretch(0, 1)
        for column, title in enumerate((tr("Before"), tr("After")), start=1):
            self.grid.addWidget(write_label(title, "name", self), 0, column)
        names = (tr("Vertices"), tr("Triangles"), tr("Smallest angle"))
        names += (tr("Mean distance to the source"), tr("Largest distance"))
        names += (tr("Felt at {depth}").format(depth=quantity(1e3 * DEPTH, "mm", 2)),)
        self.cells: list[tuple[QLabel, QLabel]] = []
        for row, name in enumerate(names, start=1):
            before, after = write_label("", "value", self), write_label("", "value", self)
            self.grid.addWidget(write_label(name, "name", self), row, 0)
            self.grid.addWidget(before, row, 1)
            self.grid.addWidget(after, row, 2)
            self.cells.append((before, after))
        self.result.body.addLayout(self.grid)
        self.felt: tuple[Organ, FeltChange] | None = None
        """Of the decimation that was done last, while its organ is built as it was."""
        self.felt_words = write_label("", "note", self)
        self.felt_words.setObjectName("felt_change")
        self.felt_words.setWordWrap(True)
        self.result.add(self.felt_words)
        self.coloured = QCheckBox(tr("Show the distance as colours"), self)
        self.coloured.setObjectName("distance_colours")
        self.coloured.setChecked(True)
        self.coloured.toggled.connect(self.context.show_distance)
        self.result.add(self.coloured)

    # ------------------------------------------------------------ showing

    def show_organ(self, organ: Organ) -> None:
        there = organ.imported is not None
        self.button.setEnabled(there)
        self.within_button.setEnabled(there)
        self.result.setVisible(there)
        self.undo_button.setVisible(organ.decimation is not None)
        self.coloured.setVisible(organ.decimation is not None)
        imported = organ.imported
        if imported is None:
            return
        most = len(imported.vertices)
        self.target.setMaximum(most)
        for button in self.presets:
            button.setEnabled(int(button.property("vertices")) <= most)
        done = organ.decimation
        if done is not self.shown:
            self.shown = done
            if done is not None:
                self.target.setValue(done.vertices)
        after = len(organ.surface.vertices) if organ.surface else 0
        triangles = len(organ.surface.triangles) if organ.surface else 0
        self.write(0, count(most), count(after))
        self.write(1, count(len(imported.triangles)), count(triangles))
        self.write(3, "", quantity(1e3 * done.mean_distance, "mm", 3) if done else "–")
        self.write(4, "", quantity(1e3 * done.max_distance, "mm", 3) if done else "–")

        self.write_felt(organ)

    def show_felt(self, organ: Organ, change: FeltChange) -> None:
        self.felt = (organ, change)
        self.write_felt(self.context.session.organ)

    def write_felt(self, organ: Organ) -> None:
        """What is felt before and after, as long as nothing that is felt has changed since."""
        known = self.felt is not None and is_built_alike(self.felt[0], organ)
        if self.felt is None or not known:
            self.write(5, "", "–")
            self.felt_words.setVisible(False)
            return
        change = self.felt[1]
        places = [p for p in change.places if p.before is not None and p.after is not None]
        if places:
            before = sum(p.before or 0.0 for p in places) / len(places)
            after = sum(p.after or 0.0 for p in places) / len(places)
            self.write(5, quantity(1e3 * before, "mN", 3), quantity(1e3 * after, "mN", 3))
        self.felt_words.setText(say_felt(change))
        self.felt_words.setVisible(True)
        largest = change.largest
        if largest is not None:
            set_tone(self.cells[5][1], "good" if abs(largest) <= LITTLE else "warning")

    def show_assessment(self) -> None:
        assessment = self.context.assessment
        if assessment is None or assessment.report is None or assessment.comparison is None:
            return
        angle = assessment.report.smallest_angle_deg
        before = assessment.comparison.imported_angle
        self.write(2, degrees(before), degrees(angle))
        if angle is not None:
            set_tone(self.cells[2][1], "good" if angle >= GOOD_ANGLE else "warning")

    def write(self, row: int, before: str, after: str) -> None:
        self.cells[row][0].setText(before)
        self.cells[row][1].setText(after)

    def good_news(self) -> list[str]:
        organ, assessment = self.context.session.organ, self.context.assessment
        if organ.surface is None or assessment is None or assessment.report is None:
            return []
        angle = assessment.report.smallest_angle_deg
        news = []
        if angle is not None and angle >= GOOD_ANGLE:
            news.append(tr("Triangles are well shaped."))
        if assessment.tick_share is not None and assessment.tick_share <= TICK_SHARE:
            share = f"{100 * assessment.tick_share:.0f} %"
            news.append(tr("About {share} of a millisecond for every tick.").format(share=share))
        return news

    # ------------------------------------------------------------ doing

    def use_preset(self) -> None:
        button = self.sender()
        if isinstance(button, QPushButton):
            self.target.setValue(int(button.property("vertices")))
            self.decimate()

    def button_pressed(self) -> None:
        """Enter in the field does what the button does."""
        self.button.click()

    def decimate(self) -> None:
        self.target.interpretText()
        self.tasks.decimate(self.target.value())

    def decimate_within(self) -> None:
        self.error.enter()
        if self.error.shown is not None:
            self.tasks.decimate_within(self.error.shown)

    def use_imported(self) -> None:
        self.tasks.apply_slowly(UseImported())


def degrees(angle: float | None) -> str:
    return "–" if angle is None else f"{number(angle, 3)}°"


def say_felt(change: FeltChange) -> str:
    """In a sentence, which place has changed most."""
    if change.untold:
        return tr("What is felt was not compared: {reason}").format(reason=say(change.untold))
    largest = change.largest
    if largest is None:
        return tr("Nothing was felt at the places that were pressed.")
    return tr("Pressed at {places} places: by {change} at most.").format(
        places=count(len(change.places)), change=f"{100.0 * largest:+.1f} %"
    )
