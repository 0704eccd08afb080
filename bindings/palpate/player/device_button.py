# SPDX-License-Identifier: BSD-3-Clause
"""The button of the arm takes what a board offers, so that a hand need not leave the stylus."""

from __future__ import annotations

from threading import Event, Thread

from PySide6.QtCore import QObject, QTimer, Signal

import palpate
from palpate.device.link import Ended, build_link
from palpate.device.names import find_port

BUTTONS = 3
"""Bits of either button."""
LOOK_EVERY = 0.02
"""[s] Nobody presses for a shorter time."""
TRY_EVERY = 2.0
"""[s] between two tries to reach an arm."""


class Press:
    """Goes down once for each press. What is down at first was pressed for something else: jaws may
    be held closed beyond the end of a run.
    """

    def __init__(self) -> None:
        self._down = True

    @property
    def ready(self) -> bool:
        """The button has been seen up, so that the next press counts."""
        return not self._down

    def take(self, buttons: int) -> bool:
        before, self._down = self._down, bool(buttons & BUTTONS)
        return self._down and not before


class DeviceButton(QObject):
    """Listens to an arm, its motors off, while a board is shown and no run has it."""

    pressed = Signal()
    _went_down = Signal(object)

    def __init__(self, arm: str, parent: QObject):
        """`arm` is a device by name: one at a port is listened to, others have no button."""
        super().__init__(parent)
        self._arm = arm if find_port(arm) else ""
        self._thread: Thread | None = None
        self._stop, self._heard = Event(), Event()
        self._driver: palpate.SerialDevice | None = None
        self._press = Press()
        self._timer = QTimer(self, interval=round(1000 * LOOK_EVERY))
        self._timer.timeout.connect(self._look)
        self._went_down.connect(self._tell)

    @property
    def listening(self) -> bool:
        """From listen() to rest(), if there is a button to listen to."""
        return self._driver is not None or self._thread is not None

    @property
    def hears(self) -> bool:
        """The arm has answered and its button been seen up, so that a press counts from now on."""
        return self._press.ready if self._driver is not None else self._heard.is_set()

    def listen(self, driver: palpate.SerialDevice | None = None) -> None:
        """From now on; may be repeated. `driver` is of the run that rests, where there is one, read
        by this thread; without it the arm is opened beside the window.
        """
        if driver is not None:
            self.rest()
            self._driver, self._press = driver, Press()
            self._timer.start()
        elif self._arm and self._thread is None:
            self.rest()
            self._stop, self._heard = Event(), Event()
            self._thread = Thread(
                target=self._keep_company, args=(self._stop, self._heard), daemon=True
            )
            self._thread.start()

    def rest(self) -> None:
        """The arm is free for a run once this returns."""
        self._timer.stop()
        self._driver = None
        self._stop.set()
        thread, self._thread = self._thread, None
        if thread is not None:
            thread.join()

    def _look(self) -> None:
        driver = self._driver
        if driver is None:
            return
        driver.take_status()
        if self._press.take(driver.status().buttons):
            self.pressed.emit()

    def _keep_company(self, stop: Event, heard: Event) -> None:
        """In a thread of its own. An arm that cannot be reached is tried again and not told of: a
        run that needs it says what is wrong.
        """
        while not stop.is_set():
            try:
                self._wait_for_presses(stop, heard)
            except (OSError, Ended):  # DeviceError is one
                stop.wait(TRY_EVERY)

    def _wait_for_presses(self, stop: Event, heard: Event) -> None:
        link, press = build_link(self._arm), Press()
        link.begin()
        try:
            while not stop.wait(LOOK_EVERY) and not link.is_lost():
                if press.take(link.status().buttons):
                    self._went_down.emit(stop)
                if press.ready:
                    heard.set()
        finally:
            heard.clear()
            link.end()

    def _tell(self, stop: Event) -> None:
        if stop is self._stop and not stop.is_set():
            self.pressed.emit()
