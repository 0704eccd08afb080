# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb `editor`: opens the window; Qt is only loaded when it is called."""

from __future__ import annotations

import argparse
import logging
import signal
from pathlib import Path

from palpate.display import require_display
from palpate.verb import Refusal, Report, Verb

LANGUAGES = ("en", "tr")
INSTEAD = (
    "these verbs do the editor's work without one: import, inspect, repair, decimate, material, "
    "check, press, publish"
)


def add_editor(word: argparse.ArgumentParser) -> None:
    word.add_argument(
        "file", type=Path, nargs="?", help=".organ, .palpate or mesh file to begin with"
    )
    word.add_argument("--theme", choices=("dark", "light"), help="default: as chosen last")
    word.add_argument("--language", choices=LANGUAGES, help="default: as chosen last")


def run_editor(call: argparse.Namespace) -> Report:
    if call.file is not None and not call.file.is_file():
        raise Refusal(call.file, "", "no such file", "an .organ, a .palpate or a mesh file")
    require_display(INSTEAD)
    logging.basicConfig(level=logging.WARNING, format="palpate editor: %(message)s")
    return open_window(call.file, call.theme, call.language)


def open_window(file: Path | None, theme: str | None, language: str | None) -> Report:
    """Shows the window until it is closed."""
    from palpate.viewport.gl_view import build_format
    from PySide6.QtGui import QSurfaceFormat
    from PySide6.QtWidgets import QApplication

    from palpate_editor.app.settings import Settings
    from palpate_editor.views.editor import Editor

    QSurfaceFormat.setDefaultFormat(build_format())
    app = QApplication.instance() or QApplication(["palpate"])
    app.setApplicationName("Palpate Editor")
    app.setDesktopFileName("palpate-editor")
    editor = Editor(app, Settings(), theme=theme, language=language)
    # Ctrl+C in the terminal: Qt's loop would not let Python hear it; what is unsaved is recovered
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    editor.show()
    if file is not None:
        editor.window.files.open(file)
    code = app.exec()
    return {"closed": True, "code": code}


def describe_editor(report: Report) -> str:
    return "closed"


EDITOR = Verb(
    "editor",
    "open the organ editor",
    "palpate editor spleen.organ --theme light",
    add_editor,
    run_editor,
    describe_editor,
)
