# SPDX-License-Identifier: GPL-3.0-or-later
"""The parts of a mesh file as a tree: as the file groups them or, where it does not, each below the
part it lies inside of. Ticked parts become the organ."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from PySide6.QtCore import QPoint, QSize, Qt, Signal
from PySide6.QtGui import QBrush, QColor, QIcon, QPixmap
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QMenu,
    QTreeWidget,
    QTreeWidgetItem,
    QWidget,
)

from palpate_editor.appearance import fold
from palpate_editor.edits.part_list import Part
from palpate_editor.views.context import Context
from palpate_editor.views.icons import plain_icon
from palpate_editor.views.translations import count, number, quantity, tr

NAME = Qt.ItemDataRole.UserRole
"""Of a part; None of a group."""
WHAT, TAKE, EYE = range(3)
"""Columns."""
TICKED, FREE = Qt.CheckState.Checked, Qt.CheckState.Unchecked
SWATCH = 12
"""[px]"""


class PartsTree(QTreeWidget):
    """A row for each part and each group of them."""

    changed = Signal()
    """Other parts are ticked, taken away or hidden."""
    entered = Signal(object)
    """The name of the part under the pointer or the keyboard, None for none."""

    def __init__(self, context: Context, parent: QWidget | None = None):
        super().__init__(parent)
        self.context = context
        self.taken: set[str] = set()
        """Parts whose inside is taken away from the others."""
        self.hidden: set[str] = set()
        """Parts that are not drawn though they are ticked."""
        self.setObjectName("parts")
        self.setColumnCount(3)
        self.setHeaderHidden(True)
        self.setIndentation(14)
        self.setIconSize(QSize(15, 15))
        self.setSelectionMode(QAbstractItemView.SelectionMode.NoSelection)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setMouseTracking(True)
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        header = self.header()
        header.setStretchLastSection(False)
        header.setMinimumSectionSize(24)
        header.setSectionResizeMode(WHAT, QHeaderView.ResizeMode.Stretch)
        for column in (TAKE, EYE):
            header.setSectionResizeMode(column, QHeaderView.ResizeMode.Fixed)
            header.resizeSection(column, 26)
        self.itemChanged.connect(self.on_changed)
        self.itemClicked.connect(self.on_clicked)
        self.itemEntered.connect(self.on_entered)
        self.currentItemChanged.connect(self.on_entered)
        self.customContextMenuRequested.connect(self.open_menu)
        context.theme_changed.connect(self.show_signs)

    # ------------------------------------------------------------ filling

    def fill(self, parts: Mapping[str, Part | None]) -> None:
        """Other parts than before; None for one whose file was not read in this window."""
        self.blockSignals(True)
        self.clear()
        self.taken.clear()
        self.hidden.clear()
        self.rows: dict[str, QTreeWidgetItem] = {}
        grouped = any(part is not None and part.groups for part in parts.values())
        groups: dict[tuple[str, ...], QTreeWidgetItem] = {}
        for name, part in parts.items():
            self.rows[name] = build_row(name, part)
        for name, part in parts.items():
            above = None
            if part is not None and grouped:
                above = self.find_group(part.groups, groups)
            elif part is not None and part.inside is not None:
                above = self.rows[part.inside]
            self.put(self.rows[name], above)
        self.expandAll()
        self.blockSignals(False)
        self.show_signs()

    def find_group(
        self, path: tuple[str, ...], groups: dict[tuple[str, ...], QTreeWidgetItem]
    ) -> QTreeWidgetItem | None:
        """The row of a group, or of the part that is one; made where it is not there."""
        if not path:
            return None
        if path[-1] in self.rows:
            return self.rows[path[-1]]
        if path not in groups:
            group = QTreeWidgetItem([path[-1]])
            flags = Qt.ItemFlag.ItemIsUserCheckable | Qt.ItemFlag.ItemIsAutoTristate
            group.setFlags(flags | Qt.ItemFlag.ItemIsEnabled)
            group.setToolTip(WHAT, path[-1])
            groups[path] = group
            self.put(group, self.find_group(path[:-1], groups))
        return groups[path]

    def put(self, row: QTreeWidgetItem, above: QTreeWidgetItem | None) -> None:
        if above is None:
            self.addTopLevelItem(row)
        else:
            above.addChild(row)

    def items(self) -> list[QTreeWidgetItem]:
        """The rows of parts, in the order of the file."""
        return list(getattr(self, "rows", {}).values())

    def count(self) -> int:
        return len(self.items())

    # ------------------------------------------------------------ choosing

    def chosen(self) -> list[str]:
        """Parts that are ticked and not taken away, in the order of the file."""
        return [name for name in self.ticked() if name not in self.taken]

    def ticked(self) -> list[str]:
        return [str(i.data(WHAT, NAME)) for i in self.items() if i.checkState(WHAT) == TICKED]

    def shown(self) -> list[str]:
        """Parts that are drawn."""
        return [name for name in self.ticked() if name not in self.hidden]

    def tick(self, names: set[str] | None) -> None:
        """Ticks these parts and no others; None for all."""
        self.blockSignals(True)
        for item in self.items():
            ticked = names is None or item.data(WHAT, NAME) in names
            item.setCheckState(WHAT, TICKED if ticked else FREE)
        self.blockSignals(False)
        self.viewport().update()
        self.changed.emit()

    def tick_visible(self, ticked: bool) -> None:
        """All that the search has left."""
        self.blockSignals(True)
        for item in self.items():
            if not item.isHidden():
                item.setCheckState(WHAT, TICKED if ticked else FREE)
        self.blockSignals(False)
        self.viewport().update()
        self.changed.emit()

    def find(self, text: str) -> None:
        """Leaves what has the text in its name or its group's, whatever accents and capitals."""
        wanted = fold(text).strip() or text.strip().casefold()

        def matches(name: str) -> bool:
            return wanted in fold(name) or wanted in name.casefold()

        def filter_row(item: QTreeWidgetItem, above: bool) -> bool:
            fits = above or matches(item.text(WHAT).partition("\n")[0])
            below = [filter_row(item.child(i), fits) for i in range(item.childCount())]
            item.setHidden(not (fits or any(below)))
            return fits or any(below)

        for i in range(self.topLevelItemCount()):
            filter_row(self.topLevelItem(i), False)

    def toggle(self, marked: set[str], item: QTreeWidgetItem) -> None:
        """Marks the parts of a row and of all below it, or takes the mark off."""
        names = set(list_names(item))
        if names <= marked:
            marked -= names
        else:
            marked |= names
        self.show_signs()
        self.changed.emit()

    def take_away(self, item: QTreeWidgetItem) -> None:
        """What is taken away is ticked as well."""
        self.toggle(self.taken, item)
        self.tick(set(self.ticked()) | (self.taken & set(list_names(item))))

    # ------------------------------------------------------------ showing

    def show_signs(self, *_: object) -> None:
        """The signs at the right of each row, in the colours of the theme."""
        self.blockSignals(True)
        colours = self.context.colours
        for item in walk(self.invisibleRootItem()):
            names = set(list_names(item))
            taken, hidden = names <= self.taken, names <= self.hidden
            item.setIcon(TAKE, plain_icon("minus", colours.bad if taken else colours.line))
            item.setIcon(EYE, plain_icon("closed_eye" if hidden else "eye", colours.faint))
            item.setToolTip(TAKE, tr("Taken away from the others") if taken else
                            tr("Take its inside away from the others"))  # fmt: skip
            item.setToolTip(EYE, tr("Show it again") if hidden else tr("Hide it in the view"))
            faint = QBrush(QColor(colours.faint)) if hidden else QBrush()
            item.setForeground(WHAT, faint)
        self.blockSignals(False)
        self.viewport().update()

    def on_changed(self, item: QTreeWidgetItem, column: int) -> None:
        del item
        if column == WHAT:
            self.changed.emit()

    def on_clicked(self, item: QTreeWidgetItem, column: int) -> None:
        if column == TAKE:
            self.take_away(item)
        elif column == EYE:
            self.toggle(self.hidden, item)

    def on_entered(self, item: QTreeWidgetItem | None, *_: object) -> None:
        self.entered.emit(None if item is None else item.data(WHAT, NAME))

    def open_menu(self, place: QPoint) -> None:
        item = self.itemAt(place)
        if item is not None:
            menu = self.build_menu(item)
            menu.popup(self.viewport().mapToGlobal(place))

    def build_menu(self, item: QTreeWidgetItem) -> QMenu:
        """What the signs do, for the keyboard; and this row alone."""
        names = set(list_names(item))
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        menu.addAction(tr("Choose this alone"), lambda: self.tick(names))
        hidden = names <= self.hidden
        menu.addAction(tr("Show it again") if hidden else tr("Hide it in the view"),
                       lambda: self.toggle(self.hidden, item))  # fmt: skip
        taken = names <= self.taken
        menu.addAction(tr("Take nothing away") if taken else
                       tr("Take its inside away from the others"),
                       lambda: self.take_away(item))  # fmt: skip
        return menu


def walk(above: QTreeWidgetItem) -> Iterator[QTreeWidgetItem]:
    for i in range(above.childCount()):
        yield above.child(i)
        yield from walk(above.child(i))


def list_names(item: QTreeWidgetItem) -> Iterator[str]:
    """The part of a row, and those below it."""
    for row in (item, *walk(item)):
        if row.data(WHAT, NAME) is not None:
            yield str(row.data(WHAT, NAME))


def build_row(name: str, part: Part | None) -> QTreeWidgetItem:
    row = QTreeWidgetItem([name if part is None else "\n".join([name, *describe(part)])])
    row.setData(WHAT, NAME, name)
    row.setFlags(Qt.ItemFlag.ItemIsUserCheckable | Qt.ItemFlag.ItemIsEnabled)
    row.setCheckState(WHAT, FREE)
    row.setToolTip(WHAT, row.text(WHAT) if part is None else "\n".join(tell(part)))
    if part is not None and part.colour is not None:
        row.setIcon(WHAT, swatch(part.colour))
    return row


def swatch(colour: tuple[float, ...]) -> QIcon:
    pixmap = QPixmap(SWATCH, SWATCH)
    pixmap.fill(QColor.fromRgbF(*colour))
    return QIcon(pixmap)


def describe(part: Part) -> Iterator[str]:
    """How large a part is, and how it lies to others."""
    size = " × ".join(number(1e3 * length, 2) for length in part.size)
    triangles = count(len(part.surface.triangles))
    yield tr("{size} mm, {triangles} △").format(size=size, triangles=triangles)
    if part.inside is not None:
        yield tr("inside {part}").format(part=part.inside)
    if part.crosses:
        yield tr("crosses {parts}").format(parts=shorten(part.crosses))


def shorten(names: tuple[str, ...]) -> str:
    """The first of many names, and how many more there are."""
    if len(names) == 1:
        return names[0]
    return tr("{count} parts: {first}, …").format(count=count(len(names)), first=names[0])


def tell(part: Part) -> Iterator[str]:
    """All that is known of a part, line by line."""
    yield part.name
    size = " × ".join(number(1e3 * length, 3) for length in part.size)
    yield tr("{vertices} vertices, {triangles} △, {size} mm").format(
        vertices=count(len(part.surface.vertices)),
        triangles=count(len(part.surface.triangles)),
        size=size,
    )
    if part.volume is None:
        yield tr("open")
    else:
        yield quantity(1e6 * part.volume, "ml", 4)
    if part.inside is not None:
        yield tr("inside {part}").format(part=part.inside)
    if part.crosses:
        yield tr("crosses {parts}").format(parts=", ".join(part.crosses))
    if part.crossing_faces:
        yield tr("{count} of its triangles cross others of its own").format(
            count=count(part.crossing_faces)
        )
