# SPDX-License-Identifier: BSD-3-Clause
"""Opens the device window and comes back when it is closed."""

from __future__ import annotations

from palpate.command.verb import Report
from palpate.device_window.window import DeviceWindow
from palpate.player.start import Watch
from palpate.viewport.application import collect_in_this_thread, open_application


def open_device_window(
    device: str | None = None, language: str | None = None, theme: str = "dark"
) -> Report:
    """Shows the window until it is closed; it begins with a device where one is named."""
    app, code = open_application(language)
    with collect_in_this_thread():
        window = DeviceWindow(theme, code)
        window.show()
        if device is not None:
            window.connect_to(device)
        with Watch(window):
            app.exec()
        window.close()
    return window.report()
