# SPDX-License-Identifier: BSD-3-Clause
"""The application that windows of palpate stand in."""

from __future__ import annotations

from PySide6.QtCore import QLocale
from PySide6.QtGui import QSurfaceFormat
from PySide6.QtWidgets import QApplication

from palpate import translation
from palpate.viewport.gl_view import build_format


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


def use_language(code: str) -> None:
    """One of palpate.translation.LANGUAGES, from now on, in the words and numbers of all windows.

    Numbers first: windows say everything again when they are told of the words.
    """
    app = QApplication.instance()
    assert app is not None
    QLocale.setDefault(QLocale(code))
    translation.install(app, code)
