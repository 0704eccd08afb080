# SPDX-License-Identifier: BSD-3-Clause
"""A simulated hand that plays an attempt beside the window, which goes on meanwhile."""

from __future__ import annotations

from threading import Event, Thread
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

import palpate
from palpate.assessment.selfplay import Attempt, attempt
from palpate.player.sentences import translate

if TYPE_CHECKING:
    from palpate.player.host import Host


class HandWork(QObject):
    """One attempt at a time, in a thread of its own: seconds of work, for it has to be computed
    tick by tick. Signals come in the thread of the window.
    """

    played = Signal(object)
    """Attempt"""
    failed = Signal(str)
    _over = Signal(object)

    def __init__(self, parent: QObject):
        super().__init__(parent)
        self._thread: Thread | None = None
        self._stop = Event()
        self._over.connect(self._tell)

    @property
    def running(self) -> bool:
        return self._thread is not None

    def start(self, scene: palpate.Scene, drawn: palpate.scenario.DrawnTask, hand: str) -> None:
        """What was begun before is given up."""
        self.stop()
        self._stop = Event()
        self._thread = Thread(target=self._play, args=(scene, drawn, hand, self._stop), daemon=True)
        self._thread.start()

    def stop(self) -> None:
        """Within a few ticks; nothing is told of what was given up."""
        self._stop.set()
        thread, self._thread = self._thread, None
        if thread is not None:
            thread.join()

    def _play(
        self, scene: palpate.Scene, drawn: palpate.scenario.DrawnTask, hand: str, stop: Event
    ) -> None:
        found: Attempt | Exception
        try:
            found = attempt(scene, drawn, hand, stop.is_set)
        except Exception as problem:  # said in the window, whatever it is
            found = problem
        if not stop.is_set():
            self._over.emit((stop, found))

    def _tell(self, told: tuple[Event, Attempt | Exception]) -> None:
        stop, found = told
        if stop is not self._stop or stop.is_set():
            return
        self._thread = None
        if isinstance(found, Attempt):
            self.played.emit(found)
        else:
            self.failed.emit(f"{type(found).__name__}: {found}")


class Preparation(QObject):
    """Before a run of a simulated hand: it computes its attempt first, then the run begins."""

    def __init__(self, window: Host, parent: QObject):
        super().__init__(parent)
        self._window = window
        self._work = HandWork(self)
        self._work.played.connect(self._take)
        self._work.failed.connect(self._refuse)

    @property
    def running(self) -> bool:
        return self._work.running

    def start(self) -> bool:
        """False where there is nothing to prepare."""
        play = self._window.play
        if play.has_hand() or play.drawn is None:
            return False
        self._window.show_board(None)
        self._say(translate("Player", "The simulated hand gets ready. Esc leaves it."))
        self._work.start(self._window.scene, play.drawn, play.hand)
        return True

    def leave(self) -> None:
        """Back to where it was started from."""
        self.stop()
        self._say("")
        self._window.show_board(self._window.over.start)

    def stop(self) -> None:
        self._work.stop()

    def _say(self, sentence: str) -> None:
        self._window.over.warning.tell(sentence)
        self._window.over.place()

    def _take(self, played: Attempt) -> None:
        self._window.play.samples = played.samples
        self._say("")
        self._window.restart()

    def _refuse(self, problem: str) -> None:
        self.leave()
        text = translate("Player", "The simulated hand cannot play: %1")
        self._window.over.alarm.tell(text.replace("%1", problem))
        self._window.over.place()
