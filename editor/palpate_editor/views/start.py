# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens the editor's window and comes back when it is closed."""

from __future__ import annotations

import signal
from pathlib import Path

from palpate.command.verb import Report
from palpate.viewport.gl_view import build_format
from PySide6.QtGui import QSurfaceFormat
from PySide6.QtWidgets import QApplication

from palpate_editor.app.settings import Settings
from palpate_editor.views.editor import Editor
from palpate_editor.views.files import is_layout


def open_window(file: Path | None, theme: str | None, language: str | None) -> Report:
    """Shows the window until it is closed."""
    QSurfaceFormat.setDefaultFormat(build_format())
    app = QApplication.instance() or QApplication(["palpate"])
    app.setApplicationName("Palpate Editor")
    app.setDesktopFileName("palpate-editor")
    editor = Editor(app, Settings(), theme=theme, language=language)
    # Ctrl+C in the terminal: Qt's loop would not let Python hear it; what is unsaved is recovered
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    if file is not None and is_layout(file):
        editor.open_layout(file)
    if not editor.layouts:
        editor.show()
        if file is not None:
            editor.window.files.open(file)
    code = app.exec()
    return {"closed": True, "code": code}
