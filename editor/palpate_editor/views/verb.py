# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb `editor`: opens the window; Qt is only loaded when it is called."""

from __future__ import annotations

import argparse
import logging
import os
import signal
import subprocess
import sys
from pathlib import Path

from palpate.verb import Refusal, Report, Verb

LANGUAGES = ("en", "tr")
WITHOUT_WINDOW = "import, inspect, repair, decimate, material, check, press, publish"
PROBE = "from PySide6.QtGui import QGuiApplication; QGuiApplication([])"


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


def require_display() -> None:
    """Qt ends the whole program where it cannot reach a display. Raises RuntimeError."""
    if not has_display():
        raise RuntimeError(
            "the editor needs a display, and neither DISPLAY nor WAYLAND_DISPLAY is set; these "
            f"verbs do its work without one: {WITHOUT_WINDOW}"
        )
    if not sys.platform.startswith("linux") or os.environ.get("QT_QPA_PLATFORM"):
        return
    # somebody else's display, or one that is gone: only another process survives finding out
    probe = subprocess.run([sys.executable, "-c", PROBE], capture_output=True, check=False)
    if probe.returncode != 0:
        name = os.environ.get("WAYLAND_DISPLAY") or os.environ.get("DISPLAY")
        raise RuntimeError(
            f"the display {name} cannot be reached; these verbs do the editor's work without one: "
            f"{WITHOUT_WINDOW}"
        )


def run_editor(call: argparse.Namespace) -> Report:
    if call.file is not None and not call.file.is_file():
        raise Refusal(call.file, "", "no such file", "an .organ, a .palpate or a mesh file")
    require_display()
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
