# SPDX-License-Identifier: BSD-3-Clause
"""What is common to the windows of player and device."""

from __future__ import annotations

import gc
import threading
import weakref

import pytest
from palpate.viewport import application


class Node:
    """That refers to itself, as a widget does that keeps its own bound method."""

    def __init__(self, ended: list[str]):
        self.itself = self
        weakref.finalize(self, lambda: ended.append(threading.current_thread().name))


@pytest.fixture(autouse=True)
def collecting():
    """As a program begins: tests of windows leave the collector off in their process."""
    collected = gc.isenabled()
    gc.enable()
    yield
    if not collected:
        gc.disable()


def test_reference_cycles_end_in_the_thread_of_the_windows(qtbot, monkeypatch):
    monkeypatch.setattr(application, "SWEEP", 20)
    ended: list[str] = []

    def work() -> None:  # as much as a collection would begin at, many times
        kept = [[] for _ in range(200_000)]
        del kept

    with application.collect_in_this_thread():
        Node(ended)
        thread = threading.Thread(target=work, name="hand")
        thread.start()
        thread.join()
        assert ended == []
        qtbot.waitUntil(lambda: ended != [])

    assert ended == [threading.main_thread().name]
    assert gc.isenabled()


def test_where_nothing_was_collected_nothing_is_afterwards():
    gc.disable()
    with application.collect_in_this_thread():
        pass
    assert not gc.isenabled()
