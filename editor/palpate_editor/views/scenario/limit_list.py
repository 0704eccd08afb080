# SPDX-License-Identifier: GPL-3.0-or-later
"""The limits: what is measured, from where on it is wrong, and what that comes to."""

from __future__ import annotations

from palpate.assessment import author
from palpate.assessment.author import Json
from PySide6.QtWidgets import QHBoxLayout, QMenu, QPushButton, QVBoxLayout, QWidget

from palpate_editor.views.scenario.band_row import NumberRow
from palpate_editor.views.scenario.step_form import Choice
from palpate_editor.views.scenario.task_draft import TaskDraft
from palpate_editor.views.scenario.words import say_consequence, say_measure
from palpate_editor.views.stages.facts import write_label
from palpate_editor.views.translations import tr

SCALES = {
    "force": ("N", 1.0, 0.1, 60), "force_rate": ("N/s", 1.0, 1.0, 100),
    "depth": ("mm", 1e-3, 0.5, 80), "distance": ("mm", 1e-3, 0.5, 100),
    "speed": ("mm/s", 1e-3, 10.0, 100), "clearance": ("mm", 1e-3, 0.5, 60),
    "path.off": ("mm", 1e-3, 0.5, 60), "strain": ("%", 0.01, 1.0, 100),
    "object_force": ("N", 1.0, 0.1, 60), "pad_pressure": ("kPa", 1e3, 5.0, 80),
}  # fmt: skip
"""Unit, what that is in SI, one tick of a slider, and how many."""
AT_PLACE = ("contact",)
"""Measures that need a place, of those that can be added here."""
ADDED = (
    *("force", "contact", "depth", "speed", "distance", "force_rate", "strain", "out_of_view"),
    *("pad_pressure", "torn"),
)


class LimitRow(QWidget):
    """One of them."""

    def __init__(self, limit: Json, draft: TaskDraft, parent: QWidget):
        super().__init__(parent)
        self.draft, self.identity = draft, str(limit["id"])
        when = limit["when"]
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        row = QHBoxLayout()
        name = say_measure(str(when["measure"]))
        if "place" in when:
            name += " \N{MIDDLE DOT} " + draft.name_place(str(when["place"]))
        row.addWidget(write_label(name, "value", self), 1)
        self.then = Choice(self)
        self.then.setObjectName(f"then_{self.identity}")
        self.then.setAccessibleName(tr("What it comes to"))
        for then in author.CONSEQUENCES:
            self.then.addItem(say_consequence(then), then)
        self.then.setCurrentIndex(self.then.findData(limit["then"]))
        self.then.activated.connect(self._set_then)
        row.addWidget(self.then)
        remove = QPushButton(tr("Remove"), self)
        remove.setObjectName(f"remove_{self.identity}")
        remove.setProperty("small", True)
        remove.clicked.connect(self._remove)
        row.addWidget(remove)
        column.addLayout(row)
        self.end = "below" if "below" in when else "above"
        if self.end in when and when["measure"] in SCALES:
            text = tr("wrong below") if self.end == "below" else tr("wrong above")
            bound = NumberRow(f"bound_{self.identity}", text, *SCALES[when["measure"]], self)
            bound.show_value(when[self.end])
            bound.entered.connect(self._set_bound)
            column.addWidget(bound)

    def _set_bound(self, value: float) -> None:
        self.draft.change("limit", author.change_limit, self.identity, {self.end: value})

    def _set_then(self) -> None:
        then = self.then.currentData()
        self.draft.change("limit", author.change_limit, self.identity, {}, then)

    def _remove(self) -> None:
        self.draft.change("limit", author.remove_limit, self.identity)


class LimitList(QWidget):
    """All of them, and a way to a new one; one of contact is at the place of the chosen step."""

    def __init__(self, draft: TaskDraft, parent: QWidget | None = None):
        super().__init__(parent)
        self.draft = draft
        self.column = QVBoxLayout(self)
        self.column.setContentsMargins(0, 0, 0, 0)
        self.rows: list[LimitRow] = []
        self._shown: list[Json] | None = None
        self.add = QPushButton(tr("Add a limit"), self)
        self.add.setObjectName("add_limit")
        self.menu = QMenu(self.add)
        for measure in ADDED:
            if measure in AT_PLACE:
                self.of_contact = self.menu.addMenu(say_measure(measure))
                self.of_contact.aboutToShow.connect(self._list_regions)
                continue
            action = self.menu.addAction(say_measure(measure))
            action.setObjectName(f"add_limit_{measure}")
            action.setData(measure)
        self.menu.triggered.connect(self._add)
        self.add.setMenu(self.menu)
        self.column.addWidget(self.add)
        draft.shown.connect(self.show_draft)

    def show_draft(self) -> None:
        limits = self.draft.limits
        self.add.setEnabled(self.draft.assessment is not None)
        if limits == self._shown:
            return
        self._shown = limits
        for row in self.rows:
            row.hide()
            row.deleteLater()
        self.rows = [LimitRow(limit, self.draft, self) for limit in limits]
        for number, row in enumerate(self.rows):
            self.column.insertWidget(number, row)

    def _list_regions(self) -> None:
        self.of_contact.clear()
        for region in self.draft.regions:
            action = self.of_contact.addAction(region)
            action.setData(f"contact:{region}")

    def _add(self, action: object) -> None:
        measure, _, region = str(action.data()).partition(":")  # type: ignore[attr-defined]
        if self.draft.assessment is None:
            return
        made, values = self.draft.assessment, {}
        if region:
            made, place = author.add_place(made, region, self.draft.of_region(region))
            values = {"place": place}
        made, _ = author.add_limit(made, measure, values)
        words = ["--at", f"region:{region}"] if region else []
        self.draft.apply(made, "limit", "limit", "--add", measure, *words)
