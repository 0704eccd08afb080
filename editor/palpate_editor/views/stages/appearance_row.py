# SPDX-License-Identifier: GPL-3.0-or-later
"""What the organ looks like: one of the styles that ship, in its own colour or another."""

from __future__ import annotations

from PySide6.QtGui import QColor, QIcon, QPixmap
from PySide6.QtWidgets import QColorDialog, QComboBox, QHBoxLayout, QPushButton, QWidget

from palpate_editor.appearance import find_style, read_styles, write_colour
from palpate_editor.document import Organ
from palpate_editor.edits import SetAppearance
from palpate_editor.views.context import Context
from palpate_editor.views.translations import tr

SWATCH = 16
"""[px]"""
PLAIN, OWN = "", "own"
"""Entries that are no style."""


def style_title(name: str) -> str:
    """A style in the language of the window."""
    return {
        "liver": tr("Liver"),
        "spleen": tr("Spleen"),
        "kidney": tr("Kidney"),
        "gallbladder": tr("Gallbladder"),
        "stomach": tr("Stomach"),
        "soft_patch": tr("Soft tissue"),
        "stone": tr("Stone"),
        PLAIN: tr("Plain"),
        OWN: tr("Its own"),
    }.get(name, name)


class AppearanceRow(QWidget):
    """A list of styles and a button for the colour."""

    def __init__(self, context: Context, parent: QWidget | None = None):
        super().__init__(parent)
        self.context = context
        self.styles = QComboBox(self)
        self.styles.setObjectName("appearance")
        for name, style in read_styles().items():
            colour = QColor.fromRgbF(*style.appearance.colour)
            self.styles.addItem(swatch(colour), style_title(name), name)
        self.styles.addItem(style_title(PLAIN), PLAIN)
        self.styles.activated.connect(self.choose_style)
        self.button = QPushButton(tr("Colour…"), self)
        self.button.setObjectName("appearance_colour")
        self.button.clicked.connect(self.ask_colour)
        self.dialog: QColorDialog | None = None
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(8)
        row.addWidget(self.styles, 1)
        row.addWidget(self.button)

    def show_organ(self, organ: Organ) -> None:
        there = organ.surface is not None
        self.styles.setEnabled(there)
        style = find_style(organ.appearance)
        self.button.setEnabled(there and style is not None)
        self.show_own(organ.appearance is not None and style is None)
        name = style.name if style is not None else OWN if organ.appearance is not None else PLAIN
        self.styles.setCurrentIndex(self.styles.findData(name))
        if organ.appearance is not None:
            colour = QColor.fromRgbF(*organ.appearance.colour)
            self.button.setIcon(swatch(colour))
            self.button.setToolTip(write_colour(organ.appearance.colour))

    def show_own(self, shown: bool) -> None:
        """The entry for an appearance that is of no style, for an organ that has one."""
        at = self.styles.findData(OWN)
        if shown and at < 0:
            self.styles.addItem(style_title(OWN), OWN)
        elif not shown and at >= 0:
            self.styles.removeItem(at)

    def choose_style(self, row: int) -> None:
        name = self.styles.itemData(row)
        style = find_style(self.context.session.organ.appearance)
        if name == OWN or name == (style.name if style else PLAIN):
            return
        self.context.apply(SetAppearance(name or None))

    def ask_colour(self) -> None:
        appearance = self.context.session.organ.appearance
        if appearance is None:
            return
        dialog = QColorDialog(QColor.fromRgbF(*appearance.colour), self)
        dialog.setWindowTitle(tr("Colour of the tissue"))
        dialog.colorSelected.connect(self.choose_colour)
        dialog.finished.connect(dialog.deleteLater)
        self.dialog = dialog
        dialog.open()

    def choose_colour(self, colour: QColor) -> None:
        style = find_style(self.context.session.organ.appearance)
        if style is not None:
            wanted = (colour.red() / 255.0, colour.green() / 255.0, colour.blue() / 255.0)
            self.context.apply(SetAppearance(style.name, wanted))


def swatch(colour: QColor) -> QIcon:
    pixmap = QPixmap(SWATCH, SWATCH)
    pixmap.fill(colour)
    return QIcon(pixmap)
