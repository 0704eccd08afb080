# SPDX-License-Identifier: BSD-3-Clause
"""A dent is seen: in the shade of it, on every shipped organ, from where a trainee looks at it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate.runs.play import open_play
from palpate.runs.press import Place, find_place, find_top
from palpate.viewport import canvas
from palpate.viewport.dents import Dents
from PySide6.QtCore import QPointF
from surfaces import ellipsoid
from windows import grab, keep_picture, read_pixels

ORGANS = Path(__file__).resolve().parents[2] / "meshes" / "published"
# the kidney stone is not among them: nothing can dent it
SOFT = sorted(path.stem for path in ORGANS.glob("*.palpate") if path.stem != "kidney_stone")
SAMPLE, AT_LANDING = ("spleen",), ("gallbladder", "liver")
TIERS = (pytest.mark.verify, pytest.mark.landing)
"""Those that are looked at in every run."""
DENT = 3e-3
"""[m]"""


def press_until_dented(scene: palpate.Scene, place: Place) -> tuple[np.ndarray, np.ndarray]:
    """[m] The surface at rest, and pressed so far that what moved most has moved by DENT."""
    rest = palpate.compute_surface(scene.bodies[0].tissue, scene.bodies[0].tissue.rest_position)
    world = palpate.World(scene)
    for k in range(2000):
        height = scene.instruments[0].tool.radius + 4e-3 - 5e-5 * k
        sample = palpate.HapticSample(position=place.point + place.outward * height)
        palpate.tick(scene, sample, 1.0 / scene.rate, world)
        now = palpate.compute_surface(scene.bodies[0].tissue, world.bodies[0].tissue.position)
        moved = np.linalg.norm(now - rest, axis=1).max()
        if moved >= DENT:
            return rest, rest + (now - rest) * (DENT / moved)
    raise AssertionError("nothing gives way")


def find_facing(view, scene: palpate.Scene) -> Place:
    """Where the surface at rest faces the eye most."""
    x, triangles = view.scenery.vertices, view.scenery.triangles
    normals = np.asarray(palpate.compute_vertex_normals(x, triangles))
    best, found = -1.0, None
    for at in np.ndindex(14, 9):
        pixel = QPointF(*((np.array(at) + 0.5) / (14, 9) * (view.width(), view.height())))
        hit = view.pick(pixel)
        if hit is not None:
            outward = np.asarray(hit.weights) @ normals[triangles[hit.triangle]]
            faces = -float(outward @ view.ray_at(pixel)[1])
            best, found = max((best, found), (faces, hit.point), key=lambda pair: pair[0])
    return find_place(scene, np.array(found))


def count_changed(before: np.ndarray, after: np.ndarray) -> int:
    """Pixels that differ by 15 grey levels or more."""
    return int((np.abs(after.mean(axis=-1) - before.mean(axis=-1)) >= 15.0).sum())


def test_all_organs_that_can_be_dented_are_looked_at():
    assert len(SOFT) >= 6


@pytest.mark.parametrize(
    "organ",
    [name for name in SOFT if name in SAMPLE]
    + [pytest.param(name, marks=TIERS[name in AT_LANDING]) for name in SOFT if name not in SAMPLE],
)
def test_a_dent_of_3_mm_is_seen_on_every_shipped_organ(open_window, monkeypatch, organ):
    """Without the tool and its arrow, in the fine frame and in the quick one of a processor that is
    as busy as can be, so draws the fewest pixels there are."""
    monkeypatch.setattr(canvas, "QUICK_SIZES", canvas.QUICK_SIZES[:1] * 5)
    window = open_window(open_play(ORGANS / f"{organ}.palpate"))
    window.resize(1280, 800)
    window.over.show_board(None)
    view, scene = window.view, window.scene
    rest = read_pixels(view.grab_picture())
    for name, place in (("facing", find_facing(view, scene)), ("top", find_top(scene))):
        before, after = press_until_dented(scene, place)
        view.move_surface(after)
        fine = count_changed(rest, read_pixels(view.grab_picture()))
        keep_picture(window, f"dent_{organ}_{name}")
        view.move_surface(before)
        quick = grab(view)
        view.move_surface(after)
        assert fine >= 200, name
        assert count_changed(quick, grab(view)) >= 200, name


BALL = ellipsoid((0.04, 0.04, 0.04), 4)
REST = np.array(BALL.vertices)
NORMALS = REST / np.linalg.norm(REST, axis=1, keepdims=True)
TURN = np.array([[0.36, -0.48, 0.8], [0.8, 0.6, 0.0], [-0.48, 0.64, 0.6]])


def test_a_surface_that_moves_turns_or_grows_as_a_whole_gets_no_darker():
    dents = Dents(REST, NORMALS)

    for whole in (
        REST,
        REST + [0.02, -0.01, 0.03],
        1.2 * REST,
        0.8 * REST,
        0.5 * REST @ TURN + 0.1,
    ):
        assert dents.shade(whole).min() > 0.9999


def test_a_dent_is_as_deep_on_a_surface_that_has_moved_turned_and_grown():
    dents = Dents(REST, NORMALS)
    away = np.linalg.norm(REST - REST[np.argmax(REST[:, 2])], axis=1)
    dented = REST - DENT * np.exp(-((away / 4e-3) ** 2))[:, None] * NORMALS

    np.testing.assert_allclose(
        dents.measure(1.25 * dented @ TURN + [0.02, -0.01, 0.03]),
        1.25 * dents.measure(dented),
        atol=1e-9,
    )


def test_a_surface_without_numbers_or_size_is_no_error():
    dents = Dents(REST, NORMALS)

    assert dents.shade(np.zeros_like(REST)).shape == (len(REST),)
    assert dents.shade(np.full_like(REST, np.nan)).shape == (len(REST),)


def test_a_dent_is_as_deep_as_it_is_against_what_lies_around_it():
    dents = Dents(REST, NORMALS)
    away = np.linalg.norm(REST - REST[np.argmax(REST[:, 2])], axis=1)
    dented = REST - DENT * np.exp(-((away / 4e-3) ** 2))[:, None] * NORMALS

    depth = dents.measure(dented)

    assert 0.8 * DENT < depth.max() <= DENT
    assert depth[away > 0.03].max() < 0.05 * DENT
    assert dents.shade(dented).min() < 0.3
    assert dents.measure(REST + 2e-3 * NORMALS * (away < 5e-3)[:, None]).max() < 1e-3
