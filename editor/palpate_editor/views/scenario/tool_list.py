# SPDX-License-Identifier: GPL-3.0-or-later
"""The instruments of a task: what each is, where it passes the wall, how it rubs and closes."""

from __future__ import annotations

from palpate.assessment import author_tools
from palpate.assessment.author import Json
from palpate.assessment.instruments import SHAPES
from palpate.scene.instrument_kinds import KINDS
from PySide6.QtWidgets import QHBoxLayout, QMenu, QPushButton, QSizePolicy, QVBoxLayout, QWidget

from palpate_editor.views.scenario.band_row import NumberRow
from palpate_editor.views.scenario.step_form import Choice
from palpate_editor.views.scenario.task_draft import TaskDraft
from palpate_editor.views.scenario.words import say_tool_kind
from palpate_editor.views.stages.facts import write_label
from palpate_editor.views.translations import tr

OWN = ""
"""The kind of an instrument that has the organ's own tip."""
USUAL_HEIGHT = 0.15
"""[m] of a trocar over the organ, where an assessment says none."""


class ToolRow(QWidget):
    """One of them: its kind, and the numbers that this kind has."""

    def __init__(self, name: str, said: Json, draft: TaskDraft, parent: QWidget | None = None):
        super().__init__(parent)
        self.draft, self.name = draft, name
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 6)
        row = QHBoxLayout()
        row.setSpacing(6)
        row.addWidget(write_label(name, "name", self), 1)
        self.kind = Choice(self)
        self.kind.setObjectName(f"kind_{name}")
        self.kind.setAccessibleName(tr("Kind of {name}").format(name=name))
        own = not SHAPES & set(said)
        self.shown = OWN if own else str(said["kind"])
        if own:
            self.kind.addItem(draft.own_words, OWN)
        for kind in KINDS:
            self.kind.addItem(say_tool_kind(kind), kind)
        self.kind.setCurrentIndex(self.kind.findData(self.shown))
        self.kind.activated.connect(self._set_kind)
        row.addWidget(self.kind)
        remove = QPushButton(tr("Remove"), self)
        remove.setObjectName(f"remove_tool_{name}")
        remove.setProperty("small", True)
        remove.setEnabled(len(draft.tools) > 1)
        remove.clicked.connect(self._remove)
        row.addWidget(remove)
        column.addLayout(row)
        self.numbers: dict[str, NumberRow] = {}
        if not own:
            self._build_numbers(said, column)

    def _build_numbers(self, said: Json, column: QVBoxLayout) -> None:
        friction = said.get("friction", self.draft.usual_friction)
        self._number(column, "friction", tr("Friction"), "", 1.0, 0.05, (0, 20), friction)
        if "grip_force_N" in said:
            self._number(column, "grip_force_N", tr("Grip force"), "N", 1.0, 0.5, (1, 40),
                         said["grip_force_N"])  # fmt: skip
        if not said.get("length_m"):
            return
        if "trocar_m" not in said:
            height = said.get("trocar_height_m", USUAL_HEIGHT)
            self._number(column, "trocar_height_m", tr("Trocar height"), "mm", 1e-3, 10.0, (0, 30),
                         height)  # fmt: skip
            self._number(column, "trocar_side_m", tr("Trocar to the side"), "mm", 1e-3, 10.0,
                         (-15, 15), said.get("trocar_side_m", 0.0))  # fmt: skip
        self._number(column, "fulcrum_m", tr("Tip to handle"), "mm", 1e-3, 20.0, (0, 25),
                     said.get("fulcrum_m", 0.0))  # fmt: skip

    def _number(
        self, column: QVBoxLayout, member: str, text: str, unit: str, scale: float, step: float,
        ends: tuple[int, int], value: object,
    ) -> None:  # fmt: skip
        row = NumberRow(f"{member}_{self.name}", text, unit, scale, step, ends[1], self)
        row.slider.setMinimum(ends[0])
        row.show_value(value)
        row.setProperty("member", member)
        row.entered.connect(self._set_number)
        column.addWidget(row)
        self.numbers[member] = row

    def _set_kind(self) -> None:
        kind = str(self.kind.currentData())
        self.kind.setCurrentIndex(self.kind.findData(self.shown))  # what is refused stays as it was
        if kind != OWN:
            self.draft.change("tool", author_tools.set_kind, self.name, kind)

    def _set_number(self, value: float) -> None:
        member = str(self.sender().property("member"))
        # none of a handle is the tip, whatever was before
        gone = member == "fulcrum_m" and value == 0.0
        values = {member: None if gone else value}
        self.draft.change("tool", author_tools.set_tool, self.name, values)

    def _remove(self) -> None:
        self.draft.change("tool", author_tools.remove_tool, self.name)


class ToolList(QWidget):
    """All of them, and a way to one more."""

    def __init__(self, draft: TaskDraft, parent: QWidget | None = None):
        super().__init__(parent)
        self.draft = draft
        self.column = QVBoxLayout(self)
        self.column.setContentsMargins(0, 0, 0, 0)
        self.rows: list[ToolRow] = []
        self._shown: dict[str, Json] | None = None
        self.add = QPushButton(tr("Add an instrument"), self)
        self.add.setObjectName("add_tool")
        menu = QMenu(self.add)
        for kind in KINDS:
            action = menu.addAction(say_tool_kind(kind))
            action.setObjectName(f"add_tool_{kind}")
            action.setData(kind)
        menu.triggered.connect(self._add)
        self.add.setMenu(menu)
        self.column.addWidget(self.add)
        draft.shown.connect(self.show_draft)

    def show_draft(self) -> None:
        tools = self.draft.tools
        self.add.setEnabled(bool(tools))
        if tools == self._shown:
            return
        self._shown = tools
        for row in self.rows:
            row.hide()
            row.deleteLater()
        self.rows = [ToolRow(name, said, self.draft, self) for name, said in tools.items()]
        for number, row in enumerate(self.rows):
            self.column.insertWidget(number, row)

    def _add(self, action: object) -> None:
        kind = str(action.data())  # type: ignore[attr-defined]
        if self.draft.assessment is not None:
            name = author_tools.name_tool(self.draft.assessment, kind)
            self.draft.change("tool", author_tools.set_kind, name, kind)
