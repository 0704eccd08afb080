# SPDX-License-Identifier: GPL-3.0-or-later
"""Help beside the window: what each stage is for, and what keys and mouse do."""

from __future__ import annotations

from collections.abc import Iterable
from html import escape

import palpate
from palpate.viewport.screen import fit_to_screen
from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QDialog, QTextBrowser, QVBoxLayout, QWidget

from palpate_editor.views.stage_bar import stage_title
from palpate_editor.views.translations import tr

SIZE = QSize(560, 620)
"""[px]"""


def stage_help(stage: str) -> list[str]:
    """Paragraphs on a stage."""
    return {
        "import": [
            tr("Drop a mesh file on the window, or choose one. Files with several parts, such as a "
               "whole heart, can be used in part: tick what you need and import again."),
            tr("A file rarely says how long its unit is. The editor guesses by the size of the "
               "organ and says why; correct it where it is wrong, and everything follows."),
            tr("Importing again keeps your constants but forgets what was painted."),
        ],
        "repair": [
            tr("Doubled points are welded, doubled and empty triangles removed, and triangles "
               "turned so that all face outwards. What was done stands in the panel."),
            tr("Holes are never closed behind your back: an open surface can be a hollow organ or "
               "a sheet, and then needs the thickness of its wall."),
        ],
        "decimate": [
            tr("The loop has a millisecond for every tick. Fewer vertices leave more of it free; "
               "600 to 2400 are usual. The colours show how far the new surface is from the file."),
            tr("Decimating always starts from the imported surface, so you can try several counts. "
               "What you have painted is carried over."),
        ],
        "material": [
            tr("Every number has its unit beside it. Type a value, or use the arrow keys. Mass, "
               "substeps and the stability margin follow at once."),
            tr("The mass–spring model has springs along all edges. The molecular model adds angles "
               "and their coupling to stretch; a triangle can only take a certain range of it."),
            tr("A wall can have its constants from the tissue: choose so under Constants, and read "
               "what the model makes of the wall. A shell of prisms bends as well."),
            tr("Fix what is attached to the body, and paint places that are harder: choose a brush "
               "at the left, and drag over the organ."),
        ],
        "test": [
            tr("The very loop that a haptic device will run, with your mouse as the hand. The left "
               "button presses, the right one takes hold, the wheel goes deeper."),
            tr("A scripted press gives numbers that can be compared from one day to the next."),
        ],
        "publish": [
            tr("A published file holds the finished model and everything needed to feel it; it "
               "also holds your document, so it can be opened here again."),
            tr("Errors of any stage, in red, prevent publishing. Each says what it got and what "
               "was expected."),
        ],
    }[stage]  # fmt: skip


class HelpWindow(QDialog):
    """A window that stays beside the editor."""

    def __init__(self, parent: QWidget):
        super().__init__(parent, Qt.WindowType.Tool)
        self.setObjectName("help_window")
        self.setWindowTitle(tr("Help"))
        self.text = QTextBrowser(self)
        self.text.setOpenExternalLinks(False)
        column = QVBoxLayout(self)
        column.setContentsMargins(14, 10, 6, 10)
        column.addWidget(self.text)
        fit_to_screen(self, SIZE)

    def show_html(self, html: str) -> None:
        self.text.setHtml(html)
        self.show()
        self.raise_()

    def show_stage(self, stage: str) -> None:
        paragraphs = "".join(f"<p>{escape(text)}</p>" for text in stage_help(stage))
        self.show_html(f"<h2>{escape(stage_title(stage))}</h2>{paragraphs}{mouse_help()}")

    def show_keys(self, actions: Iterable[tuple[str, QAction]]) -> None:
        rows = []
        for path, action in actions:
            keys = ", ".join(k.toString(k.SequenceFormat.PortableText) for k in action.shortcuts())
            if keys:
                name = action.text().replace("&", "")
                rows.append(
                    f"<tr><td><b>{escape(keys)}</b>&nbsp;&nbsp;</td><td>{escape(name)}</td>"
                    f"<td>&nbsp;&nbsp;<i>{escape(path)}</i></td></tr>"
                )
        title = escape(tr("Keyboard and mouse"))
        self.show_html(f"<h2>{title}</h2>{mouse_help()}<table>{''.join(rows)}</table>")

    def show_about(self) -> None:
        text = [
            tr("Soft-tissue organ models that surgeons in training can feel."),
            tr("Not validated, not a medical device."),
            tr("The editor is free software under the GNU General Public License 3 or later; what "
               "it publishes is yours."),
        ]  # fmt: skip
        paragraphs = "".join(f"<p>{escape(line)}</p>" for line in text)
        self.show_html(f"<h2>Palpate {palpate.__version__}</h2>{paragraphs}")


def mouse_help() -> str:
    rows = (
        (tr("Left drag beside the organ, or with Orbit"), tr("turn")),
        (tr("Right or middle drag while a brush is on"), tr("turn")),
        (tr("Shift and drag, or middle drag"), tr("move")),
        (tr("Wheel"), tr("zoom to the pointer")),
        ("[  ]", tr("size of the brush")),
        (tr("Shift / Ctrl with a brush"), tr("smooth / erase")),
        ("Esc", tr("back to Orbit")),
    )
    lines = "".join(
        f"<tr><td><b>{escape(keys)}</b>&nbsp;&nbsp;</td><td>{escape(text)}</td></tr>"
        for keys, text in rows
    )
    return f"<table>{lines}</table>"
