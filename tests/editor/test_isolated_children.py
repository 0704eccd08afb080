# SPDX-License-Identifier: GPL-3.0-or-later
"""What stands in the current folder is data: no process that the editor starts imports it."""

from __future__ import annotations

import subprocess
from types import SimpleNamespace

import pytest
from hostile_names import list_run, make_hostile_folder
from palpate.files.refusal import Refusal
from palpate_editor import demo
from palpate_editor.authoring import READER, read_mesh
from palpate_editor.views.child_processes import ChildProcesses

PATIENCE = 60_000
"""[ms]"""


@pytest.fixture
def hostile(tmp_path, monkeypatch):
    folder = make_hostile_folder(tmp_path / "organs")
    monkeypatch.chdir(folder)
    return folder


def test_a_verb_in_another_process_imports_nothing_from_the_current_folder(hostile):
    with pytest.raises(Refusal, match=r"none\.prec"):
        demo.run_elsewhere("replay", hostile / "none.prec")

    assert list_run(hostile) == ""


def test_the_editor_that_a_demo_opens_imports_nothing_from_the_current_folder(hostile, monkeypatch):
    started = []

    def start(*words, **options):
        started.append(popen(*words, stderr=subprocess.PIPE, **options))

    popen = subprocess.Popen
    monkeypatch.setattr(demo.subprocess, "Popen", start)
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"):
        monkeypatch.delenv(name, raising=False)

    demo.open_editor(hostile / "none.organ")

    _, words = started[0].communicate()
    assert b"none.organ" in words
    assert list_run(hostile) == ""


def test_a_window_that_the_editor_opens_imports_nothing_from_the_current_folder(qtbot, hostile):
    said = []
    context = SimpleNamespace(tell=said.append, log_command=said.append)
    child_processes = ChildProcesses(context)

    child_processes.start(["play", hostile / "none.palpate"])

    qtbot.waitUntil(lambda: child_processes.running == [], timeout=PATIENCE)
    assert "none.palpate" in said[-1]
    assert list_run(hostile) == ""


def test_the_mesh_reader_is_started_by_its_own_path(hostile):
    program = hostile / READER.name
    program.write_text("#!/bin/sh\ntouch was-run\n", encoding="utf-8")
    program.chmod(0o755)
    (hostile / "a.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", encoding="utf-8")

    assert READER.is_absolute()
    assert len(read_mesh(hostile / "a.obj").parts) == 1
    assert list_run(hostile) == ""
