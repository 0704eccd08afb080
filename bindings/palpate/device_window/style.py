# SPDX-License-Identifier: BSD-3-Clause
"""The style sheet of the device window, after the colours of the trainee's."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from PySide6.QtGui import QColor, QFont, QPainter
from PySide6.QtWidgets import QWidget

from palpate.player.style import ACCENTS, as_css, mix, to_colour
from palpate.render.theme import FORCE, THEMES, Colour

LETTER = 13
"""[px] of text."""
SIGNS = Path(__file__).with_name("signs")
ROUND = 10
"""[px] of a card's corners."""


def card_colour(theme: str) -> Colour:
    """Behind what is written in a card."""
    return mix(THEMES[theme].panel, THEMES[theme].text, 0.05 if theme == "dark" else 0.0)


def window_colour(theme: str) -> Colour:
    return THEMES[theme].panel if theme == "dark" else mix(THEMES[theme].panel, (0, 0, 0), 0.075)


def commanded_colour(theme: str) -> QColor:
    """Of what is asked of the motors, in plots and in 3D."""
    return to_colour(ACCENTS[theme].accent)


def applied_colour(theme: str) -> QColor:
    """Of what the motors give."""
    return to_colour(FORCE if theme == "light" else (1.0, 0.36, 0.30))


def pick(theme: str, name: str, opacity: float = 1.0) -> QColor:
    """A colour of the theme by name: text, faint, accent, warm, hot, line, track or card."""
    return to_colour(find_colours(theme)[name], opacity)


@cache
def find_colours(theme: str) -> dict[str, Colour]:
    colours, accents, card = THEMES[theme], ACCENTS[theme], card_colour(theme)
    return {
        "text": colours.text,
        "faint": colours.faint,
        "accent": accents.accent,
        "warm": accents.warm,
        "hot": accents.hot,
        "line": mix(card, colours.text, 0.16),
        "track": mix(card, colours.text, 0.10),
        "card": card,
    }


class Painted(QWidget):
    """A widget that paints itself in the colours of a theme."""

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.theme = "dark"

    def use_theme(self, theme: str) -> None:
        self.theme = theme
        self.update()

    def begin(self) -> QPainter:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        return painter

    def letters(self, size: float = LETTER, bold: bool = False) -> QFont:
        font = QFont(self.font())
        font.setPixelSize(round(size))
        font.setWeight(QFont.Weight.DemiBold if bold else QFont.Weight.Normal)
        return font


def build_style(theme: str) -> str:
    colours, accents = THEMES[theme], ACCENTS[theme]
    text, faint, card = as_css(colours.text), as_css(colours.faint), card_colour(theme)
    line = as_css(mix(card, colours.text, 0.16))
    field = as_css(mix(card, colours.text, 0.07))
    over = as_css(mix(card, colours.text, 0.15))
    window = as_css(window_colour(theme))
    signs = SIGNS.as_posix()
    accent, hot, warm = as_css(accents.accent), as_css(accents.hot), as_css(accents.warm)
    return f"""
    QWidget#device {{ background: {window}; }}
    QScrollArea, QWidget#page {{ background: transparent; border: none; }}
    QFrame#card {{ background: {as_css(card)}; border-radius: {ROUND}px;
        border: 1px solid {line}; }}
    QLabel {{ color: {text}; font-size: {LETTER}px; background: transparent; }}
    QLabel#brand {{ font-size: 17px; font-weight: 600; }}
    QLabel#headline {{ font-size: 19px; font-weight: 600; }}
    QLabel#section {{ color: {faint}; font-size: 11px; font-weight: 600; }}
    QLabel#faint {{ color: {faint}; font-size: 12px; }}
    QLabel#number {{ font-size: {LETTER}px; font-weight: 600; }}
    QLabel#good {{ color: {accent}; font-weight: 600; }}
    QLabel#bad {{ color: {hot}; font-weight: 600; }}
    QLabel#warn {{ color: {warm}; font-weight: 600; }}
    QLabel#pill {{ font-weight: 600; padding: 4px 12px; border-radius: 11px;
        background: {field}; color: {faint}; }}
    QLabel#pill[tone="good"] {{ background: {as_css(accents.accent, 0.18)}; color: {accent}; }}
    QLabel#pill[tone="warm"] {{ background: {as_css(accents.warm, 0.18)}; color: {warm}; }}
    QLabel#pill[tone="bad"] {{ background: {hot}; color: white; }}
    QFrame#alarm {{ background: {as_css(accents.hot, 0.95)}; border-radius: 10px; }}
    QLabel#alarm_text {{ color: white; font-size: 14px; font-weight: 600; }}
    QPushButton, QComboBox, QDoubleSpinBox {{ color: {text}; background: {field};
        border: 1px solid {line}; border-radius: 7px; padding: 6px 12px;
        font-size: {LETTER}px; min-height: 18px; }}
    QPushButton:hover, QPushButton:focus, QComboBox:hover, QComboBox:focus,
    QDoubleSpinBox:focus {{ border: 1px solid {accent}; }}
    QPushButton:hover {{ background: {over}; }}
    QPushButton:disabled, QComboBox:disabled, QDoubleSpinBox:disabled {{
        color: {as_css(mix(colours.faint, card, 0.45))}; border: 1px solid {field}; }}
    QPushButton#main {{ color: {as_css(accents.on_accent)}; background: {accent};
        font-weight: 600; border: 1px solid {accent}; }}
    QPushButton#main:disabled {{ background: {field};
        color: {as_css(mix(colours.faint, card, 0.45))}; border: 1px solid {field}; }}
    QPushButton#main:focus {{ border: 1px solid {text}; }}
    QPushButton#tab {{ background: transparent; border: none; border-radius: 0;
        border-bottom: 2px solid transparent; padding: 8px 6px; color: {faint}; }}
    QPushButton#tab:checked {{ color: {text}; border-bottom: 2px solid {accent};
        font-weight: 400; }}
    QPushButton#tab:focus {{ color: {accent}; }}
    QPushButton:checked {{ border: 1px solid {accent}; color: {accent}; font-weight: 600; }}
    QCheckBox {{ color: {text}; font-size: {LETTER}px; }}
    QComboBox::drop-down {{ border: none; width: 22px; }}
    QComboBox::down-arrow {{ image: url({signs}/down_{theme}.svg); width: 12px; height: 12px; }}
    QDoubleSpinBox::up-button, QDoubleSpinBox::down-button {{ width: 0; border: none; }}
    QCheckBox::indicator {{ width: 14px; height: 14px; border-radius: 4px;
        border: 1px solid {line}; background: {field}; }}
    QCheckBox::indicator:checked {{ background: {accent}; border: 1px solid {accent};
        image: url({signs}/tick_{theme}.svg); }}
    QFrame#notice {{ background: {as_css(colours.panel, 0.75)}; border-radius: 8px;
        border: 1px solid {as_css(accents.warm, 0.8)}; }}
    QLabel#notice_text {{ color: {warm}; font-size: 12px; font-weight: 600; }}
    QComboBox QAbstractItemView {{ background: {as_css(card)}; color: {text};
        border: 1px solid {line}; selection-background-color: {accent};
        selection-color: {as_css(accents.on_accent)}; }}
    QComboBox QLineEdit {{ color: {text}; background: transparent; border: none; }}
    QScrollBar:vertical {{ background: transparent; width: 8px; margin: 0; }}
    QScrollBar::handle:vertical {{ background: {over}; border-radius: 4px; min-height: 24px; }}
    QScrollBar::add-line, QScrollBar::sub-line {{ height: 0; }}
    QToolTip {{ color: {text}; background: {as_css(card)}; border: 1px solid {line}; }}
    """
