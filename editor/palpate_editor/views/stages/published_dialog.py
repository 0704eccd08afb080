# SPDX-License-Identifier: GPL-3.0-or-later
"""All published values of a tissue in a table, to which a designer adds those of other sources."""

from __future__ import annotations

from palpate.files.refusal import Refusal
from palpate.viewport.screen import fit_to_screen
from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QColor
from PySide6.QtWidgets import (
    QAbstractItemView,
    QComboBox,
    QDialog,
    QGridLayout,
    QHBoxLayout,
    QHeaderView,
    QLineEdit,
    QPushButton,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from palpate_editor.app.spoken import say_tissue
from palpate_editor.document.constants import find_constant
from palpate_editor.edits import EditError
from palpate_editor.own_values import (
    QUANTITIES,
    OwnValue,
    find_fault,
    find_file,
    read_own_values,
    write_own_values,
)
from palpate_editor.tissue_library import LibraryTissue, Value, read_library
from palpate_editor.views.context import Context
from palpate_editor.views.quantity_box import QuantityBox, QuantityRow
from palpate_editor.views.shipped_organs import name_tissue
from palpate_editor.views.stages.facts import write_label
from palpate_editor.views.translations import number, say, tr

SIZE = QSize(1080, 560)
OWN = Qt.ItemDataRole.UserRole


class PublishedDialog(QDialog):
    """Stays open beside the form, so that numbers can be read from it."""

    changed = Signal()
    """A value was added or removed."""

    def __init__(self, context: Context, parent: QWidget | None = None):
        super().__init__(parent)
        self.setObjectName("published_dialog")
        self.context, self.tissues = context, list_library()
        self.own: tuple[OwnValue, ...] = ()
        self.setWindowTitle(tr("Published values"))
        column = QVBoxLayout(self)
        column.setSpacing(8)
        self.tissue = QComboBox(self)
        self.tissue.setAccessibleName(tr("Tissue to look up"))
        self.tissue.addItems([name_tissue(tissue.name, tissue.title) for tissue in self.tissues])
        self.tissue.currentIndexChanged.connect(self.fill)
        column.addWidget(self.tissue)
        column.addWidget(self.build_table(), 1)
        self.note = write_label("", "note", self)
        self.note.setWordWrap(True)
        column.addWidget(self.note)
        column.addLayout(self.build_form())
        self.read()

    def build_table(self) -> QTableWidget:
        self.table = QTableWidget(0, 6, self)
        self.table.setObjectName("published_table")
        titles = [tr("Constant"), tr("Range"), tr("Measured by"), tr("Source")]
        titles += [tr("In, at a rate of"), tr("Status")]
        self.table.setHorizontalHeaderLabels(titles)
        self.table.verticalHeader().hide()
        self.table.setWordWrap(True)
        self.table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.table.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        header = self.table.horizontalHeader()
        for column in (0, 1, 4, 5):
            header.setSectionResizeMode(column, QHeaderView.ResizeMode.ResizeToContents)
        for column in (2, 3):
            header.setSectionResizeMode(column, QHeaderView.ResizeMode.Stretch)
        self.table.itemSelectionChanged.connect(self.show_use)
        return self.table

    def build_form(self) -> QGridLayout:
        """What another publication says, and the buttons."""
        grid = QGridLayout()
        grid.setHorizontalSpacing(8)
        self.quantity = QComboBox(self)
        self.quantity.setObjectName("published_quantity")
        self.quantity.addItems([say_quantity(name) for name in QUANTITIES])
        self.quantity.currentIndexChanged.connect(self.build_range)
        self.range = QHBoxLayout()
        self.method, self.source = QLineEdit(self), QLineEdit(self)
        for field, name, cells in (
            (self.method, "published_method", tr("Measured by")),
            (self.source, "published_source", tr("Source: authors, journal, year")),
        ):
            field.setObjectName(name)
            field.setPlaceholderText(cells)
        self.source.returnPressed.connect(self.add)
        self.add_button = QPushButton(tr("Add"), self)
        self.add_button.setObjectName("add_published")
        self.add_button.setAutoDefault(False)
        self.add_button.clicked.connect(self.add)
        self.remove_button = QPushButton(tr("Remove"), self)
        self.remove_button.setObjectName("remove_published")
        self.remove_button.setAutoDefault(False)
        self.remove_button.clicked.connect(self.remove)
        grid.addWidget(self.quantity, 0, 0)
        grid.addLayout(self.range, 0, 1)
        grid.addWidget(self.remove_button, 0, 2)
        grid.addWidget(self.method, 1, 0)
        grid.addWidget(self.source, 1, 1)
        grid.addWidget(self.add_button, 1, 2)
        grid.setColumnStretch(1, 1)
        self.build_range()
        return grid

    def build_range(self) -> None:
        """Two fields in the unit of the constant that is chosen."""
        while self.range.count():
            widget = self.range.takeAt(0).widget()
            if widget is not None:
                widget.deleteLater()
        constant = find_constant("material", QUANTITIES[self.quantity.currentIndex()])
        assert constant is not None
        self.low, self.high = (QuantityBox(constant.unit, constant.scale, self) for _ in range(2))
        for box, name in ((self.low, "published_low"), (self.high, "published_high")):
            box.setObjectName(name)
            box.show_value(None)
            box.entered.connect(box.show_value)
            self.range.addWidget(QuantityRow(box, parent=self))

    # ------------------------------------------------------------ showing

    def show_tissue(self, row: int) -> None:
        """Opens on a tissue."""
        self.tissue.setCurrentIndex(row)
        fit_to_screen(self, SIZE)
        self.show()
        self.raise_()

    def read(self) -> None:
        try:
            self.own = read_own_values(find_file())
        except (Refusal, OSError) as problem:
            self.context.refuse(problem)
        self.fill()

    def fill(self) -> None:
        tissue = self.tissues[self.tissue.currentIndex()]
        mine = [value for value in self.own if value.tissue == tissue.name]
        self.table.setRowCount(len(tissue.values) + len(mine))
        for row, found in enumerate([*tissue.values, *mine]):
            is_own = isinstance(found, OwnValue)
            cells = (
                say_quantity(found.quantity),
                say_range(found.quantity, found.low, found.high),
                found.method if is_own else say_tissue(found.method),
                found.source,
                *(("", tr("your own")) if is_own else say_trust(found)),
            )
            for column, text in enumerate(cells):
                item = QTableWidgetItem(text)
                item.setToolTip(text)
                item.setData(OWN, found if is_own else None)
                if not is_own and found.status != "checked":
                    item.setForeground(QColor(self.context.colours.warning))
                self.table.setItem(row, column, item)
        self.table.resizeRowsToContents()
        self.note.setText(say_tissue(tissue.note))
        self.show_use()

    def chosen(self) -> OwnValue | None:
        """The row that is chosen, where a designer added it."""
        items = self.table.selectedItems()
        return items[0].data(OWN) if items else None

    def show_use(self) -> None:
        """What ships cannot be removed."""
        self.remove_button.setEnabled(self.chosen() is not None)
        why = tr("Values that ship with Palpate stay; choose one of your own.")
        self.remove_button.setToolTip("" if self.chosen() is not None else why)

    # ------------------------------------------------------------ doing

    def add(self) -> None:
        self.low.enter()
        self.high.enter()
        low = self.low.shown
        high = low if self.high.shown is None else self.high.shown
        if low is None or high is None:
            self.context.tell(tr("A published value needs a number."), "warning")
            return
        value = OwnValue(
            self.tissues[self.tissue.currentIndex()].name,
            QUANTITIES[self.quantity.currentIndex()],
            low,
            high,
            self.method.text().strip(),
            self.source.text().strip(),
        )
        fault = find_fault(value)
        if fault is not None:
            self.context.refuse(EditError(fault))
            return
        if self.keep((*self.own, value)):
            self.method.clear()
            self.source.clear()
            self.build_range()

    def remove(self) -> None:
        gone = self.chosen()
        if gone is not None:
            self.keep(tuple(value for value in self.own if value is not gone))

    def keep(self, own: tuple[OwnValue, ...]) -> bool:
        try:
            write_own_values(find_file(), own)
        except (OSError, ValueError) as problem:
            self.context.refuse(problem)
            return False
        self.own = own
        self.fill()
        self.changed.emit()
        return True


def say_quantity(quantity: str) -> str:
    constant = find_constant("material", quantity)
    return quantity if constant is None else str(say(constant.label))


def list_library() -> list[LibraryTissue]:
    """As the form beside it has it, which has said what is wrong with a designer's own file."""
    try:
        return read_library()
    except (Refusal, OSError):
        return read_library(own=False)


def say_status(status: str) -> str:
    return {
        "checked": tr("checked in its source"),
        "recalled": tr("recalled, not looked up: no default"),
        "unknown": tr("unknown: no default"),
    }[status]


def say_trust(value: Value) -> tuple[str, str]:
    """In what and how fast it was measured, and how far it can be trusted."""
    known = [say_tissue(text) for text in (value.setting, value.rate) if text != "unknown"]
    short = {"checked": tr("checked"), "recalled": tr("recalled"), "unknown": tr("unknown")}
    return ", ".join(known) or tr("unknown"), short[value.status]


def say_range(quantity: str, low: float | None, high: float | None) -> str:
    """In the unit of the form's own field; a dash where no number is known."""
    if low is None or high is None:
        return "\N{EN DASH}"
    constant = find_constant("material", quantity)
    scale, unit = (1.0, "") if constant is None else (constant.scale, constant.unit)
    cells = number(low / scale, 3)
    if high != low:
        cells += f" \N{EN DASH} {number(high / scale, 3)}"
    return f"{cells}\N{NO-BREAK SPACE}{unit}"
