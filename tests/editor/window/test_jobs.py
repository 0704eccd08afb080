# SPDX-License-Identifier: GPL-3.0-or-later
"""Work in other threads, up to the end of the window that asked for it."""

from __future__ import annotations

import threading

import pytest
from palpate_editor.views import jobs as room
from palpate_editor.views.jobs import Jobs
from patience import PATIENCE
from PySide6.QtCore import QEvent, QObject
from shiboken6 import isValid

pytestmark = [pytest.mark.window, pytest.mark.landing]


class Listener(QObject):
    """Notes what it is told."""

    def __init__(self):
        super().__init__()
        self.heard: list[object] = []

    def hear(self, said: object) -> None:
        self.heard.append(said)


@pytest.fixture
def uncaught(monkeypatch) -> list[BaseException]:
    """What no thread caught."""
    found: list[BaseException] = []
    monkeypatch.setattr(threading, "excepthook", lambda caught: found.append(caught.exc_value))
    return found


def end(qapp, jobs: Jobs) -> None:
    """As a window that goes away does it, without the time to wait for anything."""
    jobs.finish(0.0)
    jobs.deleteLater()
    qapp.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    assert not isValid(jobs)


@pytest.mark.parametrize("ending", ["returns", "raises", "speaks"])
def test_work_that_outlives_its_window_ends_unheard(qapp, uncaught, ending):
    jobs, listener, held = Jobs(), Listener(), threading.Event()

    def work(progress):
        assert held.wait(PATIENCE / 1000)
        if ending == "raises":
            raise ValueError("late")
        if ending == "speaks":
            progress.said.emit("late", 0.5)
        return "late"

    job = jobs.start("held", work, listener.hear, listener.hear)
    job.progressed.connect(listener.hear)
    end(qapp, jobs)
    assert job.thread.is_alive() and isValid(job) and isValid(job.progress)

    held.set()
    job.thread.join(PATIENCE / 1000)
    qapp.processEvents()

    assert not job.thread.is_alive()
    assert uncaught == []
    assert listener.heard == []


def test_what_outlived_a_window_is_let_go_once_its_thread_has_ended(qapp, uncaught):
    jobs, listener, held = Jobs(), Listener(), threading.Event()
    job = jobs.start("held", lambda progress: held.wait(PATIENCE / 1000), listener.hear, print)
    end(qapp, jobs)
    assert job in room.OUTLIVED

    held.set()
    job.thread.join(PATIENCE / 1000)
    end(qapp, Jobs())

    assert job not in room.OUTLIVED
    assert uncaught == []


def test_work_that_ends_in_time_is_waited_for(qapp, uncaught):
    jobs, listener = Jobs(), Listener()
    job = jobs.start_unseen("short", lambda progress: "done", listener.hear, listener.hear)

    jobs.finish()
    job_ended = not job.thread.is_alive()
    end(qapp, jobs)
    qapp.processEvents()

    assert job_ended and job not in room.OUTLIVED
    assert uncaught == [] and listener.heard == []
