# SPDX-License-Identifier: BSD-3-Clause
"""What a person does with the device window, and reads in it."""

from __future__ import annotations

import palpate
from device_runs import spoil
from palpate.device.link import Link, build_link
from palpate.device_window import DeviceWindow
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel, QPushButton
from windows import LEFT

PATIENCE = 30_000
"""[ms] that a test waits on a machine that is busy."""


class QuickLink(Link):
    """A simulated device whose time passes only while a thread waits, and then at once."""

    def begin(self, live: bool | None = None) -> None:
        super().begin(live=False)


def build_quick(name: str) -> Link:
    """A plant whose time passes at once."""
    plant = build_link(name)
    return QuickLink(plant.name, plant.driver, plant.arm, plant._hand, note=plant.note)


def build_spoilt(name: str) -> Link:
    """One whose EEPROM holds what is not so."""
    plant = build_quick(name)
    plant.open()
    plant.driver.store(spoil(plant.driver.calibration()))
    return plant


def connect(window: DeviceWindow, qtbot) -> Link:
    """With the button, until there is something to see."""
    QTest.mouseClick(window.bar.go, LEFT)
    qtbot.waitUntil(lambda: window.link is not None, timeout=PATIENCE)
    link = window.link
    if isinstance(link, QuickLink):
        link.run(0.2)
    qtbot.waitUntil(lambda: link.status().reports > 100, timeout=PATIENCE)
    window.follow()
    return link


def texts(window: DeviceWindow) -> list[str]:
    """Everything that can be read now."""
    found = [*window.findChildren(QLabel), *window.findChildren(QPushButton)]
    return [thing.text() for thing in found if thing.isVisible() and thing.text()]


def wait_for_mode(window: DeviceWindow, qtbot, mode: palpate.DeviceMode) -> None:
    qtbot.waitUntil(lambda: window.link.status().mode is mode, timeout=PATIENCE)
    window.follow()


def click_through(window: DeviceWindow, qtbot) -> None:
    """The main button of the calibration, and what it takes."""
    page = window.calibrate
    QTest.mouseClick(page.go, LEFT)
    qtbot.waitUntil(lambda: not page.working, timeout=PATIENCE)
