# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of several bodies in the verbs that open published files."""

from __future__ import annotations

import copy
import json
from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate import scenario
from palpate.cli.main import main
from palpate.runs.press import find_top
from palpate.scene.surfaces import join_positions, join_rest_surfaces, join_triangles
from published import write_press
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from surfaces import organ_scene
from windows import LEFT, move

BESIDE = np.array([0.07, 0.0, 0.0])


def write_pair(folder: Path, instruments: int = 1) -> Path:
    """Two organs, the second 70 mm beside the first and of fewer vertices."""
    tissues = [copy.copy(organ_scene(n).bodies[0].tissue) for n in (2, 1)]
    np.asarray(tissues[1].rest_position)[:] += BESIDE
    bodies = [palpate.SoftBody(tissue=tissue) for tissue in tissues]
    scene = palpate.Scene(bodies=bodies, instruments=[palpate.Instrument()] * instruments)
    path = folder / "pair.palpate"
    scenario.write(path, scenario.Scenario(scene=palpate.build_scene(scene), title="Two organs"))
    return path


def test_the_window_shows_every_body_and_the_mouse_presses_the_first(tmp_path, open_window, qtbot):
    path = write_pair(tmp_path)
    window = open_window(path)
    counts = [len(body.tissue.rest_position) for body in window.scene.bodies]
    assert len(window.view.scenery.vertices) == sum(counts) == 162 + 42
    rest = window.view.scenery.vertices.copy()

    window.restart()
    top = window.view.world_to_pixel(find_top(window.scene).point).toPoint()
    move(window.view, top)
    QTest.mousePress(window.view, LEFT, Qt.KeyboardModifier.NoModifier, top)
    qtbot.waitUntil(lambda: window.over.force.force > 0.0, timeout=20_000)

    moved = np.linalg.norm(window.view.scenery.vertices - rest, axis=1)
    assert moved[: counts[0]].max() > 1e-4
    assert moved[counts[0] :].max() < 1e-6
    window.close()
    record = palpate.read_record(window.report()["record"])
    assert palpate.replay(window.scene, record).equal


@pytest.mark.usefixtures("little_sky")
def test_a_headless_play_of_two_bodies_replays_and_draws(tmp_path, capsys):
    path, record = write_pair(tmp_path), tmp_path / "pair.prec"
    device = f"script:{write_press(tmp_path)}"
    assert main(["play", str(path), "--headless", "--device", device, "--record", str(record)]) == 0
    assert main(["replay", str(record)]) == 0
    assert "the same bits" in capsys.readouterr().out
    assert palpate.read_record(record).instruments == 1
    for file in (path, record):
        out = tmp_path / f"{file.suffix[1:]}.png"
        assert main(["render", str(file), "-o", str(out), "--size", "320x180"]) == 0
        assert out.stat().st_size > 1000


def test_several_instruments_are_refused_by_what_has_one_device(tmp_path, capsys):
    path = write_pair(tmp_path, instruments=2)

    assert main(["press", str(path), "--json"]) == 1

    told = json.loads(capsys.readouterr().out)["error"]
    assert (told["where"], told["got"]) == ("scene.instruments", "2")
    assert told["expected"] == "1, as there is one device to drive them"


def test_surfaces_of_all_bodies_are_one():
    bodies = [palpate.SoftBody(tissue=organ_scene(n).bodies[0].tissue) for n in (1, 0)]
    scene = palpate.build_scene(palpate.Scene(bodies=bodies))

    x, triangles = join_rest_surfaces(scene), join_triangles(scene)

    assert len(x) == 42 + 12
    assert len(triangles) == 80 + 20
    assert triangles[80:].min() == 42
    assert np.array_equal(x[triangles[80:]], x[42:][np.asarray(bodies[1].tissue.triangles)])
    assert np.array_equal(join_positions([x[:42], x[42:]]), x)
