# SPDX-License-Identifier: BSD-3-Clause
"""What a widget's colour says, for a style sheet to paint."""

from __future__ import annotations

from PySide6.QtWidgets import QWidget


def set_tone(widget: QWidget, tone: str) -> None:
    """Colours a widget by the style sheet: good, warning, bad or none."""
    if widget.property("tone") != tone:
        widget.setProperty("tone", tone)
        widget.style().unpolish(widget)
        widget.style().polish(widget)
