# SPDX-License-Identifier: GPL-3.0-or-later
"""The steps in their order: dragged, duplicated, muted, removed, and new ones."""

from __future__ import annotations

from palpate.assessment import author
from palpate.assessment.author import Json
from PySide6.QtCore import QModelIndex, Qt
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHBoxLayout,
    QListWidget,
    QListWidgetItem,
    QMenu,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from palpate_editor.views.scenario.task_draft import TaskDraft
from palpate_editor.views.scenario.words import say_row, say_verb
from palpate_editor.views.translations import tr

ROW, LEAST, MOST = 26, 2, 8
"""[px] height of a row, and how many are seen at once."""
ID = Qt.ItemDataRole.UserRole


class StepList(QWidget):
    """Every row is a step; the one that is chosen stands in the form."""

    def __init__(self, draft: TaskDraft, parent: QWidget | None = None):
        super().__init__(parent)
        self.draft = draft
        self._writing = False
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self.list = QListWidget(self)
        self.list.setObjectName("steps")
        self.list.setAccessibleName(tr("Steps"))
        self.list.setDragDropMode(QAbstractItemView.DragDropMode.InternalMove)
        self.list.setToolTip(tr("Drag a step to another place in the order"))
        self.list.currentItemChanged.connect(self._choose)
        self.list.model().rowsMoved.connect(self._order)
        column.addWidget(self.list)
        row = QHBoxLayout()
        row.setSpacing(6)
        self.add = self._button("add_step", tr("Add a step"))
        self.menu = QMenu(self.add)
        self.menu.setObjectName("verbs")
        for verb in author.VERBS:
            action = self.menu.addAction(say_verb(verb))
            action.setObjectName(f"add_{verb}")
            action.setData(verb)
        self.menu.triggered.connect(self._add)
        self.add.setMenu(self.menu)
        self.duplicate = self._button("duplicate_step", tr("Duplicate"))
        self.mute = self._button("mute_step", tr("Mute"))
        self.remove = self._button("remove_step", tr("Remove"))
        self.duplicate.clicked.connect(self._duplicate)
        self.mute.clicked.connect(self._mute)
        self.remove.clicked.connect(self._remove)
        self.mute.setToolTip(tr("A muted step stays here, and is not published"))
        row.addWidget(self.add, 2)
        for button in (self.duplicate, self.mute, self.remove):
            button.setProperty("small", True)
            row.addWidget(button, 1)
        column.addLayout(row)
        draft.shown.connect(self.show_draft)

    def _button(self, name: str, text: str) -> QPushButton:
        button = QPushButton(text, self)
        button.setObjectName(name)
        return button

    def show_draft(self) -> None:
        self._writing = True
        steps = self.draft.steps
        self.list.clear()
        for number, step in enumerate(steps, start=1):
            self.list.addItem(self._write(number, step))
            if step["id"] == self.draft.step_id:
                self.list.setCurrentRow(number - 1)
        self.list.setFixedHeight(ROW * min(max(len(steps), LEAST), MOST) + 8)
        chosen = self.draft.step
        for button in (self.duplicate, self.mute, self.remove):
            button.setEnabled(chosen is not None)
        for action in self.menu.actions():
            action.setVisible(action.data() in self.draft.verbs)
        muted = chosen is not None and bool(chosen.get("muted"))
        self.mute.setText(tr("Unmute") if muted else tr("Mute"))
        self._writing = False

    def _write(self, number: int, step: Json) -> QListWidgetItem:
        item = QListWidgetItem(f"{number}. {say_row(step, self.draft)}")
        item.setData(ID, step["id"])
        item.setToolTip(item.text())
        if step.get("muted"):
            font = item.font()
            font.setStrikeOut(True)
            item.setFont(font)
        return item

    def _choose(self, item: QListWidgetItem | None) -> None:
        if item is not None and not self._writing:
            self.draft.choose(item.data(ID))

    def _order(
        self, source: QModelIndex, start: int, end: int, target: QModelIndex, row: int
    ) -> None:
        """A step was dropped in front of another row, or behind the last."""
        del source, end, target
        if not self._writing:
            to = row - 1 if row > start else row
            self.draft.change("order", author.move_step, self.draft.steps[start]["id"], to)

    def _add(self, action: object) -> None:
        self.draft.add_step(action.data())  # type: ignore[attr-defined]

    def _duplicate(self) -> None:
        made = self.draft.change("duplicate", author.duplicate_step, self.draft.step_id)
        if made is not None:
            self.draft.choose(made)

    def _mute(self) -> None:
        step = self.draft.step
        if step is not None:
            muted = not step.get("muted")
            self.draft.change("mute", author.mute_step, self.draft.step_id, muted)

    def _remove(self) -> None:
        self.draft.change("remove", author.remove_step, self.draft.step_id)
