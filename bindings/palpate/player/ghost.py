# SPDX-License-Identifier: BSD-3-Clause
"""Before an attempt: how its task is done, shown by a simulated careful hand and never felt."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer, Signal

import palpate
from palpate.assessment.selfplay import Attempt
from palpate.player.hand_work import HandWork
from palpate.player.sentences import translate
from palpate.runs.live import Frame, LiveRun
from palpate.scene.surfaces import join_rest_surfaces
from palpate.viewport.application import FRAME_MS
from palpate.viewport.show_frame import show_frame

if TYPE_CHECKING:
    from palpate.player.host import Host


class Ghost(QObject):
    """Computes an attempt of a careful hand at the same level and seed, once, then shows it as
    often as is wanted: the organ gives way as it did then. No device is opened, and nothing is
    recorded or judged of the trainee.
    """

    ended = Signal()

    def __init__(self, window: Host, parent: QObject):
        super().__init__(parent)
        self.window, self.over = window, window.over
        self.run: LiveRun | None = None
        self.attempt: Attempt | None = None
        self.work = HandWork(self)
        self.work.played.connect(self._take)
        self.work.failed.connect(self._refuse)
        self._timer = QTimer(self, interval=FRAME_MS)
        self._timer.timeout.connect(self.follow)

    def is_offered(self) -> bool:
        """Not where it would give away what is to be found."""
        drawn = self.window.play.drawn
        if drawn is None:
            return False
        return all(step.verb is not palpate.TaskVerb.find for step in drawn.task.steps)

    @property
    def busy(self) -> bool:
        """While it is computed or shown."""
        return self.run is not None or self.work.running

    def show(self) -> None:
        if self.busy or not self.is_offered():
            return
        self.window.show_board(None)
        if self.attempt is not None:
            self._begin()
            return
        drawn = self.window.play.drawn
        assert drawn is not None
        self._say(translate("Player", "The simulated hand gets ready. Esc leaves it."))
        self.work.start(self.window.scene, drawn, "careful")

    def stop(self) -> None:
        """Back to what it was shown from; nothing where it is not shown."""
        if self.busy:
            self._end()
            self.ended.emit()

    def forget(self) -> None:
        """Another attempt was drawn."""
        self.close()
        self.attempt = None

    def close(self) -> None:
        """Without a word: the window goes, or a run begins."""
        if self.busy:
            self._end()

    def follow(self) -> None:
        """Shows what has come since the last frame."""
        run = self.run
        if run is None:
            return
        frame = None if self.window.view.is_busy() else run.take_frame()
        if frame is not None:
            self._show(frame)
        if not run.running:
            self.stop()

    def _take(self, played: Attempt) -> None:
        self.attempt = played
        self._begin()

    def _refuse(self, problem: str) -> None:
        text = translate("Player", "The task cannot be shown: %1")
        self._end()
        self.ended.emit()
        self.over.alarm.tell(text.replace("%1", problem))
        self.over.place()

    def _begin(self) -> None:
        assert self.attempt is not None
        samples = self.attempt.samples
        scene, drawn = self.window.scene, self.attempt.drawn
        options = palpate.LoopOptions(duration=len(samples[0]) / scene.rate)
        devices = [palpate.ReplayDevice(each) for each in samples]
        self.run = LiveRun(scene, devices, options=options, task=drawn.task)
        self._say(translate("Player", "A simulated hand shows how it is done. Esc leaves it."))
        self.run.start()
        self._timer.start()

    def _say(self, sentence: str) -> None:
        self.over.warning.tell(sentence)
        self.over.place()

    def _show(self, frame: Frame) -> None:
        show_frame(self.window.view, self.window.scene, frame)
        self.window.marks.show(frame)
        self.window.play.state = frame.task
        self.over.tell_task()
        self.over.place()

    def _end(self) -> None:
        self._timer.stop()
        self.work.stop()
        run, self.run = self.run, None
        if run is not None:
            run.finish()
        self.window.play.state = None
        self.over.tell_task()
        view = self.window.view
        view.show_instruments(())
        view.move_surface(join_rest_surfaces(self.window.scene))
        view.show_torn(None)
        view.move_rigid(self.window.scene.rigid)
        self.window.marks.show_first()
        self._say("")
