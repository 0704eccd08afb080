# SPDX-License-Identifier: BSD-3-Clause
"""Opens the device window and comes back when it is closed."""

from __future__ import annotations

from PySide6.QtCore import QLocale
from PySide6.QtGui import QSurfaceFormat
from PySide6.QtWidgets import QApplication

from palpate import translation
from palpate.device_window.window import DeviceWindow
from palpate.player.start import Watch
from palpate.verb import Report
from palpate.viewport.gl_view import build_format


def open_device_window(
    device: str | None = None, language: str | None = None, theme: str = "dark"
) -> Report:
    """Shows the window until it is closed; it begins with a device where one is named."""
    app = QApplication.instance()
    if app is None:
        QSurfaceFormat.setDefaultFormat(build_format())
        app = QApplication(["palpate"])
    app.setApplicationName("palpate")
    app.setStyle("Fusion")
    code = translation.install(app, language)
    QLocale.setDefault(QLocale(code))
    window = DeviceWindow(theme, code)
    window.show()
    if device is not None:
        window.connect_to(device)
    with Watch(window):
        app.exec()
    window.close()
    return window.report()
