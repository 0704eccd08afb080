# SPDX-License-Identifier: GPL-3.0-or-later
"""Long work runs beside the window: it goes on living, and can be cancelled."""

from __future__ import annotations

import threading

import pytest
from hands import child, click
from palpate_editor import authoring
from palpate_editor.edits import decimate as decimate_room
from palpate_editor.edits import import_mesh as import_room
from palpate_editor.views import assessment, tasks
from patience import PATIENCE, settle
from PySide6.QtCore import QTimer

pytestmark = [pytest.mark.window, pytest.mark.landing]

HEAVY = [
    ("VH_F_Spleen", (), 1200),
    pytest.param("VH_M_Heart", ("VH_M_left_cardiac_atrium",), 4000, marks=pytest.mark.verify),
]
"""Organs, their parts, and to how many vertices: a spleen of 4274 vertices, and the largest surface
among the shared organs that is clean, of 16967."""


class Heartbeat:
    """Counts how often the window's thread got round to its events, phase by phase."""

    def __init__(self, window):
        self.beats: dict[str, int] = {}
        self.phase = "idle"
        self.enough = threading.Event()
        self.timer = QTimer(window, interval=5)
        self.timer.timeout.connect(self.beat)
        self.timer.start()

    def beat(self) -> None:
        self.beats[self.phase] = self.beats.get(self.phase, 0) + 1
        if self.beats.get("import_read", 0) >= 3:
            self.enough.set()


def record_threads(monkeypatch, module, names, seen, heartbeat) -> None:
    """Notes on which thread the heavy functions of a module run, and what phase that is.

    Reading a file ends within a few beats, so its thread stays until the window had three of them.
    """
    for name in names:
        real = getattr(module, name)

        def watched(*args, real=real, name=name, **options):
            seen[name] = threading.get_ident()
            heartbeat.phase = name
            try:
                result = real(*args, **options)
                if name == "import_read":
                    assert heartbeat.enough.wait(PATIENCE / 1000)
                return result
            finally:
                heartbeat.phase = "idle"

        monkeypatch.setattr(module, name, watched)


@pytest.mark.parametrize(("organ", "parts", "vertices"), HEAVY, ids=["spleen", "heart"])
def test_the_window_lives_through_a_heavy_import_and_decimation(
    qtbot, window, shared_data, monkeypatch, organ, parts, vertices
):
    path = shared_data(f"organs/{organ}.glb")
    heartbeat, seen = Heartbeat(window), {}
    record_threads(monkeypatch, tasks, ["import_read", "decimate_organ"], seen, heartbeat)
    record_threads(monkeypatch, assessment, ["assess", "measure_distances"], seen, heartbeat)

    window.tasks.import_mesh(path, list(parts))
    settle(qtbot, window)
    window.tasks.decimate(vertices)
    settle(qtbot, window)

    assert window.session.organ.decimation.vertices == vertices
    assert set(seen) == {"import_read", "decimate_organ", "assess", "measure_distances"}
    assert threading.get_ident() not in seen.values()
    # the others take many times longer than a beat: the window never waited for one to end
    for phase in ("import_read", "decimate_organ", "assess"):
        assert heartbeat.beats.get(phase, 0) >= 3, (phase, heartbeat.beats)


def test_the_heavy_functions_are_the_ones_the_work_calls():
    """What the test above watches is what does the work."""
    assert tasks.import_read is import_room.import_read
    assert tasks.decimate_organ is decimate_room.decimate_organ
    assert decimate_room.authoring is authoring


def test_cancelling_lets_the_window_go_on_and_changes_nothing(qtbot, spleen_window, monkeypatch):
    window, held = spleen_window, threading.Event()
    before = window.session.organ
    real = tasks.decimate_organ

    def slow(organ, vertices, features):
        assert held.wait(PATIENCE / 1000)
        return real(organ, vertices, features)

    monkeypatch.setattr(tasks, "decimate_organ", slow)
    window.tasks.decimate(1200)
    job = window.context.jobs.current
    button = child(window, "cancel_job")
    qtbot.waitUntil(button.isVisible, timeout=PATIENCE)  # after half a second, not before
    assert "Decimating to 1200 vertices" in window.status.busy.label.text()

    click(button)

    assert window.context.jobs.current is None
    assert "cancelled" in window.messages.text
    with qtbot.waitSignal(job.ended, timeout=PATIENCE):
        held.set()
    assert window.session.organ is before


@pytest.mark.landing
def test_a_second_long_work_is_refused_with_a_sentence(qtbot, spleen_window, monkeypatch):
    window, held = spleen_window, threading.Event()
    real = tasks.decimate_organ
    monkeypatch.setattr(tasks, "decimate_organ", lambda *a: held.wait(PATIENCE / 1000) and real(*a))
    window.tasks.decimate(1200)

    window.tasks.decimate(700)

    assert "still under way" in window.messages.text
    held.set()
    settle(qtbot, window)
    assert window.session.organ.vertex_count == 1200


@pytest.mark.landing
def test_work_that_changed_organ_meanwhile_is_refused(qtbot, spleen_window, spleen, monkeypatch):
    window, held = spleen_window, threading.Event()
    real = tasks.decimate_organ
    monkeypatch.setattr(tasks, "decimate_organ", lambda *a: held.wait(PATIENCE / 1000) and real(*a))
    window.tasks.decimate(1200)
    window.session.history.setIndex(0)

    held.set()
    settle(qtbot, window)

    assert window.session.organ.surface is None
    assert "decimate it again" in window.messages.text


def test_a_failure_inside_work_is_a_sentence(qtbot, spleen_window, monkeypatch):
    window = spleen_window

    def fail(organ, vertices, features):
        raise KeyError("surprise")

    monkeypatch.setattr(tasks, "decimate_organ", fail)
    window.tasks.decimate(1200)
    settle(qtbot, window)

    assert "Something went wrong in the editor itself" in window.messages.text
    assert "Traceback" not in window.messages.text


def test_closing_waits_for_work_that_is_under_way(qtbot, spleen_window, monkeypatch):
    window = spleen_window

    def work_until_cancelled(organ, vertices, features):
        assert window.context.jobs.current.progress.stop.wait(PATIENCE / 1000)

    monkeypatch.setattr(tasks, "decimate_organ", work_until_cancelled)
    window.tasks.decimate(1200)
    job = window.context.jobs.current

    window.may_close = True
    window.close()

    assert not job.thread.is_alive()
    assert window.context.jobs.start("late", print, print, print) is None
