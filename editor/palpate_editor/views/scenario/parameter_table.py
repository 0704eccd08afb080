# SPDX-License-Identifier: GPL-3.0-or-later
"""Named numbers that levels change and a seed draws, and where they stand for a bound."""

from __future__ import annotations

from palpate.assessment import author_values
from palpate.assessment.author import Json
from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QHBoxLayout,
    QHeaderView,
    QMenu,
    QPushButton,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from palpate_editor.views.scenario.limit_list import SCALES
from palpate_editor.views.scenario.step_form import OF_VERB
from palpate_editor.views.scenario.task_draft import TaskDraft
from palpate_editor.views.scenario.words import say_measure
from palpate_editor.views.translations import number, tr

ROW, MOST = 26, 6
NEW = {"N": ("force", 1.0), "m": ("length", 0.005), "s": ("time", 2.0)}
"""Unit of a new parameter, its name, and its value [SI]."""
SHOWN = {"m": ("mm", 1e-3)}
"""Units that people like better, and what they are in SI."""
SI_OF = {"N": "N", "mm": "m"}
"""Unit of a slider's row -> that of a parameter."""
LEVELS = ("easy", "normal", "hard")
CODE, EDITABLE = Qt.ItemDataRole.UserRole, Qt.ItemFlag.ItemIsEditable
USUAL = 3
"""Columns before those of the levels."""


class ParameterTable(QWidget):
    """A cell is an edit: 0.6 is a value, 0.4..0.8 is drawn between, a; b is one of them."""

    def __init__(self, draft: TaskDraft, parent: QWidget | None = None):
        super().__init__(parent)
        self.draft = draft
        self._writing = False
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self.table = QTableWidget(self)
        self.table.setObjectName("parameters")
        self.table.setAccessibleName(tr("Levels and parameters"))
        self.table.setToolTip(
            tr("0.6 is a value, 0.4..0.8 is drawn between the two, a; b is one of these")
        )
        self.table.verticalHeader().hide()
        self.table.cellChanged.connect(self._enter)
        self.table.currentCellChanged.connect(self._tell_buttons)
        column.addWidget(self.table)
        self.add = self._button("add_parameter", tr("Add a parameter"))
        self.remove = self._button("remove_parameter", tr("Remove"))
        self.use = self._button("use_parameter", tr("Use it as"))
        self.levels = self._button("change_levels", tr("Levels"))
        self.remove.clicked.connect(self._remove)
        self.menus: dict[str, QMenu] = {}
        for name, button, act in (
            ("add", self.add, self._add),
            ("use", self.use, self._use),
            ("levels", self.levels, self._change_level),
        ):
            menu = QMenu(button)
            menu.triggered.connect(act)
            button.setMenu(menu)
            self.menus[name] = menu
        row = QHBoxLayout()
        row.setSpacing(6)
        for button in (self.add, self.use, self.levels, self.remove):
            row.addWidget(button, 1)
        column.addLayout(row)
        self._fill_add()
        draft.shown.connect(self.show_draft)

    def _button(self, name: str, text: str) -> QPushButton:
        button = QPushButton(text, self)
        button.setObjectName(name)
        button.setProperty("small", True)
        return button

    # ------------------------------------------------------------ showing

    @property
    def rows(self) -> dict[str, Json]:
        draft = self.draft
        return {} if draft.assessment is None else dict(draft.assessment.get("parameters", {}))

    def chosen(self) -> str:
        """The parameter of the current row."""
        item = self.table.item(self.table.currentRow(), 0)
        return "" if item is None else str(item.data(CODE))

    def show_draft(self) -> None:
        self._writing = True
        levels, rows = self.draft.levels, self.rows
        self.table.setColumnCount(USUAL + len(levels))
        heads = [tr("Name"), tr("Unit"), tr("Value"), *levels]
        self.table.setHorizontalHeaderLabels(heads)
        self.table.setRowCount(len(rows))
        for line, (name, row) in enumerate(rows.items()):
            unit, scale = SHOWN.get(str(row.get("unit")), (str(row.get("unit")), 1.0))
            cells = [name, unit, say_values(row, scale)]
            known = row.get("levels", {})
            cells += [number(known[code] / scale, 4) if code in known else "" for code in levels]
            for column, text in enumerate(cells):
                item = QTableWidgetItem(text)
                item.setData(CODE, name)
                fixed = column == 1 or (column >= USUAL and "value" not in row)
                if fixed:
                    item.setFlags(item.flags() & ~EDITABLE)
                self.table.setItem(line, column, item)
        self.table.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        self.table.setFixedHeight(ROW * (min(max(len(rows), 1), MOST) + 1) + 12)
        self.table.setVisible(bool(rows) or bool(levels))
        self._writing = False
        self._tell_buttons()

    def _tell_buttons(self, *_: int) -> None:
        chosen = bool(self.chosen())
        self.remove.setEnabled(chosen)
        self._fill_use()
        self._fill_levels()
        self.use.setEnabled(bool(self.menus["use"].actions()))

    # ------------------------------------------------------------ changing

    def _change(self, act: object, *arguments: object) -> None:
        self.draft.change("parameter", act, *arguments)

    def _enter(self, line: int, column: int) -> None:
        if self._writing:
            return
        item = self.table.item(line, column)
        name, text = str(item.data(CODE)), item.text().strip()
        row = self.rows.get(name, {})
        scale = SHOWN.get(str(row.get("unit")), ("", 1.0))[1]
        if column == 0:
            if text != name:
                self._change(author_values.rename_parameter, name, text)
        elif column == 2:
            values = read_values(text, scale, places=row.get("unit") == "place")
            if values:
                self._change(author_values.set_parameter, name, values)
        else:
            value = read_number(text)
            level = self.draft.levels[column - USUAL]
            if value is not None or not text:
                told = None if value is None else round(value * scale, 9)
                self._change(author_values.set_level_value, name, level, told)
        self.show_draft()  # what was refused is taken back

    def _fill_add(self) -> None:
        for unit in NEW:
            action = self.menus["add"].addAction(SHOWN.get(unit, (unit, 1.0))[0])
            action.setObjectName(f"parameter_{unit}")
            action.setData(unit)

    def _add(self, action: object) -> None:
        unit = str(action.data())  # type: ignore[attr-defined]
        base, value = NEW[unit]
        if self.draft.assessment is None:
            return
        name = author_values.name_parameter(self.draft.assessment, base)
        self._change(author_values.set_parameter, name, {"unit": unit, "value": value})
        self.table.setCurrentCell(len(self.rows) - 1, 0)

    def _remove(self) -> None:
        self._change(author_values.remove_parameter, self.chosen())

    def _fill_use(self) -> None:
        """The ends of bands of the chosen step, and the limits, that have its unit."""
        menu, unit = self.menus["use"], str(self.rows.get(self.chosen(), {}).get("unit"))
        menu.clear()
        step = self.draft.step
        for member in OF_VERB.get("" if step is None else str(step.get("do")), ()):
            if author_values.BANDS[member] != unit or step is None:
                continue
            for end, said in enumerate((tr("least of the step"), tr("most of the step"))):
                action = menu.addAction(f"{member.partition('_')[0]}: {said}")
                action.setObjectName(f"use_{member}_{end}")
                action.setData(("step", member, end))
        for limit in self.draft.limits:
            measure = str(limit["when"]["measure"])
            if measure in SCALES and SI_OF.get(SCALES[measure][0]) == unit:
                text = tr("bound of the limit {name}").format(name=say_measure(measure))
                action = menu.addAction(text)
                action.setObjectName(f"use_limit_{limit['id']}")
                action.setData(("limit", limit["id"], unit))

    def _use(self, action: object) -> None:
        kind, where, more = action.data()  # type: ignore[attr-defined]
        if kind == "limit":
            self._change(author_values.use_in_limit, where, self.chosen(), more)
        else:
            step = self.draft.step or {}
            band = list(step.get(where, [None, None]))
            band[more] = f"${self.chosen()}"
            self.draft.set_step({where: band})

    def _fill_levels(self) -> None:
        menu, known = self.menus["levels"], self.draft.levels
        menu.clear()
        for level in [*LEVELS, *(code for code in known if code not in LEVELS)]:
            action = menu.addAction(level)
            action.setObjectName(f"level_{level}")
            action.setCheckable(True)
            action.setChecked(level in known)
            action.setData(level)

    def _change_level(self, action: object) -> None:
        level = str(action.data())  # type: ignore[attr-defined]
        known = level in self.draft.levels
        act = author_values.remove_level if known else author_values.add_level
        self.draft.change("level", act, level)


def say_values(row: Json, scale: float) -> str:
    """A number, two dots between what it is drawn from, or what it is chosen of."""
    if "uniform" in row:
        return "..".join(number(end / scale, 4) for end in row["uniform"])
    if "choose" in row:
        return "; ".join(
            each if isinstance(each, str) else number(each / scale, 4) for each in row["choose"]
        )
    return number(row.get("value", 0.0) / scale, 4)


def read_number(text: str) -> float | None:
    """With a point or a comma; None for anything else."""
    try:
        value = float(text.replace(",", "."))
    except ValueError:
        return None
    return value if abs(value) < float("inf") else None


def read_values(text: str, scale: float, places: bool) -> Json:
    """As say_values writes them, `places` by their names; nothing for what is none of these."""
    value = read_number(text)
    if value is not None:
        return {"value": round(value * scale, 9)}
    ends = [read_number(end) for end in text.split("..")]
    if len(ends) == 2 and None not in ends:
        return {"uniform": [round(end * scale, 9) for end in ends if end is not None]}
    parts = [part.strip() for part in text.split(";") if part.strip()]
    if not parts:
        return {}
    found = [read_number(part) for part in parts]
    if places or None in found:
        return {"choose": parts} if places else {}
    return {"choose": [round(each * scale, 9) for each in found if each is not None]}
