# SPDX-License-Identifier: GPL-3.0-or-later
"""The organs that come with Palpate, as pictures to choose from."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QIcon, QPainter, QPainterPath, QPixmap
from PySide6.QtWidgets import QGridLayout, QToolButton, QWidget

from palpate_editor.app.spoken import say_tissue
from palpate_editor.shipped import find_picture, list_organs
from palpate_editor.views.translations import tr

COLUMNS = 4
PICTURE, SMALL_PICTURE = QSize(112, 92), QSize(78, 64)
ROUND = 6
"""[px] Of a picture's corners."""


def name_organs() -> dict[str, str]:
    """What people call them, in the language of the window."""
    return {
        "simple_tissue": tr("Simple tissue"),
        "spleen": tr("Spleen"),
        "kidney": tr("Kidney"),
        "collecting_system": tr("Hollow kidney"),
        "kidney_stone": tr("Kidney stone"),
        "gallbladder": tr("Gallbladder"),
        "liver": tr("Liver"),
        "stomach": tr("Stomach"),
    }


def name_tissue(name: str, title: str) -> str:
    """What people call a tissue of the library, in the language of the window."""
    return {
        "liver": tr("liver"),
        "spleen": tr("spleen"),
        "kidney": tr("kidney"),
        "gallbladder": tr("gallbladder wall"),
        "stomach": tr("stomach wall"),
        "soft_patch": tr("soft patch"),
        "stone": tr("kidney stone"),
    }.get(name) or say_tissue(title)


class ShippedOrgans(QWidget):
    """A button for each, with its picture."""

    chosen = Signal(str)

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.setObjectName("shipped_organs")
        self.theme = ""
        self.buttons: dict[str, QToolButton] = {}
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setSpacing(4)
        names = name_organs()
        for row, (entry, _) in enumerate(list_organs()):
            button = QToolButton(self)
            button.setProperty("role", "organ")
            button.setObjectName(entry.name)
            button.setText(names[entry.name])
            button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextUnderIcon)
            button.setIconSize(PICTURE)
            button.setToolTip(tr("{count} vertices").format(count=entry.vertices))
            button.clicked.connect(self.choose)
            grid.addWidget(button, row // COLUMNS, row % COLUMNS)
            self.buttons[entry.name] = button

    def use_theme(self, theme: str) -> None:
        """Shows the pictures that go with a theme of the window."""
        if theme == self.theme:
            return
        self.theme = theme
        for name, button in self.buttons.items():
            button.setIcon(QIcon(round_off(QPixmap(str(find_picture(name, theme))))))

    def use_columns(self, columns: int) -> None:
        """So many beside each other."""
        grid = self.layout()
        if isinstance(grid, QGridLayout):
            for row, button in enumerate(self.buttons.values()):
                grid.addWidget(button, row // columns, row % columns)

    def use_size(self, large: bool) -> None:
        """Large pictures, or small ones where there is little room."""
        for button in self.buttons.values():
            button.setIconSize(PICTURE if large else SMALL_PICTURE)

    def choose(self) -> None:
        button = self.sender()
        if isinstance(button, QToolButton):
            self.chosen.emit(button.objectName())


def round_off(picture: QPixmap) -> QPixmap:
    """The picture with round corners; nothing where there is none."""
    if picture.isNull():
        return picture
    rounded = QPixmap(picture.size())
    rounded.fill(Qt.GlobalColor.transparent)
    painter = QPainter(rounded)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    outline = QPainterPath()
    outline.addRoundedRect(picture.rect(), 2 * ROUND, 2 * ROUND)
    painter.setClipPath(outline)
    painter.drawPixmap(0, 0, picture)
    painter.end()
    rounded.setDevicePixelRatio(picture.width() / PICTURE.width())
    return rounded
