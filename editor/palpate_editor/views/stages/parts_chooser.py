# SPDX-License-Identifier: GPL-3.0-or-later
"""Which parts of a mesh file are used: found by name, told by size, shown before they are taken."""

from __future__ import annotations

from collections.abc import Mapping

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHBoxLayout,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from palpate_editor.appearance import fold
from palpate_editor.views.context import Context
from palpate_editor.views.stages.parts_preview import PartsPreview
from palpate_editor.views.tasks import Part
from palpate_editor.views.translations import count, number, tr

NAME = Qt.ItemDataRole.UserRole
ROWS = 6
SEARCHED = 6
"""Parts from which on there is a field to find them by."""


class PartsChooser(QWidget):
    """The list, what finds in it, and what it shows in the view."""

    changed = Signal()
    """Other parts are ticked."""

    def __init__(self, context: Context, parent: QWidget | None = None):
        super().__init__(parent)
        self.context = context
        self.known: dict[str, Part | None] = {}
        """By name; None for one whose file was not read in this window."""
        self.preview = PartsPreview(context, self)
        self.search = QLineEdit(self)
        self.search.setObjectName("find_part")
        self.search.setPlaceholderText(tr("Find a part by its name"))
        self.search.setClearButtonEnabled(True)
        self.search.textChanged.connect(self.find)
        self.list = self.build_list()
        self.show_button = QPushButton(tr("Show them"), self)
        self.show_button.setObjectName("show_parts")
        self.show_button.setCheckable(True)
        self.show_button.setToolTip(
            tr("The ticked parts in the view; the one under the pointer stands out")
        )
        self.show_button.toggled.connect(self.on_show)
        self.all_button, self.none_button = QPushButton(tr("All")), QPushButton(tr("None"))
        self.all_button.clicked.connect(self.tick_all)
        self.none_button.clicked.connect(self.tick_none)
        row = QHBoxLayout()
        for button in (self.all_button, self.none_button, self.show_button):
            button.setProperty("small", True)
            row.addWidget(button)
        row.addStretch(1)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.search)
        column.addWidget(self.list)
        column.addLayout(row)
        context.stage_shown.connect(self.on_stage)
        context.session.changed.connect(self.end_preview)

    def build_list(self) -> QListWidget:
        made = QListWidget(self)
        made.setObjectName("parts")
        made.setSelectionMode(QAbstractItemView.SelectionMode.NoSelection)
        made.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        made.setMouseTracking(True)
        made.itemChanged.connect(self.on_tick)
        made.itemEntered.connect(self.mark)
        made.currentItemChanged.connect(self.mark)
        made.viewport().installEventFilter(self)
        return made

    # ------------------------------------------------------------ filling

    def show_parts(self, parts: Mapping[str, Part | None], chosen: tuple[str, ...]) -> None:
        """Lists parts; none chosen means all."""
        self.end_preview()
        self.list.blockSignals(True)
        if list(parts.items()) != list(self.known.items()):
            self.fill(parts)
        for item in self.items():
            ticked = not chosen or item.data(NAME) in chosen
            item.setCheckState(Qt.CheckState.Checked if ticked else Qt.CheckState.Unchecked)
        self.list.blockSignals(False)
        rows = max(2, min(ROWS, len(parts)))
        self.list.setFixedHeight(rows * max(26, self.list.sizeHintForRow(0)) + 6)
        self.search.clear()
        self.search.setVisible(len(parts) >= SEARCHED)
        self.show_button.setVisible(any(part is not None for part in parts.values()))
        self.changed.emit()

    def fill(self, parts: Mapping[str, Part | None]) -> None:
        """A line for each of other parts than before."""
        self.known = dict(parts)
        self.list.clear()
        for name, part in parts.items():
            item = QListWidgetItem(name if part is None else f"{name}\n{describe(part)}")
            item.setData(NAME, name)
            item.setToolTip(item.text())
            item.setFlags(Qt.ItemFlag.ItemIsUserCheckable | Qt.ItemFlag.ItemIsEnabled)
            self.list.addItem(item)

    def items(self) -> list[QListWidgetItem]:
        return [self.list.item(i) for i in range(self.list.count())]

    def chosen(self) -> list[str]:
        """The names of the parts that are ticked."""
        ticked = Qt.CheckState.Checked
        return [str(i.data(NAME)) for i in self.items() if i.checkState() == ticked]

    def tick_all(self) -> None:
        self.tick(Qt.CheckState.Checked)

    def tick_none(self) -> None:
        self.tick(Qt.CheckState.Unchecked)

    def tick(self, state: Qt.CheckState) -> None:
        """All that the search has left in the list."""
        self.list.blockSignals(True)
        for item in self.items():
            if not item.isHidden():
                item.setCheckState(state)
        self.list.blockSignals(False)
        self.on_tick()

    def find(self, text: str) -> None:
        """Leaves those in the list whose name has the text, whatever its accents and capitals."""
        wanted = fold(text).strip() or text.strip().casefold()
        for item in self.items():
            name = str(item.data(NAME))
            item.setHidden(wanted not in fold(name) and wanted not in name.casefold())

    # ------------------------------------------------------------ in the view

    def on_tick(self, item: QListWidgetItem | None = None) -> None:
        del item
        self.changed.emit()
        if self.context.previewing:
            self.preview.show(self.ticked())

    def ticked(self) -> list[Part]:
        return [part for name in self.chosen() if (part := self.known[name]) is not None]

    def on_show(self, shown: bool) -> None:
        if shown:
            self.preview.show(self.ticked(), frame=True)
        else:
            self.preview.clear()

    def begin_preview(self) -> None:
        """Shows the parts of a file that cannot be used whole, to choose from."""
        self.show_button.setChecked(True)

    def end_preview(self, *_: object) -> None:
        self.show_button.setChecked(False)

    def on_stage(self, stage: str) -> None:
        if stage != "import":
            self.end_preview()

    def mark(self, item: QListWidgetItem | None, *_: object) -> None:
        """Highlights the part under the pointer, or that the keyboard has come to."""
        if not self.context.previewing or item is None:
            return
        self.preview.mark(self.known.get(str(item.data(NAME))))

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Leave:
            self.preview.mark(None)
        return super().eventFilter(watched, event)


def describe(part: Part) -> str:
    """How much there is of a part, and how large it is."""
    size = " × ".join(number(1e3 * length, 2) for length in part.size)
    return tr("{vertices} vertices, {triangles} △, {size} mm").format(
        vertices=count(len(part.surface.vertices)),
        triangles=count(len(part.surface.triangles)),
        size=size,
    )
