# SPDX-License-Identifier: GPL-3.0-or-later
"""Long work in threads of its own: the window never waits for it.

A job's work is a plain function. It gets a `Progress`, tells it what it is doing, and by that asks
whether it is still wanted. The C++ functions it calls release the interpreter, so the window keeps
drawing. Cancelling lets the window go on at once; the work itself ends at its next step.
"""

from __future__ import annotations

import logging
import threading
import time
from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QObject, Signal

LOG = logging.getLogger(__name__)

OUTLIVED: list[Job] = []
"""Work that was still under way when its window closed: kept until its thread has ended, because
a signal of an object that is gone, or an object that ends in another thread, ends the program."""


class Cancelled(Exception):  # noqa: N818  # not an error: a person wanted it
    """Raised inside work that is no longer wanted."""


class Progress(QObject):
    """What work says while it runs; made in the window's thread, used in the work's."""

    said = Signal(str, float)

    def __init__(self, parent: QObject | None = None):
        super().__init__(parent)
        self.stop = threading.Event()

    def __call__(self, text: str, share: float) -> None:
        """Says what begins now and how much is done, 0 to 1. Raises Cancelled."""
        if self.stop.is_set():
            raise Cancelled
        self.said.emit(text, share)


Work = Callable[[Progress], Any]


class Job(QObject):
    """One piece of work under way. Its signals arrive in the window's thread."""

    progressed = Signal(str, float)
    done = Signal(object)
    refused = Signal(object)
    """The exception."""
    released = Signal(object)
    """The job, before done and refused: the next one may begin."""
    ended = Signal(object)
    """The job, after done or refused, or when cancelled work has let go."""
    _finished = Signal(object, object)

    def __init__(self, title: str, work: Work, parent: QObject | None = None):
        super().__init__(parent)
        self.title, self.work = title, work
        self.progress = Progress(self)
        self.speaking = threading.Lock()
        self.left = False
        self.progress.said.connect(self.tell)
        self._finished.connect(self.finish)
        self.thread_id: int | None = None
        self.thread = threading.Thread(target=self.run, name=title, daemon=True)

    def start(self) -> None:
        self.thread.start()

    def run(self) -> None:
        """In the work's thread."""
        self.thread_id = threading.get_ident()
        try:
            result, problem = self.work(self.progress), None
        except BaseException as caught:  # whatever it is, the window must hear of it
            result, problem = None, caught
        with self.speaking:
            if not self.left:
                self._finished.emit(result, problem)

    def tell(self, text: str, share: float) -> None:
        if not self.cancelled and not self.left:
            self.progressed.emit(text, share)

    def finish(self, result: object, problem: object) -> None:
        if self.left:
            return
        self.thread.join()
        self.released.emit(self)
        if not self.cancelled:
            if problem is None:
                self.done.emit(result)
            elif not isinstance(problem, Cancelled):
                self.refused.emit(problem)
        self.ended.emit(self)

    @property
    def cancelled(self) -> bool:
        return self.progress.stop.is_set()

    def cancel(self) -> None:
        self.progress.stop.set()

    def leave(self) -> None:
        """Belongs to no window any more, and says nothing from now on."""
        with self.speaking:
            self.left = True
        self.setParent(None)


class Jobs(QObject):
    """The window's long work: one at a time that a person waits for, others unseen."""

    started = Signal(object)
    stopped = Signal(object)
    """A job that is done, refused or cancelled: the window is free again."""

    def __init__(self, parent: QObject | None = None):
        super().__init__(parent)
        self.current: Job | None = None
        self.alive: list[Job] = []
        self.closed = False

    def start(
        self,
        title: str,
        work: Work,
        done: Callable[[Any], None],
        refused: Callable[[BaseException], None],
    ) -> Job | None:
        """Starts work a person waits for; None where other such work is under way.

        `done` and `refused` must be bound methods of objects of the window's thread.
        """
        if self.current is not None or self.closed:
            return None
        self.current = job = self._launch(title, work, done, refused)
        self.started.emit(job)
        job.start()
        return job

    def start_unseen(
        self,
        title: str,
        work: Work,
        done: Callable[[Any], None],
        refused: Callable[[BaseException], None],
    ) -> Job | None:
        """Starts work nobody waits for, such as compiling what is shown beside a form."""
        if self.closed:
            return None
        job = self._launch(title, work, done, refused)
        job.start()
        return job

    def cancel(self) -> None:
        """Lets go of the current work at once."""
        job = self.current
        if job is not None:
            job.cancel()
            self.current = None
            self.stopped.emit(job)

    def finish(self, seconds: float = 5.0) -> None:
        """Cancels everything and begins nothing more; before the window goes away.

        Waits so long [s] for all of it. What takes longer ends by itself, unheard.
        """
        self.closed = True
        for job in self.alive:
            job.cancel()
        until = time.monotonic() + seconds
        for job in self.alive:
            job.thread.join(max(0.0, until - time.monotonic()))
        OUTLIVED[:] = [job for job in OUTLIVED if job.thread.is_alive()]
        for job in [job for job in self.alive if job.thread.is_alive()]:
            job.leave()
            self.alive.remove(job)
            OUTLIVED.append(job)

    def _launch(
        self,
        title: str,
        work: Work,
        done: Callable[[Any], None],
        refused: Callable[[BaseException], None],
    ) -> Job:
        job = Job(title, work, self)
        job.released.connect(self._release)
        job.done.connect(done)
        job.refused.connect(refused)
        job.ended.connect(self._forget)
        self.alive.append(job)
        return job

    def _release(self, job: Job) -> None:
        if job is self.current:
            self.current = None
            self.stopped.emit(job)

    def _forget(self, job: Job) -> None:
        self.alive.remove(job)
        job.deleteLater()
