# SPDX-License-Identifier: GPL-3.0-or-later
"""What an empty window says: where to begin."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import (
    QAbstractButton,
    QFrame,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from palpate_editor.document import Organ
from palpate_editor.views.context import Context
from palpate_editor.views.icons import draw_icon
from palpate_editor.views.shipped_organs import COLUMNS, ShippedOrgans
from palpate_editor.views.stages.facts import write_label
from palpate_editor.views.theme import title_font
from palpate_editor.views.translations import tr

RECENT = 4
WIDTH, LEAST_WIDTH = 560, 440
"""[px] of the card, and for all of it beside each other."""
SIDES, NARROW_SIDES = 30, 10
"""[px] left free at the left and right."""


class Welcome(QFrame):
    """A card over the empty viewport."""

    open_wanted = Signal()
    recent_wanted = Signal(object)

    def __init__(self, context: Context, view: QWidget):
        super().__init__(view)
        self.context = context
        self.setProperty("role", "card")
        self.setObjectName("welcome")
        self.area = QScrollArea(self)
        self.area.setWidgetResizable(True)
        self.area.setFrameShape(QFrame.Shape.NoFrame)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.addWidget(self.area)
        self.page = QWidget()
        self.area.setWidget(self.page)
        for part in (self.page, self.area.viewport()):
            part.setAutoFillBackground(False)
        self.column = column = QVBoxLayout(self.page)
        column.setContentsMargins(SIDES, 20, SIDES, 16)
        column.setSpacing(8)
        self.sign = QLabel(self)
        self.sign.setAlignment(Qt.AlignmentFlag.AlignHCenter)
        column.addWidget(self.sign)
        title = write_label(tr("Drop an organ here"), "title", self)
        title.setFont(title_font(self.font(), 1.55))
        title.setAlignment(Qt.AlignmentFlag.AlignHCenter)
        title.setWordWrap(True)
        column.addWidget(title)
        lead = write_label(
            tr("A mesh from a scan or a modeller (OBJ, STL, PLY, glTF, FBX …), or an .organ file."),
            "lead",
            self,
        )
        lead.setWordWrap(True)
        lead.setAlignment(Qt.AlignmentFlag.AlignHCenter)
        column.addWidget(lead)
        self.row = row = QHBoxLayout()
        row.setContentsMargins(0, 8, 0, 4)
        self.import_button = QPushButton(tr("Import a mesh…"), self)
        self.import_button.setProperty("main", True)
        self.import_button.clicked.connect(context.import_wanted)
        self.open_button = QPushButton(tr("Open…"), self)
        self.open_button.clicked.connect(self.open_wanted)
        row.addStretch(1)
        row.addWidget(self.import_button)
        row.addWidget(self.open_button)
        row.addStretch(1)
        column.addLayout(row)
        begin = write_label(tr("Or begin with one of these"), "faint", self)
        begin.setWordWrap(True)
        column.addWidget(begin)
        self.shipped = ShippedOrgans(self)
        column.addWidget(self.shipped)
        self.recent = QGridLayout()
        self.recent.setSpacing(1)
        column.addLayout(self.recent)
        self.setFixedWidth(WIDTH)
        view.installEventFilter(self)
        context.session.changed.connect(self.on_changed)
        context.theme_changed.connect(self.on_theme)
        context.preview_shown.connect(self.on_preview)
        self.refresh()

    def on_changed(self, before: Organ, after: Organ) -> None:
        del before, after
        self.refresh()

    def on_preview(self, shown: bool) -> None:
        del shown
        self.refresh()

    def on_theme(self, theme: str) -> None:
        del theme
        self.refresh()

    def refresh(self) -> None:
        empty = self.context.session.organ.surface is None and not self.context.previewing
        self.setVisible(empty)
        if empty:
            self.sign.setPixmap(draw_icon("import", self.context.colours.accent_text, 46, 1.2))
            self.shipped.use_theme(self.context.theme)
            self.fill_recent()
            self.place()

    def fill_recent(self) -> None:
        while self.recent.count():
            widget = self.recent.takeAt(0).widget()
            if widget is not None:
                widget.hide()
                widget.deleteLater()
        for row, file in enumerate(self.context.settings.recent_files()[:RECENT]):
            button = QPushButton(file.path.name, self)
            button.setProperty("link", True)
            button.setProperty("path", str(file.path))
            button.setToolTip(str(file.path))
            button.setEnabled(file.exists)
            button.clicked.connect(self.open_recent)
            self.recent.addWidget(button, row // 2, row % 2)
            button.show()

    def open_recent(self) -> None:
        button = self.sender()
        if isinstance(button, QPushButton):
            self.recent_wanted.emit(Path(str(button.property("path"))))

    def place(self) -> None:
        room = self.parentWidget().size()
        width = min(WIDTH, max(0, room.width() - 16))
        narrow = width < LEAST_WIDTH
        sides = NARROW_SIDES if narrow else SIDES
        self.column.setContentsMargins(sides, 20, sides, 16)
        direction = (
            QHBoxLayout.Direction.TopToBottom if narrow else QHBoxLayout.Direction.LeftToRight
        )
        self.row.setDirection(direction)
        self.shipped.use_columns(1 if narrow else COLUMNS)
        self.setFixedWidth(width)
        # in a low window the organs matter more than the sign, and then their names than they do
        for with_sign, large in ((True, True), (False, True), (False, False)):
            self.sign.setVisible(with_sign)
            self.shipped.use_size(large)
            self.shipped.layout().activate()
            self.column.invalidate()
            self.column.activate()
            height = self.column.totalHeightForWidth(self.width()) + 2 * self.frameWidth()
            if height <= room.height() - 16:
                break
        # what there is no room for is scrolled
        height = min(height, max(0, room.height() - 16))
        self.resize(self.width(), height)
        self.move((room.width() - self.width()) // 2, max(8, (room.height() - self.height()) // 2))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Enter takes the button that is chosen, else the first organ."""
        if event.key() not in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            super().keyPressEvent(event)
            return
        chosen = self.window().focusWidget()
        if not isinstance(chosen, QAbstractButton) or not self.isAncestorOf(chosen):
            chosen = next(iter(self.shipped.buttons.values()))
        chosen.click()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Resize and not self.isHidden():
            self.place()
        return super().eventFilter(watched, event)
