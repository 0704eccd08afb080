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

from palpate_editor.views.stage import Stage
from palpate_editor.views.translations import tr

SIZE = QSize(560, 620)
"""[px]"""


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

    def show_stage(self, stage: Stage) -> None:
        paragraphs = "".join(f"<p>{escape(text)}</p>" for text in stage.help())
        self.show_html(f"<h2>{escape(stage.title())}</h2>{paragraphs}{mouse_help()}")

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
