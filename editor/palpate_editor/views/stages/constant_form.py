# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields for the numbers and laws of a document, made from the one table of constants."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QComboBox, QGridLayout, QWidget

from palpate_editor.comparison import COMPARED_KINDS, FRONT_KINDS, say_error
from palpate_editor.document import Organ
from palpate_editor.document.constants import (
    CHOICES,
    LAW_NAMES,
    VALUE_NAMES,
    Constant,
    counts_choice,
    find_constant,
)
from palpate_editor.document.idle import Idle, find_idle
from palpate_editor.edits import EditError, SetChoice, SetConstant
from palpate_editor.views.context import Context
from palpate_editor.views.quantity_box import QuantityBox, QuantityRow
from palpate_editor.views.stages.drag_label import DragLabel
from palpate_editor.views.stages.facts import write_label
from palpate_editor.views.translations import say, tr

LABEL_WIDTH = 112
"""[px] so that all sections line up."""
WALL = 2e-3
"""[m] that a hollow organ begins with."""


def choice_text(value: str) -> str:
    """What a law is called."""
    return str(say(VALUE_NAMES.get(value, value)))


def say_idle(idle: Idle) -> str:
    """Why a number has no effect, as its field says it."""
    return tr("Has no effect here: {why}. {where}").format(why=say(idle.why), where=say(idle.where))


class ConstantField(QuantityRow):
    """One number of the document."""

    def __init__(self, context: Context, constant: Constant, parent: QWidget | None = None):
        box = QuantityBox(constant.unit, constant.scale)
        super().__init__(box, self.tick_text(constant), parent)
        self.context, self.constant = context, constant
        self.label = DragLabel(say(constant.label), "name", parent)
        self.label.setMinimumWidth(LABEL_WIDTH)
        self.label.setBuddy(box)
        self.label.dragged.connect(self.drag)
        self.label.dropped.connect(self.drop)
        box.setObjectName(constant.key)
        box.setAccessibleName(say(constant.label))
        if constant.field == "wall_thickness":
            self.default = WALL
        self.entered.connect(self.enter)

    @staticmethod
    def tick_text(constant: Constant) -> str | None:
        if not constant.optional:
            return None
        return tr("hollow") if constant.field == "wall_thickness" else tr("own value")

    def find_dragged(self, factor: float) -> float | None:
        """The value that a drag by so much gives, to three digits; None where there is none."""
        organ = self.context.session.organ
        value = getattr(getattr(organ, self.constant.part), self.constant.field)
        if value is None or not self.box.isEnabled():
            return None
        wanted = float(f"{factor * value:.3g}")
        return float(round(wanted)) if self.constant.whole else wanted

    def drag(self, factor: float) -> None:
        """Shows what it would be; those who listen to `dragged` are told the organ."""
        value = self.find_dragged(factor)
        if value is None or not self.constant.allows(value):
            return
        self.box.show_value(value)
        try:
            edit = SetConstant(self.constant.part, self.constant.field, value)
            self.context.dragged.emit(edit(self.context.session.organ))
        except EditError:
            return  # a drag back to where it was changes nothing

    def drop(self, factor: float) -> None:
        """One edit, whatever way the drag went."""
        value = self.find_dragged(factor)
        organ = self.context.session.organ
        self.show_organ(organ)
        if value is not None and self.constant.allows(value):
            self.enter(value)
        self.context.dragged.emit(self.context.session.organ)

    def enter(self, value: float | None) -> None:
        edit = SetConstant(self.constant.part, self.constant.field, value)
        if not self.context.apply(edit):
            self.box.mark(True)

    def show_organ(self, organ: Organ) -> None:
        shown = self.constant.counts(organ.model)
        self.label.setVisible(shown)
        self.setVisible(shown)
        self.show_value(getattr(getattr(organ, self.constant.part), self.constant.field))
        idle = find_idle(self.constant, organ)
        self.label.setEnabled(idle is None)
        self.setEnabled(idle is None)
        why = say(self.constant.describe_range()) if idle is None else say_idle(idle)
        for widget in (self, self.label, self.box):
            widget.setToolTip(f"{say(self.constant.label)}: {why}")


class ChoiceField(QComboBox):
    """One law of the model."""

    def __init__(self, context: Context, field: str, parent: QWidget | None = None):
        super().__init__(parent)
        self.context, self.field = context, field
        label = str(say(LAW_NAMES[field]))
        self.values: list[str | None] = [*CHOICES[f"model.{field}"]]
        if field == "kind":
            # None is the line, and what stands in it
            self.values = [*FRONT_KINDS, None, None, *COMPARED_KINDS]
        for value in self.values:
            self.add_choice(value)
        self.setObjectName(f"model.{field}")
        self.setAccessibleName(label)
        self.label = write_label(label, "name", parent)
        self.label.setMinimumWidth(LABEL_WIDTH)
        self.activated.connect(self.enter)

    def add_choice(self, value: str | None) -> None:
        row = self.count()
        if value is None and self.values[row - 1] is not None:
            self.insertSeparator(row)
        elif value is None:
            self.addItem(tr("For comparison"))
            self.setItemData(row, 0, Qt.ItemDataRole.UserRole - 1)  # not to be chosen
        else:
            self.addItem(choice_text(value))
            error = say_error(value) if self.field == "kind" else None
            if error is not None:
                self.setItemData(row, str(say(error)), Qt.ItemDataRole.ToolTipRole)

    def enter(self, row: int) -> None:
        value = self.values[row]
        if value is None or value == getattr(self.context.session.organ.model, self.field):
            return
        self.context.apply(SetChoice(self.field, value))
        self.show_organ(self.context.session.organ)

    def show_organ(self, organ: Organ) -> None:
        value = getattr(organ.model, self.field)
        if value in self.values:
            self.setCurrentIndex(self.values.index(value))
        shown = counts_choice(self.field, organ.model)
        self.label.setVisible(shown)
        self.setVisible(shown)

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Scrolling the form must not change laws on the way."""
        event.ignore()


def build_grid(
    context: Context, keys: Sequence[str], parent: QWidget
) -> tuple[QGridLayout, list[ConstantField]]:
    """Labels and fields of some constants, one under the other."""
    grid = QGridLayout()
    grid.setHorizontalSpacing(12)
    grid.setVerticalSpacing(6)
    grid.setColumnStretch(1, 1)
    fields = []
    for row, key in enumerate(keys):
        constant = find_constant(*key.split("."))
        assert constant is not None, key
        field = ConstantField(context, constant, parent)
        grid.addWidget(field.label, row, 0)
        grid.addWidget(field, row, 1)
        fields.append(field)
    return grid, fields
