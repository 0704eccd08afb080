# SPDX-License-Identifier: BSD-3-Clause
"""The application that windows of palpate stand in."""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager

from PySide6.QtCore import QLocale, QTimer
from PySide6.QtGui import QSurfaceFormat
from PySide6.QtWidgets import QApplication

from palpate import translation
from palpate.viewport.gl_view import build_format

FRAME_MS = 16
"""[ms] between two frames of what moves."""
SWEEP = 2000
"""[ms] between two collections of reference cycles."""


def open_application(language: str | None) -> tuple[QApplication, str]:
    """The application, made where there is none, and the code of the language it now speaks."""
    app = QApplication.instance()
    if app is None:
        QSurfaceFormat.setDefaultFormat(build_format())
        app = QApplication(["palpate"])
    app.setApplicationName("palpate")
    app.setStyle("Fusion")
    code = translation.install(app, language)
    QLocale.setDefault(QLocale(code))
    return app, code


@contextmanager
def collect_in_this_thread() -> Iterator[None]:
    """Reference cycles are collected by the thread of the windows alone: widgets and what they draw
    with must die in it, and a collection in the thread of a hand or device would end them there.

    What stands at the beginning stays, as sweeping through all of it would stop a frame.
    """
    collected = gc.isenabled()
    gc.disable()
    gc.collect()
    gc.freeze()
    sweeper = QTimer(interval=SWEEP)
    sweeper.timeout.connect(_sweep)
    sweeper.start()
    try:
        yield
    finally:
        sweeper.stop()
        gc.unfreeze()
        if collected:
            gc.enable()


def _sweep() -> None:
    gc.collect()


def use_language(code: str) -> None:
    """One of palpate.translation.LANGUAGES, from now on, in the words and numbers of all windows.

    Numbers first: windows say everything again when they are told of the words.
    """
    app = QApplication.instance()
    assert app is not None
    QLocale.setDefault(QLocale(code))
    translation.install(app, code)
