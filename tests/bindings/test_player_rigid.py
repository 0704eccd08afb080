# SPDX-License-Identifier: BSD-3-Clause
"""Stones and tables in what plays, replays and draws published files."""

from __future__ import annotations

import math

import numpy as np
import palpate
import pytest
from palpate.cli.main import main
from palpate.render import draw_picture
from palpate.render.hard_parts import build_shape, place_shape
from palpate.runs.pictures import draw_hard_parts
from palpate.scene.surfaces import join_rest_surfaces, join_triangles
from published import write_press
from stones import RADIUS, START, TABLE, make_stone_scene, make_table, write_stone


def drawn(window, name: str) -> np.ndarray:
    return np.array(window.view.scenery._things[name].streams["position"])


def test_the_window_shows_the_table_and_the_stone_where_it_has_fallen(tmp_path, open_window, qtbot):
    window = open_window(write_stone(tmp_path))
    table = drawn(window, "scenery 0")
    assert table[:, 2].max() == pytest.approx(TABLE)
    assert np.allclose(drawn(window, "rigid 0").mean(axis=0), START, atol=1e-6)

    window.restart()
    qtbot.waitUntil(lambda: window.shown.time > 0.5, timeout=20_000)

    stone = drawn(window, "rigid 0")
    assert stone[:, 2].min() == pytest.approx(TABLE, abs=1e-4)
    assert stone[:, 2].max() - stone[:, 2].min() == pytest.approx(2 * RADIUS, rel=0.05)
    assert np.array_equal(drawn(window, "scenery 0"), table)
    window.restart()
    assert np.allclose(drawn(window, "rigid 0").mean(axis=0), START, atol=1e-6)
    window.close()
    record = palpate.read_record(window.report()["record"])
    assert palpate.replay(window.scene, record).equal


def test_the_window_keeps_a_stone_beside_the_organ_in_sight(tmp_path, open_window):
    window = open_window(write_stone(tmp_path))
    for corner in drawn(window, "rigid 0"):
        pixel = window.view.world_to_pixel(corner)
        assert 0 <= pixel.x() <= window.view.width()
        assert 0 <= pixel.y() <= window.view.height()


@pytest.mark.usefixtures("little_sky")
def test_a_headless_play_of_a_stone_replays_to_the_bit_and_draws(tmp_path, capsys):
    path, record = write_stone(tmp_path), tmp_path / "stone.prec"
    device = f"script:{write_press(tmp_path)}"
    assert main(["play", str(path), "--headless", "--device", device, "--record", str(record)]) == 0
    assert main(["replay", str(record)]) == 0
    assert "the same bits" in capsys.readouterr().out
    for file in (path, record):
        out = tmp_path / f"{file.suffix[1:]}.png"
        assert main(["render", str(file), "-o", str(out), "--size", "320x180"]) == 0
        assert out.stat().st_size > 1000


def test_a_snapshot_tells_where_a_stone_is():
    scene = make_stone_scene()
    far = palpate.KeyFrame()
    far.position = (0.0, 0.0, 0.2)
    loop = palpate.Loop(scene, palpate.ScriptedDevice([far]), palpate.LoopOptions(duration=0.4))
    loop.start()
    assert loop.wait(20.0)
    loop.take_snapshot()

    (stone,) = loop.snapshot().rigid

    world = palpate.World(scene)
    for i in range(loop.snapshot().tick + 1):
        sample = palpate.HapticSample(position=(0.0, 0.0, 0.2), time=i * 1e-3)
        palpate.tick(scene, sample, 1e-3, world)
    assert np.array_equal(stone.position, world.rigid[0].position)
    assert np.array_equal(stone.orientation, world.rigid[0].orientation)
    assert stone.position[2] < TABLE + 0.006


@pytest.mark.usefixtures("little_sky")
def test_a_picture_has_the_stone_where_it_is():
    scene = make_stone_scene()
    x, triangles = join_rest_surfaces(scene), join_triangles(scene)
    options = {"size": (320, 240), "supersample": 1, "wireframe": False}

    def draw(height: float) -> np.ndarray:
        state = palpate.RigidState()
        state.position = (0.05, 0.0, height)
        return draw_picture(x, triangles, beside=draw_hard_parts(scene, [state]), **options)

    def has_ochre(pixels: np.ndarray) -> np.ndarray:
        """Neither red as tissue nor white as bone."""
        r, g, b = pixels.astype(int).transpose(2, 0, 1)
        return (b < 0.72 * r) & (g > 0.75 * r)

    high, low = has_ochre(draw(0.02)), has_ochre(draw(-0.05))
    assert high.sum() > 20 and low.sum() > 20
    assert np.argwhere(high)[:, 0].mean() < np.argwhere(low)[:, 0].mean()


def test_a_box_keeps_its_edges_and_a_ball_is_smooth():
    box = build_shape(make_table())
    assert {tuple(np.abs(np.rint(n))) for n in box.normals} == {(1, 0, 0), (0, 1, 0), (0, 0, 1)}
    assert np.allclose(np.abs(box.normals).max(axis=1), 1.0)
    ball = build_shape(make_stone_scene().rigid[0].mesh)
    out = ball.vertices / np.linalg.norm(ball.vertices, axis=1, keepdims=True)
    assert np.einsum("ij,ij->i", out, ball.normals).min() > math.cos(math.radians(6.0))


def test_a_shape_is_turned_about_its_own_origin_and_moved():
    half = math.sqrt(0.5)
    placed = place_shape(build_shape(make_table()), (1.0, 0.0, 0.0), (0.0, 0.0, half, half))
    before = build_shape(make_table())
    assert np.allclose(placed.vertices[:, 0], 1.0 - before.vertices[:, 1], atol=1e-6)
    assert np.allclose(placed.vertices[:, 1], before.vertices[:, 0], atol=1e-6)
    assert np.allclose(placed.normals[:, 1], before.normals[:, 0], atol=1e-6)
