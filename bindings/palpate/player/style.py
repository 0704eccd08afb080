# SPDX-License-Identifier: BSD-3-Clause
"""Colours and letters of the trainee's window, after the theme of its pictures."""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtGui import QColor, QPalette

from palpate.render.theme import DARK, LIGHT, THEMES, Colour


@dataclass(frozen=True)
class Accents:
    """What pictures need no words for: signals and buttons."""

    accent: Colour
    """Of what may be pressed, and of a force that is far from its limit."""
    warm: Colour
    """Of what wants attention."""
    hot: Colour
    """Of what went wrong, and of a force at its limit."""
    on_accent: Colour
    """Text on the accent."""


ACCENTS = {
    "dark": Accents((0.25, 0.78, 0.72), (0.98, 0.72, 0.25), DARK.alarm, (0.03, 0.09, 0.09)),
    "light": Accents((0.00, 0.48, 0.46), (0.72, 0.42, 0.0), LIGHT.alarm, (1.0, 1.0, 1.0)),
}
PANEL = 0.66
"""[-] opacity of a card over the picture."""
SOLID = 0.95
"""[-] of one that is read while all else waits."""


def to_colour(colour: Colour, opacity: float = 1.0) -> QColor:
    return QColor.fromRgbF(*colour, opacity)


def as_css(colour: Colour, opacity: float = 1.0) -> str:
    red, green, blue = (round(255 * part) for part in colour)
    return f"rgba({red}, {green}, {blue}, {opacity:.3f})"


def mix(a: Colour, b: Colour, share: float) -> Colour:
    """`share` 0 gives a, 1 gives b."""
    first, second, third = (x + share * (y - x) for x, y in zip(a, b, strict=True))
    return first, second, third


def build_palette(name: str) -> QPalette:
    """For what the style sheet does not reach."""
    theme, accents = THEMES[name], ACCENTS[name]
    palette = QPalette()
    for role, colour in (
        (QPalette.ColorRole.Window, theme.corner),
        (QPalette.ColorRole.Base, theme.panel),
        (QPalette.ColorRole.Button, theme.panel),
        (QPalette.ColorRole.WindowText, theme.text),
        (QPalette.ColorRole.Text, theme.text),
        (QPalette.ColorRole.ButtonText, theme.text),
        (QPalette.ColorRole.Highlight, accents.accent),
        (QPalette.ColorRole.HighlightedText, accents.on_accent),
    ):
        palette.setColor(role, to_colour(colour))
    return palette


def build_style(name: str, letter: float) -> str:
    """The style sheet, for text `letter` pixels high."""
    theme, accents = THEMES[name], ACCENTS[name]
    text, faint, accent = map(as_css, (theme.text, theme.faint, accents.accent))
    raised = as_css(mix(theme.panel, theme.text, 0.10), 0.9)
    over = as_css(mix(theme.panel, theme.text, 0.20), 0.95)
    return f"""
    QWidget#page {{ background: transparent; }}
    QScrollBar:vertical {{ background: transparent; width: 9px; margin: 8px 2px 8px 0; }}
    QScrollBar::handle:vertical {{ background: {as_css(theme.text, 0.35)}; border-radius: 3px;
        min-height: 20px; }}
    QScrollBar::add-line:vertical, QScrollBar::sub-line:vertical {{ height: 0; }}
    QScrollBar::add-page:vertical, QScrollBar::sub-page:vertical {{ background: transparent; }}
    QFrame#card {{ background: {as_css(theme.panel, PANEL)}; border-radius: 14px; }}
    QFrame#board {{ background: {as_css(theme.panel, SOLID)}; border-radius: 20px;
        border: 1px solid {as_css(theme.text, 0.10)}; }}
    QLabel {{ color: {text}; font-size: {letter:.0f}px; background: transparent; }}
    QLabel#title {{ font-size: {1.30 * letter:.0f}px; font-weight: 600; }}
    QLabel#headline {{ font-size: {1.9 * letter:.0f}px; font-weight: 600; }}
    QLabel#clock {{ font-size: {1.9 * letter:.0f}px; font-weight: 600; }}
    QLabel#caption {{ color: {faint}; font-size: {0.80 * letter:.0f}px; }}
    QLabel#body {{ color: {text}; font-size: {1.0 * letter:.0f}px; }}
    QLabel#keys {{ color: {faint}; font-size: {0.88 * letter:.0f}px; }}
    QFrame#notice {{ background: {as_css(theme.panel, 0.75)}; border-radius: 10px;
        border: 1px solid {as_css(accents.warm, 0.8)}; }}
    QLabel#notice_text {{ color: {as_css(accents.warm)}; font-size: {0.92 * letter:.0f}px;
        font-weight: 600; }}
    QFrame#alarm {{ background: {as_css(accents.hot, 0.95)}; border-radius: 12px; }}
    QLabel#alarm_text {{ color: white; font-size: {1.05 * letter:.0f}px; font-weight: 600; }}
    QFrame#warning {{ background: {as_css(theme.panel, 0.85)}; border-radius: 12px;
        border: 1px solid {as_css(accents.warm)}; }}
    QLabel#warning_text {{ color: {as_css(accents.warm)}; font-size: {letter:.0f}px; }}
    QFrame#signal {{ background: {as_css(theme.panel, 0.85)}; border-radius: 12px;
        border: 1px solid {as_css(theme.text, 0.4)}; }}
    QLabel#signal_text {{ color: {text}; font-size: {letter:.0f}px; font-weight: 600; }}
    QFrame#glow {{ background: transparent; border: {0.4 * letter:.0f}px solid
        {as_css(accents.hot, 0.75)}; }}
    QLineEdit {{ color: {text}; background: {raised}; border: 1px solid {accent};
        border-radius: 10px; padding: {0.5 * letter:.0f}px {0.8 * letter:.0f}px;
        font-size: {1.2 * letter:.0f}px; }}
    QComboBox {{ color: {text}; background: {raised}; border: 1px solid {as_css(theme.text, 0.2)};
        border-radius: 8px; padding: {0.4 * letter:.0f}px {0.7 * letter:.0f}px;
        font-size: {letter:.0f}px; }}
    QComboBox QAbstractItemView {{ color: {text}; background: {as_css(theme.panel)}; }}
    QPushButton {{ color: {text}; background: {raised};
        border: 1px solid {as_css(theme.text, 0.08)}; border-radius: 10px;
        padding: {0.55 * letter:.0f}px {1.1 * letter:.0f}px;
        font-size: {letter:.0f}px; }}
    QPushButton:hover, QPushButton:focus {{ background: {over};
        border: 1px solid {accent}; }}
    QPushButton#small {{ padding: {0.3 * letter:.0f}px {0.8 * letter:.0f}px;
        font-size: {0.85 * letter:.0f}px; }}
    QPushButton#main {{ color: {as_css(accents.on_accent)}; background: {accent};
        font-weight: 600; border: 1px solid transparent; }}
    QPushButton#main:hover, QPushButton#main:focus {{ border: 1px solid {text}; }}
    QPushButton:disabled, QPushButton#main:disabled, QComboBox:disabled {{
        color: {as_css(theme.text, 0.35)}; background: {raised}; border: 1px solid transparent; }}
    QPushButton:checked {{ border: 1px solid {accent}; color: {accent};
        font-weight: 600; }}
    """
