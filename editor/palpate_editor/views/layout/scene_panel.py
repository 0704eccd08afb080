# SPDX-License-Identifier: GPL-3.0-or-later
"""The panel of the Scene stage: add, place, pairs, checks, costs, publish."""

from __future__ import annotations

import palpate
from palpate.assessment.check_problem import Problem
from palpate.layout.check import Checked
from palpate.layout.document import Layout, Placed
from palpate.layout.separate import Separation
from palpate.translation.refusals import say_refusal
from PySide6.QtCore import QEvent, Signal
from PySide6.QtWidgets import QHBoxLayout, QPushButton, QVBoxLayout, QWidget

from palpate_editor.layout_shapes import Key, PartShape
from palpate_editor.views.budget import BODY, CONTACT, TOOL, Budget, Part
from palpate_editor.views.budget_bar import BudgetBar
from palpate_editor.views.layout.pair_rows import PairRows
from palpate_editor.views.layout.part_form import PartForm
from palpate_editor.views.layout.scene_form import SceneForm
from palpate_editor.views.layout.tool_form import ToolForm
from palpate_editor.views.stages.facts import CheckRow, Section, write_label
from palpate_editor.views.theme import Colours, title_font
from palpate_editor.views.translations import tr

TONES = {"error": "bad", "warning": "warning", "note": "faint"}
RANKS = ("error", "warning", "note")


class ScenePanel(QWidget):
    """Shows a layout and says what is wanted of it."""

    add_wanted = Signal(str)
    """organ, stone or scenery."""
    apart_wanted = Signal()
    look_wanted = Signal(object)
    """A Separation."""
    measure_wanted = Signal()
    publish_wanted = Signal()

    def __init__(self, colours: Colours, parent: QWidget | None = None):
        super().__init__(parent)
        self.setObjectName("stage_page")
        self.colours = colours
        column = QVBoxLayout(self)
        column.setContentsMargins(16, 12, 16, 14)
        column.setSpacing(8)
        title = write_label(tr("Scene"), "title", self)
        title.setFont(title_font(self.font(), 1.45))
        column.addWidget(title)
        lead = write_label(
            tr("Place published organs, stones and scenery, and say which may touch."), "lead", self
        )
        lead.setWordWrap(True)
        column.addWidget(lead)
        adding = QHBoxLayout()
        for kind, words in (
            ("organ", tr("Add an organ…")),
            ("stone", tr("A stone…")),
            ("scenery", tr("Scenery…")),
        ):
            button = QPushButton(words, self)
            button.setObjectName(f"add_{kind}")
            button.clicked.connect(self._add)
            adding.addWidget(button)
        column.addLayout(adding)
        chosen = Section(tr("Chosen"), self)
        self.form = PartForm(self)
        chosen.add(self.form)
        column.addWidget(chosen)
        said = Section(tr("Title, task and surroundings"), self)
        self.scene_form = SceneForm(self)
        said.add(self.scene_form)
        touched = Section(tr("Instrument"), self)
        self.tool_form = ToolForm(self)
        touched.add(self.tool_form)
        touching = Section(tr("What may touch"), self)
        self.pairs = PairRows(self)
        touching.add(self.pairs)
        column.addWidget(touching)
        column.addWidget(touched)
        self.checks = Section(tr("Checks"), self)
        self.rows: list[CheckRow] = []
        column.addWidget(self.checks)
        costs = Section(tr("Cost of a tick"), self)
        self.budget = BudgetBar(tr("Each pair is pressed together to measure it."), self)
        costs.add(self.budget)
        self.measure = QPushButton(tr("Press each pair"), self)
        self.measure.setObjectName("measure")
        self.measure.clicked.connect(self.measure_wanted)
        costs.add(self.measure)
        column.addWidget(costs)
        column.addWidget(said)
        column.addStretch(1)
        self.publish = QPushButton(tr("Publish the scene…"), self)
        self.publish.setObjectName("publish_scene")
        self.publish.setProperty("main", True)
        self.publish.clicked.connect(self.publish_wanted)
        column.addWidget(self.publish)

    def show_layout(
        self, layout: Layout, shapes: dict[Key, PartShape], part: Placed | None
    ) -> None:
        self.form.show_part(layout, shapes, part)
        self.pairs.show_layout(layout)
        self.tool_form.show_layout(layout)
        self.scene_form.show_layout(layout)

    def show_checked(self, checked: Checked | None) -> None:
        """The gravest first; None while nothing is known."""
        problems = [] if checked is None else sorted(checked.problems, key=rank)
        places: dict[int, Separation] = {} if checked is None else find_places(checked)
        entries: list[tuple[str, str, Separation | None]] = [
            (TONES[p.severity], f"{p.where}: {say_refusal(p.message)}", places.get(id(p)))
            for p in problems
        ]
        if checked is None:
            entries = [("faint", tr("Being checked."), None)]
        elif not entries:
            entries = [("good", tr("Nothing is wrong with this scene."), None)]
        while len(self.rows) < len(entries):
            row = CheckRow(self)
            row.fix_wanted.connect(self._part)
            row.look_wanted.connect(self.look_wanted)
            self.rows.append(row)
            self.checks.add(row)
        for index, row in enumerate(self.rows):
            row.setVisible(index < len(entries))
            if index < len(entries):
                tone, words, place = entries[index]
                fix = place if place is not None and place.shift is not None else None
                row.show_check(tone, words, self.colours, fix, tr("Move apart"), place)

    def show_costs(self, checked: Checked, layout: Layout) -> None:
        """What each pair takes of a tick while it is pressed together; of stones and scenery beside
        one organ, what every part takes while that is pressed."""
        scene = checked.scene
        if scene is not None and checked.press is not None:
            self.budget.show_budget(read_press(checked.press, layout, scene.rate))
            return
        if scene is None or not checked.costs:
            self.budget.wait(tr("No two that may touch are near enough to be pressed together."))
            return
        parts = []
        for index, cost in checked.costs.items():
            pair = scene.body_pairs[index]
            names = (layout.bodies[pair.first].name, layout.bodies[pair.second].name)
            words = tr("{one} and {other}").format(one=names[0], other=names[1])
            parts.append(Part(CONTACT, index, words, cost.pair_median, cost.pair_p99))
        worst = max(checked.costs.values(), key=lambda cost: cost.tick_p99)
        self.budget.show_budget(
            Budget(tuple(parts), worst.tick_median, worst.tick_p99, 1.0 / scene.rate)
        )

    def event(self, event: QEvent) -> bool:
        """As high as its words are when they are wrapped, which a scroll area does not ask for."""
        done = super().event(event)
        if event.type() in (QEvent.Type.LayoutRequest, QEvent.Type.Resize):
            self.setMinimumHeight(self.layout().totalHeightForWidth(self.width()))
        return done

    def _add(self) -> None:
        self.add_wanted.emit(self.sender().objectName().removeprefix("add_"))

    def _part(self, fix: object) -> None:
        del fix
        self.apart_wanted.emit()


def read_press(costs: palpate.SceneCosts, layout: Layout, rate: float) -> Budget:
    """The parts of a scene without pairs: organs, stones, and what scenery stops."""
    both = tr("{one} and {other}")
    stopped = [
        both.format(one=body, other=scenery.name)
        for scenery in layout.scenery
        for body in scenery.stops
    ]
    named = [
        (BODY, body.name, cost) for body, cost in zip(layout.bodies, costs.bodies, strict=True)
    ]
    named += [(TOOL, tr("Tool"), cost) for cost in costs.instruments]
    if layout.stones:
        stones = ", ".join(stone.name for stone in layout.stones)
        named.append((CONTACT, stones, costs.rigid))
    named += [(CONTACT, name, cost) for name, cost in zip(stopped, costs.scenery, strict=True)]
    parts = tuple(
        Part(kind, index, name, cost.median, cost.p99)
        for index, (kind, name, cost) in enumerate(named)
    )
    whole = costs.tick
    return Budget(parts, whole.median, whole.p99, 1.0 / rate, alarm=bool(costs.alarm))


def rank(problem: Problem) -> int:
    return RANKS.index(problem.severity)


def find_places(checked: Checked) -> dict[int, Separation]:
    """Of the problems that tell of a separation, that separation."""
    return {id(problem): separation for problem, separation in checked.separations}
