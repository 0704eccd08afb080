# SPDX-License-Identifier: BSD-3-Clause
"""Opens the trainee's window and comes back when it is closed."""

from __future__ import annotations

import signal
import socket
import sys
from pathlib import Path
from types import FrameType, TracebackType

from PySide6.QtCore import QSocketNotifier

from palpate.command.verb import Report
from palpate.device.names import POINTER
from palpate.player.scenario_cards import ScenariosWindow
from palpate.player.trainee_window import TraineeWindow
from palpate.runs.kept_play import Keeper
from palpate.runs.play import Play
from palpate.viewport.application import collect_in_this_thread, open_application


def play_in_window(
    play: Play, language: str | None = None, theme: str = "dark", keeper: Keeper | None = None
) -> Report:
    """Shows the window until it is closed; `keeper` is of a person who was named before. Raises
    OSError where a record was lost.
    """
    app, code = open_application(language)
    with collect_in_this_thread():
        window = TraineeWindow(play, theme, code)
        if keeper is not None:
            window.attendance.admission.use(keeper)
        window.show()
        if play.frames is not None or play.hand:  # a script needs nobody to be ready
            window.restart()
        with Watch(window):
            app.exec()
    return window.report()


def show_scenarios(
    folder: Path,
    language: str | None = None,
    theme: str = "dark",
    device: str = POINTER,
    code: str = "",
) -> Report:
    """The scenarios of a folder, until their window is closed; `code` is of a person who plays."""
    app, spoken = open_application(language)
    with collect_in_this_thread():
        window = ScenariosWindow(folder, theme, spoken, device)
        if code:
            window.identification.take_code(code)
        window.show()
        app.exec()
    return {"scenario": str(folder), "title": "", "task": "", "records": [], "record": None}


class Watch:
    """While it is entered, Ctrl-C closes the window and a defect becomes a sentence in it."""

    def __init__(self, window: TraineeWindow):
        self._window = window
        self._usual = sys.excepthook
        self._interrupt = signal.getsignal(signal.SIGINT)
        # Python runs a handler between its own instructions, and a window at rest runs none: the
        # signal's byte wakes Qt, and Qt wakes Python
        self._woken, self._waker = socket.socketpair()
        self._woken.setblocking(False)
        self._waker.setblocking(False)
        self._notifier = QSocketNotifier(self._woken.fileno(), QSocketNotifier.Type.Read)
        self._notifier.activated.connect(self._read)
        self._wakeup = -1

    def __enter__(self) -> None:
        sys.excepthook = self._tell
        signal.signal(signal.SIGINT, self._close)
        self._wakeup = signal.set_wakeup_fd(self._waker.fileno(), warn_on_full_buffer=False)

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        sys.excepthook = self._usual
        signal.signal(signal.SIGINT, self._interrupt)
        signal.set_wakeup_fd(self._wakeup)
        self._notifier.setEnabled(False)
        self._woken.close()
        self._waker.close()

    def _read(self) -> None:
        self._woken.recv(64)

    def _tell(
        self, kind: type[BaseException], error: BaseException, trace: TracebackType | None
    ) -> None:
        del kind, trace
        self._window.tell_unexpected(error)

    def _close(self, number: int, frame: FrameType | None) -> None:
        del number, frame
        self._window.close()
