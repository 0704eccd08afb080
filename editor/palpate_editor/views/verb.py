# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb `editor`: opens the window; Qt is only loaded when it is called."""

from __future__ import annotations

import argparse
import logging
import os
import sys
from pathlib import Path

from palpate.verb import Refusal, Report, Verb

LANGUAGES = ("en", "tr")


def add_editor(word: argparse.ArgumentParser) -> None:
    word.add_argument(
        "file", type=Path, nargs="?", help=".organ, .palpate or mesh file to begin with"
    )
    word.add_argument("--theme", choices=("dark", "light"), help="default: as chosen last")
    word.add_argument("--language", choices=LANGUAGES, help="default: as chosen last")


def has_display() -> bool:
    """Whether Qt can be expected to show a window; on other systems than Linux it always can."""
    if not sys.platform.startswith("linux"):
        return True
    return any(os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"))


def run_editor(call: argparse.Namespace) -> Report:
    if call.file is not None and not call.file.is_file():
        raise Refusal(call.file, "", "no such file", "an .organ, a .palpate or a mesh file")
    if not has_display():
        raise RuntimeError(
            "the editor needs a display, and neither DISPLAY nor WAYLAND_DISPLAY is set; these "
            "verbs do its work without one: inspect, import, decimate, material, check, publish"
        )
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
