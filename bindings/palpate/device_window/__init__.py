# SPDX-License-Identifier: BSD-3-Clause
"""The device window: connect, watch, feel, calibrate, test. Needs PySide6, as the player does."""

from palpate.device_window.start import open_device_window
from palpate.device_window.window import DeviceWindow

__all__ = ["DeviceWindow", "open_device_window"]
