# SPDX-License-Identifier: GPL-3.0-or-later
"""Line icons drawn from paths, in the colours of the theme and sharp at every scale."""

from __future__ import annotations

from functools import cache

from PySide6.QtCore import QByteArray, QRectF, Qt
from PySide6.QtGui import QIcon, QPainter, QPixmap
from PySide6.QtSvg import QSvgRenderer

SCALE = 3
"""Pixmaps are made this many times larger than shown, for screens of high resolution."""

PATHS = {
    "orbit": "M12 12m-2.2 0a2.2 2.2 0 1 0 4.4 0a2.2 2.2 0 1 0-4.4 0 M3 12c0-3 4-5.2 9-5.2s9 2.2 "
    "9 5.2-4 5.2-9 5.2 M15 14.6l-3 2.6 3 2.7",
    "select": "M5 4l6 16 2.300-6.700L20 11z",
    "fix": "M12 3a5 5 0 0 1 5 5c0 3.4-5 9-5 9s-5-5.600-5-9a5 5 0 0 1 5-5z M12 8m-1.600 0a1.600 "
    "1.600 0 1 0 3.200 0a1.600 1.600 0 1 0-3.200 0 M5 21h14",
    "stiffness": "M20.500 3.500c-5 2-9 6-10.500 9l1.500 1.500c3-1.500 7-5.500 9-10.500z M9.500 "
    "13.500c-3 0-3.500 2-3.500 4s-1.500 3-2.500 3c3 1 8 .5 8-4.500z",
    "open": "M3 6.500h6l2 2.500h10v9.500a1 1 0 0 1-1 1H4a1 1 0 0 1-1-1z",
    "import": "M12 3v11 M8 10.500l4 4 4-4 M4 16v4h16v-4",
    "save": "M5 4h11l4 4v12H4V5a1 1 0 0 1 1-1z M8 4v5h7V4 M8 20v-6h8v6",
    "new": "M6 3h8l5 5v13H6z M14 3v5h5",
    "undo": "M8 5L4 9l4 4 M4 9h10a5.500 5.500 0 0 1 0 11h-4",
    "redo": "M16 5l4 4-4 4 M20 9H10a5.500 5.500 0 0 0 0 11h4",
    "frame": "M4 9V4h5 M15 4h5v5 M20 15v5h-5 M9 20H4v-5 M12 12m-3 0a3 3 0 1 0 6 0a3 3 0 1 0-6 0",
    "wire": "M12 3l9 16H3z M7.500 11h9 M12 19l-4.500-8 M12 19l4.500-8",
    "camera": "M4 8h3.500l1.500-2.500h6L16.500 8H20v11H4z M12 13.300m-3.300 0a3.300 3.300 0 1 0 "
    "6.600 0a3.300 3.300 0 1 0-6.600 0",
    "play": "M7 4.500l12 7.500-12 7.500z",
    "stop": "M6 6h12v12H6z",
    "publish": "M12 15V4 M8 7.500L12 3.500l4 4 M4 14v6h16v-6",
    "tick": "M4.500 12.500l5 5 10-11",
    "cross": "M6 6l12 12 M18 6L6 18",
    "warning": "M12 3.500L22 20H2z M12 10v4.500 M12 17.200v.300",
    "info": "M12 12m-9 0a9 9 0 1 0 18 0a9 9 0 1 0-18 0 M12 11v6 M12 7.500v.300",
    "search": "M10.500 10.500m-6.500 0a6.500 6.500 0 1 0 13 0a6.500 6.500 0 1 0-13 0 M15.500 "
    "15.500l5 5",
    "organ": "M8 4c5-2 11 1 12 7 1 5-3 9-6 9s-3-3-5-3.500S4 17 3.500 12 5 5.500 8 4z",
    "file": "M6 3h8l5 5v13H6z M14 3v5h5 M9 13h7 M9 16.500h7",
    "mesh": "M12 3l8 5v8l-8 5-8-5V8z M4 8l8 5 8-5 M12 13v8",
    "tool": "M4 20l9-9 M13 11m0 0l2-4 4-2-1 5-4 2z M4 20m-1 0a1 1 0 1 0 2 0a1 1 0 1 0-2 0",
    "hand": "M8 12V6a1.500 1.500 0 0 1 3 0v5 M11 10V4.500a1.500 1.500 0 0 1 3 0V11 M14 11V6a1.500 "
    "1.500 0 0 1 3 0v8c0 4-2.500 7-6 7s-5-2-6.500-5.500L4 13c.7-1.300 2.300-1 3 0l1 1.500",
    "spring": "M3 12h3l1.500-4 3 8 3-8 3 8 1.500-4h3",
    "task": "M5 4h14v16H5z M8.500 9h7 M8.500 12.500h7 M8.500 16h4",
    "reset": "M4 12a8 8 0 1 0 2.500-5.800 M4 4v5h5",
    "chevron": "M9 5l7 7-7 7",
    "minus": "M12 12m-8.500 0a8.500 8.500 0 1 0 17 0a8.500 8.500 0 1 0-17 0 M8 12h8",
    "eye": "M2.500 12c3-5 6-7 9.500-7s6.500 2 9.500 7c-3 5-6 7-9.500 7s-6.500-2-9.500-7z M12 "
    "12m-2.800 0a2.800 2.800 0 1 0 5.600 0a2.800 2.800 0 1 0-5.600 0",
    "closed_eye": "M2.500 10c3 4 6 5.500 9.500 5.500s6.500-1.500 9.500-5.500 M5 14l-2 2.500 M12 "
    "16v3 M19 14l2 2.500",
}
"""Strokes on a square of 24."""

SVG = (
    '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24"><path d="{path}" fill="none" '
    'stroke="{colour}" stroke-width="{width}" stroke-linecap="round" stroke-linejoin="round"/>'
    "</svg>"
)


def draw_icon(name: str, colour: str, size: int = 20, width: float = 1.7) -> QPixmap:
    """One icon, transparent around its strokes."""
    text = SVG.format(path=PATHS[name], colour=colour, width=width)
    pixmap = QPixmap(size * SCALE, size * SCALE)
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    QSvgRenderer(QByteArray(text.encode())).render(painter, QRectF(pixmap.rect()))
    painter.end()
    pixmap.setDevicePixelRatio(SCALE)
    return pixmap


@cache
def plain_icon(name: str, colour: str) -> QIcon:
    """An icon of one colour, for lists, whose open branches count as switched on."""
    return QIcon(draw_icon(name, colour))


@cache
def icon(name: str, colour: str, chosen: str = "#ffffff", faded: str = "#808080") -> QIcon:
    """An icon for actions: `chosen` is its colour where it is switched on."""
    made = QIcon(draw_icon(name, colour))
    made.addPixmap(draw_icon(name, chosen), QIcon.Mode.Normal, QIcon.State.On)
    made.addPixmap(draw_icon(name, faded), QIcon.Mode.Disabled, QIcon.State.Off)
    return made
