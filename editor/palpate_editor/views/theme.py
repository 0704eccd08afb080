# SPDX-License-Identifier: GPL-3.0-or-later
"""How the window looks, dark and light: palettes on Fusion, one style sheet, one table of colours.

Qt's own switch of the colour scheme does nothing on several platforms, so both schemes stand here.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from PySide6.QtGui import QColor, QFont, QPalette
from PySide6.QtWidgets import QApplication, QStyleFactory

THEMES = ("dark", "light")
SHEET = Path(__file__).with_name("theme.qss")


@dataclass(frozen=True)
class Colours:
    """Every colour of one appearance, as #rrggbb."""

    window: str
    """Behind everything."""
    panel: str
    """Docks and forms."""
    field: str
    """What can be typed into, lists."""
    raised: str
    """Buttons."""
    hover: str
    line: str
    """Borders and separators."""
    text: str
    faint: str
    """Text of less weight."""
    disabled: str
    accent: str
    """Behind white text: what is chosen, the main button."""
    accent_text: str
    """Accent as text or line on a panel."""
    good: str
    warning: str
    bad: str
    curve: str
    """The first curve of a plot."""


DARK = Colours(
    window="#191b1f",
    panel="#22252a",
    field="#1a1c20",
    raised="#31353c",
    hover="#3b4049",
    line="#3a3f47",
    text="#e7e9ec",
    faint="#a2a9b4",
    disabled="#666d78",
    accent="#2070d0",
    accent_text="#74b4ff",
    good="#53c28b",
    warning="#f0b44c",
    bad="#ff7b72",
    curve="#ff7a5c",
)
LIGHT = Colours(
    window="#e6e8ec",
    panel="#f6f7f9",
    field="#ffffff",
    raised="#ffffff",
    hover="#e7edf6",
    line="#ccd1d9",
    text="#1c2128",
    faint="#5a6472",
    disabled="#9aa2ae",
    accent="#1b66c4",
    accent_text="#1457ad",
    good="#137040",
    warning="#8a5000",
    bad="#b8241a",
    curve="#d1381f",
)
COLOURS = {"dark": DARK, "light": LIGHT}


def build_palette(colours: Colours) -> QPalette:
    """Qt's roles from our table."""
    roles = QPalette.ColorRole
    table = {
        roles.Window: colours.panel,
        roles.WindowText: colours.text,
        roles.Base: colours.field,
        roles.AlternateBase: colours.panel,
        roles.Text: colours.text,
        roles.Button: colours.raised,
        roles.ButtonText: colours.text,
        roles.BrightText: "#ffffff",
        roles.ToolTipBase: colours.raised,
        roles.ToolTipText: colours.text,
        roles.Highlight: colours.accent,
        roles.HighlightedText: "#ffffff",
        roles.PlaceholderText: colours.disabled,
        roles.Link: colours.accent_text,
        roles.Light: colours.hover,
        roles.Midlight: colours.raised,
        roles.Mid: colours.line,
        roles.Dark: colours.line,
        roles.Shadow: colours.window,
    }
    palette = QPalette()
    for role, colour in table.items():
        palette.setColor(role, QColor(colour))
    for role in (roles.Text, roles.ButtonText, roles.WindowText, roles.HighlightedText):
        palette.setColor(QPalette.ColorGroup.Disabled, role, QColor(colours.disabled))
    palette.setColor(QPalette.ColorGroup.Disabled, roles.Highlight, QColor(colours.line))
    return palette


def use_theme(app: QApplication, name: str) -> Colours:
    """Dresses the whole application and returns the colours in use."""
    colours = COLOURS[name]
    sheet = SHEET.read_text(encoding="utf-8")
    for field in sorted(Colours.__dataclass_fields__, key=len, reverse=True):
        sheet = sheet.replace(f"@{field}", getattr(colours, field))
    sheet = sheet.replace("@folder", SHEET.parent.as_posix()).replace("@name", name)
    if app.styleSheet() == sheet:
        return colours  # as it is: Qt would take half a second to dress every widget again
    app.setStyle(QStyleFactory.create("Fusion"))
    app.setPalette(build_palette(colours))
    app.setStyleSheet(sheet)
    return colours


def title_font(base: QFont, scale: float = 1.3) -> QFont:
    font = QFont(base)
    font.setPointSizeF(base.pointSizeF() * scale)
    font.setWeight(QFont.Weight.DemiBold)
    return font


def fixed_font(base: QFont) -> QFont:
    """For command lines and coordinates: every letter as wide as the next."""
    font = QFont("monospace")
    font.setStyleHint(QFont.StyleHint.Monospace)
    font.setPointSizeF(base.pointSizeF() * 0.95)
    return font


def prefers_dark(app: QApplication) -> bool:
    """What the desktop asks for; dark where it says nothing, as the 3D view is easier to read."""
    from PySide6.QtCore import Qt

    return app.styleHints().colorScheme() != Qt.ColorScheme.Light
