# SPDX-License-Identifier: GPL-3.0-or-later
"""The command palette: every action of the window, found by a few of its letters."""

from __future__ import annotations

from collections.abc import Iterable

from palpate.viewport.screen import find_room, keep_on_screen
from PySide6.QtCore import QEvent, QObject, QPoint, QRect, QSize, Qt
from PySide6.QtGui import QAction, QColor, QKeyEvent, QPainter, QPalette
from PySide6.QtWidgets import (
    QDialog,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QVBoxLayout,
    QWidget,
)

from palpate_editor.views.translations import tr

WIDTH, ROWS = 620, 11
SLACK = 22
"""Points of score behind the best that are still listed."""
ACTION, PATH, KEYS = (Qt.ItemDataRole.UserRole + i for i in range(3))


def score(query: str, text: str) -> int | None:
    """How well the letters of a query are found in a text, in order; None where they are not.

    Beginnings of words and letters in a row count more, so `de` finds Decimate before Redo.
    """
    if not query:  # the order of the menus is as good as any
        return 0
    total, place, last = 0, 0, -2
    text, query = text.casefold(), query.casefold().replace(" ", "")
    for letter in query:
        found = best_place(text, letter, place)
        if found < 0:
            return None
        starts_word = found == 0 or not text[found - 1].isalnum()
        total += 10 * (found == last + 1) + 8 * starts_word - min(found - place, 6)
        place, last = found + 1, found
    return total - len(text) // 8


def best_place(text: str, letter: str, start: int) -> int:
    """The next place of a letter; the next beginning of a word with it where it stands nearby."""
    found = text.find(letter, start)
    if found <= start:
        return found
    place = found
    while place >= 0:
        if not text[place - 1].isalnum():
            return place
        place = text.find(letter, place + 1)
    return found


class Row(QStyledItemDelegate):
    """A name, its menu behind it, its keys at the right."""

    def sizeHint(self, option: QStyleOptionViewItem, index: object) -> QSize:
        return QSize(WIDTH, 34)

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: object) -> None:
        chosen = bool(option.state & QStyle.StateFlag.State_Selected)
        palette, rect = option.palette, option.rect
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        if chosen:
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(palette.color(QPalette.ColorRole.Highlight))
            painter.drawRoundedRect(rect.adjusted(4, 1, -4, -1), 5, 5)
        name = palette.color(
            QPalette.ColorRole.HighlightedText if chosen else QPalette.ColorRole.Text
        )
        faint = QColor(name)
        faint.setAlphaF(0.72)
        inner = rect.adjusted(14, 0, -14, 0)
        middle = Qt.AlignmentFlag.AlignVCenter
        painter.setPen(name)
        painter.drawText(inner, middle | Qt.AlignmentFlag.AlignLeft, index.data())
        painter.setPen(faint)
        keys = index.data(KEYS)
        painter.drawText(inner, middle | Qt.AlignmentFlag.AlignRight, keys)
        keys_width = painter.fontMetrics().horizontalAdvance(keys)
        left = inner.left() + painter.fontMetrics().horizontalAdvance(index.data()) + 14
        room = QRect(left, inner.top(), inner.right() - left - keys_width - 14, inner.height())
        path = painter.fontMetrics().elidedText(
            index.data(PATH), Qt.TextElideMode.ElideRight, room.width()
        )
        painter.drawText(room, middle | Qt.AlignmentFlag.AlignLeft, path)
        painter.restore()


class CommandPalette(QDialog):
    """Asks for an action and runs it."""

    def __init__(self, actions: Iterable[tuple[str, QAction]], parent: QWidget):
        super().__init__(parent, Qt.WindowType.Popup | Qt.WindowType.FramelessWindowHint)
        self.setObjectName("palette")
        self.setAccessibleName(tr("Command palette"))
        self.actions_by_path = list(actions)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(1, 1, 1, 6)
        layout.setSpacing(6)
        self.query = QLineEdit(self)
        self.query.setObjectName("palette_query")
        self.query.setPlaceholderText(tr("What would you like to do?"))
        self.query.textChanged.connect(self.find)
        self.query.installEventFilter(self)
        self.list = QListWidget(self)
        self.list.setItemDelegate(Row(self.list))
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.list.setUniformItemSizes(True)
        self.list.setVerticalScrollMode(QListWidget.ScrollMode.ScrollPerPixel)
        self.list.itemClicked.connect(self.run_item)
        layout.addWidget(self.query)
        layout.addWidget(self.list)
        self.chosen: QAction | None = None
        room = find_room(self)
        self.setFixedSize(min(WIDTH, room.width()), min(58 + 34 * ROWS, room.height()))
        self.find("")

    def place(self) -> None:
        """Under the top of the window, in its middle."""
        window = self.parentWidget()
        corner = window.mapToGlobal(QPoint((window.width() - self.width()) // 2, 92))
        self.move(corner)
        keep_on_screen(self)

    def find(self, query: str) -> None:
        """Lists what fits, the best first; what cannot be done now stands last."""
        found = []
        for order, (path, action) in enumerate(self.actions_by_path):
            name = action.text().replace("&", "")
            by_name = score(query, name)
            by_path = score(query, f"{path} {name}")
            best = by_name + 6 if by_name is not None else by_path
            if best is not None:
                found.append((not action.isEnabled(), -best, order, path, name, action))
        found.sort(key=lambda entry: entry[:3])
        # far worse than the best is not what was meant
        least = max((-entry[1] for entry in found), default=0) - SLACK
        found = [entry for entry in found if not query or -entry[1] >= least]
        self.list.clear()
        for disabled, _, _, path, name, action in found:
            item = QListWidgetItem(name)
            item.setData(ACTION, action)
            item.setData(PATH, path)
            keys = action.shortcut()  # as they stand on keyboards, in every language
            item.setData(KEYS, keys.toString(keys.SequenceFormat.PortableText))
            if disabled:
                item.setFlags(Qt.ItemFlag.NoItemFlags)
            self.list.addItem(item)
        self.list.setCurrentRow(0)

    def run_item(self, item: QListWidgetItem | None) -> None:
        action = item.data(ACTION) if item is not None else None
        if action is None or not action.isEnabled():
            return
        self.chosen = action
        self.accept()
        action.trigger()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Arrows and Return go to the list while letters go to the query."""
        if event.type() != QEvent.Type.KeyPress or not isinstance(event, QKeyEvent):
            return super().eventFilter(watched, event)
        steps = {
            Qt.Key.Key_Down: 1,
            Qt.Key.Key_Up: -1,
            Qt.Key.Key_PageDown: ROWS - 1,
            Qt.Key.Key_PageUp: 1 - ROWS,
        }
        if event.key() in steps:
            row = self.list.currentRow() + steps[event.key()]
            self.list.setCurrentRow(max(0, min(self.list.count() - 1, row)))
            return True
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.run_item(self.list.currentItem())
            return True
        return super().eventFilter(watched, event)
